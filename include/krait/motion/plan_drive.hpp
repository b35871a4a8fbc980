// SPDX-License-Identifier: Apache-2.0
// The motion of a plan: what its controls lead to when they are driven from the start, with an error that hardly grows
// with the plan's length. The states of the tree carry the rounding and the truncation of every step on to the next;
// here Runge-Kutta steps are shorter, and a state carries along what rounding took from it. The controls are the
// tree's, but for what keeps this motion on the tree's.
#pragma once

#include "krait/motion/drive.hpp"

namespace krait {

// Determined by start, targets and numbers of steps, as Drive is.
template <Robot R>
class PlanDrive {
 public:
  // The robot must outlive this; time steps last dt seconds; `state` is where the plan starts, copied.
  void begin(const R& robot, float dt, const float* state) {
    robot_ = &robot;
    dt_ = dt;
    tree_.assign(robot, dt);
    tree_.begin(state);
    const float longest = longest_plan_step(robot, dt);
    parts_ = longest < kInfinity ? parts_of(dt, longest, kMostPlanParts) : kUnknownParts;
    for (int i = 0; i < robot.state_size(); ++i) {
      states_[here_][i] = state[i];
      rests_[here_][i] = 0.0F;
    }
  }
  void begin(const R&&, float, const float*) = delete;

  // Where to go from here, with a fresh controller.
  void aim(const Target& target) { tree_.aim(target); }

  // Finds the control at state(), whose bodies' frames are `poses`, and the state that it leads to.
  void step(const Pose* poses) {
    const int size = robot_->state_size();
    float* const next = states_[1 - here_];
    Pose own[R::kMaxBodies];
    follow_tree(own);
    for (int i = 0; i < size; ++i) {
      next[i] = state()[i];
      rests_[1 - here_][i] = rests_[here_][i];
    }
    const float part = dt_ / static_cast<float>(parts_);
    integrate(poses, part);
    for (int done = 1; done < parts_; ++done) {
      robot_->place(StateView(next, size), own);
      integrate(own, part);
    }
    refine();
  }

  // Goes there.
  void go() {
    here_ = 1 - here_;
    tree_.go();
  }

  const float* state() const { return states_[here_]; }
  const float* control() const { return control_; }         // of the last step
  const float* next() const { return states_[1 - here_]; }  // where it leads, until go
  // The tree's state beside state(): the bits of the vertex that the same targets and steps led to.
  const float* tree_state() const { return tree_.state(); }

 private:
  static constexpr int kUnknownParts = 4;  // for a robot that does not state its rate
  // To first order, a derivative changes along the rests as along so many times as much, divided by that: a power of
  // two.
  static constexpr float kMagnified = 4096;

  // The tree's next step, and the control that stays with it.
  void follow_tree(Pose* poses) {
    const int size = robot_->state_size();
    const StateView reference(tree_.state(), size);
    robot_->place(reference, poses);
    tree_.lead(poses);
    tree_.follow(poses);
    for (int i = 0; i < robot_->control_size(); ++i) control_[i] = tree_.control()[i];
    track(*robot_, StateView(state(), size), reference, dt_, ControlRef(control_, robot_->control_size()));
  }

  // One Runge-Kutta step from next() on, whose frames are `poses`.
  void integrate(const Pose* poses, float dt) {
    const StateView from(next(), robot_->state_size());
    float d[R::kMaxState];
    motion_.integrate_lead(*robot_, from, poses, control_, dt, d);
    motion_.integrate_rest(*robot_, from, poses, dt, d);
    for (int i = 0; i < robot_->state_size(); ++i) add(i, d[i]);
  }

  // states_ + rests_ is the state, and its rounding error is a float's of the rest. Knuth's exact sum of two floats
  // (The Art of Computer Programming, 4.2.2, Theorem B), then the rest is added.
  void add(int i, float increment) {
    float& state = states_[1 - here_][i];
    float& rest = rests_[1 - here_][i];
    const float sum = state + increment;
    rest = rest + sum_error(state, increment, sum);
    state = sum + rest;
    rest = rest - (state - sum);
  }

  // What Runge-Kutta steps in float leave out of the leading components, which the position depends on: a wheel that is
  // a hair faster than its float says turns a robot away within a kilometre. First Simpson's rule replaces the changes
  // that it knows better, then what the rests add to all changes is found, to first order.
  void refine() {
    constexpr float kSimpson = 2.0F / 3.0F;  // the weight of the middle, whose rounding counts as a rest
    const int size = leading_size(*robot_);
    float first[R::kMaxState];
    float middle[R::kMaxState];
    float last[R::kMaxState];
    float at[R::kMaxState] = {};  // for compilers that doubt that the size is above 0
    float lost[R::kMaxState];     // of `at`, by rounding
    rates(state(), first);
    rates(next(), last);
    for (int i = 0; i < size; ++i) at[i] = halfway(i, first[i] - last[i], lost[i]);
    rates(at, middle);
    for (int i = 0; i < size; ++i) {
      move_steadily(i, middle[i], (first[i] - middle[i]) + (last[i] - middle[i]));
      at[i] = at[i] + kMagnified * (0.5F * (rests_[here_][i] + rests_[1 - here_][i]) + kSimpson * lost[i]);
    }
    rates(at, last);
    for (int i = 0; i < size; ++i) add(i, dt_ / kMagnified * (last[i] - middle[i]));
  }

  // A component half a step on, by the cubic that has the states and, `apart` from each other, the rates of both ends.
  float halfway(int i, float apart, float& lost) const {
    const float sum = state()[i] + next()[i];
    const float bulge = dt_ / 8.0F * apart;
    const float at = 0.5F * sum + bulge;
    lost = 0.5F * sum_error(state()[i], next()[i], sum) + sum_error(0.5F * sum, bulge, at);
    return at;
  }

  // Of the leading components.
  void rates(const float* at, float* rates) const {
    const int size = leading_size(*robot_);
    robot_->derivative(StateView(at, size), ControlView(control_, robot_->control_size()), StateRef(rates, size));
  }

  // A component whose rate is almost linear over the step, but for `bend`, changes as Simpson's rule says, to the last
  // bit, where short steps in float add up the rounding of each. Not where the rate swings between the three points:
  // there Runge-Kutta found another change.
  void move_steadily(int i, float middle, float bend) {
    constexpr float kSame = 1e-5F;  // of the change
    constexpr float kNear = 1e-6F;
    float& next = states_[1 - here_][i];
    float& rest = rests_[1 - here_][i];
    const float change = product(middle, dt_);
    const float bent = dt_ / 6.0F * bend;
    const float found = (next - state()[i]) + (rest - rests_[here_][i]);
    if (!(absolute(bent) <= kNear)) return;
    if (!(absolute((change + bent) - found) <= kSame * absolute(change) + kNear)) return;
    next = state()[i];
    rest = rests_[here_][i];
    add(i, change);
    add(i, product_error(middle, dt_, change) + bent);
  }

  // a + b - sum, where `sum` is a + b as a float: exact, by Knuth (as above).
  static float sum_error(float a, float b, float sum) {
    const float added = sum - a;
    return (a - (sum - added)) + (b - added);
  }

  // a b - rounded, where `rounded` is a b as a float: exact, by Dekker's halves (Numerische Mathematik 18, 1971).
  static float product_error(float a, float b, float rounded) {
    const auto high = [](float x) {
      constexpr float kSplitter = 4097.0F;
      const float scaled = kSplitter * x;
      return scaled - (scaled - x);
    };
    const float ah = high(a);
    const float bh = high(b);
    const float al = a - ah;
    const float bl = b - bh;
    return ((ah * bh - rounded) + ah * bl + al * bh) + al * bl;
  }

  const R* robot_ = nullptr;
  float dt_ = 0.1F;
  int parts_ = 1;  // Runge-Kutta steps of a time step
  int here_ = 0;
  float states_[2][R::kMaxState];
  float rests_[2][R::kMaxState];
  float control_[R::kMaxControl];
  Drive<R> tree_;
  Motion<R> motion_;
};

}  // namespace krait
