// SPDX-License-Identifier: Apache-2.0
// From what a user asked (names or world coordinates) to what the core takes, and what the verifier holds it to.
#pragma once

#include <vector>

#include "host/run/robots.hpp"
#include "host/run/run.hpp"

namespace krait::host {

struct ResolvedQuery {
  std::vector<float> start;  // the core's state, local coordinates
  krait::Goal goal = krait::Goal::named(0);
  Asked asked;    // world coordinates
  PlanFile form;  // the plan's file without states
};

// The pose to start from, world coordinates. Throws InputError where the scene has none such.
Start resolve_start(const krait::Scene& scene, const SearchRequest& request);
// Throws InputError where the scene has no such goal.
krait::Goal resolve_goal(const krait::Scene& scene, const SearchRequest& request);
Asked asked_of(const krait::Scene& scene, const SearchRequest& request, const Start& start, const krait::Goal& goal);
PlanFile plan_form(const krait::Scene& scene, const SearchRequest& request, const krait::Goal& goal);

inline Point world_of(const krait::Scene& scene, Vec2 p) {
  return {scene.header().origin_x + static_cast<double>(p.x), scene.header().origin_y + static_cast<double>(p.y)};
}
inline Vec2 local_of(const krait::Scene& scene, Point p) {
  return {static_cast<float>(p.x - scene.header().origin_x), static_cast<float>(p.y - scene.header().origin_y)};
}

// The robot standing still at a start; trailers at the start's angles or all at its heading.
std::vector<float> state_at(const Robot& robot, const krait::Scene& scene, const Start& start);

ResolvedQuery resolve(const krait::Scene& scene, const Robot& robot, const SearchRequest& request);

}  // namespace krait::host
