// SPDX-License-Identifier: Apache-2.0
#include "host/run/robots.hpp"

#include <algorithm>

#include "motion/rk4.hpp"
#include "robot/shape.hpp"

namespace krait::host {
namespace {

template <class P>
P parameters_of(const RobotSpec& spec) {
  P parameters;
  P::describe([&]<class Number>(const ParameterField<P, Number>& field) {
    if (*field.unit != '\0') parameters.*field.member = static_cast<Number>(spec.parameters.at(field.name));
  });
  if constexpr (requires { parameters.trailers; }) parameters.trailers = spec.links;
  return parameters;
}

// The robot of class R, with the parameters and the bodies of the specification.
template <class R>
CoreRobot::Any make(const RobotSpec& spec) {
  R robot(parameters_of<typename R::Parameters>(spec));
  for (std::size_t k = 0; k < spec.bodies.size(); ++k) {
    Vec2 vertices[kMaxVertices];
    int count = 0;
    for (const Point& p : spec.bodies[k]) {
      if (count < kMaxVertices) vertices[count++] = {static_cast<float>(p.x), static_cast<float>(p.y)};
    }
    robot.set_body(static_cast<int>(k), {vertices, count});
  }
  return robot;
}

CoreRobot::Any core_of(const RobotSpec& spec) {
#define KRAIT_MAKE(name, Class, file, trailers) \
  if (spec.model == #name) return make<Class>(spec);
  KRAIT_MODELS(KRAIT_MAKE)
#undef KRAIT_MAKE
  throw InputError("robot model \"" + spec.model + "\" is not known");
}

float largest_radius(Polygon body) {
  const Box box = bounding_box(body);
  const Vec2 center = 0.5F * (box.min + box.max);
  float radius = 0.0F;
  for (int i = 0; i < body.count; ++i) radius = std::max(radius, length(body[i] - center));
  return radius * (1.0F + 1e-6F);
}

// Metres: how far a point of a body moves in a time step of dt seconds, at most.
float longest_travel(const CoreRobot& core, float dt) {
  const Extremes most = core.extremes();
  const Robot robot = core.view();
  float farthest = 0.0F;
  for (int k = 0; k < robot.body_count(); ++k) {
    const Polygon body = robot.body(k);
    farthest = std::max(farthest, detail::farthest(body.vertices, body.count));
  }
  return dt * (most.speed + farthest * most.turn);
}

}  // namespace

CoreRobot::CoreRobot(const RobotSpec& spec) : robot_(core_of(spec)) {}

RobotExtent extent_of(const CoreRobot& core, const Parameters& parameters) {
  const Robot robot = core.view();
  RobotExtent extent;
  extent.bodies = static_cast<std::uint64_t>(robot.body_count());
  extent.gap = static_cast<std::uint64_t>(robot.self_collision_gap());
  extent.longest_travel = longest_travel(core, parameters.dt);
  extent.length = detail::robot_length(robot);
  extent.tree_parts =
      detail::parts_of(parameters.dt, detail::longest_tree_step(robot, parameters.dt), detail::kMostParts);
  extent.plan_parts =
      detail::parts_of(parameters.dt, detail::longest_plan_step(robot, parameters.dt), detail::kMostPlanParts);
  for (int k = 0; k < robot.body_count(); ++k) {
    extent.largest_radius = std::max(extent.largest_radius, largest_radius(robot.body(k)));
  }
  return extent;
}

RobotExtent extent_of(const RobotSpec& spec, const Parameters& parameters) {
  return extent_of(CoreRobot(spec), parameters);
}

}  // namespace krait::host
