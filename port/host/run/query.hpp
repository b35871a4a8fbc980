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
template <class R>
std::vector<float> state_at(const R& robot, const krait::Scene& scene, const Start& start) {
  std::vector<float> state(static_cast<std::size_t>(robot.state_size()));
  const Vec2 at = local_of(scene, start.position);
  const auto heading = static_cast<float>(start.heading);
  if constexpr (requires { robot.rest(at, heading, nullptr, state.data()); }) {
    const std::vector<float> angles(start.angles.begin(), start.angles.end());
    robot.rest(at, heading, angles.empty() ? nullptr : angles.data(), state.data());
  } else {
    robot.rest(at, heading, state.data());
  }
  return state;
}

template <class R>
ResolvedQuery resolve(const krait::Scene& scene, const R& robot, const SearchRequest& request) {
  const Start start = resolve_start(scene, request);
  const krait::Goal goal = resolve_goal(scene, request);
  return {state_at(robot, scene, start), goal, asked_of(scene, request, start, goal), plan_form(scene, request, goal)};
}

}  // namespace krait::host
