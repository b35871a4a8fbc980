// A solved plan: driven again from the start by a cursor in O(1) memory, or copied.
#pragma once

#include <cstdint>

#include "krait/motion/drive.hpp"
#include "krait/search/motion_tree.hpp"

namespace krait {

// Folds floats into an FNV-1a 64 hash, each as 4 little-endian bytes.
class Fnv {
 public:
  void add(const float* values, int count);
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325ULL;
};

// Walks along a plan: s0 u0 s1 u1 … sL. Its memory is its own.
template <Robot R>
class PlanCursor {
 public:
  PlanCursor(const R& robot, const MotionTree& tree, Index first, const float* start, float dt)
      : robot_(&robot), tree_(&tree), expansion_(first), dt_(dt) {
    drive_.begin(robot, start);
    enter();
  }

  int state_size() const { return robot_->state_size(); }
  int control_size() const { return robot_->control_size(); }

  // Whether this is the last state.
  bool done() const { return expansion_ == kNone; }
  // state_size() floats.
  const float* state() const { return drive_.state(); }
  // control_size() floats, held for dt from this state on; not when done.
  const float* control() const { return drive_.control(); }

  // On to the next state; not when done. Work: one control and one RK4 step.
  void advance() {
    drive_.go();
    if (++step_ == tree_->steps(expansion_)) {
      expansion_ = tree_->next_of_path(expansion_);
      enter();
    } else {
      step();
    }
  }

 private:
  void enter() {
    step_ = 0;
    if (expansion_ == kNone) return;
    Target target = tree_->target(expansion_);
    target.dt = dt_;
    drive_.aim(target);
    step();
  }

  void step() {
    Pose poses[R::kMaxBodies];
    robot_->place(StateView(drive_.state(), state_size()), poses);
    drive_.lead(poses);
    drive_.follow(poses);
  }

  const R* robot_;
  const MotionTree* tree_;
  Index expansion_;
  std::uint32_t step_ = 0;
  float dt_;
  Drive<R> drive_;
};

struct PlanMeasures {
  std::uint32_t steps = 0;
  float length = 0.0F;     // metres, of the line through the positions
  std::uint64_t hash = 0;  // FNV-1a 64 over s0, u0, s1, u1, …, sL
};

// Of the rest of a plan; the cursor goes to its end. Calls watch(control) at every step.
template <Robot R, class Watch>
PlanMeasures measure(PlanCursor<R>& at, Watch watch) {
  PlanMeasures measures;
  Fnv hash;
  for (; !at.done(); ++measures.steps) {
    hash.add(at.state(), at.state_size());
    hash.add(at.control(), at.control_size());
    watch(at.control());
    const Vec2 before{at.state()[0], at.state()[1]};
    at.advance();
    measures.length += length(Vec2{at.state()[0], at.state()[1]} - before);
  }
  hash.add(at.state(), at.state_size());
  measures.hash = hash.value();
  return measures;
}

// What a search found, in the planner's memory: valid until its next start.
template <Robot R>
class Plan {
 public:
  Plan() = default;
  // `start` is robot.state_size() floats; `first` the path's first expansion in the tree, kNone for a plan of one
  // state.
  Plan(const R& robot, const MotionTree& tree, Index first, const float* start, float dt)
      : robot_(&robot), tree_(&tree), first_(first), start_(start), dt_(dt) {
    for (Index e = first; e != kNone; e = tree.next_of_path(e)) steps_ += tree.steps(e);
  }

  bool empty() const { return start_ == nullptr; }
  std::uint32_t steps() const { return steps_; }
  int state_size() const { return empty() ? 0 : robot_->state_size(); }
  int control_size() const { return empty() ? 0 : robot_->control_size(); }
  float dt() const { return dt_; }                                     // seconds
  float duration() const { return dt_ * static_cast<float>(steps_); }  // seconds

  // From the first state; not of an empty plan.
  PlanCursor<R> cursor() const { return {*robot_, *tree_, first_, start_, dt_}; }

  // Metres, of the line through the positions; 0 for no plan. O(steps).
  float length() const { return empty() ? 0.0F : measures().length; }

  // FNV-1a 64 over s0, u0, s1, u1, …, sL; 0 for no plan. O(steps).
  std::uint64_t hash() const { return empty() ? 0 : measures().hash; }

  // (steps() + 1) * state_size() and steps() * control_size() floats into the caller's arrays. O(steps).
  void copy(float* states, float* controls) const {
    if (empty()) return;
    PlanCursor<R> at = cursor();
    for (; !at.done(); at.advance()) {
      for (int i = 0; i < state_size(); ++i) *states++ = at.state()[i];
      for (int i = 0; i < control_size(); ++i) *controls++ = at.control()[i];
    }
    for (int i = 0; i < state_size(); ++i) *states++ = at.state()[i];
  }

 private:
  PlanMeasures measures() const {
    PlanCursor<R> at = cursor();
    return measure(at, [](const float*) {});
  }

  const R* robot_ = nullptr;
  const MotionTree* tree_ = nullptr;
  Index first_ = kNone;
  const float* start_ = nullptr;
  float dt_ = 0.0F;
  std::uint32_t steps_ = 0;
};

}  // namespace krait
