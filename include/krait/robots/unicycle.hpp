// SPDX-License-Identifier: Apache-2.0
/// \file
/// First-order unicycle: state (x, y, theta), control (speed, turn rate).
#pragma once

#include "krait/robots/fields.hpp"
#include "krait/robots/planar.hpp"

namespace krait {

/// Metres, radians, seconds; all numbers finite.
struct UnicycleParameters {
  float body_length = 0.5F;    ///< metres, > 0
  float body_width = 0.4F;     ///< metres, > 0
  float max_speed = 1.0F;      ///< m/s, > 0
  float min_speed = -1.0F;     ///< m/s, <= max_speed; below 0 it may reverse, above 0 it never stands still
  float max_turn_rate = 2.0F;  ///< rad/s, > 0, either way

  /// Calls see(field) for each of them, in their order. Costs these calls.
  template <class See>
  static constexpr void describe(const See& see) {
    using P = UnicycleParameters;
    see(length_field("body_length", &P::body_length));
    see(length_field("body_width", &P::body_width));
    see(limit_field("max_speed", &P::max_speed, "metres a second"));
    see(ParameterField<P, float>{"min_speed", &P::min_speed, "metres a second", -kMostLimit, kMostLimit});
    see(limit_field("max_turn_rate", &P::max_turn_rate, "radians a second"));
  }
};

/// A unicycle, whose speed and turn rate change at once. It owns its parameters. Its members are those that RobotModel
/// describes; each is O(1).
class Unicycle : public PlanarBody {
 public:
  using Parameters = UnicycleParameters;                                  ///< what its constructor copies
  static constexpr int kMaxState = 3;                                     ///< floats of a state
  static constexpr int kMaxControl = 2;                                   ///< floats of a control
  static constexpr const char* kStateNames[] = {"x", "y", "theta"};       ///< of a state's components
  static constexpr const char* kControlNames[] = {"speed", "turn_rate"};  ///< of a control's components

  /// Copies the parameters; sound() says whether they can be used.
  explicit Unicycle(const UnicycleParameters& parameters)
      : PlanarBody(parameters.body_length, parameters.body_width), parameters_(parameters) {}

  const UnicycleParameters& parameters() const { return parameters_; }  ///< its own copy
  int state_size() const { return 3; }                                  ///< floats: x y theta; metres, radians
  int control_size() const { return 2; }                                ///< floats: m/s, rad/s
  bool reversible() const { return parameters_.min_speed < 0.0F; }      ///< whether it can drive backwards
  bool sound() const;                                                   ///< whether every parameter is in its range

  /// Writes state_size() floats. Metres, radians.
  void rest(Vec2 position, float heading, float* state) const { stand(position, heading, state_size(), state); }

  /// Rolls along its heading and turns, as the control says.
  void derivative(StateView s, ControlView u, StateRef ds) const {
    const SinCos heading = math::sin_cos(s[2]);
    ds[0] = u[0] * heading.cos;
    ds[1] = u[0] * heading.sin;
    ds[2] = u[1];
  }
  /// Turns on the spot, or, where it must always move, at its least speed, until the target lies ahead; then drives,
  /// the more slowly the further the target lies to the side.
  void steer(StateView s, const Target& target, Steering& steering, ControlRef u) const;
  /// Brings it back to its reference's line within some body lengths.
  void track(StateView s, StateView reference, float dt, ControlRef u) const;
  /// Metres: 0, since it turns on the spot; where it must always move, the radius at its least speed and largest turn
  /// rate.
  float turning_radius() const {
    return parameters_.min_speed > 0.0F ? parameters_.min_speed / parameters_.max_turn_rate : 0.0F;
  }
  float top_speed() const { return parameters_.max_speed; }  ///< m/s
  /// Whether position and heading are finite and the heading is at most kMaxAngle either way. The state has no speed:
  /// the robot stands still as soon as no control is held.
  bool within_limits(StateView s) const;
  /// Bounds the body's motion by the control alone; always true.
  bool travel(StateView s, ControlView u, float dt, StateView next, Travel* travel) const;
  /// 1/s: half the largest turn rate. A Runge-Kutta step has the heading exactly; only the position has an error, in
  /// proportion to the fourth power of the turn in that step.
  float fastest_rate(float) const { return 0.5F * parameters_.max_turn_rate; }
  /// The extremes of its motion.
  Extremes extremes() const {
    const UnicycleParameters& p = parameters_;
    return {detail::fastest(p), p.max_turn_rate, 0.0F};
  }
  /// Writes the control of top speed and the sharpest turn to the left. The state has neither, and is not written.
  void turn_fastest(float*, float* control) const {
    control[0] = parameters_.max_speed;
    control[1] = parameters_.max_turn_rate;
  }

 private:
  UnicycleParameters parameters_;
};

/// The library does not check its results.
template <>
inline constexpr bool kAnswersProven<Unicycle> = true;
/// It turns on the spot.
template <>
inline constexpr bool kParks<Unicycle> = false;

// Compiled in the library, with its arithmetic.
extern template class detail::FunctionsOf<Unicycle>;

}  // namespace krait
