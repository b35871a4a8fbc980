// SPDX-License-Identifier: Apache-2.0
/// \file
/// First-order car with trailers: state (x, y, theta0, theta1 … thetaN), control (speed of the rear axle, steering
/// angle).
#pragma once

#include "krait/robots/chain.hpp"

namespace krait {

/// Metres, radians, seconds; all numbers finite.
struct KinematicTruckParameters {
  static constexpr float kMostSteering = 1.5F;  ///< radians: the most max_steering, whose tangent is 14
  static constexpr ChainParameters kChain{};    ///< whose defaults these have

  int trailers = kChain.trailers;            ///< 0 … kMaxTrailers
  float body_length = kChain.body_length;    ///< metres, > 0
  float body_width = kChain.body_width;      ///< metres, > 0
  float body_offset = kChain.body_offset;    ///< metres, any: of body 0's centre ahead of the rear axle
  float wheelbase = kChain.wheelbase;        ///< metres, > 0: rear axle to front axle
  float hitch_length = kChain.hitch_length;  ///< metres, > 0: axle to axle
  float max_speed = kChain.max_speed;        ///< m/s, > 0: of the rear axle
  float min_speed = kChain.min_speed;        ///< m/s, <= 0: of the rear axle; below 0 it may reverse
  /// Radians, above 0, up to kMostSteering: the most of the steering angle, either way.
  float max_steering = kChain.max_steering;
  /// >= 1: bodies i and j are tested against each other where |i - j| is at least this.
  int self_collision_gap = kChain.self_collision_gap;
  /// Radians, above 0, up to ChainParameters::kMostHitch: the most of theta(i-1) - theta(i).
  float max_hitch_angle = kChain.max_hitch_angle;

  /// Calls see(field) for each of them, in their order. Costs these calls.
  template <class See>
  static constexpr void describe(const See& see) {
    using P = KinematicTruckParameters;
    see(ParameterField<P, int>{"trailers", &P::trailers});
    see(length_field("body_length", &P::body_length));
    see(length_field("body_width", &P::body_width));
    see(ParameterField<P, float>{"body_offset", &P::body_offset});
    see(length_field("wheelbase", &P::wheelbase));
    see(length_field("hitch_length", &P::hitch_length));
    see(limit_field("max_speed", &P::max_speed, "metres a second"));
    see(reverse_field("min_speed", &P::min_speed));
    see(ParameterField<P, float>{"max_steering", &P::max_steering, "radians", kLeastLimit, kMostSteering});
    see(ParameterField<P, int>{"self_collision_gap", &P::self_collision_gap, "bodies", 1, 1000});
    see(ParameterField<P, float>{"max_hitch_angle", &P::max_hitch_angle, "radians", kLeastLimit,
                                 ChainParameters::kMostHitch});
  }
};

/// A car whose speed and steering angle change at once, and trailers that roll without slip. While a control is held,
/// it moves like a truck whose speed and steering angle are held, so a Chain computes its bodies, hitches and bounds.
/// It owns its parameters and polygons and allocates nothing: 2 KB. Its members are those that RobotModel describes;
/// every function of a state is O(trailers), except track, integrate_lead, and steer where it is passed the frames,
/// which are O(1).
class KinematicTruck {
 public:
  using Parameters = KinematicTruckParameters;                           ///< what its constructor copies
  static constexpr int kCarState = 3;                                    ///< floats of the car's state
  static constexpr int kMaxState = kCarState + kMaxTrailers;             ///< floats of a state, at most
  static constexpr int kMaxControl = 2;                                  ///< floats of a control
  static constexpr const char* kStateNames[] = {"x", "y", "theta0"};     ///< of the car's components
  static constexpr const char* kControlNames[] = {"speed", "steering"};  ///< of a control's components
  static constexpr int kMaxBodies = Chain::kMaxBodies;                   ///< the car and its trailers, at most
  using Lead = Chain::Lead;                                              ///< as of a Chain

  /// Copies the parameters; sound() says whether they can be used. A number of trailers that is out of range becomes
  /// -1, as in a Chain.
  explicit KinematicTruck(const KinematicTruckParameters& parameters);

  const KinematicTruckParameters& parameters() const { return parameters_; }  ///< its own copy
  int state_size() const { return kCarState + parameters_.trailers; }         ///< floats: x y theta0 theta1 …
  int leading_size() const { return kCarState; }                              ///< floats of the car's part of a state
  int control_size() const { return 2; }                                      ///< floats: m/s, radians
  int body_count() const { return truck_.body_count(); }                      ///< the car and its trailers
  int self_collision_gap() const { return parameters_.self_collision_gap; }   ///< of KinematicTruckParameters
  bool reversible() const { return parameters_.min_speed < 0.0F; }            ///< whether it can drive backwards
  bool sound() const;  ///< whether every parameter is in its range; O(1)

  /// Replaces the polygon of body k, 0 … kMaxTrailers: metres, 3 to 8 vertices, convex, counter-clockwise, in its
  /// frame; copied. Of a polygon with more vertices it keeps none of them, and init then refuses the robot as
  /// bad_robot.
  void set_body(int k, Polygon polygon) { truck_.set_body(k, polygon); }
  /// Body k's polygon, 0 … kMaxTrailers, in its frame; metres. The vertices are this robot's.
  Polygon body(int k) const { return truck_.body(k); }

  /// Standing straight: writes state_size() floats. Metres, radians; `angles`: one heading a trailer, or null for
  /// `heading`. O(trailers).
  void rest(Vec2 position, float heading, const float* angles, float* state) const;

  /// The last trailer, where the truck can drive backwards and pulls at most three; else the car. O(1).
  int backing_body() const;
  /// Steers body 0 toward the target's point, backwards the backing body; trailers bound how far the wheels turn.
  void steer(StateView s, const Target& target, Steering& steering, ControlRef u) const;
  /// The same, knowing the frames of all bodies.
  void steer(StateView s, const Pose* poses, const Target& target, Steering& steering, ControlRef u) const;
  /// Brings the car back to its reference's line within half a dozen wheelbases. The trailers follow; backwards it
  /// brings the backing body back to its line, and all hitches to the reference's.
  void track(StateView s, StateView reference, float dt, ControlRef u) const;
  /// Updates the errors of the trailers' headings over dt seconds; returns in metres how far they can displace a body
  /// (Chain::carry_errors).
  float carry_errors(StateView s, const Pose* poses, ControlView u, float dt, float* errors) const;
  /// Metres: the radius of the sharpest turn that body 0 can drive for long. The lock of the wheels limits it, and the
  /// trailers, which must be able to follow.
  float turning_radius() const { return truck_.turning_radius(); }
  float top_speed() const { return parameters_.max_speed; }  ///< m/s
  /// Whether the hitch angles keep their limit and the position is finite. The state has no speed: the robot stands
  /// still as soon as no control is held.
  bool within_limits(StateView s) const;
  /// Whether within_limits holds with 2 mrad to spare in every hitch angle.
  bool keeps_reserve(StateView s) const;
  /// Body 0's frame is the rear axle, trailer i's its own axle.
  void place(StateView s, Pose* poses) const;
  /// Bounds the motion of each body by the lemmas of lib/robot/CHAIN.md.
  bool travel(StateView s, ControlView u, float dt, StateView next, Travel* travel) const;
  /// The bounds of travel for all bodies alike, by lemmas 10 to 13 of lib/robot/CHAIN.md.
  QuickBound quick_bound(StateView s, ControlView u, float dt, StateView next) const;

  /// 1/s: the larger of the largest speed over the hitch length and half the turn rate at full speed and full lock.
  float fastest_rate(float dt) const;
  /// The extremes of its motion: at full speed and lock.
  Extremes extremes() const {
    const float turn = fastest() * lock_ / parameters_.wheelbase;
    const float pull = fastest() / parameters_.hitch_length;
    return {fastest(), turn > pull ? turn : pull, 0.0F};
  }
  /// Writes the control of top speed and full lock to the left. The state has neither, and is not written.
  void turn_fastest(float*, float* control) const {
    control[0] = parameters_.max_speed;
    control[1] = parameters_.max_steering;
  }

  /// The car rolls where its wheels point; the trailers follow as those of a truck.
  void derivative(StateView s, ControlView u, StateRef ds) const;

  /// A rough step. It moves all frames, but of the trailers' headings in s only the first.
  bool sketch(StateRef s, Pose* poses, ControlView u, float dt) const;

  /// What a Runge-Kutta step adds to the car's part of the state, and in `lead` what integrate_rest needs of it.
  void integrate_lead(StateView s, const Pose* poses, ControlView u, float dt, Lead& lead, float* d) const;
  /// What the same step adds to the trailers' headings, from what integrate_lead wrote to `lead`.
  void integrate_rest(StateView s, const Pose* poses, float dt, const Lead& lead, float* d) const;

 private:
  float steering_limit(StateView s, float heading_error, float speed) const;

  // Radians to be added to the steering angle, so that trailers which are pushed `way` metres come back to a reference.
  float pushing_change(StateView s, StateView reference, float way, float steering) const;

  float fastest() const { return detail::fastest(parameters_); }  // m/s

  KinematicTruckParameters parameters_;
  Chain truck_;  // that moves alike
  float lock_;   // the tangent of max_steering
};

/// The library does not check its results.
template <>
inline constexpr bool kAnswersProven<KinematicTruck> = true;

// Compiled in the library, with its arithmetic.
extern template class detail::FunctionsOf<KinematicTruck>;

}  // namespace krait
