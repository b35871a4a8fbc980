// SPDX-License-Identifier: Apache-2.0
#include "search/sketcher.hpp"

namespace krait::detail {

void Sketcher::allocate(Arena& arena, const Robot& robot) {
  const auto bodies = static_cast<std::uint32_t>(robot.body_count());
  state_ = arena.allocate<float>(Pool::work, static_cast<std::uint32_t>(robot.state_size()));
  centers_ = arena.allocate<Vec2>(Pool::work, bodies);
  poses_ = arena.allocate<Pose>(Pool::work, bodies);
  looks_ = arena.allocate<Look>(Pool::work, bodies);
}

void Sketcher::assign(const Robot& robot, const Scene& scene, float dt, float near) {
  robot_ = robot;
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
  sight_ = Sight::in(scene, kRoom * radius_, 1.0F);
}

std::uint32_t Sketcher::free_steps(const float* state, const Target& toward) {
  begin(state);
  Target target = toward;
  target.dt = dt_;
  const int leader = target.speed < 0.0F ? robot_.backing_body() : 0;
  float control[kMaxControl];
  for (std::uint32_t step = 0; step < kSteps; ++step) {
    robot_.steer(state_, poses_, target, steering_, control);
    if (!robot_.sketch(state_, poses_, control, dt_) || !free()) return step;
    const Vec2 apart = target.point - poses_[leader].position;
    if (dot(apart, apart) <= squared_near_) return kSteps;
  }
  return kSteps;
}

void Sketcher::begin(const float* state) {
  for (int i = 0; i < robot_.state_size(); ++i) state_[i] = state[i];
  robot_.place(state_, poses_);
  steering_ = {};
  for (int k = 0; k < robot_.body_count(); ++k) looks_[k] = {{}, -1.0F};
}

[[gnu::flatten]] bool Sketcher::free() {
  const int bodies = robot_.body_count();
  const Pose* const poses = poses_;
  const Vec2* const centers = centers_;
  Look* const looks = looks_;
  for (int k = 0; k < bodies; ++k) {
    const Vec2 center = poses[k].position + turned(poses[k].heading, centers[k]);
    Look& look = looks[k];
    const Vec2 moved = center - look.center;
    if (dot(moved, moved) <= look.squared_slack) continue;
    const float slack = sight_.slack(center);
    if (slack < 0.0F) return false;
    look = {center, slack * slack};
  }
  return true;
}

}  // namespace krait::detail
