// SPDX-License-Identifier: Apache-2.0
// COLLISION (section 3) for states and for whole time steps.
//
// A step is free when it is proven so. In the open, by the clearance grid alone: the circle around body k is at least
// a(k) from everything at the step's beginning and b(k) at its end, its centre travels at most t(k), and
// a(k) + b(k) > t(k). Near obstacles, by the body itself: its vertices stay within e(k) of the straight lines between
// their places at the ends, so that it never leaves the hull of both, grown by e(k); the hull must keep away by more.
// Where that is not so, or the robot's limits are not proven to hold in between, the step is halved, down to one part
// of max_substeps, and what was left to prove of the whole is proven of the parts; what is then still unproven counts
// as a collision. So does what a robot answers that is no answer: a state, a control or a frame that is not finite, and
// a Travel that is NaN or negative.
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
  // is compared with all obstacles, found by their boxes alone, and every pair of bodies with each other.
  void assign(const R& robot, const Scene& scene, float clearance, int max_substeps, bool shortcuts) {
    robot_ = &robot;
    scene_ = &scene;
    max_substeps_ = max_substeps;
    shortcuts_ = shortcuts;
    gap_ = krait::self_collision_gap(robot);
    bodies_ = robot.body_count();
    checks_ = 0;
    keep(clearance, kInfinity);
  }
  void assign(const R&&, const Scene&, float, int, bool) = delete;
  void assign(const R&, const Scene&&, float, int, bool) = delete;

  // From now on bodies keep `clearance` metres on top of what rounding needs, and parts of a step are integrated by
  // Runge-Kutta steps of at most `longest_step` seconds. O(bodies).
  void keep(float clearance, float longest_step) {
    obstacles_ = Obstacles(*scene_, clearance, shortcuts_);
    longest_step_ = longest_step;
    measure_bodies();
  }

  // Makes `state` the one that the next step begins from.
  void begin(const float* state) { place(state, left()); }

  // The frames of the state that the next step begins from.
  const Pose* poses() const { return placements_[left_].poses; }

  // Whether the robot, standing in `state`, keeps the margin everywhere. Discrete. On success the next step begins from
  // it.
  bool free(const float* state) {
    place(state, right());
    if (!all_finite(state, right())) return false;
    for (int k = 0; k < bodies_; ++k) {
      if (!clear(right(), k)) return false;
    }
    left_ = 1 - left_;
    return R::kMaxBodies == 1 || bodies_ <= gap_ || still_apart();
  }

  // What lacks most of the margin where the robot stands in `state`, the first among equals; none where it keeps the
  // margin everywhere. The next step must begin anew.
  Contact contact(const float* state) {
    Placement& placement = right();
    robot_->place(StateView(state, robot_->state_size()), placement.poses);
    Contact worst;
    const auto consider = [&worst](Contact contact, int body) {
      if (contact.with == Hindrance::none) return;
      contact.body = static_cast<Index>(body);
      const bool worse = contact.needed - contact.distance > worst.needed - worst.distance;
      if (worst.with == Hindrance::none || worse) worst = contact;
    };
    for (int k = 0; k < bodies_; ++k)
      consider(obstacles_.contact(placed(placement, k, placement.poses[k].position)), k);
    for (int i = 0; i + gap_ < bodies_; ++i) {
      for (int j = i + gap_; j < bodies_; ++j) consider(contact_of_pair(placement, i, j), i);
    }
    return worst;
  }

  // False where body 0 does not keep the margin at the end of the step to be asked next, of which `next` has only the
  // leading components: the step is not free then, and the rest need not be found. True promises nothing.
  bool lead_free(const float* state, const float* next) {
    if constexpr (LeadingRobot<R>) {
      if (bodies_ == 1 || !shortcuts_) return true;
      if (left().circle_room[0] > length(Vec2{next[0], next[1]} - Vec2{state[0], state[1]})) return true;
      robot_->place(StateView(next, robot_->leading_size()), right().poses);
      find_room(right(), 0);
      if (clear(right(), 0)) return true;
      ++checks_;
      return false;
    }
    return true;
  }

  // Whether the control is finite and the robot's limits are proven to hold throughout the step, whose ends keep them.
  bool keeps_limits(const float* state, const float* control, float dt, const float* next) {
    return usable(control) && bound({state, control, dt, next});
  }

  // Whether the step from `state` (that of begin, or the last step's end) under `control` to `next`, both within the
  // robot's limits, is proven free and within them.
  // On success the next step begins from `next`.
  bool step_free(const float* state, const float* control, float dt, const float* next) {
    if (!usable(control)) return false;
    const Step step{state, control, dt, next};
    place(next, right());
    Unproven unproven{true, true, ~0U};
    const Outcome whole = judge(step, unproven);
    if (whole == Outcome::hit) return false;
    if (whole == Outcome::unproven && !march(step, unproven)) return false;
    left_ = 1 - left_;
    return true;
  }

  // Placements tested so far.
  std::uint64_t checks() const { return checks_; }

 private:
  enum class Outcome { free, unproven, hit };

  static_assert(R::kMaxBodies <= 32, "bodies are marked by the bits of a word");
  static constexpr float kReach = 1e-3F;  // metres: how far obstacles are looked for beyond what must be free

  // From `state` under `control` for dt seconds to `next`.
  struct Step {
    const float* state;
    const float* control;
    float dt;
    const float* next;
  };

  // What is to be proven of a step, or what is left of that.
  struct Unproven {
    bool limits;           // that the robot's hold all the way
    bool self;             // that bodies keep away from each other
    std::uint32_t bodies;  // which keep away from obstacles, a bit each
  };

  struct Placement {
    Pose poses[R::kMaxBodies];
    float circle_room[R::kMaxBodies];  // at most the distance of body k's circle, less the margin, by the grid;
                                       // -infinity where the grid does not prove that there is one
  };

  struct Circle {
    Vec2 center;   // in the body's frame
    float offset;  // from its origin
  };

  Placement& left() { return placements_[left_]; }
  Placement& right() { return placements_[1 - left_]; }

  void measure_bodies() {
    farthest_of_all_ = 0.0F;
    centered_ = true;
    for (int k = 0; k < bodies_; ++k) {
      const Polygon body = robot_->body(k);
      const Box box = bounding_box(body);
      const Vec2 center = 0.5F * (box.min + box.max);
      float radius = 0.0F;
      for (int i = 0; i < body.count; ++i) {
        const float distance = length(body[i] - center);
        if (distance > radius) radius = distance;
      }
      circles_[k] = {center, length(center)};
      centered_ = centered_ && circles_[k].offset == 0.0F;
      needed_[k] = shortcuts_ ? radius * (1.0F + 1e-6F) + obstacles_.margin() : kInfinity;
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
    ++checks_;
    for (int k = 0; k < bodies_; ++k) find_room(placement, k);
    if (!kAnswersProven<R> && !all_finite(state, placement)) place_nowhere(placement);
  }

  // Whether the state and its frames' headings are; positions that are not have no room.
  bool all_finite(const float* state, const Placement& placement) const {
    float sum = sum_of(state, robot_->state_size());
    for (int k = 0; k < bodies_; ++k) sum = sum + placement.poses[k].heading.sin + placement.poses[k].heading.cos;
    return finite(sum);
  }

  // Not finite where one of the numbers is not; nor where they are too large to be added, which nothing in metres,
  // radians and seconds is.
  static float sum_of(const float* numbers, int count) {
    float sum = 0.0F;
    for (int i = 0; i < count; ++i) sum = sum + numbers[i];
    return sum;
  }

  // Where nothing is free: body 0 has no room, by whatever proof.
  static void place_nowhere(Placement& placement) {
    placement.poses[0].position.x = std::numeric_limits<float>::quiet_NaN();
    placement.circle_room[0] = -kInfinity;
  }

  void find_room(Placement& placement, int k) const {
    const Vec2 at = centered_ ? placement.poses[k].position : center(placement, k);
    const float room = obstacles_.clearance().at(at) - needed_[k];
    placement.circle_room[k] = room > 0.0F ? room : -kInfinity;
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

  // Bounds the step by what all bodies have in common where that will do, else body by body; returns whether the limits
  // hold.
  bool bound(const Step& step) {
    bounded_ = false;
    if (shortcuts_) {
      quick_ = quick_bound(*robot_, view(step.state), ControlView(step.control, robot_->control_size()), step.dt,
                           view(step.next));
      if (quick_.limited && usable(quick_.most)) return true;
    }
    quick_.separation = 0.0F;
    return bound_bodies(step);
  }

  bool bound_bodies(const Step& step) {
    bounded_ = true;
    bool limited = robot_->travel(view(step.state), ControlView(step.control, robot_->control_size()), step.dt,
                                  view(step.next), travel_);
    for (int k = 0; !kAnswersProven<R> && k < bodies_; ++k) {
      if (usable(travel_[k])) continue;
      travel_[k] = {kInfinity, kInfinity, kInfinity, kInfinity};
      limited = false;
    }
    return limited;
  }

  bool usable(const float* control) const {
    return kAnswersProven<R> || finite(sum_of(control, robot_->control_size()));
  }

  // False of a bound that is NaN or negative; infinity is one that proves nothing.
  static bool usable(const Travel& travel) {
    if constexpr (kAnswersProven<R>) return true;
    return travel.path >= 0.0F && travel.turn >= 0.0F && travel.bend >= 0.0F && travel.twist >= 0.0F;
  }

  const Travel& travel(int k) const { return bounded_ ? travel_[k] : quick_.most; }

  // Whether body k's circle is proven free from left to right, by the grid.
  bool circle_free(int k) const { return circle_rooms(k) > travel(k).path + circles_[k].offset * travel(k).turn; }

  float circle_rooms(int k) const { return placements_[0].circle_room[k] + placements_[1].circle_room[k]; }

  // The first body from k on whose circle is not proven free, or bodies_.
  int next_near(int k) const {
    if (bounded_ || !centered_) {
      while (k < bodies_ && circle_free(k)) ++k;
      return k;
    }
    const float path = quick_.most.path;
    while (k < bodies_ && circle_rooms(k) > path) ++k;
    return k;
  }

  // Whether bodies whose frames' origins are so far apart cannot touch.
  bool far_apart(float separation) const { return separation > 2.0F * farthest_of_all_ + obstacles_.margin(); }

  // How far body k may leave the hull of its two places: never by more than half of what it moved.
  float stray(int k) const {
    const Travel& most = travel(k);
    const float bent = most.bend + farthest_[k] * most.twist;
    const float half = 0.5F * (most.path + farthest_[k] * most.turn);
    return bent < half ? bent : half;
  }

  // Whether body k is proven free from left to right, by its hull.
  bool hull_free(const Step& step, int k) {
    const float allowed = stray(k);
    const float room = obstacles_.room(swept(k, placements_[1 - left_].poses[k].position), allowed + kReach);
    if (room > allowed) return true;
    if (bounded_ || room <= 0.0F) return false;
    bound_bodies(step);
    return room > stray(k);
  }

  // Judges the step from left to right by what is to be proven of it, of which it leaves what is not.
  Outcome judge(const Step& step, Unproven& unproven) {
    const Unproven asked = unproven;
    const bool limited = bound(step);
    unproven = {asked.limits && !limited, false, 0};
    for (int k = next_near(0); k < bodies_; k = next_near(k + 1)) {
      if ((asked.bodies >> k & 1U) == 0 || hull_free(step, k)) continue;
      if (!clear(right(), k)) return Outcome::hit;
      unproven.bodies |= 1U << k;
    }
    unproven.self = asked.self && !self_free(step);
    return unproven.limits || unproven.self || unproven.bodies != 0 ? Outcome::unproven : Outcome::free;
  }

  // Halves the step from left to right until what is left to prove is proven of every part. False when it is not.
  bool march(const Step& step, const Unproven& whole) {
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
        propagate_in_parts(*robot_, from, poses(), step.control, duration,
                           parts_of(duration, longest_step_, kMostPlanParts), to);
      }
      place(to, right());
      Unproven unproven = whole;
      const Outcome outcome = judge({from, step.control, duration, to}, unproven);
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

  // No two bodies at least gap_ apart come within the margin on the way from left to right.
  bool self_free(const Step& step) {
    if (R::kMaxBodies == 1 || bodies_ <= gap_ || far_apart(quick_.separation) || pairs_free()) return true;
    if (bounded_) return false;
    bound_bodies(step);
    return pairs_free();
  }

  // No two bodies come within the margin of each other at left.
  bool still_apart() {
    right() = left();
    bounded_ = false;
    quick_.most = {};
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
      if (travel(k).path > path) path = travel(k).path;
    }
    const float near = 2.0F * farthest_of_all_ + path + obstacles_.margin();
    for (int i = 0; i + gap_ < bodies_; ++i) {
      int j = i + gap_;
      while (j < bodies_) {
        const float apart = length(centers[j] - centers[i]) - near;
        if (apart > 0.0F) {
          const float reached = along[j] + apart;
          for (++j; shortcuts_ && j < bodies_ && along[j] < reached;) ++j;
        } else {
          if (!pair_free(i, j)) return false;
          ++j;
        }
      }
    }
    return true;
  }

  Contact contact_of_pair(const Placement& placement, int i, int j) const {
    const Vec2 at = placement.poses[i].position;
    const Gap gap = polygon_gap(placed(placement, i, at).polygon(), placed(placement, j, at).polygon());
    if (!(gap.distance <= obstacles_.margin())) return {};
    return {Hindrance::body, 0, static_cast<Index>(j), gap.distance, obstacles_.margin(), at + gap.middle};
  }

  bool pair_free(int i, int j) const {
    const Vec2 at = placements_[1 - left_].poses[i].position;
    const float apart = polygon_distance(swept(i, at).polygon(), swept(j, at).polygon());
    return apart - obstacles_.margin() > stray(i) + stray(j);
  }

  const R* robot_ = nullptr;
  const Scene* scene_ = nullptr;
  Obstacles obstacles_;
  float longest_step_ = kInfinity;  // seconds
  int max_substeps_ = 16;
  int gap_ = 2;
  int bodies_ = 0;
  bool shortcuts_ = true;
  float farthest_of_all_ = 0.0F;
  bool centered_ = true;  // whether every circle's centre is its body's origin
  Circle circles_[R::kMaxBodies];
  float needed_[R::kMaxBodies];    // clearance at the circle's centre from which on it keeps the margin
  float farthest_[R::kMaxBodies];  // of a body's vertices from its frame's origin
  bool bounded_ = false;           // whether travel_ tells of the step in question, else quick_
  QuickBound quick_;
  Travel travel_[R::kMaxBodies];
  Placement placements_[2];  // the step's two ends
  int left_ = 0;
  float middle_[2][R::kMaxState];
  std::uint64_t checks_ = 0;
};

}  // namespace krait
