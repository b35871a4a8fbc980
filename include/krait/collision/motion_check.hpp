// COLLISION (section 3) for states and for whole time steps.
//
// A step is free when it is proven so: no point of body k travels further than t(k) during it, so where the body is
// a(k) from everything at the step's beginning and b(k) at its end, a(k) + b(k) > t(k) means that it was never touched.
// Where that is not so, or the robot's limits are not proven to hold in between, the step is halved, down to one part
// of max_substeps; what is then still unproven counts as a collision.
#pragma once

#include "krait/collision/obstacles.hpp"
#include "krait/motion/rk4.hpp"
#include "krait/robot/robot.hpp"

namespace krait {

template <Robot R>
class MotionCheck {
 public:
  // Copies nothing: robot and scene must outlive this. `max_substeps` is a power of two.
  void assign(const R& robot, const Scene& scene, float clearance, int max_substeps) {
    robot_ = &robot;
    obstacles_ = Obstacles(scene, clearance);
    max_substeps_ = max_substeps;
    gap_ = krait::self_collision_gap(robot);
    bodies_ = robot.body_count();
    measure_bodies();
    checks_ = 0;
  }

  // Whether the robot, standing in `state`, keeps the margin everywhere. Discrete.
  bool free(const float* state) {
    place(state, left_);
    for (int k = 0; k < bodies_; ++k) {
      if (!(room(left_, k, 0.0F) > 0.0F)) return false;
    }
    return self_free(left_, left_, 0.0F, nullptr);
  }

  // Makes `state` the one that the next step begins from.
  void begin(const float* state) {
    place(state, left_);
    for (int k = 0; k < bodies_; ++k) left_.room[k] = -1.0F;  // not known yet
  }

  // Whether the step from `state` (that of begin, or the last step's end) under `control` to `next`, both within the
  // robot's limits, is proven free and within them.
  // On success the next step begins from `next`.
  bool step_free(const float* state, const float* control, float dt, const float* next) {
    place(next, right_);
    const Outcome whole = judge(state, control, dt, next);
    if (whole == Outcome::hit) return false;
    if (whole == Outcome::unproven && !march(state, control, dt, next)) return false;
    swap_sides();
    return true;
  }

  // Placements tested so far.
  std::uint64_t checks() const { return checks_; }

 private:
  enum class Outcome { free, unproven, hit };

  static constexpr float kLeastReach = 1e-3F;  // metres: how far obstacles are looked for around a body that stands

  struct Placement {
    Pose poses[R::kMaxBodies];
    float room[R::kMaxBodies];  // at most the distance to obstacles and bounds, less the margin; -1: not known
  };

  struct Circle {
    Vec2 center;  // in the body's frame
    float radius;
  };

  void measure_bodies() {
    largest_radius_ = 0.0F;
    for (int k = 0; k < bodies_; ++k) {
      const Polygon body = robot_->body(k);
      Vec2 low = body[0];
      Vec2 high = body[0];
      for (int i = 1; i < body.count; ++i) {
        low = {body[i].x < low.x ? body[i].x : low.x, body[i].y < low.y ? body[i].y : low.y};
        high = {body[i].x > high.x ? body[i].x : high.x, body[i].y > high.y ? body[i].y : high.y};
      }
      circles_[k] = {0.5F * (low + high), 0.0F};
      for (int i = 0; i < body.count; ++i) {
        const float distance = length(body[i] - circles_[k].center);
        if (distance > circles_[k].radius) circles_[k].radius = distance;
      }
      circles_[k].radius = circles_[k].radius * (1.0F + 1e-6F);
      if (circles_[k].radius > largest_radius_) largest_radius_ = circles_[k].radius;
    }
  }

  Vec2 center(const Placement& placement, int k) const {
    return placement.poses[k].position + turned(placement.poses[k].heading, circles_[k].center);
  }

  void place(const float* state, Placement& placement) {
    robot_->place(StateView(state, robot_->state_size()), placement.poses);
    ++checks_;
  }

  // Body k with its vertices relative to `at`.
  PlacedBody placed(const Placement& placement, int k, Vec2 at) const {
    const Polygon shape = robot_->body(k);
    const Pose& pose = placement.poses[k];
    PlacedBody body;
    body.at = at;
    body.count = shape.count;
    const Vec2 shift = pose.position - at;
    for (int i = 0; i < shape.count; ++i) body.vertices[i] = shift + turned(pose.heading, shape[i]);
    body.center = center(placement, k);
    body.radius = circles_[k].radius;
    return body;
  }

  // At least `half` of what is free around body k, by the grid if that suffices, else exactly up to 1.25 times `half`
  // twice over.
  float room(Placement& placement, int k, float half) const {
    const float by_grid = obstacles_.room_by_grid(center(placement, k), circles_[k].radius);
    if (by_grid > half) return placement.room[k] = by_grid;
    const float reach = 2.5F * half + kLeastReach;
    return placement.room[k] = obstacles_.room(placed(placement, k, placement.poses[k].position), reach);
  }

  // Judges left_ to right_, the ends of a step of dt seconds from `state` to `next`.
  Outcome judge(const float* state, const float* control, float dt, const float* next) {
    const StateView s(state, robot_->state_size());
    const ControlView u(control, robot_->control_size());
    float travel[R::kMaxBodies];
    float longest = 0.0F;
    const bool limited = keeps_limits(*robot_, s, u, dt, StateView(next, robot_->state_size()));
    Outcome outcome = limited ? Outcome::free : Outcome::unproven;
    for (int k = 0; k < bodies_; ++k) {
      travel[k] = robot_->travel(s, u, dt, k);
      if (travel[k] > longest) longest = travel[k];
      const float half = 0.5F * travel[k];
      if (!(room(right_, k, half) > 0.0F)) return Outcome::hit;
      if (left_.room[k] < half) room(left_, k, half);
      if (!(left_.room[k] + right_.room[k] > travel[k])) outcome = Outcome::unproven;
    }
    if (outcome == Outcome::free && !self_free(left_, right_, longest, travel)) outcome = Outcome::unproven;
    return outcome;
  }

  // Halves the step from left to right until every part is proven free. False when one is not.
  bool march(const float* state, const float* control, float dt, const float* next) {
    for (int i = 0; i < robot_->state_size(); ++i) middle_[0][i] = state[i];
    int here = 0;
    int done = 0;  // in parts of 1 / max_substeps
    int part = max_substeps_ / 2;
    while (part > 0 && done < max_substeps_) {
      const bool last = done + part >= max_substeps_;
      const float* from = middle_[here];
      float* to = middle_[1 - here];
      const float duration = dt * static_cast<float>(part) / static_cast<float>(max_substeps_);
      if (last) {
        for (int i = 0; i < robot_->state_size(); ++i) to[i] = next[i];
      } else {
        propagate(*robot_, from, control, duration, to);
      }
      place(to, right_);
      const Outcome outcome = judge(from, control, duration, to);
      if (outcome == Outcome::hit) return false;
      if (outcome == Outcome::unproven) {
        part /= 2;
        continue;
      }
      done += part;
      here = 1 - here;
      if (done < max_substeps_) swap_sides();
      while (done % (2 * part) == 0 && done + 2 * part <= max_substeps_) part *= 2;
    }
    return done >= max_substeps_;
  }

  void swap_sides() { left_ = right_; }

  // No two bodies at least gap_ apart come within the margin, at right or while no point of them moved further than
  // `longest` from left. Bodies whose circles are far apart are skipped, and with them all that the chain cannot
  // bring closer.
  bool self_free(const Placement& left, const Placement& right, float longest, const float* travel) const {
    if (R::kMaxBodies == 1 || bodies_ <= gap_) return true;
    Vec2 centers[R::kMaxBodies];
    float along[R::kMaxBodies];  // length of the line through the centres
    for (int k = 0; k < bodies_; ++k) {
      centers[k] = center(right, k);
      along[k] = k == 0 ? 0.0F : along[k - 1] + length(centers[k] - centers[k - 1]);
    }
    const float near = 2.0F * (largest_radius_ + longest) + obstacles_.margin();
    for (int i = 0; i + gap_ < bodies_; ++i) {
      int j = i + gap_;
      while (j < bodies_) {
        const float apart = length(centers[j] - centers[i]) - near;
        if (apart > 0.0F) {
          const float reached = along[j] + apart;
          for (++j; j < bodies_ && along[j] < reached;) ++j;
        } else {
          if (!pair_free(left, right, i, j, travel)) return false;
          ++j;
        }
      }
    }
    return true;
  }

  float pair_distance(const Placement& placement, int i, int j) const {
    const Vec2 at = placement.poses[i].position;
    return polygon_distance(placed(placement, i, at).polygon(), placed(placement, j, at).polygon()) -
           obstacles_.margin();
  }

  bool pair_free(const Placement& left, const Placement& right, int i, int j, const float* travel) const {
    const float after = pair_distance(right, i, j);
    if (!(after > 0.0F)) return false;
    if (travel == nullptr) return true;
    const float moved = travel[i] + travel[j];
    return after > moved || after + pair_distance(left, i, j) > moved;
  }

  const R* robot_ = nullptr;
  Obstacles obstacles_;
  int max_substeps_ = 16;
  int gap_ = 2;
  int bodies_ = 0;
  float largest_radius_ = 0.0F;
  Circle circles_[R::kMaxBodies];
  Placement left_;
  Placement right_;
  float middle_[2][R::kMaxState];
  std::uint64_t checks_ = 0;
};

}  // namespace krait
