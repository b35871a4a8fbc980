// SPDX-License-Identifier: Apache-2.0
// A solved plan: driven again from the start by a cursor in O(1) memory, or copied. Its states are those of PlanDrive.
#pragma once

#include <cstdint>

#include "krait/base/contract.hpp"
#include "krait/motion/plan_drive.hpp"
#include "krait/plan/motion_tree.hpp"
#include "krait/plan/way.hpp"

namespace krait {

// Folds floats into an FNV-1a 64 hash, each as 4 little-endian bytes.
class Fnv {
 public:
  void add(const float* values, int count);
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325ULL;
};

struct PlanMeasures {
  std::uint32_t steps = 0;
  float length = 0.0F;     // metres, of the line through the positions
  std::uint64_t hash = 0;  // FNV-1a 64 over s0, u0, s1, u1, …, sL
};

// Measures a plan step by step, in the order in which it is driven.
class PlanMeter {
 public:
  // One step; arrays of state_size and control_size floats.
  void add(const float* state, int state_size, const float* control, int control_size, const float* next);

  float length() const { return measures_.length; }  // metres, so far

  // The measures of the plan that ends with `state`.
  PlanMeasures end(const float* state, int state_size);

 private:
  PlanMeasures measures_;
  Fnv hash_;
};

// The legs of a plan, one after the other: a path of the motion tree, or a way that was found later.
class PlanPath {
 public:
  PlanPath() = default;
  // `first` is the path's first expansion, kNone for a plan of one state.
  PlanPath(const MotionTree& tree, Index first) : tree_(&tree), first_(first) {}
  PlanPath(const Way& way, const TargetGrid& grid) : way_(&way), grid_(&grid), first_(way.count() > 0 ? 0 : kNone) {}

  Index first() const { return first_; }  // kNone: no leg
  Index next(Index leg) const;
  Target target(Index leg) const { return tree_ != nullptr ? tree_->target(leg) : grid_->unpack((*way_)[leg].target); }
  std::uint32_t steps(Index leg) const { return tree_ != nullptr ? tree_->steps(leg) : (*way_)[leg].steps; }

 private:
  const MotionTree* tree_ = nullptr;  // or
  const Way* way_ = nullptr;
  const TargetGrid* grid_ = nullptr;
  Index first_ = kNone;
};

// Walks along a plan: s0 u0 s1 u1 … sL. Its memory is its own.
class PlanCursor {
 public:
  PlanCursor() = default;
  PlanCursor(const Robot& robot, const PlanPath& path, const float* start, float dt);

  int state_size() const { return robot_.state_size(); }
  int control_size() const { return robot_.control_size(); }

  // Whether this is the last state.
  bool done() const { return leg_ == kNone; }
  // state_size() floats.
  const float* state() const { return drive_.state(); }
  // control_size() floats, held for dt from this state on; not when done.
  const float* control() const {
    KRAIT_ASSERT(!done());
    return drive_.control();
  }
  // The state that the control leads to; not when done.
  const float* next() const {
    KRAIT_ASSERT(!done());
    return drive_.next();
  }

  // On to the next state; not when done. Work: one control and the Runge-Kutta steps of a time step.
  void advance();

 private:
  void enter();

  void step();

  Robot robot_;
  PlanPath path_;
  Index leg_ = kNone;
  std::uint32_t step_ = 0;
  PlanDrive drive_;
};

// What a search found, in the planner's memory: valid until its next start or improve.
class Plan {
 public:
  Plan() = default;
  // `start` is robot.state_size() floats.
  Plan(const Robot& robot, const PlanPath& path, const float* start, float dt);

  bool empty() const { return start_ == nullptr; }
  std::uint32_t steps() const { return steps_; }
  int state_size() const { return empty() ? 0 : robot_.state_size(); }
  int control_size() const { return empty() ? 0 : robot_.control_size(); }
  float dt() const { return dt_; }                                     // seconds
  float duration() const { return dt_ * static_cast<float>(steps_); }  // seconds

  // From the first state; of an empty plan one that is done and has no state.
  PlanCursor cursor() const { return empty() ? PlanCursor() : PlanCursor(robot_, path_, start_, dt_); }

  // Metres, of the line through the positions; 0 for no plan. O(steps).
  float length() const { return empty() ? 0.0F : measures().length; }

  // FNV-1a 64 over s0, u0, s1, u1, …, sL; 0 for no plan. O(steps).
  std::uint64_t hash() const { return empty() ? 0 : measures().hash; }

  // (steps() + 1) * state_size() and steps() * control_size() floats into the caller's arrays. O(steps).
  void copy(float* states, float* controls) const;

 private:
  PlanMeasures measures() const;

  Robot robot_;
  PlanPath path_;
  const float* start_ = nullptr;
  float dt_ = 0.0F;
  std::uint32_t steps_ = 0;
};

}  // namespace krait
