// SPDX-License-Identifier: Apache-2.0
/// \file
/// The functions that are optional for a robot (model.hpp): its own where it has one, else the default. Internal, and
/// installed since functions.hpp includes it.
#pragma once

#include <type_traits>

#include "krait/robots/model.hpp"

namespace krait::detail {

// Whether a robot has the optional function, const and of the type that model.hpp says, which defines two of these.
template <class R>
concept HasCarryErrors = requires(const R& robot, StateView s, const Pose* poses, ControlView u, float dt,
                                  float* errors) {
  { robot.carry_errors(s, poses, u, dt, errors) } -> std::same_as<float>;
};
template <class R>
concept HasKeepsReserve = requires(const R& robot, StateView s) {
  { robot.keeps_reserve(s) } -> std::same_as<bool>;
};
template <class R>
concept HasLeadingSize = requires(const R& robot) {
  { robot.leading_size() } -> std::same_as<int>;
};
template <class R>
concept HasSelfCollisionGap = requires(const R& robot) {
  { robot.self_collision_gap() } -> std::same_as<int>;
};
template <class R>
concept HasExact = requires(const R& robot) {
  { robot.exact() } -> std::same_as<bool>;
};
template <class R>
concept HasSound = requires(const R& robot) {
  { robot.sound() } -> std::same_as<bool>;
};
template <class R>
concept HasQuickBound = requires(const R& robot, StateView s, ControlView u, float dt, StateView next) {
  { robot.quick_bound(s, u, dt, next) } -> std::same_as<QuickBound>;
};
template <class R>
concept HasFastestRate = requires(const R& robot, float dt) {
  { robot.fastest_rate(dt) } -> std::same_as<float>;
};
template <class R>
concept HasStoppingWay = requires(const R& robot, StateView s) {
  { robot.stopping_way(s) } -> std::same_as<float>;
};
template <class R>
concept HasTurningRadius = requires(const R& robot) {
  { robot.turning_radius() } -> std::same_as<float>;
};
template <class R>
concept HasTopSpeed = requires(const R& robot) {
  { robot.top_speed() } -> std::same_as<float>;
};
template <class R>
concept HasSpeed = requires(const R& robot, StateView s) {
  { robot.speed(s) } -> std::same_as<float>;
};
template <class R>
concept HasSketch = requires(const R& robot, StateRef s, Pose* poses, ControlView u, float dt) {
  { robot.sketch(s, poses, u, dt) } -> std::same_as<bool>;
};
template <class R>
concept HasTrack = requires(const R& robot, StateView s, StateView reference, float dt, ControlRef u) {
  robot.track(s, reference, dt, u);
};
template <class R>
concept HasRest = requires(const R& robot, Vec2 position, float heading, float* s) {
  robot.rest(position, heading, s);
};
template <class R>
concept HasRestOfAll = requires(const R& robot, Vec2 position, float heading, const float* angles, float* s) {
  robot.rest(position, heading, angles, s);
};

/// For types_match alone: whether the member function of that name is what Has says, or there is none.
#define KRAIT_TYPED(name, Has)                                                                          \
  static_assert((Has) || !requires { requires std::is_member_function_pointer_v<decltype(&R::name)>; }, \
                "krait: " #name                                                                         \
                " of the robot would not be called: RobotModel has it const, with other arguments or another result");

// Does not compile for a robot with a member function that has an optional one's name and another type, which would not
// be called. One that is overloaded may be meant for others.
template <class R>
constexpr bool types_match() {
  KRAIT_TYPED(carry_errors, HasCarryErrors<R>)
  KRAIT_TYPED(keeps_reserve, HasKeepsReserve<R>)
  KRAIT_TYPED(leading_size, HasLeadingSize<R>)
  KRAIT_TYPED(self_collision_gap, HasSelfCollisionGap<R>)
  KRAIT_TYPED(exact, HasExact<R>)
  KRAIT_TYPED(sound, HasSound<R>)
  KRAIT_TYPED(quick_bound, HasQuickBound<R>)
  KRAIT_TYPED(fastest_rate, HasFastestRate<R>)
  KRAIT_TYPED(stopping_way, HasStoppingWay<R>)
  KRAIT_TYPED(turning_radius, HasTurningRadius<R>)
  KRAIT_TYPED(top_speed, HasTopSpeed<R>)
  KRAIT_TYPED(reversible, HasReversible<R>)
  KRAIT_TYPED(backing_body, HasBackingBody<R>)
  KRAIT_TYPED(speed, HasSpeed<R>)
  KRAIT_TYPED(sketch, HasSketch<R>)
  KRAIT_TYPED(track, HasTrack<R>)
  KRAIT_TYPED(rest, HasRest<R> || HasRestOfAll<R>)
  KRAIT_TYPED(integrate_lead, LeadingRobot<R>)
  KRAIT_TYPED(integrate_rest, LeadingRobot<R>)
  return true;
}
#undef KRAIT_TYPED

// The control that steers s, whose frames are `poses`, toward the target.
template <RobotModel R>
void steer(const R& robot, StateView s, const Pose* poses, const Target& target, Steering& steering, ControlRef u) {
  if constexpr (requires { robot.steer(s, poses, target, steering, u); }) {
    robot.steer(s, poses, target, steering, u);
  } else {
    robot.steer(s, target, steering, u);
  }
}

// The travel of a body by its rates over dt, by lemma 1 of lib/robot/CHAIN.md: a point that accelerates by at most A
// leaves the line between its places by at most A dt^2 / 8. It also leaves it by no more than half its way.
inline Travel travel_of(const BodyRates& most, float dt) {
  const float path = most.speed * dt;
  const float turn = most.turn * dt;
  const float eighth = 0.125F * dt * dt;
  const float bend = most.acceleration * eighth;
  const float twist = (most.turn_acceleration + most.turn * most.turn) * eighth;
  return {path, turn, bend < 0.5F * path ? bend : 0.5F * path, twist < 0.5F * turn ? twist : 0.5F * turn};
}

// Bounds every body's motion while u is held for dt, by the robot's travel or by its rates. False where its limits are
// not proven to hold in between.
template <RobotModel R>
bool travel(const R& robot, StateView s, ControlView u, float dt, StateView next, Travel* travel) {
  if constexpr (StatesTravel<R>) {
    return robot.travel(s, u, dt, next, travel);
  } else {
    BodyRates rates[R::kMaxBodies] = {};
    const bool limits_hold = robot.rates(s, u, dt, next, rates);
    for (int k = 0; k < robot.body_count(); ++k) travel[k] = travel_of(rates[k], dt);
    return limits_hold;
  }
}

// Changes u, the reference's control, so that the robot comes back from s to the reference. Default: u stays.
template <RobotModel R>
void track(const R& robot, StateView s, StateView reference, float dt, ControlRef u) {
  if constexpr (HasTrack<R>) robot.track(s, reference, dt, u);
}

// Updates the errors of a state's components over a time step, and returns the metres that a body may be off then.
// Default: 0, and the errors stay.
template <RobotModel R>
float carry_errors(const R& robot, StateView s, const Pose* poses, ControlView u, float dt, float* errors) {
  if constexpr (HasCarryErrors<R>) return robot.carry_errors(s, poses, u, dt, errors);
  return 0.0F;
}

// Whether the state is within the limits, and far enough for the tree. Default: within_limits.
template <RobotModel R>
bool keeps_reserve(const R& robot, StateView s) {
  if constexpr (HasKeepsReserve<R>) return (kAnswersProven<R> || robot.within_limits(s)) && robot.keeps_reserve(s);
  return robot.within_limits(s);
}

// How many of the state's first components depend on no others. Default: all.
template <RobotModel R>
int leading_size(const R& robot) {
  if constexpr (HasLeadingSize<R>) return robot.leading_size();
  return robot.state_size();
}

// Bodies i and j are tested against each other when |i - j| is at least this. Default: 2.
template <RobotModel R>
int self_collision_gap(const R& robot) {
  if constexpr (HasSelfCollisionGap<R>) return robot.self_collision_gap();
  return 2;
}

// Whether its functions compute floats as written. Default: true.
template <RobotModel R>
bool exact(const R& robot) {
  if constexpr (HasExact<R>) return robot.exact();
  return true;
}

// Whether the dimensions and limits can be used. Default: true.
template <RobotModel R>
bool sound(const R& robot) {
  if constexpr (HasSound<R>) return robot.sound();
  return true;
}

// A cheap bound on a step of the whole robot. Default: one that proves nothing.
template <RobotModel R>
QuickBound quick_bound(const R& robot, StateView s, ControlView u, float dt, StateView next) {
  if constexpr (HasQuickBound<R>) return robot.quick_bound(s, u, dt, next);
  return {};
}

// How fast the dynamics can change within a time step of dt seconds, 1/s. Default: 0.
template <RobotModel R>
float fastest_rate(const R& robot, float dt) {
  if constexpr (HasFastestRate<R>) return robot.fastest_rate(dt);
  return 0.0F;
}

// How fast it moves in a state, m/s. Default: 0.
template <RobotModel R>
float speed_of(const R& robot, StateView s) {
  if constexpr (HasSpeed<R>) return robot.speed(s);
  return 0.0F;
}

// How far ahead, along body 0, braking would end, metres. Default: 0.
template <RobotModel R>
float stopping_way(const R& robot, StateView s) {
  if constexpr (HasStoppingWay<R>) return robot.stopping_way(s);
  return 0.0F;
}

// Metres, of the sharpest turn that the robot drives for long. Default: `length`.
template <RobotModel R>
float turning_radius(const R& robot, float length) {
  if constexpr (HasTurningRadius<R>) return robot.turning_radius();
  return length;
}

// m/s, straight ahead. Default: `length` metres a second.
template <RobotModel R>
float top_speed(const R& robot, float length) {
  if constexpr (HasTopSpeed<R>) return robot.top_speed();
  return length;
}

// Writes the state in which the robot stands still, its bodies but the first turned as `count` angles say, or as the
// first where there are none. False, and nothing is written, where it has no such function or another number of bodies.
template <RobotModel R>
bool rest(const R& robot, Vec2 position, float heading, const float* angles, std::uint32_t count, float* s) {
  if constexpr (HasRestOfAll<R>) {
    const auto followers = static_cast<std::uint32_t>(robot.body_count() - 1);
    const bool straight = count == 0 || followers == 0;
    if (!straight && count != followers) return false;
    robot.rest(position, heading, straight ? nullptr : angles, s);
    return true;
  } else if constexpr (HasRest<R>) {
    robot.rest(position, heading, s);
    return true;
  }
  return false;
}

// Whether the robot can drive backwards. Default: false.
template <RobotModel R>
bool reversible(const R& robot) {
  if constexpr (HasReversible<R>) return robot.reversible();
  return false;
}

// The body that steer brings to the target's point when it drives backwards. Default: 0.
template <RobotModel R>
int backing_body(const R& robot) {
  if constexpr (HasBackingBody<R>) return robot.backing_body();
  return 0;
}

// A fourth-order Runge-Kutta step of Eqn 2 with the control held, by a model's derivative.
// What dt seconds add to a state, or to its leading components: d, as many floats. Four derivatives.
template <RobotModel R>
void runge_kutta(const R& robot, StateView state, ControlView u, float dt, float* d) {
  const int n = static_cast<int>(state.size());
  float k1[R::kMaxState];
  float k23[R::kMaxState];
  float k[R::kMaxState];
  float middle[R::kMaxState] = {};  // for compilers that doubt that n is above 0
  const float half = 0.5F * dt;
  robot.derivative(state, u, StateRef(k1, n));
  for (int i = 0; i < n; ++i) middle[i] = state[i] + half * k1[i];
  const StateView at(middle, n);
  robot.derivative(at, u, StateRef(k23, n));
  for (int i = 0; i < n; ++i) middle[i] = state[i] + half * k23[i];
  robot.derivative(at, u, StateRef(k, n));
  for (int i = 0; i < n; ++i) {
    middle[i] = state[i] + dt * k[i];
    k23[i] = k23[i] + k[i];
  }
  robot.derivative(at, u, StateRef(k, n));
  const float sixth = dt / 6.0F;
  for (int i = 0; i < n; ++i) d[i] = sixth * ((k1[i] + k[i]) + 2.0F * k23[i]);
}

// Moves the state s and its frames `poses` by dt under u, roughly. False where it leaves the robot's limits. Default: a
// step by the midpoint rule.
template <RobotModel R>
bool sketch(const R& robot, StateRef s, Pose* poses, ControlView u, float dt) {
  if constexpr (HasSketch<R>) {
    return robot.sketch(s, poses, u, dt);
  } else {
    const int n = robot.state_size();
    float rates[R::kMaxState];
    float middle[R::kMaxState];
    robot.derivative(StateView(s.data(), n), u, StateRef(rates, n));
    for (int i = 0; i < n; ++i) middle[i] = s[i] + 0.5F * dt * rates[i];
    robot.derivative(StateView(middle, n), u, StateRef(rates, n));
    for (int i = 0; i < n; ++i) s[i] = s[i] + dt * rates[i];
    if (!robot.within_limits(StateView(s.data(), n))) return false;
    robot.place(StateView(s.data(), n), poses);
    return true;
  }
}

}  // namespace krait::detail
