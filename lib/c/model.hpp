// SPDX-License-Identifier: Apache-2.0
// What the C interface needs of a model of robot, and how it comes from the C++ class.
#pragma once

#include <algorithm>
#include <cstring>
#include <new>
#include <type_traits>

#include "krait/krait.h"
#include "krait/krait.hpp"

// How a model's robot is made of what C describes it by; one constant each, so that a program contains the models that
// it names.
struct krait_model {
  std::size_t robot_bytes;
  // Makes the robot at `place`, which has robot_bytes and is aligned to krait::Setup::kAlignment.
  krait::Robot (*make)(void* place, const krait_robot& from);
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

// The most bytes of a robot of any model: make asserts that those written in C have no more.
template <class... Models>
struct LargestOf {
  static constexpr std::size_t kBytes = std::max({sizeof(Models)...});
};
inline constexpr std::size_t kMostRobotBytes = AllRobots<LargestOf>::kBytes;

template <class R>
Robot make(void* place, const krait_robot& from) {
  static_assert(sizeof(R) <= kMostRobotBytes && alignof(R) <= Setup::kAlignment);
  static_assert(std::is_trivially_destructible_v<R>);
  return Robot(*::new (place) R(make_robot<R>(from)));
}

template <class R>
inline constexpr krait_model kModel = {sizeof(R), make<R>};

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
