// SPDX-License-Identifier: Apache-2.0
#include "krait/robots/kinematic_truck.hpp"

#include <algorithm>

#include "robot/front_wheels.hpp"
#include "robot/pushing.hpp"
#include "robot/trailers.hpp"

namespace krait {

using detail::deviation;
using detail::kSteeringGains;
using detail::recoverable_tangent;
using detail::rest_trailers;
using detail::steady_tangent;
using detail::trailer_rates;
using detail::wheel_correction;
using detail::WheelCorrection;
using detail::wheels_error;
using detail::within_lock;

namespace {

constexpr int kCarState = KinematicTruck::kCarState;
constexpr float kNoControl[] = {0.0F, 0.0F};  // of a truck that holds its speed and steering angle

ChainParameters truck_of(const KinematicTruckParameters& p) {
  ChainParameters truck;
  truck.trailers = p.trailers;
  truck.body_length = p.body_length;
  truck.body_width = p.body_width;
  truck.body_offset = p.body_offset;
  truck.wheelbase = p.wheelbase;
  truck.hitch_length = p.hitch_length;
  truck.max_speed = p.max_speed;
  truck.min_speed = p.min_speed;
  truck.max_steering = p.max_steering;
  truck.self_collision_gap = p.self_collision_gap;
  truck.max_hitch_angle = p.max_hitch_angle;
  return truck;
}

float tangent(SinCos angle) { return angle.sin / angle.cos; }

// The state of a truck with the same bodies, at a speed and with a steering angle.
class TruckState {
 public:
  TruckState(const float* s, int size, float speed, float steering) : size_(size - kCarState + Chain::kCarState) {
    for (int i = 0; i < kCarState; ++i) floats_[i] = s[i];
    floats_[3] = speed;
    floats_[4] = steering;
    for (int i = kCarState; i < size; ++i) trailers()[i - kCarState] = s[i];
  }
  explicit TruckState(StateView s, float speed = 0.0F, float steering = 0.0F)
      : TruckState(s.data(), static_cast<int>(s.size()), speed, steering) {}

  StateView view() const { return {floats_, size_}; }
  StateRef ref() { return {floats_, size_}; }
  float* data() { return floats_; }
  float* trailers() { return floats_ + Chain::kCarState; }

 private:
  float floats_[Chain::kMaxState];
  int size_;
};

// A truck's lemmas ask for the most of its speed V and steering angle P, from which they know that an axle goes at most
// V, that the car turns by at most V P / wheelbase a second, and that trailers are pulled with V at most. Here these
// are the speed of the rear axle and the tangent (lib/robot/CHAIN.md).
TruckState for_lemmas(StateView s, ControlView u) { return TruckState(s, u[0], tangent(math::sin_cos(u[1]))); }

}  // namespace

KinematicTruck::KinematicTruck(const KinematicTruckParameters& parameters)
    : parameters_(parameters),
      truck_(truck_of(parameters), false),
      lock_(tangent(math::sin_cos(parameters.max_steering))) {
  parameters_.trailers = truck_.parameters().trailers;
}

bool KinematicTruck::sound() const {
  return truck_.sound() && parameters_.max_steering <= KinematicTruckParameters::kMostSteering;
}

void KinematicTruck::rest(Vec2 position, float heading, const float* angles, float* state) const {
  state[0] = position.x;
  state[1] = position.y;
  state[2] = heading;
  rest_trailers(heading, angles, parameters_.trailers, state + kCarState);
}

// The most that the wheels may turn toward the side of `heading_error`. They turn at once, so that a single trailer may
// be turned more sharply than it follows for long; a hitch further back is not in their hands.
float KinematicTruck::steering_limit(StateView s, float heading_error, float speed) const {
  const KinematicTruckParameters& p = parameters_;
  if (p.trailers == 0) return p.max_steering;
  const float side = heading_error < 0.0F ? -1.0F : 1.0F;
  float most = recoverable_tangent(p, side * (s[2] - s[kCarState]), speed);
  if (p.trailers > 1 && steady_tangent(p) < most) most = steady_tangent(p);
  const float limit = math::atan2(most, 1.0F);
  return std::min(p.max_steering, limit);
}

void KinematicTruck::steer(StateView s, const Target& target, Steering& steering, ControlRef u) const {
  Pose poses[kMaxBodies];
  place(s, poses);
  steer(s, poses, target, steering, u);
}

int KinematicTruck::backing_body() const { return detail::pushed(parameters_); }

// As a truck's, but that the wheels turn at once: they are not turned further than what faces the target within a step.
void KinematicTruck::steer(StateView s, const Pose* poses, const Target& target, Steering& steering,
                           ControlRef u) const {
  const KinematicTruckParameters& p = parameters_;
  if (target.speed == 0.0F) {
    u.setZero();
    return;
  }
  const bool backward = target.speed < 0.0F;
  const float set_point = target.speed * (backward ? -p.min_speed : p.max_speed);
  const bool pushes = backward && backing_body() > 0;
  const float slowest = pushes ? -detail::fastest_push(detail::train_of(p), target.dt) : p.min_speed;
  const float speed = std::max(set_point, slowest);
  const float way = math::absolute(speed) * target.dt;
  const float lock = target.turn < 1.0F ? math::atan2(target.turn * lock_, 1.0F) : p.max_steering;
  u[0] = speed;
  if (pushes) {
    const float wanted =
        detail::pushing_tangent(detail::train_of(p), poses, {0.0F, 0.0F, way, kInfinity}, target.point);
    u[1] = math::clamp(math::atan2(wanted, 1.0F), -lock, lock);
    return;
  }
  const float error = wheels_error(s, poses[0].heading, target.point, backward);
  PidGains gains = kSteeringGains;
  if (gains.proportional * way > p.wheelbase) gains.proportional = p.wheelbase / way;
  const float wanted = steering.heading(gains, error, target.dt);
  const float side = steering_limit(s, wanted, speed);
  u[1] = within_lock(wanted, side, lock);
}

void KinematicTruck::track(StateView s, StateView reference, float dt, ControlRef u) const {
  const KinematicTruckParameters& p = parameters_;
  WheelCorrection change = wheel_correction(deviation(s, reference), u[0], p.wheelbase, dt);
  if (backing_body() > 0 && u[0] < 0.0F) change.steering = pushing_change(s, reference, -u[0] * dt, u[1]);
  u[0] = math::clamp(u[0] + change.speed, p.min_speed, p.max_speed);
  u[1] = math::clamp(u[1] + change.steering, -p.max_steering, p.max_steering);
}

float KinematicTruck::pushing_change(StateView s, StateView reference, float way, float steering) const {
  Pose poses[1 + detail::kMostPushed];
  Pose wanted[1 + detail::kMostPushed];
  place(s, poses);
  place(reference, wanted);
  const float bend =
      detail::pushing_correction(detail::train_of(parameters_), poses, wanted, {0.0F, 0.0F, way, kInfinity});
  const float cosine = math::sin_cos(steering).cos;
  return cosine * cosine * bend;
}

float KinematicTruck::carry_errors(StateView s, const Pose* poses, ControlView u, float dt, float* errors) const {
  TruckState own(errors, state_size(), 0.0F, 0.0F);
  const float off = truck_.carry_errors(TruckState(s, u[0]).view(), poses, {kNoControl, 2}, dt, own.data());
  for (int i = 0; i < parameters_.trailers; ++i) errors[kCarState + i] = own.trailers()[i];
  return off;
}

bool KinematicTruck::within_limits(StateView s) const { return truck_.within_limits(TruckState(s).view()); }

bool KinematicTruck::keeps_reserve(StateView s) const { return truck_.keeps_reserve(TruckState(s).view()); }

void KinematicTruck::place(StateView s, Pose* poses) const { truck_.place(TruckState(s).view(), poses); }

bool KinematicTruck::travel(StateView s, ControlView u, float dt, StateView next, Travel* travel) const {
  return truck_.travel(for_lemmas(s, u).view(), {kNoControl, 2}, dt, TruckState(next).view(), travel);
}

QuickBound KinematicTruck::quick_bound(StateView s, ControlView u, float dt, StateView next) const {
  return truck_.quick_bound(for_lemmas(s, u).view(), {kNoControl, 2}, dt, TruckState(next).view());
}

float KinematicTruck::fastest_rate(float) const {
  const float turn = 0.5F * fastest() * lock_ / parameters_.wheelbase;
  const float pull = parameters_.trailers > 0 ? fastest() / parameters_.hitch_length : 0.0F;
  return std::max(pull, turn);
}

void KinematicTruck::derivative(StateView s, ControlView u, StateRef ds) const {
  const SinCos heading = math::sin_cos(s[2]);
  ds[0] = u[0] * heading.cos;
  ds[1] = u[0] * heading.sin;
  ds[2] = u[0] * tangent(math::sin_cos(u[1])) / parameters_.wheelbase;
  const auto hitch = [s](int k) { return math::sin_cos(s[kCarState - 1 + k] - s[kCarState + k]); };
  trailer_rates(u[0] / parameters_.hitch_length, static_cast<int>(s.size()) - kCarState, hitch, ds.data() + kCarState);
}

bool KinematicTruck::sketch(StateRef s, Pose* poses, ControlView u, float dt) const {
  const int size = state_size();
  TruckState truck(s.data(), size, u[0] / math::sin_cos(u[1]).cos, u[1]);
  if (!truck_.sketch(truck.ref(), poses, {kNoControl, 2}, dt)) return false;
  for (int i = 0; i < kCarState; ++i) s[i] = truck.data()[i];
  if (size > kCarState) s[kCarState] = truck.trailers()[0];
  return true;
}

// The car turns at the same rate in all stages of the step. A hitch angle changes by no more than what Chain says.
void KinematicTruck::integrate_lead(StateView s, const Pose* poses, ControlView u, float dt, Lead& lead,
                                    float* d) const {
  const KinematicTruckParameters& p = parameters_;
  const SinCos heading = poses[0].heading;
  const float rate = u[0] * tangent(math::sin_cos(u[1])) / p.wheelbase;
  const float pull = u[0] / p.hitch_length;
  const float turned = math::absolute(rate) * dt;
  const float reach = math::absolute(pull) * dt;
  const bool little = 1.42F * reach <= kSmallAngle && turned + reach <= kSmallAngle;
  const float half = (s[2] + 0.5F * dt * rate) - s[2];
  const float whole = (s[2] + dt * rate) - s[2];
  lead = {{0.0F, half, half, whole}, {pull, pull, pull, pull}, little};
  const SinCos middle = heading + (little ? math::small_sin_cos(half) : math::sin_cos(half));
  const SinCos end = heading + (little ? math::small_sin_cos(whole) : math::sin_cos(whole));
  const float sixth = u[0] * (dt / 6.0F);
  d[0] = sixth * ((heading.cos + end.cos) + 4.0F * middle.cos);
  d[1] = sixth * ((heading.sin + end.sin) + 4.0F * middle.sin);
  d[2] = dt * rate;
}

void KinematicTruck::integrate_rest(StateView s, const Pose* poses, float dt, const Lead& lead, float* d) const {
  float turns[Chain::kMaxState];
  const int trailers = static_cast<int>(s.size()) - kCarState;
  truck_.integrate_rest(TruckState(s).view(), poses, dt, lead, turns);
  for (int i = 0; i < trailers; ++i) d[kCarState + i] = turns[Chain::kCarState + i];
}

template class detail::FunctionsOf<KinematicTruck>;

}  // namespace krait
