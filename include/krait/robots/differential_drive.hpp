// SPDX-License-Identifier: Apache-2.0
// Differential drive: state (x, y, theta, left and right wheel speed), control their accelerations.
#pragma once

#include "krait/robots/planar.hpp"

namespace krait {

// Metres, radians, seconds.
struct DifferentialDriveParameters {
  float body_length = 0.5F;              // > 0
  float body_width = 0.4F;               // > 0
  float wheel_radius = 0.08F;            // > 0
  float track_width = 0.36F;             // > 0, between the wheels
  float max_wheel_speed = 12.0F;         // rad/s, > 0, both ways
  float max_wheel_acceleration = 24.0F;  // rad/s^2, > 0
};

class DifferentialDrive : public PlanarBody {
 public:
  static constexpr int kMaxState = 5;
  static constexpr int kMaxControl = 2;

  explicit DifferentialDrive(const DifferentialDriveParameters& parameters)
      : PlanarBody(parameters.body_length, parameters.body_width), parameters_(parameters) {}

  const DifferentialDriveParameters& parameters() const { return parameters_; }
  int state_size() const { return 5; }
  int control_size() const { return 2; }
  bool reversible() const { return true; }
  bool sound() const;

  // Writes state_size() floats.
  void rest(Vec2 position, float heading, float* state) const {
    state[0] = position.x;
    state[1] = position.y;
    state[2] = heading;
    state[3] = 0.0F;
    state[4] = 0.0F;
  }

  void derivative(StateView s, ControlView u, StateRef ds) const {
    const SinCos heading = math::sin_cos(s[2]);
    const float speed = 0.5F * parameters_.wheel_radius * (s[3] + s[4]);
    ds[0] = speed * heading.cos;
    ds[1] = speed * heading.sin;
    ds[2] = parameters_.wheel_radius * (s[4] - s[3]) / parameters_.track_width;
    ds[3] = u[0];
    ds[4] = u[1];
  }
  void steer(StateView s, const Target& target, Steering& steering, ControlRef u) const;
  void track(StateView s, StateView reference, float dt, ControlRef u) const;
  // Of the faster wheel's rim.
  float speed(StateView s) const {
    const float left = math::absolute(s[3]);
    const float right = math::absolute(s[4]);
    return parameters_.wheel_radius * (left > right ? left : right);
  }
  float stopping_way(StateView s) const;
  float turning_radius() const { return 0.0F; }
  float top_speed() const { return parameters_.wheel_radius * parameters_.max_wheel_speed; }
  bool within_limits(StateView s) const;
  bool travel(StateView s, ControlView u, float dt, StateView next, Travel* travel) const;
  // 1/s: half the largest turn rate, or the root of half the largest angular acceleration, as much of it as a time step
  // of dt has room for.
  float fastest_rate(float dt) const;

 private:
  void approach(StateView s, const float* wanted, float dt, ControlRef u) const;

  DifferentialDriveParameters parameters_;
};

template <>
inline constexpr bool kAnswersProven<DifferentialDrive> = true;

// Compiled in the library, with its arithmetic.
extern template class detail::FunctionsOf<DifferentialDrive>;

}  // namespace krait
