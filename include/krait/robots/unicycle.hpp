// SPDX-License-Identifier: Apache-2.0
// First-order unicycle: state (x, y, theta), control (speed, turn rate).
#pragma once

#include "krait/robots/planar.hpp"

namespace krait {

// Metres, radians, seconds.
struct UnicycleParameters {
  float body_length = 0.5F;    // > 0
  float body_width = 0.4F;     // > 0
  float max_speed = 1.0F;      // > 0
  float min_speed = -1.0F;     // <= 0
  float max_turn_rate = 2.0F;  // > 0
};

class Unicycle : public PlanarBody {
 public:
  static constexpr int kMaxState = 3;
  static constexpr int kMaxControl = 2;

  explicit Unicycle(const UnicycleParameters& parameters)
      : PlanarBody(parameters.body_length, parameters.body_width), parameters_(parameters) {}

  const UnicycleParameters& parameters() const { return parameters_; }
  int state_size() const { return 3; }
  int control_size() const { return 2; }
  bool reversible() const { return parameters_.min_speed < 0.0F; }
  bool sound() const;

  // Writes state_size() floats.
  void rest(Vec2 position, float heading, float* state) const {
    state[0] = position.x;
    state[1] = position.y;
    state[2] = heading;
  }

  void derivative(StateView s, ControlView u, StateRef ds) const {
    const SinCos heading = math::sin_cos(s[2]);
    ds[0] = u[0] * heading.cos;
    ds[1] = u[0] * heading.sin;
    ds[2] = u[1];
  }
  void steer(StateView s, const Target& target, Steering& steering, ControlRef u) const;
  void track(StateView s, StateView reference, float dt, ControlRef u) const;
  float turning_radius() const { return 0.0F; }
  float top_speed() const { return parameters_.max_speed; }
  // It is at rest where its controls end: its state has no speed.
  bool within_limits(StateView s) const;
  bool travel(StateView s, ControlView u, float dt, StateView next, Travel* travel) const;
  // 1/s: half the largest turn rate; the position alone has an error, of four orders above that of a chain.
  float fastest_rate(float) const { return 0.5F * parameters_.max_turn_rate; }

 private:
  UnicycleParameters parameters_;
};

template <>
inline constexpr bool kAnswersProven<Unicycle> = true;

// Compiled in the library, with its arithmetic.
extern template class detail::FunctionsOf<Unicycle>;

}  // namespace krait
