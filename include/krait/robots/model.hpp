// SPDX-License-Identifier: Apache-2.0
/// \file
/// What the planner requires of a robot: a class of pure functions over its state and control vectors.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <cstdint>

#include "krait/geometry.hpp"
#include "krait/parameters.hpp"

#if defined(EIGEN_VECTORIZE)
#error "krait: build with -DEIGEN_DONT_VECTORIZE: vectors of floats add up in another order"
#endif

namespace krait {

// States and controls are float vectors of the robot's run-time size, viewed in place: none of these owns its floats.
// State components 0 and 1 are the position (x, y) in metres.
using StateView = Eigen::Map<const Eigen::VectorXf>;    ///< a state that is read; components 0 and 1 are metres
using StateRef = Eigen::Map<Eigen::VectorXf>;           ///< a state that is written; components 0 and 1 are metres
using ControlView = Eigen::Map<const Eigen::VectorXf>;  ///< a control that is read
using ControlRef = Eigen::Map<Eigen::VectorXf>;         ///< a control that is written

inline constexpr int kMaxState = 32;   ///< the most components of a state, of any robot
inline constexpr int kMaxControl = 8;  ///< the most components of a control, of any robot
inline constexpr int kMaxBodies = 32;  ///< the most bodies, of any robot

/// Metres: components 0 and 1 of a state. O(1).
inline Vec2 position(const StateView& state) { return {state[0], state[1]}; }

/// Where an expansion steers to.
struct Target {
  Vec2 point = {};     ///< local metres
  float speed = 1.0F;  ///< share of the robot's top speed in (0, 1]; in [-1, 0): of its top speed backwards; 0: to rest
  float dt = Parameters().dt;  ///< seconds that the control will be held
  float turn = 1.0F;           ///< share of its sharpest turn in (0, 1]: it turns no sharper; a model may ignore it
};

/// Bounds on how a body moves during a step. A point of it that is r metres from its frame's origin travels at most
/// path + r turn, and is never further than bend + r twist from the straight line between its places at the step's
/// ends. With accelerations of at most A and angular ones of at most W, bend = A dt^2 / 8 and twist = (W +
/// (turn / dt)^2) dt^2 / 8; path / 2 and turn / 2 are always right. All are 0 or more.
struct Travel {
  float path;   ///< metres, of the frame's origin
  float turn;   ///< radians
  float bend;   ///< metres, of the frame's origin
  float twist;  ///< radians
};

/// A cheap bound on one step of the whole robot; travel is called only where it does not suffice.
struct QuickBound {
  bool limits_kept = false;  ///< whether its limits are proven to hold throughout; the rest counts only then
  float separation = 0.0F;   ///< metres, not NaN: a lower bound of the distance between the origins of two bodies that
                             ///< are tested against each other
  Travel most = {};          ///< no body's travel is more
};

/// The most that a body does at any time of a step, none of it below 0.
struct BodyRates {
  float speed;              ///< m/s, of the frame's origin
  float turn;               ///< rad/s
  float acceleration;       ///< m/s^2, of the frame's origin
  float turn_acceleration;  ///< rad/s^2
};

/// The gains of a PID controller in discrete time, finite, in units of its output for the error's unit.
struct PidGains {
  float proportional;  ///< output for an error of one unit
  float integral;      ///< output for an error of 1 that has lasted a second
  float derivative;    ///< output for an error that grows by 1 a second
};

/// A PID controller in discrete time. It remembers the sum of the errors and the last error.
class Pid {
 public:
  /// The output for an error held over dt seconds, dt > 0. O(1).
  float operator()(const PidGains& gains, float error, float dt) {
    KRAIT_ASSERT(dt > 0.0F);
    sum_ = sum_ + error * dt;
    const float slope = fresh_ ? 0.0F : (error - last_) / dt;
    last_ = error;
    fresh_ = false;
    return gains.proportional * error + gains.integral * sum_ + gains.derivative * slope;
  }

 private:
  float sum_ = 0.0F;
  float last_ = 0.0F;
  bool fresh_ = true;
};

/// The controller's memory; fresh at the start of an expansion.
struct Steering {
  Pid heading;  ///< for a heading's error, radians
  Pid speed;    ///< for a speed's error, m/s
};

/// A robot that bounds its motion by Travel.
template <class R>
concept StatesTravel = requires(const R& robot, StateView s, ControlView u, float dt, Travel* travel) {
  { robot.travel(s, u, dt, s, travel) } -> std::same_as<bool>;
};
/// A robot that bounds its motion by BodyRates.
template <class R>
concept StatesRates = requires(const R& robot, StateView s, ControlView u, float dt, BodyRates* rates) {
  { robot.rates(s, u, dt, s, rates) } -> std::same_as<bool>;
};

/// A robot is a value with these members, none of which has side effects or depends on anything but its arguments;
/// check_robot (krait/robot_check.hpp) reports where one breaks what is said here. Arrays are the caller's: states have
/// state_size() floats, controls control_size(), poses, travel and rates one element a body.
/// - `kMaxState`, `kMaxControl`, `kMaxBodies`: compile-time limits of the sizes below, at most krait::kMaxState and so
///   on
/// - `state_size()`, `control_size()`, `body_count()`: at least 2, 1 and 1; the same at every call
/// - `derivative(s, u, ds)`: the dynamics ds = f(s, u) (Eqn 2), in units of the state a second. Called most often
/// - `steer(s, target, steering, u)`: the control that steers s toward the target, inside its limits and such that a
///   step of target.dt keeps the state inside its own. Called once a time step
/// - `within_limits(s)`: speeds, steering and hitch angles are valid
/// - `body(k)`: strictly convex polygon of 3 to 8 vertices, counter-clockwise, in body k's frame, metres: within 100 m,
///   no side shorter than 0.1 mm. The vertices are the robot's and stay where they are
/// - `place(s, poses)`: writes the frame of every body; body 0's origin is the position
/// - `travel(s, u, dt, next, travel)`: writes bounds on every body's motion while u is held for dt seconds from s to
///   next, which prove that no obstacle is jumped over. Returns false when the limits, which hold in s and next, are
///   not proven to hold in between; it writes the bounds in either case
/// - `rates(s, u, dt, next, rates)`: replaces travel where the robot has none: writes the BodyRates of every body while
///   u is held for dt seconds from s to next, and returns what travel returns
///
/// The following members are optional. A function that has one of these names, but is not const or has other arguments
/// or another result, does not compile, since it would never be called. A deleted function counts as absent:
/// - `sound()`: whether its dimensions and limits can be used; init refuses the robot as bad_robot where they cannot.
///   Without it, they count as usable
/// - `reversible()`: whether it can drive backwards, at a target's speed below 0. Without it, it cannot
/// - `backing_body()`: 0 to body_count() - 1: the body whose origin steer brings to the target's point when it drives
///   backwards, as the last of the trailers that a truck pushes. Without it, body 0. The last metres to a pose are
///   driven backwards by a robot of several bodies only where it is not 0
/// - `self_collision_gap()`: at least 1: bodies i and j are tested against each other where |i - j| is at least this.
///   Without it, 2
/// - `speed(s)`: m/s, at least 0: how fast it moves in s, 0 at rest. A plan then ends at rest, or as slow as
///   Parameters::end_speed requires: steer with a target whose speed is 0 must decrease it at every step until it is 0.
///   Without it a plan ends at any speed
/// - `stopping_way(s)`: metres along body 0's x axis, negative backwards: how far from the position it comes to rest,
///   roughly, when it brakes in s. Used to know where it pays to brake for the goal; without it, 0
/// - `turning_radius()`: metres, at least 0: the radius of the sharpest turn that it can drive forwards for long; 0: it
///   turns on the spot, at any target speed above 0 toward a point that it does not face. Used to find the way to a
///   pose; without it, the length of body 0
/// - `top_speed()`: m/s, above 0: the speed of the position, straight ahead at a target's speed of 1. Used to come to
///   rest at a pose; without it, one length of body 0 a second
/// - `fastest_rate(dt)`: 1/s, at least 0: Runge-Kutta steps of at most 0.32 / fastest_rate(dt) seconds end within 0.5
///   mm and 0.5 mrad of where derivative leads, whatever state and control the limits allow in a time step of dt.
///   Without it, every time step counts as short enough
/// - `track(s, reference, dt, u)`: changes u, the control of the state `reference` that s is very near to, to the one
///   that brings s back to the motion of the reference within some time steps of dt, inside the limits as steer's.
///   Without it, u stays, and a plan's error grows with its length
/// - `carry_errors(s, poses, u, dt, errors)`: `errors` estimates, for each component of s, its signed deviation from
///   where the plan's controls lead in exact arithmetic. Updates it over a step of dt under u, including the step's own
///   rounding, and returns in metres how far that can displace a body. The plan keeps that much more clearance; a way
///   on which an error passes 2e-3 is refused. Without it, errors count as covered by every plan's margin, which is
///   true unless the motion multiplies them, as when trailers are pushed
/// - `exact()`: whether its functions compute floats as written. Without it, as the file does that names the robot to
///   the planner. Sines, cosines and angles are those of krait/math.hpp: a C library's have other bits on another
///   machine, and so has the plan then; of these use sqrt at most
/// - `keeps_reserve(s)`: whether s is so far within the limits that a plan, which is driven a little beside the tree,
///   keeps them; without it, within_limits is all that the tree keeps
/// - `quick_bound(s, u, dt, next)`: a QuickBound of the same step as travel's, at less cost. Without it, only travel is
///   called
/// - `steer(s, poses, target, steering, u)`: the same control to the bit, from a state whose frames are known; called
///   instead of the other steer
/// - `leading_size()`: how many of the first components, the position among them, depend on no others; place and
///   derivative then also accept states of that many, and place writes body 0 only
/// - `Lead`, `integrate_lead(s, poses, u, dt, lead, d)`, `integrate_rest(s, poses, dt, lead, d)`: know the frames of s
///   and write to d, as many floats as s has, what a Runge-Kutta step of dt under u adds to s: that by derivative but
///   for rounding, at less cost; called instead of derivative throughout. First the leading components, which body 0 is
///   checked by, then the rest from what the first wrote to lead, a plain struct of at most 64 bytes. The first also
///   accepts states of leading_size()
/// - `rest(position, heading, s)`, or `rest(position, heading, angles, s)`: writes to s the state in which it stands
///   still there; `angles` has the headings of all bodies but the first, or is null where they are that of the first,
///   too
/// - `sketch(s, poses, u, dt)`: moves s, as far as steer looks at it, and the frames by dt under u, roughly; false
///   where that leaves the limits. Used to look ahead, instead of derivative
template <class R>
concept RobotModel = (StatesTravel<R> || StatesRates<R>)&&requires(const R& robot, StateView s, StateRef ds,
                                                                   ControlView u, ControlRef control,
                                                                   Steering& steering, const Target& target,
                                                                   Pose* poses, Travel* travel, float dt, int k) {
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
};

/// One that integrates its leading components first.
template <class R>
concept LeadingRobot = RobotModel<R> && requires(const R& robot, StateView s, const Pose* poses, ControlView u,
                                                 float dt, typename R::Lead& lead, float* d) {
  { robot.leading_size() } -> std::same_as<int>;
  {robot.integrate_lead(s, poses, u, dt, lead, d)};
  {robot.integrate_rest(s, poses, dt, lead, d)};
};

/// Whether the library may use the results of class R without checking them: within_limits rejects non-finite states;
/// for accepted states controls and frames are finite and bounds neither NaN nor negative; keeps_reserve implies
/// within_limits. Not inherited by classes that derive from R. True of the library's models, as tested.
template <class R>
inline constexpr bool kAnswersProven = false;

namespace detail {

// Whether a robot has the optional function, const and of that type: the others stand in detail/defaults.hpp.
template <class R>
concept HasReversible = requires(const R& robot) {
  { robot.reversible() } -> std::same_as<bool>;
};
template <class R>
concept HasBackingBody = requires(const R& robot) {
  { robot.backing_body() } -> std::same_as<int>;
};

}  // namespace detail

/// Whether the search drives robots of the class R into narrow places in reverse, and out of them: those with one body
/// that can drive backwards and do not turn on the spot. A program whose classes are all false does not contain the
/// code for it, 4 KB on a Cortex-M4F. False of each of the library's models (krait/robots/all.hpp) whose header says
/// so.
template <class R>
inline constexpr bool kParks = detail::HasReversible<R>;

/// Whether the search pushes the trailers of robots of the class R back to a pose: those whose backing_body is not 0. A
/// program whose classes are all false does not contain the code for it. Of the library's models as kParks.
template <class R>
inline constexpr bool kDocks = detail::HasBackingBody<R>;

}  // namespace krait
