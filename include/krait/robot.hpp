// SPDX-License-Identifier: Apache-2.0
// A robot of any model, as the planner sees it.
#pragma once

#include <concepts>

#include "krait/robots/functions.hpp"

namespace krait {

// Refers to a robot that must outlive it, or to none; made by whatever takes one from any robot. Its sizes are those at
// that time.
// What a member does is said of the one of its name in robots/model.hpp; states have state_size() floats, controls
// control_size().
class Robot {
 public:
  Robot() = default;
  template <RobotModel R>
  Robot(const R& robot)  // NOLINT(google-explicit-constructor): a planner is made for any robot by its name
      : functions_(&detail::FunctionsOf<R>::kTable),
        self_(&robot),
        state_size_(robot.state_size()),
        control_size_(robot.control_size()),
        body_count_(robot.body_count()),
        leading_size_(detail::leading_size(robot)) {}
  template <RobotModel R>
  Robot(const R&&) = delete;  // would not outlive this

  int state_size() const { return state_size_; }
  int leading_size() const { return leading_size_; }
  int control_size() const { return control_size_; }
  int body_count() const { return body_count_; }
  int self_collision_gap() const { return functions_->self_collision_gap(self_); }
  bool sound() const { return functions_ == nullptr || functions_->sound(self_); }
  bool reversible() const { return functions_->reversible(self_); }
  Polygon body(int k) const { return functions_->body(self_, k); }

  // Whether the sizes are within the model's.
  bool fits() const {
    return functions_ != nullptr && state_size_ >= 2 && state_size_ <= functions_->max_state && control_size_ >= 1 &&
           control_size_ <= functions_->max_control && body_count_ >= 1 && body_count_ <= functions_->max_bodies;
  }
  bool leads() const { return functions_->leads; }
  bool has_speed() const { return functions_->has_speed; }
  // Whether the robot was compiled with the library's arithmetic.
  bool exact() const { return functions_ == nullptr || functions_->exact(self_); }
  bool answers_proven() const { return functions_->answers_proven; }

  void place(const float* s, Pose* poses) const { functions_->place(self_, s, state_size_, poses); }
  // Body 0's frame, by the leading components.
  void place_lead(const float* s, Pose* poses) const { functions_->place(self_, s, leading_size_, poses); }
  void derivative(const float* s, const float* u, float* ds) const {
    functions_->derivative(self_, s, state_size_, u, ds);
  }
  // Of the leading components, by them.
  void lead_rates(const float* s, const float* u, float* ds) const {
    functions_->derivative(self_, s, leading_size_, u, ds);
  }
  // Of all components that are integrated first: the leading ones, or all.
  void integrate_lead(const float* s, const Pose* poses, const float* u, float dt, detail::Lead& lead, float* d) const {
    functions_->integrate_lead(self_, s, state_size_, poses, u, dt, lead, d);
  }
  // The same of a state that has no others than the leading components.
  void integrate_lead_alone(const float* s, const Pose* poses, const float* u, float dt, detail::Lead& lead,
                            float* d) const {
    functions_->integrate_lead(self_, s, leading_size_, poses, u, dt, lead, d);
  }
  void integrate_rest(const float* s, const Pose* poses, float dt, const detail::Lead& lead, float* d) const {
    if (functions_->leads) functions_->integrate_rest(self_, s, poses, dt, lead, d);
  }

  void steer(const float* s, const Pose* poses, const Target& target, Steering& steering, float* u) const {
    functions_->steer(self_, s, poses, target, steering, u);
  }
  void track(const float* s, const float* reference, float dt, float* u) const {
    functions_->track(self_, s, reference, dt, u);
  }
  float carry_errors(const float* s, const Pose* poses, const float* u, float dt, float* errors) const {
    return functions_->carry_errors(self_, s, poses, u, dt, errors);
  }
  bool within_limits(const float* s) const { return functions_->within_limits(self_, s); }
  bool keeps_reserve(const float* s) const { return functions_->keeps_reserve(self_, s); }
  bool travel(const float* s, const float* u, float dt, const float* next, Travel* travel) const {
    return functions_->travel(self_, s, u, dt, next, travel);
  }
  QuickBound quick_bound(const float* s, const float* u, float dt, const float* next) const {
    return functions_->quick_bound(self_, s, u, dt, next);
  }
  bool sketch(float* s, Pose* poses, const float* u, float dt) const {
    return functions_->sketch(self_, s, poses, u, dt);
  }
  float fastest_rate(float dt) const { return functions_->fastest_rate(self_, dt); }
  float speed(const float* s) const { return functions_->speed(self_, s); }
  float stopping_way(const float* s) const { return functions_->stopping_way(self_, s); }
  float turning_radius(float length) const { return functions_->turning_radius(self_, length); }
  float top_speed(float length) const { return functions_->top_speed(self_, length); }
  bool rest(Vec2 position, float heading, const float* angles, std::uint32_t count, float* s) const {
    return functions_->rest(self_, position, heading, angles, count, s);
  }

 private:
  const detail::RobotFunctions* functions_ = nullptr;
  const void* self_ = nullptr;
  int state_size_ = 0;
  int control_size_ = 0;
  int body_count_ = 0;
  int leading_size_ = 0;
};

}  // namespace krait
