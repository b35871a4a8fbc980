// SPDX-License-Identifier: Apache-2.0
// What the C interface needs of a model of robot, and how it comes from the C++ class.
#pragma once

#include <cstring>
#include <new>
#include <type_traits>

#include "krait/krait.h"
#include "krait/krait.hpp"

// What a model does with a robot as C describes it; one constant each, so that a program contains the models that it
// names.
struct krait_model {
  std::size_t robot_bytes;
  // Makes the robot at `place`.
  krait::Robot (*make)(void* place, const krait_robot& from);
  std::uint32_t (*state_size)(const krait_robot& from);
  std::uint32_t (*control_size)(const krait_robot& from);
  bool (*rest)(const krait_robot& from, const krait_pose& pose, float* state);
  std::uint64_t (*pools)(const krait::Scene& scene, const krait_robot& from, const krait::Limits& limits);
  krait::Limits (*limits_for)(std::uint64_t pools, const krait::Scene& scene, const krait_robot& from,
                              std::uint32_t way_legs);
};

namespace krait::c {

// Whether one of krait.h's functions has made the robot.
inline bool is_made(const krait_robot* robot) { return robot != nullptr && robot->model != nullptr; }

// A structure of C as the one of C++ with the same fields in the same order, or the other way round.
template <class To, class From>
To convert(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && alignof(To) == alignof(From));
  static_assert(std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
  To to;
  std::memcpy(static_cast<void*>(&to), &from, sizeof to);
  return to;
}

// A robot's parameters: whichever of the union they are, they begin where it does.
template <class Parameters>
Parameters parameters_of(const krait_robot& robot) {
  static_assert(sizeof(Parameters) <= sizeof robot.parameters && std::is_trivially_copyable_v<Parameters>);
  Parameters parameters;
  std::memcpy(static_cast<void*>(&parameters), &robot.parameters, sizeof parameters);
  return parameters;
}

template <class R>
requires std::constructible_from<R, const krait_own&> R make_robot(const krait_robot& from) {
  return R(from.parameters.own);
}

template <class R>
R make_robot(const krait_robot& from) {
  R robot(parameters_of<typename R::Parameters>(from));
  for (int k = 0; from.bodies != nullptr && k < robot.body_count() && k < R::kMaxBodies; ++k) {
    Vec2 corners[kMaxVertices] = {};
    const krait_polygon& body = from.bodies[k];
    for (int i = 0; i < body.count && i < kMaxVertices; ++i) {
      corners[i] = {body.corners[i].x, body.corners[i].y};
    }
    robot.set_body(k, {corners, body.count});
  }
  return robot;
}

// The functions of krait_model for the robot R.
template <class R>
struct Model {
  static Robot make(void* place, const krait_robot& from) { return Robot(*::new (place) R(make_robot<R>(from))); }

  static std::uint32_t state_size(const krait_robot& from) {
    const R robot = make_robot<R>(from);
    return usable(robot) ? static_cast<std::uint32_t>(robot.state_size()) : 0;
  }

  static std::uint32_t control_size(const krait_robot& from) {
    const R robot = make_robot<R>(from);
    return usable(robot) ? static_cast<std::uint32_t>(robot.control_size()) : 0;
  }

  static bool rest(const krait_robot& from, const krait_pose& pose, float* state) {
    const R robot = make_robot<R>(from);
    if (!robot.sound()) return false;
    return detail::rest(robot, {pose.x, pose.y}, pose.heading, pose.angles, pose.angle_count, state);
  }

  static std::uint64_t pools(const Scene& scene, const krait_robot& from, const Limits& limits) {
    const R robot = make_robot<R>(from);
    return Planner::bytes_required(scene, robot, limits);
  }

  static Limits limits_for(std::uint64_t pools, const Scene& scene, const krait_robot& from, std::uint32_t way_legs) {
    const R robot = make_robot<R>(from);
    return Planner::limits_for(pools, scene, robot, way_legs);
  }

 private:
  static bool usable(const R& robot) { return robot.sound() && Robot(robot).sizes_valid(); }
};

template <class R>
inline constexpr krait_model kModel = {sizeof(R),      Model<R>::make,  Model<R>::state_size, Model<R>::control_size,
                                       Model<R>::rest, Model<R>::pools, Model<R>::limits_for};

// The robot of the library's class R with its defaults, and as many trailers where it may have any.
template <class R>
krait_robot robot_of([[maybe_unused]] int trailers = 0) {
  auto parameters = defaults_of<R>();
  if constexpr (requires { parameters.trailers; }) parameters.trailers = trailers;
  krait_robot robot{&kModel<R>, {}, nullptr};
  std::memcpy(&robot.parameters, &parameters, sizeof parameters);
  return robot;
}

}  // namespace krait::c
