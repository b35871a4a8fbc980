// What the planner asks of a robot: a class of pure functions over its state and control vectors.
#pragma once

#include <Eigen/Core>
#include <concepts>

#include "krait/math.hpp"
#include "krait/motion/pid.hpp"
#include "krait/scene/scene.hpp"

namespace krait {

// States and controls are float vectors of the robot's run-time size, viewed in place.
// State components 0 and 1 are the position (x, y) in metres.
using StateView = Eigen::Map<const Eigen::VectorXf>;
using StateRef = Eigen::Map<Eigen::VectorXf>;
using ControlView = Eigen::Map<const Eigen::VectorXf>;
using ControlRef = Eigen::Map<Eigen::VectorXf>;

inline Vec2 position(const StateView& state) { return {state[0], state[1]}; }

// A body's frame in the workspace.
struct Pose {
  Vec2 position;
  SinCos heading;
};

// Where an expansion steers to.
struct Target {
  Vec2 point;
  float speed = 1.0F;  // share of the robot's top speed in [0, 1]; in [-1, 0): of its top speed backwards
  float dt = 0.1F;     // seconds that the control will be held
};

// The controller's memory; fresh at the start of an expansion.
struct Steering {
  Pid heading;
  Pid speed;
};

// A robot is a value with these members, none of which has side effects or depends on anything but its arguments.
//   kMaxState, kMaxControl, kMaxBodies   compile-time limits of the sizes below
//   state_size(), control_size(), body_count()
//   derivative(s, u, ds)         the dynamics ds = f(s, u) (Eqn 2)
//   steer(s, target, steering, u)  the control that steers s toward the target, inside its limits and such
//                                that a step of target.dt keeps the state inside its own
//   within_limits(s)             speeds, steering and hitch angles are valid
//   body(k)                      convex polygon of 3 to 8 vertices, counter-clockwise, in body k's frame, metres
//   place(s, poses)              writes the frame of every body; body 0's origin is the position
//   travel(s, u, dt, k)          at least the path length, metres, of every point of body k while u is held
//                                for dt from s: what proves that nothing is jumped over between two states
template <class R>
concept Robot = requires(const R& robot, StateView s, StateRef ds, ControlView u, ControlRef control,
                         Steering& steering, const Target& target, Pose* poses, float dt, int k) {
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
  { robot.travel(s, u, dt, k) } -> std::same_as<float>;
};

// Bodies i and j are tested against each other when |i - j| is at least this; a robot may say otherwise.
template <Robot R>
int self_collision_gap(const R& robot) {
  if constexpr (requires {
                  { robot.self_collision_gap() } -> std::same_as<int>;
                })
    return robot.self_collision_gap();
  return 2;
}

// Whether the dimensions and limits can be used; a robot may say.
template <Robot R>
bool sound(const R& robot) {
  if constexpr (requires {
                  { robot.sound() } -> std::same_as<bool>;
                })
    return robot.sound();
  return true;
}

// Whether a step that holds u for dt from s to next, both within the limits, is proven to stay within them all the
// way; a robot may say. Without a word it does, as what is linear in time must.
template <Robot R>
bool keeps_limits(const R& robot, StateView s, ControlView u, float dt, StateView next) {
  if constexpr (requires {
                  { robot.keeps_limits(s, u, dt, next) } -> std::same_as<bool>;
                })
    return robot.keeps_limits(s, u, dt, next);
  return true;
}

// Whether the robot can drive backwards; a robot may say.
template <Robot R>
bool reversible(const R& robot) {
  if constexpr (requires {
                  { robot.reversible() } -> std::same_as<bool>;
                })
    return robot.reversible();
  return false;
}

}  // namespace krait
