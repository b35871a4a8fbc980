// SPDX-License-Identifier: Apache-2.0
// What snake, truck and car share: a car with steered front wheels that pulls N trailers, each hitched to the axle
// before it. State (x, y, theta0, v, psi, theta1 … thetaN), control (acceleration, steering rate). Body 0's frame is
// the rear axle, trailer i's its own axle, x forward.
#pragma once

#include <cstdint>

#include "krait/robots/functions.hpp"

namespace krait {

inline constexpr int kMaxTrailers = 25;

// Metres, radians, seconds.
struct ChainParameters {
  int trailers = 0;                    // 0 … kMaxTrailers
  float body_length = 0.7F;            // > 0
  float body_width = 0.5F;             // > 0
  float body_offset = 0.0F;            // of body 0's centre ahead of the rear axle
  float wheelbase = 0.8F;              // L > 0
  float hitch_length = 0.8F;           // d > 0, axle to axle
  float max_speed = 2.5F;              // of v, > 0
  float min_speed = 0.0F;              // of v, <= 0; below 0 the car may reverse
  float max_steering = 1.0F;           // |psi| <= this < pi/2
  float max_acceleration = 5.0F;       // > 0
  float max_steering_rate = 4.0F;      // > 0
  int self_collision_gap = 2;          // >= 1
  float max_hitch_angle = 1.5707963F;  // |theta(i-1) - theta(i)| <= this <= pi
};

class Chain {
 public:
  static constexpr int kCarState = 5;  // the car moves as if it pulled nothing
  static constexpr int kMaxState = kCarState + kMaxTrailers;
  static constexpr int kMaxControl = 2;
  static constexpr int kMaxBodies = 1 + kMaxTrailers;

  // How the trailers follow: `slip` with s = v (the paper's snake), else with the rear axle's speed s = v cos psi. A
  // number of trailers that is out of range becomes -1, which no size overflows by and sound() refuses.
  Chain(const ChainParameters& parameters, bool slip);

  const ChainParameters& parameters() const { return parameters_; }
  int state_size() const { return kCarState + parameters_.trailers; }
  int leading_size() const { return kCarState; }
  int control_size() const { return 2; }
  int body_count() const { return 1 + parameters_.trailers; }
  int self_collision_gap() const { return parameters_.self_collision_gap; }
  bool reversible() const { return parameters_.min_speed < 0.0F; }
  bool sound() const;

  // Replaces body k's polygon: 3 to 8 vertices, convex, counter-clockwise, in its frame; copied. Of more it keeps none,
  // which init refuses as bad_robot.
  void set_body(int k, Polygon polygon);
  Polygon body(int k) const { return {bodies_[k].vertices, bodies_[k].count}; }

  // Standing straight and still: writes state_size() floats. `angles`: trailer headings, or null for `heading`.
  void rest(Vec2 position, float heading, const float* angles, float* state) const;

  void steer(StateView s, const Target& target, Steering& steering, ControlRef u) const;
  void steer(StateView s, const Pose* poses, const Target& target, Steering& steering, ControlRef u) const;
  void track(StateView s, StateView reference, float dt, ControlRef u) const;
  // Errors of the trailers' headings: they fade while trailers are pulled and grow while they are pushed.
  float carry_errors(StateView s, const Pose* poses, ControlView u, float dt, float* errors) const;
  // Of the front wheels.
  float speed(StateView s) const { return math::absolute(s[3]); }
  float stopping_way(StateView s) const;
  // Of body 0: as far as the wheels steer, but no tighter than a snake's hitch or a truck's trailers follow.
  float turning_radius() const;
  float top_speed() const { return parameters_.max_speed; }
  bool within_limits(StateView s) const;
  // Whether also the hitch angles stay 2 mrad below their limit.
  bool keeps_reserve(StateView s) const;
  void place(StateView s, Pose* poses) const;
  bool travel(StateView s, ControlView u, float dt, StateView next, Travel* travel) const;
  QuickBound quick_bound(StateView s, ControlView u, float dt, StateView next) const;

  // 1/s: the largest of speed over the shorter of wheelbase and hitch, the root of acceleration over that, and three
  // quarters of the steering rate; as much of acceleration and steering rate as a time step of dt has room for.
  float fastest_rate(float dt) const;

  // Eqn 1 with the hitch angle's sine as in LaValle, Planning Algorithms, 13.1.2.3: the trailers move with speed v if
  // they slip, else with v cos psi.
  void derivative(StateView s, ControlView u, StateRef ds) const;

  // A rough step; of the trailers' headings in s it moves the first only.
  bool sketch(StateRef s, Pose* poses, ControlView u, float dt) const;

  // What the trailers' part of a Runge-Kutta step must know of the body ahead, by stage.
  struct Lead {
    static constexpr int kStages = 4;
    float turn[kStages];  // radians, since the step began
    float pull[kStages];  // radians a second: its speed along itself, by the hitch's length
    bool little;          // whether no angle changes by more than kSmallAngle
  };
  void integrate_lead(StateView s, const Pose* poses, ControlView u, float dt, Lead& lead, float* d) const;
  void integrate_rest(StateView s, const Pose* poses, float dt, const Lead& lead, float* d) const;

 private:
  struct Body {
    Vec2 vertices[kMaxVertices] = {};
    int count = 0;
  };
  bool within(StateView s, float most_hitch) const;
  bool hitches_within(StateView s, float most) const;
  void approach(StateView s, float speed, float psi, float dt, ControlRef u) const;

  // What the car does at a speed with its wheels turned so.
  struct CarRates {
    float speed;  // m/s, of the rear axle
    float turn;   // rad/s
    float pull;   // rad/s, on the first trailer: its speed by the hitch's length
  };
  CarRates car_rates(float speed, SinCos steering) const;

  bool changes_little(const float* s, const float* u, float dt) const;
  float separation(float hitch, float spread) const;
  float steering_limit(StateView s, float heading_error, float speed) const;

  ChainParameters parameters_;
  float least_hitch_cosine_;
  bool slip_;
  Body bodies_[kMaxBodies];
};

}  // namespace krait
