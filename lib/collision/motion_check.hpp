// SPDX-License-Identifier: Apache-2.0
// COLLISION (section 3) for states and for whole time steps.
//
// A step is free when it is proven so. In the open, by the clearance grid alone: the circle around body k is at least
// a(k) from everything at the step's beginning and b(k) at its end, its centre travels at most t(k), and
// a(k) + b(k) > t(k). Near obstacles, by the body itself: its vertices stay within e(k) of the straight lines between
// their places at the ends, so that it never leaves the hull of both, grown by e(k); the hull must keep away by more.
// Where that is not so, or the robot's limits are not proven to hold in between, the step is halved, down to one part
// of max_substeps, and what remained to prove of the whole is proven of the parts; what is then still unproven counts
// as a collision. So do results of a robot that cannot be used: a state, a control or a frame that is not finite, and a
// Travel that is NaN or negative.
#pragma once

#include "base/arena.hpp"
#include "collision/obstacles.hpp"
#include "krait/geometry.hpp"
#include "krait/robot.hpp"
#include "motion/rk4.hpp"

namespace krait::detail {

class MotionCheck {
 public:
  MotionCheck();

  // 88 bytes a body and 8 a component of the state. Uninitialised: assign comes before all else.
  void allocate(Arena& arena, const Robot& robot);

  // Copies nothing: robot, of the sizes that memory was allocated for, and scene must outlive this. `max_substeps` is a
  // power of two. Without `shortcuts` every body is compared with all obstacles, found by their boxes alone, and every
  // pair of bodies with each other.
  void assign(const Robot& robot, const Scene& scene, float clearance, int max_substeps, bool shortcuts);
  void assign(const Robot&, const Scene&&, float, int, bool) = delete;

  // Makes bodies keep `clearance` metres on top of what rounding needs from now on, and integrates parts of
  // a step by Runge-Kutta steps of at most `longest_step` seconds. O(bodies).
  void keep(float clearance, float longest_step);

  // Makes `state` the one that the next step begins from.
  void begin(const float* state) { place(state, before()); }

  // The frames of the state that the next step begins from.
  const Pose* poses() const { return placements_[before_].poses; }

  // Whether the robot, standing in `state`, keeps the margin everywhere. Discrete. On success the next step begins from
  // it.
  bool free(const float* state);

  // What lacks most of the margin where the robot stands in `state`, the first among equals; none where it keeps the
  // margin everywhere. Call begin before the next step.
  Contact contact(const float* state);

  // False where body 0 does not keep the margin at the end of the step to be checked next, of which `next` has only the
  // leading components: the step is not free then, and the rest need not be found. True promises nothing.
  bool lead_free(const float* state, const float* next);

  // Whether the control is finite and the robot's limits are proven to hold throughout the step, whose ends keep them.
  bool keeps_limits(const float* state, const float* control, float dt, const float* next);

  // Whether the step from `state` (that of begin, or the last step's end) under `control` to `next`, both within the
  // robot's limits, is proven free and within them.
  // On success the next step begins from `next`.
  bool step_free(const float* state, const float* control, float dt, const float* next);

  // Placements tested so far.
  std::uint64_t checks() const { return checks_; }

 private:
  enum class Outcome { free, unproven, hit };

  static_assert(kMaxBodies <= 32, "bodies are marked by the bits of a word");

  // A step leads from `state` under `control` within dt seconds to `next`.
  struct Step {
    const float* state;
    const float* control;
    float dt;
    const float* next;
  };

  // What is to be proven of a step, or what remains of that.
  struct Unproven {
    bool limits;           // that the robot's hold all the way
    bool self;             // that bodies keep away from each other
    std::uint32_t bodies;  // which keep away from obstacles, a bit each
  };

  struct Placement {
    Pose* poses;
    float* circle_room;  // at most the distance of body k's circle, less the margin, by the grid; -infinity where the
                         // grid does not prove that there is one
  };

  struct Circle {
    Vec2 center;   // in the body's frame
    float offset;  // from its origin
  };

  Placement& before() { return placements_[before_]; }
  Placement& after() { return placements_[1 - before_]; }

  void measure_bodies();

  Vec2 center(const Placement& placement, int k) const;

  void place(const float* state, Placement& placement);

  // Whether the state and its frames' headings are; positions that are not have no room.
  bool all_finite(const float* state, const Placement& placement) const;

  // Not finite where one of the numbers is not; nor where they are too large to be added, which nothing in metres,
  // radians and seconds is.
  static float sum_of(const float* numbers, int count);

  // Makes a placement that is free by no proof: body 0 has no room.
  static void leave_no_room(Placement& placement);

  // Finds the room of the first `bodies` bodies.
  void find_room(Placement& placement, int bodies) const;

  // Body k with its vertices relative to `at`.
  PlacedBody placed(const Placement& placement, int k, Vec2 at) const;

  void add_vertices(const Placement& placement, int k, PlacedBody& body) const;

  // The hull of body k at both ends.
  PlacedBody swept(int k, Vec2 at) const;

  // Whether body k, standing, keeps the margin.
  bool keeps_margin(const Placement& placement, int k) const;

  // Bounds the step by what all bodies have in common where that suffices, else body by body; returns whether the
  // limits hold.
  bool bound(const Step& step);

  bool bound_bodies(const Step& step);

  bool usable(const float* control) const;

  // False of a bound that is NaN or negative; infinity is one that proves nothing.
  bool usable(const Travel& travel) const;

  const Travel& travel(int k) const { return bounded_ ? travel_[k] : quick_.most; }

  // Whether body k's circle is proven free on the whole step, by the grid.
  bool circle_free(int k) const { return circle_rooms(k) > travel(k).path + circles_[k].offset * travel(k).turn; }

  float circle_rooms(int k) const { return placements_[0].circle_room[k] + placements_[1].circle_room[k]; }

  // The first body from k on whose circle is not proven free, or bodies_.
  int next_near(int k) const;

  // Whether bodies whose frames' origins are so far apart cannot touch.
  bool far_apart(float separation) const { return separation > 2.0F * farthest_of_all_ + obstacles_.margin(); }

  // How far body k may leave the hull of its two places: never by more than half of what it moved.
  float stray(int k) const;

  // Whether body k is proven free on the whole step, by its hull.
  bool hull_free(const Step& step, int k);

  // Judges the step by what is to be proven of it, and reduces that to what it does not prove.
  Outcome judge(const Step& step, Unproven& unproven);

  // Halves the step until what remains to prove is proven of every part. False when it is not.
  bool prove_by_halves(const Step& step, const Unproven& whole);

  // Whether there are no two bodies at least gap_ apart.
  bool never_touch() const { return bodies_ == 1 || bodies_ <= gap_; }

  // No two bodies at least gap_ apart come within the margin on the whole step.
  bool self_free(const Step& step);

  // No two bodies come within the margin of each other at the step's beginning.
  bool still_apart();

  // A body stays within `farthest` and half its path of the middle between its places. Pairs that are further apart are
  // skipped, and with them all that the chain cannot bring closer.
  bool pairs_free();

  Contact contact_of_pair(const Placement& placement, int i, int j) const;

  bool pair_free(int i, int j) const;

  Robot robot_;
  const Scene* scene_ = nullptr;
  Obstacles obstacles_;
  float longest_step_ = kInfinity;  // seconds
  int max_substeps_ = 16;
  int gap_ = 2;
  int bodies_ = 0;
  bool shortcuts_ = true;
  float farthest_of_all_ = 0.0F;
  bool centered_ = true;  // whether every circle's centre is its body's origin
  bool bounded_ = false;  // whether travel_ bounds the step in question, else quick_
  QuickBound quick_;
  int before_ = 0;
  // Arrays by body.
  Circle* circles_ = nullptr;
  float* needed_ = nullptr;    // clearance at the circle's centre from which on it keeps the margin
  float* farthest_ = nullptr;  // of its vertices from its frame's origin
  Travel* travel_ = nullptr;
  Vec2* centers_ = nullptr;    // halfway between the step's ends,
  float* along_ = nullptr;     // and the length of the line through them so far
  Placement placements_[2]{};  // the step's two ends
  float* middle_[2]{};         // states
  std::uint64_t checks_ = 0;
};

}  // namespace krait::detail
