// SPDX-License-Identifier: Apache-2.0
/// \file
/// A robot of any model, as the planner sees it.
#pragma once

#include <concepts>

#include "krait/robots/detail/functions.hpp"

namespace krait {

/// A reference to a robot, which must outlive it; a default-constructed one refers to no robot. Every class that models
/// a robot converts to it. It reads the robot's sizes once, when it is made. It owns nothing, and copies refer to the
/// same robot.
///
/// States (s, next, reference, ds, d, errors) are arrays of state_size() floats, controls (u) of control_size(), poses,
/// travel and rates of one a body; all of them are the caller's. Each member costs a call through a pointer and what
/// the robot's own function of its name does, or what stands for it where the robot has none (RobotModel says which).
/// Of a Robot that refers to none, only its sizes, sizes_valid, sound and exact may be called.
class Robot {
 public:
  Robot() = default;  ///< refers to no robot: every size is 0
  /// Refers to `robot`, which must stay where it is. O(1).
  template <RobotModel R>
  Robot(const R& robot)  // NOLINT(google-explicit-constructor): a planner is made for any robot by its name
      : functions_(&detail::FunctionsOf<R>::kTable),
        self_(&robot),
        state_size_(robot.state_size()),
        control_size_(robot.control_size()),
        body_count_(robot.body_count()),
        leading_size_(detail::leading_size(robot)) {}
  template <RobotModel R>
  Robot(const R&&) = delete;  ///< would not outlive this

  int state_size() const { return state_size_; }      ///< floats of a state, 2 … kMaxState where sizes_valid()
  int leading_size() const { return leading_size_; }  ///< how many of the first components depend on no others
  int control_size() const { return control_size_; }  ///< floats of a control, 1 … kMaxControl where sizes_valid()
  int body_count() const { return body_count_; }      ///< 1 … kMaxBodies where sizes_valid()
  /// Bodies i and j are tested against each other where |i - j| is at least this.
  int self_collision_gap() const { return functions()->self_collision_gap(self_); }
  /// Whether dimensions and limits can be used; true where it refers to no robot.
  bool sound() const { return functions_ == nullptr || functions_->sound(self_); }
  /// Whether the robot can drive backwards.
  bool reversible() const { return functions()->reversible(self_); }
  /// The body that steer brings to the target's point when it drives backwards, 0 … body_count() - 1.
  int backing_body() const { return functions()->backing_body(self_); }
  /// Body k's outline in its own frame, 0 … body_count() - 1; metres. Its vertices are the robot's.
  Polygon body(int k) const {
    KRAIT_ASSERT(k >= 0 && k < body_count_);
    return functions()->body(self_, k);
  }

  /// Whether the sizes are within the model's, the backing body is one of the robot's, and self_collision_gap is 1 or
  /// more.
  bool sizes_valid() const {
    return functions_ != nullptr && state_size_ >= 2 && state_size_ <= functions_->max_state && control_size_ >= 1 &&
           control_size_ <= functions_->max_control && body_count_ >= 1 && body_count_ <= functions_->max_bodies &&
           backing_body() >= 0 && backing_body() < body_count_ && self_collision_gap() >= 1;
  }
  bool leads() const { return functions()->leads; }          ///< whether leading components are integrated first
  bool has_speed() const { return functions()->has_speed; }  ///< whether the robot has the function `speed`
  /// Whether the robot was compiled with the library's arithmetic.
  bool exact() const { return functions_ == nullptr || functions_->exact(self_); }
  const detail::Parking* parking() const { return functions()->parking; }  ///< the library's own; null where not kParks
  /// The library's own; null where not kParks.
  const detail::Departing* departing() const { return functions()->departing; }
  const detail::Docking* docking() const { return functions()->docking; }  ///< the library's own; null where not kDocks
  bool answers_proven() const { return functions()->answers_proven; }      ///< kAnswersProven of its class

  /// Writes the frame of every body in s.
  void place(const float* s, Pose* poses) const { functions()->place(self_, s, state_size_, poses); }
  /// Writes body 0's frame, by the leading components of s alone.
  void place_lead(const float* s, Pose* poses) const { functions()->place(self_, s, leading_size_, poses); }
  /// Writes the dynamics ds = f(s, u), in units of the state a second.
  void derivative(const float* s, const float* u, float* ds) const {
    functions()->derivative(self_, s, state_size_, u, ds);
  }
  /// Writes ds of the leading components, by them alone.
  void lead_rates(const float* s, const float* u, float* ds) const {
    functions()->derivative(self_, s, leading_size_, u, ds);
  }
  /// Writes to d what dt seconds under u add to those components of s that are integrated first: the leading ones, or
  /// all. `poses` are the frames in s; `lead` is filled for integrate_rest. Costs four derivatives at most.
  void integrate_lead(const float* s, const Pose* poses, const float* u, float dt, detail::Lead& lead, float* d) const {
    functions()->integrate_lead(self_, s, state_size_, poses, u, dt, lead, d);
  }
  /// The same for a state that has the leading components only; `poses` is body 0's frame.
  void integrate_lead_alone(const float* s, const Pose* poses, const float* u, float dt, detail::Lead& lead,
                            float* d) const {
    functions()->integrate_lead(self_, s, leading_size_, poses, u, dt, lead, d);
  }
  /// Writes to d what the same step adds to the components that integrate_lead does not integrate.
  void integrate_rest(const float* s, const Pose* poses, float dt, const detail::Lead& lead, float* d) const {
    if (functions()->leads) functions()->integrate_rest(self_, s, poses, dt, lead, d);
  }

  /// Writes the control that steers s, whose frames are `poses`, toward the target.
  void steer(const float* s, const Pose* poses, const Target& target, Steering& steering, float* u) const {
    functions()->steer(self_, s, poses, target, steering, u);
  }
  /// Changes u, the control of `reference`, which s is very near to, so that the robot comes back to the reference's
  /// motion within some time steps of dt seconds.
  void track(const float* s, const float* reference, float dt, float* u) const {
    functions()->track(self_, s, reference, dt, u);
  }
  /// Carries the errors of a state's components over a time step of dt seconds; returns the metres that a body may be
  /// off then.
  float carry_errors(const float* s, const Pose* poses, const float* u, float dt, float* errors) const {
    return functions()->carry_errors(self_, s, poses, u, dt, errors);
  }
  /// Whether s is within the robot's limits.
  bool within_limits(const float* s) const { return functions()->within_limits(self_, s); }
  /// Whether s is so far within the limits that the tree may keep it.
  bool keeps_reserve(const float* s) const { return functions()->keeps_reserve(self_, s); }
  /// Writes bounds on the motion of every body while u is held for dt seconds from s to next; returns false where the
  /// limits are not proven to hold in between.
  [[nodiscard]] bool travel(const float* s, const float* u, float dt, const float* next, Travel* travel) const {
    return functions()->travel(self_, s, u, dt, next, travel);
  }
  /// A cheap bound on the same step; one that proves nothing for a robot without that function.
  QuickBound quick_bound(const float* s, const float* u, float dt, const float* next) const {
    return functions()->quick_bound(self_, s, u, dt, next);
  }
  /// Moves s and its frames by dt seconds under u, roughly; false where that leaves the limits.
  [[nodiscard]] bool sketch(float* s, Pose* poses, const float* u, float dt) const {
    return functions()->sketch(self_, s, poses, u, dt);
  }
  /// 1/s: how fast the dynamics can change within a time step of dt seconds; 0 for a robot without that function.
  float fastest_rate(float dt) const { return functions()->fastest_rate(self_, dt); }
  /// m/s, at least 0; 0 for a robot without that function.
  float speed(const float* s) const { return functions()->speed(self_, s); }
  /// Metres along body 0's x axis, negative backwards; 0 for a robot without that function.
  float stopping_way(const float* s) const { return functions()->stopping_way(self_, s); }
  /// Metres: the radius of the sharpest turn that it can drive for long; `length` for a robot without that function.
  float turning_radius(float length) const { return functions()->turning_radius(self_, length); }
  /// m/s, straight ahead; `length` metres a second for a robot without that function.
  float top_speed(float length) const { return functions()->top_speed(self_, length); }
  /// Writes to s the state in which the robot stands still there: metres, radians. `angles` are the `count` headings of
  /// the bodies after the first; with count 0 all of them have `heading`. Returns false, and writes nothing, where the
  /// robot has no such function or another number of bodies.
  [[nodiscard]] bool rest(Vec2 position, float heading, const float* angles, std::uint32_t count, float* s) const {
    return functions()->rest(self_, position, heading, angles, count, s);
  }

 private:
  const detail::RobotFunctions* functions() const {
    KRAIT_ASSERT(functions_ != nullptr);
    return functions_;
  }

  const detail::RobotFunctions* functions_ = nullptr;
  const void* self_ = nullptr;
  int state_size_ = 0;
  int control_size_ = 0;
  int body_count_ = 0;
  int leading_size_ = 0;
};

}  // namespace krait
