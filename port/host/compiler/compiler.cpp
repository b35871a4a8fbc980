// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/compiler.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/compiler/frame.hpp"
#include "host/compiler/goals.hpp"
#include "host/compiler/mesh.hpp"
#include "host/compiler/obstacles.hpp"
#include "host/compiler/pieces.hpp"
#include "host/compiler/rings.hpp"
#include "host/compiler/simplify.hpp"
#include "host/compiler/snap.hpp"
#include "host/compiler/write.hpp"
#include "host/workspace/printed.hpp"
#include "krait/format.hpp"
#include "krait/scene.hpp"

namespace krait::host {
namespace {

using namespace compiler;

constexpr double kStep = double(format::kGrid);  // metres
constexpr double kRounding = 0.7072;             // grid steps: the furthest that rounding moves a point

bool free(const Face& face) { return face.winding[0] != 0; }

// How far an obstacle may grow, how wide a passage stays where it grows, and how near to a start nothing grows; metres.
struct Growth {
  double most = 0;
  double narrow = 0;
  double start_reach = 0;
};

Growth growth_of(const Workspace& w, const CompileOptions& options) {
  if (std::isnan(options.tolerance) || options.tolerance > kMostTolerance)
    throw InputError("the tolerance is not a length of at most " + std::to_string(int(kMostTolerance)) + " m");
  if (options.tolerance >= 0) return {options.tolerance / 2};
  if (!w.cells) return {};
  return {std::min(w.cells->resolution, kMostTolerance) / 2, 2 * w.cells->resolution, kStartReach};
}

void check_starts(const Workspace& w, std::vector<std::string>& warnings) {
  if (w.starts.size() > format::kNone16) throw InputError("more than 65535 starts: split the scene");
  for (const Start& start : w.starts) {
    const std::string label = "start '" + start.name + "'";
    bool usable = std::isfinite(start.position.x) && std::isfinite(start.position.y) && std::abs(start.heading) < 1e6;
    for (const double angle : start.angles) usable = usable && std::abs(angle) < 1e6;
    if (!usable) throw InputError(label + ": a position or angle is not a finite number of a usable size");
    const Point p = start.position;
    if (p.x < w.min.x || p.x > w.max.x || p.y < w.min.y || p.y > w.max.y) {
      warnings.push_back(label + " lies outside the bounds of the workspace");
    }
  }
}

void append_reversed(Edges& edges, const Edges& other) {
  for (const Edge& e : other) edges.push_back({e.to, e.from, e.winding});
}

// The bounds as edges that divide nothing: they keep the triangulation's hull the workspace.
void append_hull(Edges& edges, const GridBox& bounds) { append_ring(edges, ring_of(bounds), {0, 0}); }

// The free space's boundary, free space on the left.
struct FreeSpace {
  Edges boundary;
  int roundings = 0;
};

FreeSpace free_space(const Edges& solid, const GridBox& bounds) {
  Edges edges;
  append_ring(edges, ring_of(bounds), {1, 0});
  append_reversed(edges, solid);
  const Snapped snapped = snap(edges);
  return {boundary(triangulate(snapped.edges), free), snapped.passes};
}

// The starts within the bounds.
Kept kept_around(const std::vector<Start>& starts, const Frame& frame, double reach) {
  Kept kept{{}, reach / kStep};
  for (const Start& start : starts) {
    const bool inside = within(frame.local(start.position), frame.bounds);
    if (inside && reach > 0) kept.places.push_back(frame.nearest(start.position));
  }
  return kept;
}

FreeSpace simplified(const FreeSpace& space, const Workspace& w, const Frame& frame, const Growth& growth) {
  Edges edges = edges_of(simplify(rings_of(space.boundary), growth.most / kStep, growth.narrow / kStep,
                                  kept_around(w.starts, frame, growth.start_reach)));
  append_hull(edges, frame.bounds);
  const Snapped snapped = snap(edges);
  return {snapped.edges, space.roundings + snapped.passes};
}

Edges with_goals(const Edges& space, const std::vector<PlacedGoal>& goals) {
  Edges edges = space;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    append_ring(edges, goals[i].clipped, {0, static_cast<std::int32_t>(i) + 1});
  }
  return snap(edges).edges;
}

void warn_of_blocked_goals(const Workspace& w, const Mesh& mesh, std::vector<std::string>& warnings) {
  std::vector<bool> reachable(w.goals.size(), false);
  for (const FreeTriangle& t : mesh.triangles) {
    if (t.goal != kNone) reachable[t.goal] = true;
  }
  for (std::size_t i = 0; i < reachable.size(); ++i) {
    if (!reachable[i])
      warnings.push_back("goal '" + w.goals[i].name + "' lies wholly inside obstacles: no plan can reach it");
  }
}

// No tolerance is to blame: simplification closes nothing.
std::string about_full(const Workspace& w) {
  const std::string covered =
      printed("obstacles cover all of the bounds, %.6g,%.6g to %.6g,%.6g m", w.min.x, w.min.y, w.max.x, w.max.y);
  if (!w.cells) return covered + ": is one of the shapes meant as the bounds, or are these too small?";
  return covered + ": are unknown cells free (see --unknown), or free and occupied values exchanged?";
}

// The core's own reader must take what leaves this program.
void check_bytes(const std::vector<std::uint8_t>& bytes) {
  Scene scene;
  const Failure failure = Scene::open(bytes.data(), bytes.size(), scene);
  if (failure.ok()) return;
  throw std::logic_error("the compiled scene is unsound in section " + std::to_string(failure.section) + ", element " +
                         std::to_string(failure.element));
}

}  // namespace

CompiledScene compile(const Workspace& workspace, const CompileOptions& options) {
  const auto tell = [&](const char* step) {
    if (options.progress) options.progress(step);
  };
  CompiledScene result;
  SceneParts parts;
  parts.frame = frame_of(workspace);
  const Growth growth = growth_of(workspace, options);
  parts.growth = growth.most + options.grown;
  check_starts(workspace, result.warnings);
  parts.goals = place_goals(workspace, parts.frame);
  const GridBox& bounds = parts.frame.bounds;

  tell("uniting obstacles");
  const Solid solid = solid_of(workspace, parts.frame, result.warnings);
  FreeSpace space = free_space(solid.boundary, bounds);
  tell("simplifying");
  space = simplified(space, workspace, parts.frame, growth);
  const double shrink = growth.most > 0 ? kShrink : 0;
  parts.obstacle_error = (kRounding * (solid.roundings + space.roundings) + shrink) * kStep;

  tell("cutting obstacles into convex pieces");
  const Triangulation coarse = triangulate(space.boundary);
  parts.pieces = convex_pieces(coarse, [](const Face& face) { return !free(face); });
  parts.free_boundary = boundary(coarse, free);

  tell("triangulating the free space");
  parts.mesh = free_mesh(with_goals(space.boundary, parts.goals), bounds, options.coarse);
  if (parts.mesh.triangles.empty()) throw InputError("no free space is left: " + about_full(workspace));
  warn_of_blocked_goals(workspace, parts.mesh, result.warnings);

  tell("measuring clearances");
  result.bytes = write_scene(workspace, parts);
  check_bytes(result.bytes);
  return result;
}

}  // namespace krait::host
