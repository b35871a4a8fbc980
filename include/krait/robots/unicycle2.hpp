// SPDX-License-Identifier: Apache-2.0
/// \file
/// Second-order unicycle: state (x, y, theta, speed, turn rate), control the accelerations of the two.
#pragma once

#include "krait/robots/fields.hpp"
#include "krait/robots/planar.hpp"

namespace krait {

/// Metres, radians, seconds; all numbers finite.
struct Unicycle2Parameters {
  float body_length = 0.5F;            ///< metres, > 0
  float body_width = 0.4F;             ///< metres, > 0
  float max_speed = 1.0F;              ///< m/s, > 0
  float min_speed = -1.0F;             ///< m/s, <= 0; below 0 it may reverse
  float max_turn_rate = 2.0F;          ///< rad/s, > 0, either way
  float max_acceleration = 2.0F;       ///< m/s^2, > 0, either way
  float max_turn_acceleration = 4.0F;  ///< rad/s^2, > 0, either way

  /// Calls see(field) for each of them, in their order. Costs these calls.
  template <class See>
  static constexpr void describe(const See& see) {
    using P = Unicycle2Parameters;
    see(length_field("body_length", &P::body_length));
    see(length_field("body_width", &P::body_width));
    see(limit_field("max_speed", &P::max_speed, "metres a second"));
    see(reverse_field("min_speed", &P::min_speed));
    see(limit_field("max_turn_rate", &P::max_turn_rate, "radians a second"));
    see(limit_field("max_acceleration", &P::max_acceleration, "metres a second squared"));
    see(limit_field("max_turn_acceleration", &P::max_turn_acceleration, "radians a second squared"));
  }
};

/// A unicycle whose speed and turn rate change at bounded rates. It owns its parameters. Its members are those that
/// RobotModel describes; each is O(1).
class Unicycle2 : public PlanarBody {
 public:
  using Parameters = Unicycle2Parameters;                                          ///< what its constructor copies
  static constexpr int kMaxState = 5;                                              ///< floats of a state
  static constexpr int kMaxControl = 2;                                            ///< floats of a control
  static constexpr const char* kStateNames[] = {"x", "y", "theta", "v", "omega"};  ///< of a state's components
  static constexpr const char* kControlNames[] = {"acceleration", "turn_acceleration"};  ///< of a control's components

  /// Copies the parameters; sound() says whether they can be used.
  explicit Unicycle2(const Unicycle2Parameters& parameters)
      : PlanarBody(parameters.body_length, parameters.body_width), parameters_(parameters) {}

  const Unicycle2Parameters& parameters() const { return parameters_; }  ///< its own copy
  int state_size() const { return 5; }                                   ///< floats: x y theta v omega; also m/s, rad/s
  int control_size() const { return 2; }                                 ///< floats: m/s^2, rad/s^2
  bool reversible() const { return parameters_.min_speed < 0.0F; }       ///< whether it can drive backwards
  bool sound() const;                                                    ///< whether every parameter is in its range

  /// Writes state_size() floats. Metres, radians.
  void rest(Vec2 position, float heading, float* state) const { stand(position, heading, state_size(), state); }

  /// Rolls along its heading and turns, both faster as the control says.
  void derivative(StateView s, ControlView u, StateRef ds) const {
    const SinCos heading = math::sin_cos(s[2]);
    ds[0] = s[3] * heading.cos;
    ds[1] = s[3] * heading.sin;
    ds[2] = s[4];
    ds[3] = u[0];
    ds[4] = u[1];
  }
  /// Turns no faster than it can stop turning when it faces the target. It drives the more slowly the further the
  /// target lies to the side, and turns on the spot where the target lies behind. Where Target::turn asks for less than
  /// the sharpest turn it drives on, the faster the less sharp the turn is.
  void steer(StateView s, const Target& target, Steering& steering, ControlRef u) const;
  /// Brings it back to its reference's line within some body lengths.
  void track(StateView s, StateView reference, float dt, ControlRef u) const;
  /// m/s: the speed of its position or, if larger, that of the ends of a body of its length that turns on the spot.
  float speed(StateView s) const {
    const float forward = math::absolute(s[3]);
    const float turning = 0.5F * parameters_.body_length * math::absolute(s[4]);
    return forward > turning ? forward : turning;
  }
  /// Metres, negative backwards: how far it rolls until its speed is 0, as if it did not turn.
  float stopping_way(StateView s) const;
  float turning_radius() const { return 0.0F; }              ///< metres: it turns on the spot
  float top_speed() const { return parameters_.max_speed; }  ///< m/s
  /// Whether speed and turn rate keep their limits, and position and heading are finite and the heading is at most
  /// kMaxAngle either way.
  bool within_limits(StateView s) const;
  /// Bounds the body's motion by speeds and turn rates at the step's ends; always true.
  bool travel(StateView s, ControlView u, float dt, StateView next, Travel* travel) const;
  /// 1/s: the larger of half the largest turn rate and the square root of half the largest turn acceleration; more
  /// where the speed changes faster than that. Accelerations count only as far as the ranges of turn rate and speed let
  /// them last for a time step of dt.
  float fastest_rate(float dt) const;
  /// The extremes of its motion.
  Extremes extremes() const {
    const Unicycle2Parameters& p = parameters_;
    return {detail::fastest(p), p.max_turn_rate, p.max_acceleration};
  }
  /// Writes the state of top speed and the sharpest turn to the left, and the control that keeps both.
  void turn_fastest(float* state, float* control) const {
    state[3] = parameters_.max_speed;
    state[4] = parameters_.max_turn_rate;
    control[0] = 0.0F;
    control[1] = 0.0F;
  }

 private:
  void approach(StateView s, float speed, float turn_rate, float share, float dt, ControlRef u) const;

  Unicycle2Parameters parameters_;
};

/// The library does not check its results.
template <>
inline constexpr bool kAnswersProven<Unicycle2> = true;
/// It turns on the spot.
template <>
inline constexpr bool kParks<Unicycle2> = false;

// Compiled in the library, with its arithmetic.
extern template class detail::FunctionsOf<Unicycle2>;

}  // namespace krait
