// SPDX-License-Identifier: Apache-2.0
#include "host/run/work.hpp"

#include <algorithm>
#include <vector>

#include "collision/obstacles.hpp"
#include "collision/sight.hpp"
#include "krait/math.hpp"
#include "search/sketcher.hpp"

namespace krait::host {
namespace {

// How far around the middle of a body's two places obstacles are looked for: the hull of both reaches half of what it
// moved further than the body, and it may stray from it by as much.
float search_radius(const krait::Scene& scene, const RobotExtent& robot, const Parameters& parameters) {
  const float margin = detail::Obstacles(scene, parameters.clearance + kTreeSlack * robot.length).margin();
  return robot.largest_radius + robot.longest_travel + detail::Obstacles::kLookBeyond + margin;
}

// Adds one to `seen` for every piece of the bucket that is not marked with `window` yet.
void count_bucket(const krait::Scene& scene, std::size_t bucket, std::size_t window, std::vector<std::size_t>& marks,
                  std::uint64_t& seen) {
  for (std::uint32_t i = scene.bucket_pieces_begin(bucket); i < scene.bucket_pieces_begin(bucket + 1); ++i) {
    std::size_t& mark = marks[scene.bucket_piece(i)];
    if (mark != window) ++seen;
    mark = window;
  }
}

// The most pieces in the buckets that a square of 2 * radius metres can meet, wherever it lies.
std::uint64_t most_pieces_near(const krait::Scene& scene, float radius) {
  const CellGrid& grid = scene.buckets();
  const auto all = static_cast<float>(std::max(grid.columns, grid.rows));
  const auto cells = static_cast<std::int32_t>(math::clamp(2.0F * radius * grid.per_metre, 0.0F, all)) + 2;
  std::vector<std::size_t> marks(scene.piece_count(), 0);
  std::uint64_t most = 0;
  std::size_t window = 0;
  for (Cell low{0, 0}; low.row < grid.rows; ++low.row) {
    for (low.column = 0; low.column < grid.columns; ++low.column) {
      std::uint64_t seen = 0;
      ++window;
      for (std::int32_t row = low.row; row < std::min(low.row + cells, grid.rows); ++row) {
        for (std::int32_t column = low.column; column < std::min(low.column + cells, grid.columns); ++column) {
          count_bucket(scene, grid.index({column, row}), window, marks, seen);
        }
      }
      most = std::max(most, seen);
    }
  }
  return most;
}

// Pairs of bodies that are at least `gap` apart in the chain.
std::uint64_t pairs(const RobotExtent& robot) {
  const std::uint64_t far = robot.bodies > robot.gap ? robot.bodies - robot.gap : 0;
  return far * (far + 1) / 2;
}

}  // namespace

// Runge-Kutta steps of a time step of a plan: those of the tree beside it, its own, and those of all parts that it may
// be cut into, each at least one.
std::uint64_t integrations(const RobotExtent& robot, const Parameters& parameters) {
  const auto plan_parts = static_cast<std::uint64_t>(robot.plan_parts);
  std::uint64_t steps = static_cast<std::uint64_t>(robot.tree_parts) + plan_parts;
  for (std::uint64_t cut = 2; parameters.tuning.continuous && cut <= parameters.tuning.max_substeps; cut *= 2) {
    steps += std::max(cut, plan_parts + cut - 1);
  }
  return steps;
}

// A step is judged whole, then in halves of halves down to one part of max_substeps: every part of the binary tree at
// most once, since the search for a free part goes on from where the last one ended. Judging looks at what every body
// sweeps, and where it stands at the end, against the pieces near it, and at every pair of bodies; before that the
// whole step's body 0 may have been looked at alone.
// Before an expansion each candidate has sight_tries points, all but the last at the end of a line of discs, and a
// sketch whose every step looks at a disc for each body. An expansion of more than max_steps is driven by several
// calls. A Dijkstra pops every region at most once and pushes each source, and each region over each of its portals, at
// most once.
Work work_bound(const krait::Scene& scene, const RobotExtent& robot, const Parameters& parameters) {
  const std::uint64_t parts = parameters.tuning.continuous ? 2 * std::uint64_t{parameters.tuning.max_substeps} - 1 : 1;
  const std::uint64_t judged = parameters.tuning.max_steps * parts;
  Work work;
  work.pieces_near = most_pieces_near(scene, search_radius(scene, robot, parameters));
  work.placements = judged + 1;
  work.runge_kutta_steps = parameters.tuning.max_steps * integrations(robot, parameters);
  work.polygon_distances =
      (2 * robot.bodies * judged + parameters.tuning.max_steps) * work.pieces_near + judged * pairs(robot);
  const std::uint64_t candidates = std::max(parameters.tuning.candidates, 1U);
  const std::uint64_t lines = candidates * std::max(parameters.tuning.sight_tries, 1U) - candidates;
  work.sketched_steps = std::uint64_t{parameters.tuning.candidates} * detail::Sketcher::kSteps;
  work.discs = lines * detail::Sight::kMostLooks + work.sketched_steps * robot.bodies;
  work.heap_operations = 2 * (std::uint64_t{scene.triangle_count()} + scene.portal_count());
  return work;
}

}  // namespace krait::host
