// SPDX-License-Identifier: Apache-2.0
// How far a target leads before the robot would hit something, as far as a coarse roll-out tells in which bodies are
// discs.
#pragma once

#include "krait/collision/sight.hpp"
#include "krait/robot/shape.hpp"
#include "krait/robot/sketch.hpp"

namespace krait {

template <Robot R>
class Sketcher {
 public:
  static constexpr std::uint32_t kSteps = 20;  // at most

  // Robot and scene must outlive this. Steps are of dt seconds; a target is reached within `near` metres.
  void assign(const R& robot, const Scene& scene, float dt, float near) {
    robot_ = &robot;
    dt_ = dt;
    squared_near_ = near * near;
    radius_ = kInfinity;
    for (int k = 0; k < robot.body_count(); ++k) {
      const Polygon body = robot.body(k);
      const Box box = bounding_box(body);
      centers_[k] = 0.5F * (box.min + box.max);
      const float radius = inner_radius(body, centers_[k]);
      if (radius < radius_) radius_ = radius;
    }
    sight_ = Sight(scene, kRoom * radius_, 1.0F);
  }

  // Metres: the radius of the discs around the bodies' middles that lie in all of them.
  float radius() const { return radius_; }

  // The steps from `state` toward the target after which the discs, a little larger, are still free; kSteps where they
  // are until the target is reached, too.
  std::uint32_t free_steps(const float* state, const Target& toward) {
    begin(state);
    Target target = toward;
    target.dt = dt_;
    float control[R::kMaxControl];
    const ControlRef u(control, robot_->control_size());
    for (std::uint32_t step = 0; step < kSteps; ++step) {
      steer(*robot_, StateView(state_, robot_->state_size()), poses_, target, steering_, u);
      const ControlView held(control, robot_->control_size());
      if (!sketch(*robot_, StateRef(state_, robot_->state_size()), poses_, held, dt_) || !free()) return step;
      const Vec2 apart = target.point - Vec2{state_[0], state_[1]};
      if (dot(apart, apart) <= squared_near_) return kSteps;
    }
    return kSteps;
  }

 private:
  static constexpr float kRoom = 1.08F;  // of the disc in a body

  // Where a disc was looked at last, and the square of what it may move from there.
  struct Look {
    Vec2 center;
    float squared_slack;
  };

  void begin(const float* state) {
    for (int i = 0; i < robot_->state_size(); ++i) state_[i] = state[i];
    robot_->place(StateView(state_, robot_->state_size()), poses_);
    steering_ = {};
    for (int k = 0; k < robot_->body_count(); ++k) looks_[k] = {{}, -1.0F};
  }

  bool free() {
    for (int k = 0; k < robot_->body_count(); ++k) {
      const Vec2 center = poses_[k].position + turned(poses_[k].heading, centers_[k]);
      Look& look = looks_[k];
      const Vec2 moved = center - look.center;
      if (dot(moved, moved) <= look.squared_slack) continue;
      const float slack = sight_.slack(center);
      if (slack < 0.0F) return false;
      look = {center, slack * slack};
    }
    return true;
  }

  const R* robot_ = nullptr;
  float dt_ = 0.2F;
  float squared_near_ = 0.0F;
  float radius_ = 0.0F;
  Sight sight_;
  Vec2 centers_[R::kMaxBodies];  // of the bodies, in their frames
  float state_[R::kMaxState];
  Pose poses_[R::kMaxBodies];
  Look looks_[R::kMaxBodies];
  Steering steering_;
};

}  // namespace krait
