// SPDX-License-Identifier: Apache-2.0
// Drives a way out of a narrow place move by move: in reverse to the pose, or from the pose out. Between two moves the
// robot stands until its wheels are turned; on a move it is steered back to the move's line by what it is off in place
// and direction.
#pragma once

#include <cstdint>

#include "krait/scene.hpp"
#include "last_metres/nimbleness.hpp"
#include "last_metres/pull_outs.hpp"

namespace krait::detail {

// A target is a point of the bounds (TargetGrid). Where it would lie outside, the way to it, which begins inside, is
// shortened by this factor, at most so often: to a seventeenth.
inline constexpr float kShortening = 0.7F;
inline constexpr int kMostShortenings = 8;

class Manoeuvre {
 public:
  static constexpr std::uint8_t kNoWay = 255;

  // For robots that come to rest within `near` metres of a move's end. What is named must outlive this.
  void assign(const Scene& scene, const Nimbleness& robot, const PullOuts& ways, float near);

  // Prepares for a way out, whose end the robot will be at when aim is called; or for none. It will be driven in.
  void begin(std::uint8_t way) {
    way_ = way;
    outward_ = false;
    moving_ = false;
  }

  // Prepares for a way out of the pose that the robot is at: it will be driven out, with more care, since what the
  // robot is off after a move takes it nearer to the obstacles that the next one must pass.
  void begin_outward(std::uint8_t way) {
    begin(way);
    outward_ = true;
  }

  // Whether there is a way, and whether it is being driven.
  bool any() const { return way_ != kNoWay; }
  bool moving() const { return moving_; }

  // Whether the robot drives the last move, and whether it has arrived at its end.
  bool on_last_move() const { return moving_ && moves_left_ == 0 && !turns_wheels_; }
  bool arrived(const Moment& now) const { return on_last_move() && move_.offset(now.at()).way <= near_; }

  // The next leg's target, on the way to the pose or at it. False where the robot is too far off the move's line or
  // does not come to rest at the pose.
  bool aim(const Moment& now, Target& target);

  // Whether a leg of that many steps is over, which takes `hold` of them, or where the robot turns its wheels, until
  // they are turned.
  bool leg_over(std::uint32_t steps, std::uint32_t hold, const Moment& now);

 private:
  void begin_first();
  void begin_move();

  // 1/m: of the move, and of what brings the robot back to its line.
  float curvature(const Move::Offset& off) const;

  // A point beside body 0, within the bounds.
  Vec2 beside(const Pose& at, float side) const;

  const Scene* scene_;
  const PullOuts* ways_;
  const Nimbleness* robot_;
  float near_;
  std::uint8_t way_;
  bool outward_;
  int moves_left_;
  bool moving_;  // whether the first move has begun
  Move move_;
  bool turns_wheels_;    // whether the leg is one in which the robot stands
  float sum_;            // of its state at the step before
  std::uint32_t stops_;  // legs that only brake
};

}  // namespace krait::detail
