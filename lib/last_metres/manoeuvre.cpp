// SPDX-License-Identifier: Apache-2.0
#include "last_metres/manoeuvre.hpp"

#include <algorithm>

#include "last_metres/arc.hpp"

namespace krait::detail {
namespace {

// Measured: bench/ABLATIONS.md, "Cars park" and "Cars leave narrow places".
constexpr float kMoveBraking = 0.5F;     // of the sharpest,
constexpr float kOutBraking = 0.3F;      // and outward
constexpr float kOutSlowest = 0.005F;    // lengths of body 0 that it goes in a time step outward, at least
constexpr float kAstray = 0.15F;         // lengths of body 0: how far off a move's line the robot may be
constexpr float kGrip = 0.3F;            // lengths of body 0 within which what it is off shrinks by e
constexpr float kLeastTurn = 0.01F;      // of the sharpest
constexpr float kStill = 1e-3F;          // how little a state's sum changes in a step where nothing moves
constexpr std::uint32_t kMostWait = 64;  // steps in which wheels are turned
constexpr std::uint32_t kMostMoveStops = 5;

}  // namespace

void Manoeuvre::assign(const Scene& scene, const Nimbleness& robot, const PullOuts& ways, float near) {
  scene_ = &scene;
  robot_ = &robot;
  ways_ = &ways;
  near_ = near;
}

void Manoeuvre::begin_first() {
  moves_left_ = ways_->moves(way_);
  stops_ = 0;
  moving_ = true;
  begin_move();
}

void Manoeuvre::begin_move() {
  --moves_left_;
  const int last = ways_->moves(way_) - 1;
  move_ = outward_ ? ways_->move(way_, last - moves_left_).reversed() : ways_->move(way_, moves_left_);
  turns_wheels_ = true;
  sum_ = kInfinity;
}

bool Manoeuvre::aim(const Moment& now, Target& target) {
  turns_wheels_ = false;
  if (!moving_) begin_first();
  Move::Offset off = move_.offset(now.at());
  while (off.way <= near_ && moves_left_ > 0) {
    begin_move();
    off = move_.offset(now.at());
  }
  if (math::absolute(off.aside) > kAstray * robot_->length) return false;
  const bool stops = off.way <= near_;
  if (stops && ++stops_ > kMostMoveStops) return false;
  const float creep = kOutSlowest * robot_->length / (robot_->dt * robot_->top_speed);
  const float braking = outward_ ? kOutBraking : kMoveBraking;
  const float slowest = outward_ ? std::min(kSlowest, creep) : kSlowest;
  const float share = pace(*robot_, std::max(0.0F, off.way), now.robot.speed(now.state),
                           now.robot.stopping_way(now.state), braking, slowest);
  target.speed = stops || turns_wheels_ ? 0.0F : (move_.backward ? share : -share);
  const float bend = curvature(off);
  target.turn = math::clamp(math::absolute(bend) * robot_->turning_radius, kLeastTurn, 1.0F);
  target.point = beside(now.at(), bend < 0.0F ? -1.0F : 1.0F);
  return true;
}

float Manoeuvre::curvature(const Move::Offset& off) const {
  const float own = static_cast<float>(move_.turn) / move_.radius;
  if (turns_wheels_) return own;
  const float grip = 1.0F / (kGrip * robot_->length);
  const float turned = move_.backward ? off.turned : -off.turned;
  return own - grip * (2.0F * turned + grip * off.aside);
}

Vec2 Manoeuvre::beside(const Pose& at, float side) const {
  Vec2 way = side * robot_->length * left_of(direction(at.heading));
  for (int i = 0; i < kMostShortenings && !scene_->inside_bounds(at.position + way); ++i) way = kShortening * way;
  return at.position + way;
}

bool Manoeuvre::leg_over(std::uint32_t steps, std::uint32_t hold, const Moment& now) {
  if (!turns_wheels_) return steps >= hold;
  float sum = 0.0F;
  for (int i = 0; i < now.robot.state_size(); ++i) sum = sum + now.state[i];
  const bool still = math::absolute(sum - sum_) < kStill;
  sum_ = sum;
  return (steps > 1 && still) || steps >= kMostWait;
}

}  // namespace krait::detail
