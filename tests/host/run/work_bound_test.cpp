// SPDX-License-Identifier: Apache-2.0
// The parts of the bound of work, against counts by hand and by brute force. That no search does more, work_test holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "../../core/scene_builder.hpp"
#include "host/run/work.hpp"

namespace krait::test {
namespace {

// Posts of 20 cm, one a metre.
OpenScene posts() {
  Room room;
  room.bounds = {0, 0, 12, 9};
  room.goals = {{0.5, 0.5, 0.75, 0.75}};
  for (int x = 1; x < 12; ++x) {
    for (int y = 1; y < 9; ++y) room.boxes.push_back({x - 0.1, y - 0.1, x + 0.1, y + 0.1});
  }
  return OpenScene(room);
}

host::RobotExtent extent(float radius) {
  host::RobotExtent robot;
  robot.largest_radius = radius;
  robot.length = 0.1F;
  return robot;
}

std::uint64_t pieces_near(const Scene& scene, float radius) {
  return host::work_bound(scene, extent(radius), Parameters()).pieces_near;
}

TEST(WorkBound, EveryPieceIsNearAtMostOnce) {
  const OpenScene open = posts();
  EXPECT_EQ(pieces_near(open.scene, 100), open.scene.piece_count());
}

TEST(WorkBound, ASquareMeetsNoMorePiecesWhereverItLies) {
  const OpenScene open = posts();
  const CellGrid& grid = open.scene.buckets();
  std::mt19937 random(1);
  for (const float radius : {0.05F, 0.4F, 0.9F, 2.0F}) {
    std::size_t most = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vec2 at{uniform_float(random, 0, 12), uniform_float(random, 0, 9)};
      const Cell low = grid.cell({at.x - radius, at.y - radius}), high = grid.cell({at.x + radius, at.y + radius});
      std::set<Index> seen;
      for (Cell cell = low; cell.row <= high.row; ++cell.row) {
        for (cell.column = low.column; cell.column <= high.column; ++cell.column) {
          const std::size_t bucket = grid.index(cell);
          for (std::uint32_t k = open.scene.bucket_pieces_begin(bucket); k < open.scene.bucket_pieces_begin(bucket + 1);
               ++k) {
            seen.insert(open.scene.bucket_piece(k));
          }
        }
      }
      most = std::max(most, seen.size());
    }
    EXPECT_LE(most, pieces_near(open.scene, radius)) << radius;
    EXPECT_GE(3 * most, pieces_near(open.scene, radius)) << radius;
  }
}

TEST(WorkBound, EveryPairOfBodiesThatIsFarEnoughApartIsTested) {
  const OpenScene open = posts();
  const auto distances = [&](std::uint64_t bodies, std::uint64_t gap) {
    host::RobotExtent robot = extent(1);
    robot.bodies = bodies;
    robot.gap = gap;
    return host::work_bound(open.scene, robot, Parameters()).polygon_distances;
  };
  for (const std::uint64_t bodies : {1U, 2U, 3U, 5U, 16U}) {
    const std::uint64_t none = distances(bodies, bodies);
    for (std::uint64_t gap = 1; gap <= bodies + 1; ++gap) {
      std::uint64_t pairs = 0;
      for (std::uint64_t i = 0; i < bodies; ++i) pairs += i + gap < bodies ? bodies - i - gap : 0;
      EXPECT_EQ(distances(bodies, gap), none + 40 * 31 * pairs) << bodies << " bodies " << gap;
    }
  }
}

// Three in the tree, five in the plan; cut in two, of which one part has a step more, 6; cut in four, 8.
TEST(WorkBound, EveryCutOfAStepIsIntegrated) {
  const OpenScene open = posts();
  host::RobotExtent robot = extent(1);
  robot.tree_parts = 3;
  robot.plan_parts = 5;
  Parameters parameters;
  parameters.tuning.max_steps = 10;
  parameters.tuning.max_substeps = 4;
  EXPECT_EQ(host::work_bound(open.scene, robot, parameters).runge_kutta_steps, 10U * (3 + 5 + 6 + 8));
  parameters.tuning.max_substeps = 1;
  EXPECT_EQ(host::work_bound(open.scene, robot, parameters).runge_kutta_steps, 10U * (3 + 5));
  parameters.tuning.max_substeps = 4;
  parameters.tuning.continuous = false;
  EXPECT_EQ(host::work_bound(open.scene, robot, parameters).runge_kutta_steps, 10U * (3 + 5));
}

TEST(WorkBound, WhatIsNotSketchedLooksAtNoDiscs) {
  const OpenScene open = posts();
  Parameters parameters;
  parameters.tuning.candidates = 0;
  parameters.tuning.sight_tries = 0;
  const host::Work work = host::work_bound(open.scene, extent(1), parameters);
  EXPECT_EQ(work.sketched_steps, 0U);
  EXPECT_EQ(work.discs, 0U);
  EXPECT_EQ(work.heap_operations, 2U * (open.scene.triangle_count() + open.scene.portal_count()));
}

}  // namespace
}  // namespace krait::test
