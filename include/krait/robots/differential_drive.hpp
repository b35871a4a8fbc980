// SPDX-License-Identifier: Apache-2.0
/// \file
/// Differential drive: state (x, y, theta, left and right wheel speed), control their accelerations.
#pragma once

#include "krait/robots/fields.hpp"
#include "krait/robots/planar.hpp"

namespace krait {

/// Metres, radians, seconds; all numbers finite.
struct DifferentialDriveParameters {
  float body_length = 0.5F;              ///< metres, > 0
  float body_width = 0.4F;               ///< metres, > 0
  float wheel_radius = 0.08F;            ///< metres, > 0
  float track_width = 0.36F;             ///< metres, > 0, between the wheels
  float max_wheel_speed = 12.0F;         ///< rad/s, > 0, both ways
  float max_wheel_acceleration = 24.0F;  ///< rad/s^2, > 0

  /// Calls see(field) for each of them, in their order. Costs these calls.
  template <class See>
  static constexpr void describe(const See& see) {
    using P = DifferentialDriveParameters;
    see(length_field("body_length", &P::body_length));
    see(length_field("body_width", &P::body_width));
    see(length_field("wheel_radius", &P::wheel_radius));
    see(length_field("track_width", &P::track_width));
    see(limit_field("max_wheel_speed", &P::max_wheel_speed, "radians a second"));
    see(limit_field("max_wheel_acceleration", &P::max_wheel_acceleration, "radians a second squared"));
  }
};

/// Two driven wheels on an axle, each with an acceleration of its own. It owns its parameters. Its members are those
/// that RobotModel describes; each is O(1).
class DifferentialDrive : public PlanarBody {
 public:
  using Parameters = DifferentialDriveParameters;                                     ///< what its constructor copies
  static constexpr int kMaxState = 5;                                                 ///< floats of a state
  static constexpr int kMaxControl = 2;                                               ///< floats of a control
  static constexpr const char* kStateNames[] = {"x", "y", "theta", "left", "right"};  ///< of a state's components
  static constexpr const char* kControlNames[] = {"left_acceleration",
                                                  "right_acceleration"};  ///< of a control's components

  /// Copies the parameters; sound() says whether they can be used.
  explicit DifferentialDrive(const DifferentialDriveParameters& parameters)
      : PlanarBody(parameters.body_length, parameters.body_width), parameters_(parameters) {}

  const DifferentialDriveParameters& parameters() const { return parameters_; }  ///< its own copy
  int state_size() const { return 5; }      ///< floats: x y theta left right; metres, radians, rad/s of the wheels
  int control_size() const { return 2; }    ///< floats: rad/s^2 of the left and the right wheel
  bool reversible() const { return true; }  ///< it can drive backwards
  bool sound() const;                       ///< whether every parameter is in its range

  /// Writes state_size() floats. Metres, radians.
  void rest(Vec2 position, float heading, float* state) const { stand(position, heading, state_size(), state); }

  /// Rolls without slip, as its wheels turn.
  void derivative(StateView s, ControlView u, StateRef ds) const {
    const SinCos heading = math::sin_cos(s[2]);
    const float speed = 0.5F * parameters_.wheel_radius * (s[3] + s[4]);
    ds[0] = speed * heading.cos;
    ds[1] = speed * heading.sin;
    ds[2] = parameters_.wheel_radius * (s[4] - s[3]) / parameters_.track_width;
    ds[3] = u[0];
    ds[4] = u[1];
  }
  /// Computes a speed and a turn rate toward the target, and from them the wheels' speeds. Where a wheel would be too
  /// fast, the speed is reduced and the turn rate is kept. The robot turns no faster than it can stop turning when it
  /// faces the target.
  void steer(StateView s, const Target& target, Steering& steering, ControlRef u) const;
  /// Brings it back to its reference's line within some body lengths.
  void track(StateView s, StateView reference, float dt, ControlRef u) const;
  /// m/s: the speed of the faster wheel's rim.
  float speed(StateView s) const {
    const float left = math::absolute(s[3]);
    const float right = math::absolute(s[4]);
    return parameters_.wheel_radius * (left > right ? left : right);
  }
  /// Metres, negative backwards: the mean of how far the two wheels roll until they stop, each as soon as it can.
  float stopping_way(StateView s) const;
  float turning_radius() const { return 0.0F; }  ///< metres: it turns on the spot
  /// m/s, with both wheels at their top speed.
  float top_speed() const { return parameters_.wheel_radius * parameters_.max_wheel_speed; }
  /// Whether the wheels keep their top speed, and position and heading are finite and the heading is at most kMaxAngle
  /// either way.
  bool within_limits(StateView s) const;
  /// Bounds the body's motion by the larger of each wheel's speeds in s and in next; always true.
  bool travel(StateView s, ControlView u, float dt, StateView next, Travel* travel) const;
  /// 1/s: the larger of half the largest turn rate and the square root of half the largest angular acceleration, which
  /// counts only as far as the range of the wheels' speeds lets it last for a time step of dt.
  float fastest_rate(float dt) const;
  /// The extremes of its motion.
  Extremes extremes() const {
    return {top_speed(), 2.0F * top_speed() / parameters_.track_width,
            parameters_.wheel_radius * parameters_.max_wheel_acceleration};
  }
  /// Writes the wheels' speeds and the control of the sharpest turn to the left at top speed: one wheel stands still.
  void turn_fastest(float* state, float* control) const {
    state[3] = 0.0F;
    state[4] = parameters_.max_wheel_speed;
    control[0] = 0.0F;
    control[1] = 0.0F;
  }

 private:
  void approach(StateView s, const float* wanted, float share, float dt, ControlRef u) const;

  DifferentialDriveParameters parameters_;
};

/// The library does not check its results.
template <>
inline constexpr bool kAnswersProven<DifferentialDrive> = true;
/// It turns on the spot.
template <>
inline constexpr bool kParks<DifferentialDrive> = false;

// Compiled in the library, with its arithmetic.
extern template class detail::FunctionsOf<DifferentialDrive>;

}  // namespace krait
