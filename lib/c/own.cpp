// SPDX-License-Identifier: Apache-2.0
#include "c/model.hpp"
#include "robot/shape.hpp"

namespace {

using krait::c::convert;

// A robot whose functions are the user's, in C: those that it must have.
class NeededFunctions {
 public:
  static constexpr int kMaxState = krait::kMaxState;
  static constexpr int kMaxControl = krait::kMaxControl;
  static constexpr int kMaxBodies = krait::kMaxBodies;

  explicit NeededFunctions(const krait_own& own) : f_(*own.functions), self_(own.self) {}

  int state_size() const { return f_.state_size; }
  int control_size() const { return f_.control_size; }
  int body_count() const { return f_.body_count; }

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
  bool rates(krait::StateView s, krait::ControlView u, float dt, krait::StateView next, krait::BodyRates* rates) const {
    return f_.rates(self_, s.data(), u.data(), dt, next.data(), reinterpret_cast<krait_body_rates*>(rates));
  }

 protected:
  const krait_functions& functions() const { return f_; }
  const void* self() const { return self_; }

 private:
  krait_functions f_;
  const void* self_;
};

// The same with those that it may have. Where one is NULL, what stands for it is what stands for that of a C++ robot
// which lacks it.
class OwnRobot : public NeededFunctions {
 public:
  using NeededFunctions::NeededFunctions;

  bool sound() const {
    const krait_functions& f = functions();
    return f.derivative != nullptr && f.steer != nullptr && f.within_limits != nullptr && f.body != nullptr &&
           f.place != nullptr && (f.travel != nullptr || f.rates != nullptr);
  }
  bool exact() const { return functions().exact != nullptr && functions().exact(); }
  bool travel(krait::StateView s, krait::ControlView u, float dt, krait::StateView next, krait::Travel* travel) const {
    if (functions().travel == nullptr) return krait::detail::travel(needed(), s, u, dt, next, travel);
    return functions().travel(self(), s.data(), u.data(), dt, next.data(), reinterpret_cast<krait_travel*>(travel));
  }
  float stopping_way(krait::StateView s) const {
    if (functions().stopping_way == nullptr) return krait::detail::stopping_way(needed(), s);
    return functions().stopping_way(self(), s.data());
  }
  float turning_radius() const {
    if (functions().turning_radius == nullptr) return krait::detail::turning_radius(needed(), length());
    return functions().turning_radius(self());
  }
  float top_speed() const {
    if (functions().top_speed == nullptr) return krait::detail::top_speed(needed(), length());
    return functions().top_speed(self());
  }
  float fastest_rate(float dt) const {
    if (functions().fastest_rate == nullptr) return krait::detail::fastest_rate(needed(), dt);
    return functions().fastest_rate(self(), dt);
  }
  void track(krait::StateView s, krait::StateView reference, float dt, krait::ControlRef u) const {
    if (functions().track != nullptr) functions().track(self(), s.data(), reference.data(), dt, u.data());
  }
  bool keeps_reserve(krait::StateView s) const {  // called for states within the limits only
    return functions().keeps_reserve == nullptr || functions().keeps_reserve(self(), s.data());
  }
  bool reversible() const {
    if (functions().reversible == nullptr) return krait::detail::reversible(needed());
    return functions().reversible(self());
  }
  int self_collision_gap() const {
    if (functions().self_collision_gap == nullptr) return krait::detail::self_collision_gap(needed());
    return functions().self_collision_gap(self());
  }
  int backing_body() const {
    if (functions().backing_body == nullptr) return krait::detail::backing_body(needed());
    return functions().backing_body(self());
  }

 private:
  const NeededFunctions& needed() const { return *this; }
  float length() const { return krait::detail::body_length(body(0)); }
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
  if (functions == nullptr) return {};
  const bool has_speed = functions->speed != nullptr;
  krait_robot robot{has_speed ? &krait::c::kModel<OwnRobotWithSpeed> : &krait::c::kModel<OwnRobot>, {}, nullptr};
  robot.parameters.own = {functions, self};
  return robot;
}
