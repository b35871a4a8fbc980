// SPDX-License-Identifier: Apache-2.0
/// \file
/// A solved plan: driven again from the start by a cursor in O(1) memory, or copied.
#pragma once

#include <cstddef>
#include <cstdint>

#include "krait/geometry.hpp"
#include "krait/robot.hpp"

namespace krait {

namespace detail {

class MotionTree;
class Search;
class TargetGrid;
class Way;
struct PackedTarget;

// The legs of a plan, one after the other: a path of the motion tree, or a way that was found later.
class PlanPath {
 public:
  PlanPath() = default;
  // `first` is the path's first expansion, kNone for a plan of one state.
  PlanPath(const MotionTree& tree, Index first) : tree_(&tree), first_(first) {}
  PlanPath(const Way& way, const TargetGrid& grid);

  Index first() const { return first_; }  // kNone: no leg
  Index next(Index leg) const;
  Target target(Index leg) const;
  const PackedTarget& packed(Index leg) const;
  std::uint32_t steps(Index leg) const;

 private:
  const MotionTree* tree_ = nullptr;  // or
  const Way* way_ = nullptr;
  const TargetGrid* grid_ = nullptr;
  Index first_ = kNone;
};

}  // namespace detail

/// Walks along a plan: s0 u0 s1 u1 … sL. It owns its memory, about a kilobyte. The robot and the planner must outlive
/// it, and the planner's next start, improve or init invalidates it. Every function is O(1) where nothing else is
/// stated.
class PlanCursor {
 public:
  /// A cursor of no plan: it is done and has no state.
  PlanCursor();

  int state_size() const;    ///< floats of a state; 0 without a plan
  int control_size() const;  ///< floats of a control; 0 without a plan

  /// Whether this is the last state.
  bool done() const;
  /// state_size() floats in the cursor, valid until its next advance.
  const float* state() const;
  /// control_size() floats in the cursor, held for dt from this state on, valid until its next advance; must not be
  /// called when done.
  const float* control() const;
  /// The state that the control leads to: state_size() floats in the cursor, valid until its next advance; must not be
  /// called when done.
  const float* next() const;

  /// Goes on to the next state; must not be called when done. Work: one control and the Runge-Kutta steps of a time
  /// step of the plan and of the tree beside it.
  void advance();

 private:
  friend class Plan;
  // `start` is robot.state_size() floats, which must stay. As much work as advance.
  PlanCursor(const Robot& robot, const detail::PlanPath& path, const float* start, float dt);

  // The size of a detail::PlanWalk.
  static constexpr std::size_t kWalkBytes = sizeof(void*) == 8 ? 1104 : 1064;

  alignas(std::uint64_t) std::byte walk_[kWalkBytes];
};

/// What a search found, in the planner's memory: valid until its next start, improve or init. Every function is O(1)
/// where nothing else is stated.
class Plan {
 public:
  Plan() = default;  ///< an empty one

  bool empty() const { return start_ == nullptr; }                          ///< whether there is no plan
  std::uint32_t steps() const { return steps_; }                            ///< controls, each held for dt()
  int state_size() const { return empty() ? 0 : robot_.state_size(); }      ///< floats of a state; 0 for no plan
  int control_size() const { return empty() ? 0 : robot_.control_size(); }  ///< floats of a control; 0 for no plan
  float dt() const { return dt_; }                                          ///< seconds, a time step
  float duration() const { return dt_ * static_cast<float>(steps_); }       ///< seconds

  /// A cursor at the first state; of an empty plan one that is done and has no state. As much work as
  /// PlanCursor::advance.
  PlanCursor cursor() const { return empty() ? PlanCursor() : PlanCursor(robot_, path_, start_, dt_); }

  /// Metres, of the line through the positions; 0 for no plan. O(steps).
  float length() const;

  /// FNV-1a 64 over s0, u0, s1, u1, …, sL, each float as 4 little-endian bytes; 0 for no plan. O(steps).
  std::uint64_t hash() const;

  /// Writes (steps() + 1) * state_size() and steps() * control_size() floats into the caller's arrays; nothing for no
  /// plan. O(steps).
  void copy(float* states, float* controls) const;

 private:
  friend class detail::Search;
  // `start` is robot.state_size() floats, which must stay. O(legs).
  Plan(const Robot& robot, const detail::PlanPath& path, const float* start, float dt);

  Robot robot_;
  detail::PlanPath path_;
  const float* start_ = nullptr;
  float dt_ = 0.0F;
  std::uint32_t steps_ = 0;
};

}  // namespace krait
