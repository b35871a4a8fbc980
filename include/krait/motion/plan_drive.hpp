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
    const float added = sum - state;
    rest = rest + ((state - (sum - added)) + (increment - added));
    state = sum + rest;
    rest = rest - (state - sum);
  }

  // What Runge-Kutta steps in float leave out of the leading components, which the position depends on: a wheel that is
  // a hair faster than its float says turns a robot away within a kilometre.
  void refine() {
    const int size = leading_size(*robot_);
    float at[R::kMaxState];
    float first[R::kMaxState];
    float middle[R::kMaxState];
    float last[R::kMaxState];
    for (int i = 0; i < size; ++i) at[i] = 0.5F * (state()[i] + next()[i]);
    rates(state(), first);
    rates(at, middle);
    rates(next(), last);
    for (int i = 0; i < size; ++i) {
      if (first[i] == middle[i] && middle[i] == last[i]) move_steadily(i, first[i]);
      at[i] = at[i] + kMagnified * 0.5F * (rests_[here_][i] + rests_[1 - here_][i]);
    }
    rates(at, last);
    for (int i = 0; i < size; ++i) add(i, dt_ / kMagnified * (last[i] - middle[i]));
  }

  // Of the leading components.
  void rates(const float* at, float* rates) const {
    const int size = leading_size(*robot_);
    robot_->derivative(StateView(at, size), ControlView(control_, robot_->control_size()), StateRef(rates, size));
  }

  // A component whose rate is the same at both ends and between them, as that of one that a control sets: it changes by
  // rate times dt, to the last bit. Not where a rate only returns to what it was, as that of the position does when the
  // heading swings to and fro: there Runge-Kutta found another change.
  void move_steadily(int i, float rate) {
    constexpr float kSame = 1e-5F;
    float& next = states_[1 - here_][i];
    float& rest = rests_[1 - here_][i];
    const float change = product(rate, dt_);
    const float found = (next - state()[i]) + (rest - rests_[here_][i]);
    if (!(absolute(change - found) <= kSame * absolute(change))) return;
    next = state()[i];
    rest = rests_[here_][i];
    add(i, change);
    add(i, product_error(rate, dt_, change));
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
