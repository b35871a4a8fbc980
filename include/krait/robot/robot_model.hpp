// SPDX-License-Identifier: Apache-2.0
// What the planner asks of a robot: a class of pure functions over its state and control vectors.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <cstdint>

#include "krait/base/geometry.hpp"
#include "krait/robot/pid.hpp"

namespace krait {

// States and controls are float vectors of the robot's run-time size, viewed in place.
// State components 0 and 1 are the position (x, y) in metres.
using StateView = Eigen::Map<const Eigen::VectorXf>;
using StateRef = Eigen::Map<Eigen::VectorXf>;
using ControlView = Eigen::Map<const Eigen::VectorXf>;
using ControlRef = Eigen::Map<Eigen::VectorXf>;

inline Vec2 position(const StateView& state) { return {state[0], state[1]}; }

// Where an expansion steers to.
struct Target {
  Vec2 point = {};
  float speed = 1.0F;  // share of the robot's top speed in (0, 1]; in [-1, 0): of its top speed backwards; 0: to rest
  float dt = 0.1F;     // seconds that the control will be held
  float turn = 1.0F;   // share of the robot's sharpest turn in (0, 1], for one whose turns cost it room
};

// How a body can have moved during a step. Of a point of it that is r metres from its frame's origin: it has gone at
// most path + r turn, and was never further than bend + r twist from the straight line between its places at the step's
// ends. With accelerations of at most A and angular ones of at most W, bend = A dt^2 / 8 and
// twist = (W + (turn / dt)^2) dt^2 / 8; path / 2 and turn / 2 are always right.
struct Travel {
  float path;   // metres, of the frame's origin
  float turn;   // radians
  float bend;   // metres, of the frame's origin
  float twist;  // radians
};

// The controller's memory; fresh at the start of an expansion.
struct Steering {
  Pid heading;
  Pid speed;
};

// A robot is a value with these members, none of which has side effects or depends on anything but its arguments;
// check_robot (krait/robot_check/robot_check.hpp) tells where one breaks what is said here.
//   kMaxState, kMaxControl, kMaxBodies   compile-time limits of the sizes below; kMaxBodies is at most 32
//   state_size(), control_size(), body_count()
//   derivative(s, u, ds)         the dynamics ds = f(s, u) (Eqn 2)
//   steer(s, target, steering, u)  the control that steers s toward the target, inside its limits and such
//                                that a step of target.dt keeps the state inside its own
//   within_limits(s)             speeds, steering and hitch angles are valid
//   body(k)                      convex polygon of 3 to 8 vertices, counter-clockwise, in body k's frame, metres
//   place(s, poses)              writes the frame of every body; body 0's origin is the position
//   travel(s, u, dt, next, travel)  bounds the motion of every body while u is held for dt from s to next, what proves
//                                that nothing is jumped over between two states, whatever it writes: false when it is
//                                not proven that the limits, which s and next keep, hold all the way
// It may also have the following, each of which a function below calls or replaces:
//   speed(s)                     m/s, at least 0: how fast it moves in s, 0 at rest. A plan then ends at rest, or as
//                                slow as Parameters::end_speed asks: steer with a target whose speed is 0 must
//                                decrease it at every step until it is 0. Without it a plan ends at any speed
//   stopping_way(s)              metres along body 0's x axis, negative backwards: how far from the position it comes
//                                to rest, roughly, when it brakes in s. Used to know where it pays to brake for the
//                                goal; without it, 0
//   turning_radius()             metres, at least 0: of the sharpest turn that it drives for long, forwards. Used to
//                                find the way to a pose; without it, the length of body 0
//   top_speed()                  m/s, above 0: of the position, straight ahead at a target's speed of 1. Used to come
//                                to rest at a pose; without it, a length of body 0 a second
//   fastest_rate(dt)             1/s, at least 0: Runge-Kutta steps of h seconds with h fastest_rate(dt) <= kStepRate
//                                (rk4.hpp) are accurate to its bounds, whatever state and control the limits allow in
//                                a time step of dt. Without it, every time step counts as short enough
//   track(s, reference, dt, u)   changes u, the control of the state `reference` that s is very near to, to the one
//                                that brings s back to the motion of the reference within some time steps of dt,
//                                inside the limits as steer's. Without it, u stays, and a plan's error grows with its
//                                length
//   carry_errors(s, poses, u, dt, errors)
//                                errors has an estimate of how far each component of s is from where the plan's
//                                controls led in exact arithmetic, on the side where it is; makes it the same after a
//                                time step of dt under u, with what the step itself rounds, and returns how far that
//                                puts a body aside, metres. A plan keeps that away from obstacles, and ends nowhere
//                                where an error has grown past 2e-3. Without it, errors count as covered by the margin
//                                of every plan, which is so unless the motion multiplies them, as that of pushed
//                                trailers does
//   exact()                      whether its functions compute floats as written. Without it, as the file does that
//                                names the robot to the planner
//   keeps_reserve(s)             s is within the limits, and so far that a plan, which is driven a little beside the
//                                tree, keeps them; without it, within_limits is all that the tree keeps
//   steer(s, poses, target, steering, u)
//                                returns the same control to the bit and knows the frames of s; called instead
//   leading_size()               how many of the first components, the position among them, depend on no others;
//                                place and derivative then also accept states of so many, and place writes body 0 only
//   Lead, integrate_lead(s, poses, u, dt, lead, d), integrate_rest(s, poses, dt, lead, d)
//                                know the frames of s and write to d, as many floats as s has, what a Runge-Kutta step
//                                of dt under u adds to s: that by derivative but for rounding, at less cost; called
//                                instead of derivative throughout. First the leading components, which body 0 is
//                                checked by, then the rest by what the first left in lead, a plain struct. The first
//                                also accepts states of leading_size()
//   rest(position, heading, s), or rest(position, heading, angles, s)
//                                writes to s the state in which it stands still there; `angles` has the headings of
//                                all bodies but the first, or is null where they are that of the first, too
//   sketch(s, poses, u, dt)      moves s, as far as steer looks at it, and the frames by dt under u, roughly; false
//                                where that leaves the limits. Used to look ahead, instead of derivative
template <class R>
concept RobotModel = requires(const R& robot, StateView s, StateRef ds, ControlView u, ControlRef control,
                              Steering& steering, const Target& target, Pose* poses, Travel* travel, float dt, int k) {
  { R::kMaxState } -> std::convertible_to<int>;
  { R::kMaxControl } -> std::convertible_to<int>;
  { R::kMaxBodies } -> std::convertible_to<int>;
  { robot.state_size() } -> std::same_as<int>;
  { robot.control_size() } -> std::same_as<int>;
  { robot.body_count() } -> std::same_as<int>;
  {robot.derivative(s, u, ds)};
  {robot.steer(s, target, steering, control)};
  { robot.within_limits(s) } -> std::same_as<bool>;
  { robot.body(k) } -> std::same_as<Polygon>;
  {robot.place(s, poses)};
  { robot.travel(s, u, dt, s, travel) } -> std::same_as<bool>;
};

// One that integrates its leading components first.
template <class R>
concept LeadingRobot = RobotModel<R> && requires(const R& robot, StateView s, const Pose* poses, ControlView u,
                                                 float dt, typename R::Lead& lead, float* d) {
  { robot.leading_size() } -> std::same_as<int>;
  {robot.integrate_lead(s, poses, u, dt, lead, d)};
  {robot.integrate_rest(s, poses, dt, lead, d)};
};

// The control that steers s, whose frames are `poses`, toward the target.
template <RobotModel R>
void steer(const R& robot, StateView s, const Pose* poses, const Target& target, Steering& steering, ControlRef u) {
  if constexpr (requires { robot.steer(s, poses, target, steering, u); }) {
    robot.steer(s, poses, target, steering, u);
  } else {
    robot.steer(s, target, steering, u);
  }
}

// Changes u, the reference's control, so that the robot comes back from s to the reference; a robot may say how.
template <RobotModel R>
void track(const R& robot, StateView s, StateView reference, float dt, ControlRef u) {
  if constexpr (requires { robot.track(s, reference, dt, u); }) robot.track(s, reference, dt, u);
}

// Carries the errors of a state's components over a time step, and returns the metres that a body may be off then; a
// robot may say.
template <RobotModel R>
float carry_errors(const R& robot, StateView s, const Pose* poses, ControlView u, float dt, float* errors) {
  if constexpr (requires {
                  { robot.carry_errors(s, poses, u, dt, errors) } -> std::same_as<float>;
                })
    return robot.carry_errors(s, poses, u, dt, errors);
  return 0.0F;
}

// Whether the answers of the class R, and of none derived from it, need no second look: within_limits refuses every
// state that is not finite, and at any other it lets pass controls and frames are finite and no bound is NaN or
// negative; keeps_reserve refuses what within_limits refuses. True of the library's models, which the tests hold to it.
template <class R>
inline constexpr bool kAnswersProven = false;

// Whether the state is within the limits, and far enough for the tree; a robot may say.
template <RobotModel R>
bool keeps_reserve(const R& robot, StateView s) {
  if constexpr (requires {
                  { robot.keeps_reserve(s) } -> std::same_as<bool>;
                })
    return (kAnswersProven<R> || robot.within_limits(s)) && robot.keeps_reserve(s);
  return robot.within_limits(s);
}

// How many of the state's first components move by themselves; a robot may say.
template <RobotModel R>
int leading_size(const R& robot) {
  if constexpr (requires {
                  { robot.leading_size() } -> std::same_as<int>;
                })
    return robot.leading_size();
  return robot.state_size();
}

// Bodies i and j are tested against each other when |i - j| is at least this; a robot may say otherwise.
template <RobotModel R>
int self_collision_gap(const R& robot) {
  if constexpr (requires {
                  { robot.self_collision_gap() } -> std::same_as<int>;
                })
    return robot.self_collision_gap();
  return 2;
}

// Whether its functions compute floats as written; a robot may say.
template <RobotModel R>
bool exact(const R& robot) {
  if constexpr (requires {
                  { robot.exact() } -> std::same_as<bool>;
                })
    return robot.exact();
  return true;
}

// Whether the dimensions and limits can be used; a robot may say.
template <RobotModel R>
bool sound(const R& robot) {
  if constexpr (requires {
                  { robot.sound() } -> std::same_as<bool>;
                })
    return robot.sound();
  return true;
}

// What can be said of a whole robot's step at little cost. Where it suffices nobody asks for more.
struct QuickBound {
  bool limits_kept = false;  // whether its limits are proven to hold throughout; the rest counts only then
  float separation = 0.0F;   // between the origins of two bodies that are tested against each other, metres
  Travel most = {};          // no body's is more
};

// A robot may say.
template <RobotModel R>
QuickBound quick_bound(const R& robot, StateView s, ControlView u, float dt, StateView next) {
  if constexpr (requires {
                  { robot.quick_bound(s, u, dt, next) } -> std::same_as<QuickBound>;
                })
    return robot.quick_bound(s, u, dt, next);
  return {};
}

// How fast the dynamics can change within a time step of dt seconds, 1/s; a robot may say.
template <RobotModel R>
float fastest_rate(const R& robot, float dt) {
  if constexpr (requires {
                  { robot.fastest_rate(dt) } -> std::same_as<float>;
                })
    return robot.fastest_rate(dt);
  return 0.0F;
}

// Whether the robot says how fast it moves in a state.
template <class R>
inline constexpr bool kHasSpeed = requires(const R& robot, StateView s) {
  { robot.speed(s) } -> std::same_as<float>;
};

// How fast it moves in a state, m/s; 0 where it does not say.
template <RobotModel R>
float speed_of(const R& robot, StateView s) {
  if constexpr (kHasSpeed<R>) return robot.speed(s);
  return 0.0F;
}

// How far ahead, along body 0, braking would end, metres; a robot may say.
template <RobotModel R>
float stopping_way(const R& robot, StateView s) {
  if constexpr (requires {
                  { robot.stopping_way(s) } -> std::same_as<float>;
                })
    return robot.stopping_way(s);
  return 0.0F;
}

// Metres, of the sharpest turn that the robot drives for long; a robot may say, and else it is `length`.
template <RobotModel R>
float turning_radius(const R& robot, float length) {
  if constexpr (requires {
                  { robot.turning_radius() } -> std::same_as<float>;
                })
    return robot.turning_radius();
  return length;
}

// m/s, straight ahead; a robot may say, and else it is `length` metres a second.
template <RobotModel R>
float top_speed(const R& robot, float length) {
  if constexpr (requires {
                  { robot.top_speed() } -> std::same_as<float>;
                })
    return robot.top_speed();
  return length;
}

// Writes the state in which the robot stands still, its bodies but the first turned as `count` angles say, or as the
// first where there are none. False, and nothing is written, where it has no such function or another number of bodies.
template <RobotModel R>
bool rest(const R& robot, Vec2 position, float heading, const float* angles, std::uint32_t count, float* s) {
  if constexpr (requires { robot.rest(position, heading, angles, s); }) {
    const auto followers = static_cast<std::uint32_t>(robot.body_count() - 1);
    const bool straight = count == 0 || followers == 0;
    if (!straight && count != followers) return false;
    robot.rest(position, heading, straight ? nullptr : angles, s);
    return true;
  } else if constexpr (requires { robot.rest(position, heading, s); }) {
    robot.rest(position, heading, s);
    return true;
  }
  return false;
}

// Whether the robot can drive backwards; a robot may say.
template <RobotModel R>
bool reversible(const R& robot) {
  if constexpr (requires {
                  { robot.reversible() } -> std::same_as<bool>;
                })
    return robot.reversible();
  return false;
}

}  // namespace krait
