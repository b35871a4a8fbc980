// SPDX-License-Identifier: Apache-2.0
/// \file
/// What snake, truck and car share: a car with steered front wheels that pulls N trailers, each hitched to the axle
/// before it. State (x, y, theta0, v, psi, theta1 … thetaN), control (acceleration, steering rate). Body 0's frame is
/// the rear axle, trailer i's its own axle, x forward.
#pragma once

#include <cstdint>

#include "krait/robots/detail/functions.hpp"
#include "krait/robots/fields.hpp"

namespace krait {

inline constexpr int kMaxTrailers = 25;  ///< the most that a robot of the library pulls

/// The parameters of a snake, a truck or a car. Metres, radians, seconds; all numbers finite.
struct ChainParameters {
  static constexpr float kMostSteering = 1.57F;  ///< radians: the most max_steering, a little below pi/2
  static constexpr float kMostHitch = kPi;       ///< radians: the most max_hitch_angle

  int trailers = 0;           ///< 0 … kMaxTrailers
  float body_length = 0.7F;   ///< metres, > 0
  float body_width = 0.5F;    ///< metres, > 0
  float body_offset = 0.0F;   ///< metres, any: of body 0's centre ahead of the rear axle
  float wheelbase = 0.8F;     ///< metres, > 0: rear axle to front axle
  float hitch_length = 0.8F;  ///< metres, > 0: axle to axle
  float max_speed = 2.5F;     ///< m/s, > 0: of v, the front wheels' speed
  float min_speed = 0.0F;     ///< m/s, <= 0: of v; below 0 the car may reverse
  float max_steering = 1.0F;  ///< radians, above 0, up to kMostSteering: the most of the steering angle psi, either way
  float max_acceleration = 5.0F;   ///< m/s^2, > 0, either way
  float max_steering_rate = 4.0F;  ///< rad/s, > 0, either way
  int self_collision_gap = 2;  ///< >= 1: bodies i and j are tested against each other where |i - j| is at least this
  float max_hitch_angle =
      1.5707963F;  ///< radians, above 0, up to kMostHitch: the most of theta(i-1) - theta(i), either way

  /// Calls see(field) for each of them, in their order. Costs these calls.
  template <class See>
  static constexpr void describe(const See& see) {
    using P = ChainParameters;
    see(ParameterField<P, int>{"trailers", &P::trailers});
    see(length_field("body_length", &P::body_length));
    see(length_field("body_width", &P::body_width));
    see(ParameterField<P, float>{"body_offset", &P::body_offset});
    see(length_field("wheelbase", &P::wheelbase));
    see(length_field("hitch_length", &P::hitch_length));
    see(limit_field("max_speed", &P::max_speed, "metres a second"));
    see(reverse_field("min_speed", &P::min_speed));
    see(ParameterField<P, float>{"max_steering", &P::max_steering, "radians", kLeastLimit, kMostSteering});
    see(limit_field("max_acceleration", &P::max_acceleration, "metres a second squared"));
    see(limit_field("max_steering_rate", &P::max_steering_rate, "radians a second"));
    see(ParameterField<P, int>{"self_collision_gap", &P::self_collision_gap, "bodies", 1, 1000});
    see(ParameterField<P, float>{"max_hitch_angle", &P::max_hitch_angle, "radians", kLeastLimit, kMostHitch});
  }
};

/// A car with steered front wheels and its trailers: what Snake, Truck and Car are. It owns its parameters and polygons
/// and allocates nothing: 2 KB. Its members are those that RobotModel describes; every function of a state is
/// O(trailers), except those of the car alone: steer, track, speed, stopping_way and integrate_lead, which are O(1).
class Chain {
 public:
  using Parameters = ChainParameters;  ///< what its constructor copies
  static constexpr int kCarState = 5;  ///< floats of the car's state, which moves as if it pulled nothing
  static constexpr int kMaxState = kCarState + kMaxTrailers;                         ///< floats of a state, at most
  static constexpr int kMaxControl = 2;                                              ///< floats of a control
  static constexpr const char* kStateNames[] = {"x", "y", "theta0", "v", "psi"};     ///< of the car's components
  static constexpr const char* kControlNames[] = {"acceleration", "steering_rate"};  ///< of a control's components
  static constexpr int kMaxBodies = 1 + kMaxTrailers;  ///< the car and its trailers, at most
  static constexpr float kTurnReserve = 1.1F;  ///< of a truck: the least radius of its turns over d sqrt(trailers), the
                                               ///< least that they follow by lemma 14 of lib/robot/CHAIN.md

  /// Copies the parameters. `slip`: whether the trailers are pulled with s = v (the paper's snake), or else with the
  /// rear axle's speed s = v cos psi. A number of trailers that is out of range becomes -1, which sound() refuses.
  /// Every body is a box of body_length by body_width until set_body. O(kMaxTrailers).
  Chain(const ChainParameters& parameters, bool slip);

  const ChainParameters& parameters() const { return parameters_; }          ///< its own copy
  int state_size() const { return kCarState + parameters_.trailers; }        ///< floats: x y theta0 v psi theta1 …
  int leading_size() const { return kCarState; }                             ///< floats of the car's part of a state
  int control_size() const { return 2; }                                     ///< floats: m/s^2 of v, rad/s of psi
  int body_count() const { return 1 + parameters_.trailers; }                ///< the car and its trailers
  int self_collision_gap() const { return parameters_.self_collision_gap; }  ///< of ChainParameters
  bool reversible() const { return parameters_.min_speed < 0.0F; }           ///< whether it can drive backwards
  bool sound() const;  ///< whether every parameter is in its range; O(1)

  /// Replaces the polygon of body k, 0 … kMaxTrailers: metres, 3 to 8 vertices, convex, counter-clockwise, in its
  /// frame; copied. Of a polygon with more vertices it keeps none of them, and init then refuses the robot as
  /// bad_robot.
  void set_body(int k, Polygon polygon);
  /// Body k's polygon, 0 … kMaxTrailers, in its frame; metres. The vertices are this robot's.
  Polygon body(int k) const {
    KRAIT_ASSERT(k >= 0 && k < kMaxBodies);
    return {bodies_[k].vertices, bodies_[k].count};
  }

  /// Standing straight and still: writes state_size() floats. Metres, radians; `angles`: one heading a trailer, or null
  /// for `heading`. O(trailers).
  void rest(Vec2 position, float heading, const float* angles, float* state) const;

  /// Steers body 0 toward the target's point by PID control, and its speed to the target's share of the top speed; a
  /// truck's trailers bound how far the wheels turn.
  void steer(StateView s, const Target& target, Steering& steering, ControlRef u) const;
  /// The same, knowing body 0's frame.
  void steer(StateView s, const Pose* poses, const Target& target, Steering& steering, ControlRef u) const;
  /// Brings the car back to its reference's line within half a dozen wheelbases. The trailers follow.
  void track(StateView s, StateView reference, float dt, ControlRef u) const;
  /// Updates the errors of the trailers' headings, radians, over dt seconds: they fade while trailers are pulled and
  /// grow while they are pushed. Returns in metres how far they can displace a body.
  float carry_errors(StateView s, const Pose* poses, ControlView u, float dt, float* errors) const;
  /// m/s, of the front wheels.
  float speed(StateView s) const { return math::absolute(s[3]); }
  /// Metres, negative backwards: how far the rear axle rolls until it stops, with the steering angle held.
  float stopping_way(StateView s) const;
  /// Metres: the radius of the sharpest turn that body 0 can drive for long. The lock of the wheels limits it, and the
  /// hitch of a snake or the trailers of a truck, which must be able to follow.
  float turning_radius() const;
  float top_speed() const { return parameters_.max_speed; }  ///< m/s
  /// Whether speed, steering and hitch angles keep their limits and the position is finite.
  bool within_limits(StateView s) const;
  /// Whether within_limits holds with 2 mrad to spare in every hitch angle.
  bool keeps_reserve(StateView s) const;
  /// Body 0's frame is the rear axle, trailer i's its own axle.
  void place(StateView s, Pose* poses) const;
  /// Bounds the motion of each body by the lemmas of lib/robot/CHAIN.md.
  bool travel(StateView s, ControlView u, float dt, StateView next, Travel* travel) const;
  /// The bounds of travel for all bodies alike, by lemmas 10 to 13 of lib/robot/CHAIN.md.
  QuickBound quick_bound(StateView s, ControlView u, float dt, StateView next) const;

  /// 1/s: the largest of v / a, the square root of (acceleration / a), and three quarters of the steering rate, where v
  /// is the largest speed, and a the shorter of wheelbase and hitch length, or the wheelbase if there are no trailers.
  /// Acceleration and steering rate count only as far as the range of the speed and that of the steering angle let them
  /// last for a time step of dt.
  float fastest_rate(float dt) const;
  /// The extremes of its motion: at full speed and lock.
  Extremes extremes() const {
    const ChainParameters& p = parameters_;
    const float speed = detail::fastest(p);
    const float lock = p.max_steering / p.wheelbase;
    const float pull = 1.0F / p.hitch_length;
    const float slip = 0.5F * p.max_steering * p.max_steering;
    return {speed * (1.0F + slip), speed * (lock > pull ? lock : pull), p.max_acceleration};
  }
  /// Writes the car's part of a state, and a control, of top speed and full lock to the left.
  void turn_fastest(float* state, float* control) const {
    state[3] = parameters_.max_speed;
    state[4] = parameters_.max_steering;
    control[0] = 0.0F;
    control[1] = 0.0F;
  }

  /// Eqn 1 with the hitch angle's sine as in LaValle, Planning Algorithms, 13.1.2.3: the trailers move with speed v if
  /// they slip, else with v cos psi.
  void derivative(StateView s, ControlView u, StateRef ds) const;

  /// A rough step. It moves all frames, but of the trailers' headings in s only the first.
  bool sketch(StateRef s, Pose* poses, ControlView u, float dt) const;

  /// What integrate_lead hands to integrate_rest: the motion of the body ahead, by stage of the Runge-Kutta step.
  struct Lead {
    static constexpr int kStages = 4;  ///< derivatives of a step
    float turn[kStages];               ///< radians, since the step began
    float pull[kStages];               ///< radians a second: its speed along its axis over the hitch length
    bool little;                       ///< whether no angle changes by more than kSmallAngle
  };
  /// What a Runge-Kutta step adds to the car's part of the state, and in `lead` what integrate_rest needs of it.
  void integrate_lead(StateView s, const Pose* poses, ControlView u, float dt, Lead& lead, float* d) const;
  /// What the same step adds to the trailers' headings, from what integrate_lead wrote to `lead`.
  void integrate_rest(StateView s, const Pose* poses, float dt, const Lead& lead, float* d) const;

 protected:
  /// Whether a target makes the car move backwards, or come to rest from it. O(1).
  static bool backs(StateView s, const Target& target) {
    return target.speed < 0.0F || (target.speed == 0.0F && s[3] < 0.0F);
  }

  /// Turns the wheels to psi, radians, within the lock and the target's share of it, and brings the speed to the
  /// target's. O(1).
  void turn_and_drive(StateView s, float psi, const Target& target, Steering& steering, ControlRef u) const;

  /// Brings speed, m/s, and steering angle, radians, as near to these as the limits allow in a time step of dt seconds.
  /// O(1).
  void approach(StateView s, float speed, float psi, float dt, ControlRef u) const;

 private:
  struct Body {
    Vec2 vertices[kMaxVertices] = {};
    int count = 0;
  };
  bool within(StateView s, float most_hitch) const;
  bool hitches_within(StateView s, float most) const;

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
