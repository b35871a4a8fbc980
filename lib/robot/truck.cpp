// SPDX-License-Identifier: Apache-2.0
#include "krait/robots/truck.hpp"

#include <algorithm>

#include "robot/pushing.hpp"
#include "robot/tracking.hpp"

namespace krait {
namespace {

// Time steps: the wheels turn at a constant rate throughout one. Measured: bench/ABLATIONS.md, "Trucks dock".
constexpr float kLag = 0.5F;
constexpr float kLeast = 1e-3F;  // metres a step: as fast at least counts

float tangent(SinCos angle) { return angle.sin / angle.cos; }

// What wheels do in a step of dt that moves the car at `speed`, their angle's tangent being `from`.
detail::Wheels wheels_at(const ChainParameters& p, float from, float speed, float dt) {
  const float way = std::max(kLeast, speed * dt);
  return {from, kLag * way, way, p.max_steering_rate * dt / way};
}

}  // namespace

int Truck::backing_body() const { return detail::pushed(parameters()); }

void Truck::steer(StateView s, const Target& target, Steering& steering, ControlRef u) const {
  Pose poses[kMaxBodies];
  place(s, poses);
  steer(s, poses, target, steering, u);
}

[[gnu::flatten]] void Truck::steer(StateView s, const Pose* poses, const Target& target, Steering& steering,
                                   ControlRef u) const {
  if (backing_body() == 0 || !backs(s, target)) return Chain::steer(s, poses, target, steering, u);
  const SinCos turned = math::sin_cos(s[4]);
  const detail::Wheels wheels = wheels_at(parameters(), tangent(turned), speed(s) * turned.cos, target.dt);
  const detail::Train train = detail::train_of(parameters());
  const float wanted = detail::pushing_tangent(train, poses, wheels, target.point);
  const float share = detail::fastest_push(train, target.dt) / -parameters().min_speed;
  Target slower = target;
  if (slower.speed < -share) slower.speed = -share;
  turn_and_drive(s, math::atan2(wanted, 1.0F), slower, steering, u);
}

void Truck::track(StateView s, StateView reference, float dt, ControlRef u) const {
  if (backing_body() == 0 || reference[3] >= 0.0F) return Chain::track(s, reference, dt, u);
  Pose poses[1 + detail::kMostPushed];
  Pose wanted[1 + detail::kMostPushed];
  place(s, poses);
  place(reference, wanted);
  const SinCos turned = math::sin_cos(reference[4]);
  const float off = tangent(math::sin_cos(s[4])) - tangent(turned);
  const detail::Wheels wheels = wheels_at(parameters(), off, speed(reference) * turned.cos, dt);
  const float bend = detail::pushing_correction(detail::train_of(parameters()), poses, wanted, wheels);
  const float faster = detail::correction(detail::deviation(s, reference), reference[3], 1.0F, dt).speed;
  approach(s, reference[3] + u[0] * dt + faster, reference[4] + u[1] * dt + turned.cos * turned.cos * bend, dt, u);
}

template class detail::FunctionsOf<Truck>;

}  // namespace krait
