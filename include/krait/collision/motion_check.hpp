// COLLISION (section 3) for states and for whole time steps.
//
// A step is free when it is proven so. In the open, by the clearance grid alone: the circle around body k is at least
// a(k) from everything at the step's beginning and b(k) at its end, its centre travels at most t(k), and
// a(k) + b(k) > t(k). Near obstacles, by the body itself: its vertices stay within e(k) of the straight lines between
// their places at the ends, so that it never leaves the hull of both, grown by e(k); the hull must keep away by more.
// Where that is not so, or the robot's limits are not proven to hold in between, the step is halved, down to one part
// of max_substeps; what is then still unproven counts as a collision.
#pragma once

#include "krait/collision/obstacles.hpp"
#include "krait/motion/rk4.hpp"
#include "krait/robot/box.hpp"
#include "krait/robot/robot.hpp"

namespace krait {

template <Robot R>
class MotionCheck {
 public:
  // Copies nothing: robot and scene must outlive this. `max_substeps` is a power of two. Without `shortcuts` every body
  // is compared with the obstacles themselves, and every pair of bodies with each other.
  void assign(const R& robot, const Scene& scene, float clearance, int max_substeps, bool shortcuts) {
    robot_ = &robot;
    obstacles_ = Obstacles(scene, clearance);
    max_substeps_ = max_substeps;
    shortcuts_ = shortcuts;
    gap_ = krait::self_collision_gap(robot);
    bodies_ = robot.body_count();
    measure_bodies();
    checks_ = 0;
  }

  // Makes `state` the one that the next step begins from.
  void begin(const float* state) { place(state, left()); }

  // The frames of the state that the next step begins from.
  const Pose* poses() const { return placements_[left_].poses; }

  // Whether the robot, standing in `state`, keeps the margin everywhere. Discrete. On success the next step begins from
  // it.
  bool free(const float* state) {
    place(state, right());
    for (int k = 0; k < bodies_; ++k) {
      if (!clear(right(), k)) return false;
    }
    left_ = 1 - left_;
    return R::kMaxBodies == 1 || bodies_ <= gap_ || still_apart();
  }

  // Whether the robot's limits are proven to hold throughout the step, whose ends keep them.
  bool keeps_limits(const float* state, const float* control, float dt, const float* next) {
    bounded_ = false;
    return bound_bodies({state, control, dt, next});
  }

  // Whether the step from `state` (that of begin, or the last step's end) under `control` to `next`, both within the
  // robot's limits, is proven free and within them.
  // On success the next step begins from `next`.
  bool step_free(const float* state, const float* control, float dt, const float* next) {
    const Step step{state, control, dt, next};
    place(next, right());
    const Outcome whole = judge(step);
    if (whole == Outcome::hit) return false;
    if (whole == Outcome::unproven && !march(step)) return false;
    left_ = 1 - left_;
    return true;
  }

  // Placements tested so far.
  std::uint64_t checks() const { return checks_; }

 private:
  enum class Outcome { free, unproven, hit };

  static constexpr float kReach = 1e-3F;  // metres: how far obstacles are looked for beyond what must be free

  // From `state` under `control` for dt seconds to `next`.
  struct Step {
    const float* state;
    const float* control;
    float dt;
    const float* next;
  };

  struct Placement {
    Pose poses[R::kMaxBodies];
    float circle_room[R::kMaxBodies];  // at most the distance of body k's circle, less the margin, by the grid
  };

  struct Circle {
    Vec2 center;  // in the body's frame
    float offset = 0.0F;
    float radius = 0.0F;
  };

  Placement& left() { return placements_[left_]; }
  Placement& right() { return placements_[1 - left_]; }

  void measure_bodies() {
    farthest_of_all_ = 0.0F;
    for (int k = 0; k < bodies_; ++k) {
      const Polygon body = robot_->body(k);
      const Box box = bounding_box(body);
      Circle circle;
      circle.center = 0.5F * (box.min + box.max);
      for (int i = 0; i < body.count; ++i) {
        const float distance = length(body[i] - circle.center);
        if (distance > circle.radius) circle.radius = distance;
      }
      circle.radius = circle.radius * (1.0F + 1e-6F);
      circle.offset = length(circle.center);
      circles_[k] = circle;
      farthest_[k] = farthest(body.vertices, body.count);
      if (farthest_[k] > farthest_of_all_) farthest_of_all_ = farthest_[k];
    }
  }

  Vec2 center(const Placement& placement, int k) const {
    const Pose& pose = placement.poses[k];
    return pose.position + turned(pose.heading, circles_[k].center);
  }

  void place(const float* state, Placement& placement) {
    robot_->place(StateView(state, robot_->state_size()), placement.poses);
    for (int k = 0; k < bodies_; ++k) {
      placement.circle_room[k] = shortcuts_ ? obstacles_.room_by_grid(center(placement, k), circles_[k].radius) : 0.0F;
    }
    ++checks_;
  }

  // Body k with its vertices relative to `at`.
  PlacedBody placed(const Placement& placement, int k, Vec2 at) const {
    PlacedBody body;
    body.at = at;
    add_vertices(placement, k, body);
    return body;
  }

  void add_vertices(const Placement& placement, int k, PlacedBody& body) const {
    const Polygon shape = robot_->body(k);
    const Pose& pose = placement.poses[k];
    const Vec2 shift = pose.position - body.at;
    for (int i = 0; i < shape.count; ++i) body.vertices[body.count++] = shift + turned(pose.heading, shape[i]);
  }

  // The hull of body k at both ends.
  PlacedBody swept(int k, Vec2 at) const {
    PlacedBody hull = placed(placements_[1 - left_], k, at);
    add_vertices(placements_[left_], k, hull);
    return hull;
  }

  // Whether body k, standing, keeps the margin.
  bool clear(const Placement& placement, int k) const {
    return placement.circle_room[k] > 0.0F ||
           obstacles_.room(placed(placement, k, placement.poses[k].position), kReach) > 0.0F;
  }

  StateView view(const float* state) const { return {state, robot_->state_size()}; }

  // Each body's own bounds in travel_; gives whether the limits hold.
  bool bound_bodies(const Step& step) {
    if (!bounded_) {
      const ControlView control(step.control, robot_->control_size());
      limited_ = robot_->travel(view(step.state), control, step.dt, view(step.next), travel_);
      bounded_ = true;
    }
    return limited_;
  }

  // Whether all circles are proven free from left to right, by the grid and the longest path.
  bool all_circles_free(const Step& step) const {
    const ControlView control(step.control, robot_->control_size());
    const float path = shortcuts_ ? longest_path(*robot_, view(step.state), control, step.dt) : kInfinity;
    for (int k = 0; k < bodies_; ++k) {
      if (circles_[k].offset > 0.0F || !circle_free(k, path)) return false;
    }
    return true;
  }

  // Whether body k's circle, whose centre goes no further than `path`, is proven free from left to right, by the grid.
  bool circle_free(int k, float path) const {
    const float before = placements_[left_].circle_room[k];
    const float after = placements_[1 - left_].circle_room[k];
    return before > 0.0F && after > 0.0F && before + after > path;
  }

  bool circle_free(int k) const { return circle_free(k, travel_[k].path + circles_[k].offset * travel_[k].turn); }

  // Whether bodies whose frames' origins are so far apart cannot touch.
  bool far_apart(float separation) const { return separation > 2.0F * farthest_of_all_ + obstacles_.margin(); }

  // How far body k may leave the hull of its two places: never by more than half of what it moved.
  float stray(int k) const {
    const Travel& travel = travel_[k];
    const float bent = travel.bend + farthest_[k] * travel.twist;
    const float half = 0.5F * (travel.path + farthest_[k] * travel.turn);
    return bent < half ? bent : half;
  }

  // Whether body k is proven free from left to right, by its hull.
  bool hull_free(int k) const {
    const float allowed = stray(k);
    return obstacles_.room(swept(k, placements_[1 - left_].poses[k].position), allowed + kReach) > allowed;
  }

  // Judges the step from left to right.
  Outcome judge(const Step& step) {
    bounded_ = false;
    if (all_circles_free(step)) {
      const ControlView control(step.control, robot_->control_size());
      const QuickBound quick = quick_bound(*robot_, view(step.state), control, step.dt, view(step.next));
      const bool limited = quick.limited || bound_bodies(step);
      return limited && self_free(step, quick.separation) ? Outcome::free : Outcome::unproven;
    }
    bool proven = bound_bodies(step);
    for (int k = 0; k < bodies_; ++k) {
      if (circle_free(k) || (proven && hull_free(k))) continue;
      if (!clear(right(), k)) return Outcome::hit;
      proven = false;
    }
    return proven && self_free(step, 0.0F) ? Outcome::free : Outcome::unproven;
  }

  // Halves the step from left to right until every part is proven free. False when one is not.
  bool march(const Step& step) {
    for (int i = 0; i < robot_->state_size(); ++i) middle_[0][i] = step.state[i];
    int here = 0;
    int done = 0;  // in parts of 1 / max_substeps
    int part = max_substeps_ / 2;
    while (part > 0 && done < max_substeps_) {
      const bool last = done + part >= max_substeps_;
      const float* from = middle_[here];
      float* to = middle_[1 - here];
      const float duration = step.dt * static_cast<float>(part) / static_cast<float>(max_substeps_);
      if (last) {
        for (int i = 0; i < robot_->state_size(); ++i) to[i] = step.next[i];
      } else {
        propagate(*robot_, from, poses(), step.control, duration, to);
      }
      place(to, right());
      const Outcome outcome = judge({from, step.control, duration, to});
      if (outcome == Outcome::hit) return false;
      if (outcome == Outcome::unproven) {
        part /= 2;
        continue;
      }
      done += part;
      here = 1 - here;
      if (done < max_substeps_) left_ = 1 - left_;
      while (done % (2 * part) == 0 && done + 2 * part <= max_substeps_) part *= 2;
    }
    return done >= max_substeps_;
  }

  // No two bodies at least gap_ apart come within the margin on the way from left to right, during which their frames'
  // origins stay at least `separation` apart.
  bool self_free(const Step& step, float separation) {
    if (R::kMaxBodies == 1 || bodies_ <= gap_ || far_apart(separation)) return true;
    bound_bodies(step);
    if (shortcuts_ && far_apart(least_separation(*robot_, view(step.state), view(step.next), travel_))) return true;
    return pairs_free();
  }

  // No two bodies come within the margin of each other at left.
  bool still_apart() {
    right() = left();
    for (int k = 0; k < bodies_; ++k) travel_[k] = {};
    return pairs_free();
  }

  // A body stays within `farthest` and half its path of the middle between its places. Pairs that are further apart are
  // skipped, and with them all that the chain cannot bring closer.
  bool pairs_free() const {
    Vec2 centers[R::kMaxBodies];
    float along[R::kMaxBodies];  // length of the line through the centres
    float path = 0.0F;
    for (int k = 0; k < bodies_; ++k) {
      centers[k] = 0.5F * (placements_[0].poses[k].position + placements_[1].poses[k].position);
      along[k] = k == 0 ? 0.0F : along[k - 1] + length(centers[k] - centers[k - 1]);
      if (travel_[k].path > path) path = travel_[k].path;
    }
    const float near = 2.0F * farthest_of_all_ + path + obstacles_.margin();
    for (int i = 0; i + gap_ < bodies_; ++i) {
      int j = i + gap_;
      while (j < bodies_) {
        const float apart = length(centers[j] - centers[i]) - near;
        if (apart > 0.0F) {
          const float reached = along[j] + apart;
          for (++j; j < bodies_ && along[j] < reached;) ++j;
        } else {
          if (!pair_free(i, j)) return false;
          ++j;
        }
      }
    }
    return true;
  }

  bool pair_free(int i, int j) const {
    const Vec2 at = placements_[1 - left_].poses[i].position;
    const float apart = polygon_distance(swept(i, at).polygon(), swept(j, at).polygon());
    return apart - obstacles_.margin() > stray(i) + stray(j);
  }

  const R* robot_ = nullptr;
  Obstacles obstacles_;
  int max_substeps_ = 16;
  int gap_ = 2;
  int bodies_ = 0;
  bool shortcuts_ = true;
  float farthest_of_all_ = 0.0F;
  Circle circles_[R::kMaxBodies];
  float farthest_[R::kMaxBodies];  // of a body's vertices from its frame's origin
  bool bounded_ = false;           // whether the next two are known of the step in question
  bool limited_ = false;
  Travel travel_[R::kMaxBodies];
  Placement placements_[2];  // the step's two ends
  int left_ = 0;
  float middle_[2][R::kMaxState];
  std::uint64_t checks_ = 0;
};

}  // namespace krait
