// SPDX-License-Identifier: Apache-2.0
// The motion of a plan: what its controls lead to when they are driven from the start, with an error that hardly grows
// with the plan's length. The states of the tree carry the rounding and the truncation of every step on to the next;
// here Runge-Kutta steps are shorter, and a state carries along what rounding took from it. The controls are the
// tree's, but for what keeps this motion on the tree's.
#pragma once

#include "motion/drive.hpp"

namespace krait::detail {

// Determined by start, targets and numbers of steps, as Drive is.
class PlanDrive {
 public:
  // The robot must outlive this; time steps last dt seconds; `state` is where the plan starts, copied.
  void begin(const Robot& robot, float dt, const float* state);

  // Steers toward a target from here on, with a fresh controller.
  void aim(const Target& target) { tree_.aim(target); }

  // Finds the control at state(), whose bodies' frames are `poses`, and the state that it leads to.
  void step(const Pose* poses);

  // Goes there.
  void go();

  const float* state() const { return states_[here_]; }
  const float* control() const { return control_; }         // of the last step
  const float* next() const { return states_[1 - here_]; }  // where it leads, until go
  // The tree's state beside state(): the bits of the vertex that the same targets and steps led to.
  const float* tree_state() const { return tree_.state(); }

 private:
  static constexpr int kUnknownParts = 4;  // for a robot that does not state its rate
  // To first order, a derivative changes along the rests by what it changes along kMagnified times as much, divided by
  // kMagnified, a power of two.
  static constexpr float kMagnified = 4096;

  // The tree's next step, and the control that stays with it.
  void follow_tree(Pose* poses);

  // One Runge-Kutta step from next() on, whose frames are `poses`.
  void integrate(const Pose* poses, float dt);

  // states_ + rests_ is the state, and its rounding error is a float's of the rest. Knuth's exact sum of two floats
  // (The Art of Computer Programming, 4.2.2, Theorem B), then the rest is added.
  void add(int i, float increment);

  // What Runge-Kutta steps in float leave out of the leading components, which the position depends on: a wheel that is
  // a hair faster than its float says turns a robot away within a kilometre. First Simpson's rule replaces the changes
  // that it knows better, then what the rests add to all changes is found, to first order.
  void refine();

  // A component half a step on, by the cubic that has the states and, `apart` from each other, the rates of both ends.
  float halfway(int i, float apart, float& lost) const;

  // Writes the rates of the leading components.
  void rates(const float* at, float* rates) const { robot_.lead_rates(at, control_, rates); }

  // A component whose rate is almost linear over the step, but for `bend`, changes as Simpson's rule says, to the last
  // bit, where short steps in float add up the rounding of each. Not where the rate swings between the three points:
  // there Runge-Kutta found another change.
  void move_steadily(int i, float middle, float bend);

  // a + b - sum, where `sum` is a + b as a float: exact, by Knuth (as above).
  static float sum_error(float a, float b, float sum);

  // a b - rounded, where `rounded` is a b as a float: exact, by Dekker's halves (Numerische Mathematik 18, 1971).
  static float product_error(float a, float b, float rounded);

  Robot robot_;
  float dt_ = 0.1F;
  int parts_ = 1;  // Runge-Kutta steps of a time step
  int here_ = 0;
  float states_[2][kMaxState];
  float rests_[2][kMaxState];
  float control_[kMaxControl];
  Drive tree_;
};

}  // namespace krait::detail
