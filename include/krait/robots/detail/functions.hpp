// SPDX-License-Identifier: Apache-2.0
/// \file
/// The functions of a model of robot by their addresses, so that the planner is compiled once for all models. Internal,
/// and installed since a robot of a user's is compiled with it.
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>

#include "krait/robots/detail/defaults.hpp"

namespace krait::detail {

// What integrate_lead hands to integrate_rest.
struct alignas(8) Lead {
  std::byte bytes[64];
};

// How robots drive into narrow places in reverse, how they leave them, and how they push trailers back to a pose. The
// planner defines them. They are only named here, so that the tables of the models that need them, and nothing else,
// link them: a planner that named them itself would put them into every program.
struct Parking;
extern const Parking kParking;
struct Departing;
extern const Departing kDeparting;
struct Docking;
extern const Docking kDocking;

// Each function is called for the robot at `self`, and does what the member of its name does (model.hpp) or, where a
// model has none, its default (defaults.hpp). Arrays have as many elements as the robot's sizes say.
struct RobotFunctions {
  std::uint8_t max_state;
  std::uint8_t max_control;
  std::uint8_t max_bodies;
  bool leads;                  // whether the leading components are integrated first
  bool has_speed;              // whether the robot has the function `speed`
  bool answers_proven;         // kAnswersProven
  const Parking* parking;      // null where not kParks
  const Departing* departing;  // null where not kParks
  const Docking* docking;      // null where not kDocks

  bool (*exact)(const void* self);  // and whether the functions were compiled with exact_arithmetic
  int (*state_size)(const void* self);
  int (*leading_size)(const void* self);
  int (*control_size)(const void* self);
  int (*body_count)(const void* self);
  int (*self_collision_gap)(const void* self);
  bool (*sound)(const void* self);
  bool (*reversible)(const void* self);
  int (*backing_body)(const void* self);
  Polygon (*body)(const void* self, int k);

  // `size` components of a state: all or the leading ones.
  void (*place)(const void* self, const float* s, int size, Pose* poses);
  void (*derivative)(const void* self, const float* s, int size, const float* u, float* ds);
  void (*integrate_lead)(const void* self, const float* s, int size, const Pose* poses, const float* u, float dt,
                         Lead& lead, float* d);
  void (*integrate_rest)(const void* self, const float* s, const Pose* poses, float dt, const Lead& lead, float* d);

  void (*steer)(const void* self, const float* s, const Pose* poses, const Target& target, Steering& steering,
                float* u);
  void (*track)(const void* self, const float* s, const float* reference, float dt, float* u);
  float (*carry_errors)(const void* self, const float* s, const Pose* poses, const float* u, float dt, float* errors);
  bool (*within_limits)(const void* self, const float* s);
  bool (*keeps_reserve)(const void* self, const float* s);
  bool (*travel)(const void* self, const float* s, const float* u, float dt, const float* next, Travel* travel);
  QuickBound (*quick_bound)(const void* self, const float* s, const float* u, float dt, const float* next);
  bool (*sketch)(const void* self, float* s, Pose* poses, const float* u, float dt);
  float (*fastest_rate)(const void* self, float dt);
  float (*speed)(const void* self, const float* s);
  float (*stopping_way)(const void* self, const float* s);
  float (*turning_radius)(const void* self, float length);
  float (*top_speed)(const void* self, float length);
  bool (*rest)(const void* self, Vec2 position, float heading, const float* angles, std::uint32_t count, float* s);
};

// The functions of the model R.
template <RobotModel R>
class FunctionsOf {
  static_assert(types_match<R>());
  static_assert(R::kMaxState <= kMaxState && R::kMaxControl <= kMaxControl && R::kMaxBodies <= kMaxBodies);

  static const R& of(const void* self) { return *static_cast<const R*>(self); }
  static StateView state(const void* self, const float* s) { return {s, of(self).state_size()}; }
  static ControlView control(const void* self, const float* u) { return {u, of(self).control_size()}; }

  static bool exact(const void* self) { return math::exact_arithmetic() && detail::exact(of(self)); }
  static int state_size(const void* self) { return of(self).state_size(); }
  static int leading_size(const void* self) { return detail::leading_size(of(self)); }
  static int control_size(const void* self) { return of(self).control_size(); }
  static int body_count(const void* self) { return of(self).body_count(); }
  static int self_collision_gap(const void* self) { return detail::self_collision_gap(of(self)); }
  static bool sound(const void* self) { return detail::sound(of(self)); }
  static bool reversible(const void* self) { return detail::reversible(of(self)); }
  static int backing_body(const void* self) { return detail::backing_body(of(self)); }
  static Polygon body(const void* self, int k) { return of(self).body(k); }

  [[gnu::flatten]] static void place(const void* self, const float* s, int size, Pose* poses) {
    of(self).place(StateView(s, size), poses);
  }
  static void derivative(const void* self, const float* s, int size, const float* u, float* ds) {
    of(self).derivative(StateView(s, size), control(self, u), StateRef(ds, size));
  }

  [[gnu::flatten]] static void integrate_lead(const void* self, const float* s, int size, const Pose* poses,
                                              const float* u, float dt, [[maybe_unused]] Lead& lead, float* d) {
    if constexpr (LeadingRobot<R>) {
      using Own = typename R::Lead;
      static_assert(sizeof(Own) <= sizeof(Lead) && alignof(Own) <= alignof(Lead));
      static_assert(std::is_trivially_copyable_v<Own> && std::is_trivially_destructible_v<Own>);
      of(self).integrate_lead(StateView(s, size), poses, control(self, u), dt, *::new (lead.bytes) Own, d);
    } else {
      runge_kutta(of(self), StateView(s, size), control(self, u), dt, d);
    }
  }
  [[gnu::flatten]] static void integrate_rest(const void* self, const float* s, const Pose* poses, float dt,
                                              [[maybe_unused]] const Lead& lead, float* d) {
    if constexpr (LeadingRobot<R>) {
      const auto* const own = std::launder(reinterpret_cast<const typename R::Lead*>(lead.bytes));
      of(self).integrate_rest(state(self, s), poses, dt, *own, d);
    }
  }

  [[gnu::flatten]] static void steer(const void* self, const float* s, const Pose* poses, const Target& target,
                                     Steering& steering, float* u) {
    detail::steer(of(self), state(self, s), poses, target, steering, ControlRef(u, of(self).control_size()));
  }
  static void track(const void* self, const float* s, const float* reference, float dt, float* u) {
    detail::track(of(self), state(self, s), state(self, reference), dt, ControlRef(u, of(self).control_size()));
  }
  [[gnu::flatten]] static float carry_errors(const void* self, const float* s, const Pose* poses, const float* u,
                                             float dt, float* errors) {
    return detail::carry_errors(of(self), state(self, s), poses, control(self, u), dt, errors);
  }
  [[gnu::flatten]] static bool within_limits(const void* self, const float* s) {
    return of(self).within_limits(state(self, s));
  }
  [[gnu::flatten]] static bool keeps_reserve(const void* self, const float* s) {
    return detail::keeps_reserve(of(self), state(self, s));
  }
  [[gnu::flatten]] static bool travel(const void* self, const float* s, const float* u, float dt, const float* next,
                                      Travel* travel) {
    return detail::travel(of(self), state(self, s), control(self, u), dt, state(self, next), travel);
  }
  [[gnu::flatten]] static QuickBound quick_bound(const void* self, const float* s, const float* u, float dt,
                                                 const float* next) {
    return detail::quick_bound(of(self), state(self, s), control(self, u), dt, state(self, next));
  }
  [[gnu::flatten]] static bool sketch(const void* self, float* s, Pose* poses, const float* u, float dt) {
    return detail::sketch(of(self), StateRef(s, of(self).state_size()), poses, control(self, u), dt);
  }
  static float fastest_rate(const void* self, float dt) { return detail::fastest_rate(of(self), dt); }
  static float speed(const void* self, const float* s) { return speed_of(of(self), state(self, s)); }
  static float stopping_way(const void* self, const float* s) { return detail::stopping_way(of(self), state(self, s)); }
  static float turning_radius(const void* self, float length) { return detail::turning_radius(of(self), length); }
  static float top_speed(const void* self, float length) { return detail::top_speed(of(self), length); }
  static bool rest(const void* self, Vec2 position, float heading, const float* angles, std::uint32_t count, float* s) {
    return detail::rest(of(self), position, heading, angles, count, s);
  }

 public:
  static constexpr RobotFunctions kTable = {R::kMaxState,
                                            R::kMaxControl,
                                            R::kMaxBodies,
                                            LeadingRobot<R>,
                                            HasSpeed<R>,
                                            kAnswersProven<R>,
                                            kParks<R> ? &kParking : nullptr,
                                            kParks<R> ? &kDeparting : nullptr,
                                            kDocks<R> ? &kDocking : nullptr,
                                            exact,
                                            state_size,
                                            leading_size,
                                            control_size,
                                            body_count,
                                            self_collision_gap,
                                            sound,
                                            reversible,
                                            backing_body,
                                            body,
                                            place,
                                            derivative,
                                            integrate_lead,
                                            integrate_rest,
                                            steer,
                                            track,
                                            carry_errors,
                                            within_limits,
                                            keeps_reserve,
                                            travel,
                                            quick_bound,
                                            sketch,
                                            fastest_rate,
                                            speed,
                                            stopping_way,
                                            turning_radius,
                                            top_speed,
                                            rest};
};

}  // namespace krait::detail
