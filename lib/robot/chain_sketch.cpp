// SPDX-License-Identifier: Apache-2.0
#include "krait/robots/chain.hpp"

namespace krait {
namespace {

constexpr float kLittlePull = 0.9F * kSmallAngle;  // sines of directions that are turned together are below 1.1

SinCos small_turn(float angle) { return math::small_sin_cos(math::clamp(angle, -kSmallAngle, kSmallAngle)); }

}  // namespace

// A step by the midpoint rule: the directions in the middle, ahead of each trailer and its own, determine how far it
// turns. The state has but the car and the first trailer's heading, which is all that steering looks at; the frames
// have the rest.
[[gnu::flatten]] bool Chain::sketch(StateRef s, Pose* poses, ControlView u, float dt) const {
  const ChainParameters& p = parameters_;
  const float speed = s[3] + 0.5F * dt * u[0];
  const SinCos steering = math::sin_cos(s[4] + 0.5F * dt * u[1]);
  const float axle_way = dt * speed * steering.cos;
  const float half_turn = 0.5F * dt * speed * steering.sin / p.wheelbase;
  const SinCos half = small_turn(half_turn);
  SinCos ahead = poses[0].heading + half;
  const Vec2 at = poses[0].position + axle_way * Vec2{ahead.cos, ahead.sin};
  poses[0] = {at, ahead + half};
  s[0] = at.x;
  s[1] = at.y;
  s[2] = s[2] + 2.0F * half_turn;
  s[3] = s[3] + dt * u[0];
  s[4] = s[4] + dt * u[1];
  const float hitch_length = p.hitch_length;
  const float least_cosine = least_hitch_cosine_;
  float pull = (slip_ ? dt * speed : axle_way) / hitch_length;
  const bool little = math::absolute(pull) < kLittlePull;
  Pose front = poses[0];
  for (int k = 1; k <= p.trailers; ++k) {
    const SinCos before = poses[k].heading;
    const float quarter = 0.5F * pull * (ahead - before).sin;
    const SinCos own = before + SinCos{quarter, 1.0F - 0.5F * quarter * quarter};
    const SinCos hitch = ahead - own;
    const float turn = pull * hitch.sin;
    if (k == 1) s[kCarState] = s[kCarState] + turn;
    pull = pull * hitch.cos;
    ahead = own;
    const SinCos heading = before + (little ? math::small_sin_cos(turn) : small_turn(turn));
    const Pose trailer{front.position - hitch_length * Vec2{heading.cos, heading.sin}, heading};
    if (!((front.heading - heading).cos >= least_cosine)) return false;
    poses[k] = trailer;
    front = trailer;
  }
  return true;
}

}  // namespace krait
