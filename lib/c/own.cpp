// SPDX-License-Identifier: Apache-2.0
#include "c/model.hpp"
#include "robot/shape.hpp"

namespace {

using krait::c::convert;

// A robot whose functions are the user's, in C.
class OwnRobot {
 public:
  static constexpr int kMaxState = krait::kMaxState;
  static constexpr int kMaxControl = krait::kMaxControl;
  static constexpr int kMaxBodies = krait::kMaxBodies;

  explicit OwnRobot(const krait_own& own) : f_(*own.functions), self_(own.self) {}

  int state_size() const { return f_.state_size; }
  int control_size() const { return f_.control_size; }
  int body_count() const { return f_.body_count; }
  bool sound() const {
    return f_.derivative != nullptr && f_.steer != nullptr && f_.within_limits != nullptr && f_.body != nullptr &&
           f_.place != nullptr && (f_.travel != nullptr || f_.rates != nullptr);
  }
  bool exact() const { return f_.exact != nullptr && f_.exact(); }

  void derivative(krait::StateView s, krait::ControlView u, krait::StateRef ds) const {
    f_.derivative(self_, s.data(), u.data(), ds.data());
  }
  void steer(krait::StateView s, const krait::Target& target, krait::Steering&, krait::ControlRef u) const {
    const krait_target to{target.point.x, target.point.y, target.speed, target.dt, target.turn};
    f_.steer(self_, s.data(), &to, u.data());
  }
  bool within_limits(krait::StateView s) const { return f_.within_limits(self_, s.data()); }
  krait::Polygon body(int k) const {
    const krait_polygon body = f_.body(self_, k);
    return {reinterpret_cast<const krait::Vec2*>(body.corners), body.count};
  }
  void place(krait::StateView s, krait::Pose* poses) const {
    f_.place(self_, s.data(), reinterpret_cast<krait_frame*>(poses));
  }
  bool travel(krait::StateView s, krait::ControlView u, float dt, krait::StateView next, krait::Travel* travel) const {
    if (f_.travel != nullptr) {
      return f_.travel(self_, s.data(), u.data(), dt, next.data(), reinterpret_cast<krait_travel*>(travel));
    }
    return travel_by_rates(s.data(), u.data(), dt, next.data(), travel);
  }

  float stopping_way(krait::StateView s) const {
    return f_.stopping_way == nullptr ? 0.0F : f_.stopping_way(self_, s.data());
  }
  float turning_radius() const { return f_.turning_radius == nullptr ? length() : f_.turning_radius(self_); }
  float top_speed() const { return f_.top_speed == nullptr ? length() : f_.top_speed(self_); }
  float fastest_rate(float dt) const { return f_.fastest_rate == nullptr ? 0.0F : f_.fastest_rate(self_, dt); }
  void track(krait::StateView s, krait::StateView reference, float dt, krait::ControlRef u) const {
    if (f_.track != nullptr) f_.track(self_, s.data(), reference.data(), dt, u.data());
  }
  bool keeps_reserve(krait::StateView s) const {
    return f_.keeps_reserve == nullptr || f_.keeps_reserve(self_, s.data());
  }
  bool reversible() const { return f_.reversible != nullptr && f_.reversible(self_); }
  int self_collision_gap() const { return f_.self_collision_gap == nullptr ? 2 : f_.self_collision_gap(self_); }
  int backing_body() const { return f_.backing_body == nullptr ? 0 : f_.backing_body(self_); }

 protected:
  const krait_functions& functions() const { return f_; }
  const void* self() const { return self_; }

 private:
  bool travel_by_rates(const float* s, const float* u, float dt, const float* next, krait::Travel* travel) const {
    krait::BodyRates rates[krait::kMaxBodies] = {};
    const bool limits_hold = f_.rates(self_, s, u, dt, next, reinterpret_cast<krait_body_rates*>(rates));
    for (int k = 0; k < f_.body_count; ++k) travel[k] = krait::detail::travel_of(rates[k], dt);
    return limits_hold;
  }

  float length() const { return krait::detail::body_length(body(0)); }

  krait_functions f_;
  const void* self_;
};

// One that says how fast it moves.
class OwnRobotWithSpeed : public OwnRobot {
 public:
  using OwnRobot::OwnRobot;
  float speed(krait::StateView s) const { return functions().speed(self(), s.data()); }
};

static_assert(sizeof(krait_point) == sizeof(krait::Vec2) && alignof(krait_point) == alignof(krait::Vec2));
static_assert(sizeof(krait_frame) == sizeof(krait::Pose) && alignof(krait_frame) == alignof(krait::Pose));
static_assert(offsetof(krait_frame, sin) == offsetof(krait::Pose, heading));
static_assert(sizeof(krait_body_rates) == sizeof(krait::BodyRates));
static_assert(sizeof(krait_travel) == sizeof(krait::Travel) && alignof(krait_travel) == alignof(krait::Travel));

}  // namespace

krait_robot krait_own_robot(const krait_functions* functions, const void* self) {
  const bool has_speed = functions->speed != nullptr;
  krait_robot robot{has_speed ? &krait::c::kModel<OwnRobotWithSpeed> : &krait::c::kModel<OwnRobot>, {}, nullptr};
  robot.parameters.own = {functions, self};
  return robot;
}
