// SPDX-License-Identifier: Apache-2.0
// What a search did, step by step, so that each part of a step can be done again and timed alone.
#pragma once

#include <utility>
#include <vector>

#include "krait/planner.hpp"
#include "krait/robots/snake.hpp"
#include "motion/rk4.hpp"

namespace krait::bench {

// A step that was tried: from a state under a control.
struct Attempt {
  std::vector<float> state;
  std::vector<float> control;
  std::vector<float> next;
};

// The attempts of an expansion, in order. All but perhaps the last were taken into the tree.
struct Expansion {
  Target target;
  std::vector<Attempt> attempts;
  std::size_t taken = 0;
};

// A snake that records the steps that it steers. Its results are the snake's.
class RecordingSnake : public Snake {
 public:
  explicit RecordingSnake(const Snake& snake) : Snake(snake) {}

  void steer(StateView state, const Target& target, Steering& steering, ControlRef control) const {
    Snake::steer(state, target, steering, control);
    target_ = target;
    steered_.push_back({{state.begin(), state.end()}, {control.begin(), control.end()}, {}});
  }

  // What was steered since the last call.
  Expansion take() const { return {target_, std::exchange(steered_, {}), 0}; }

 private:
  mutable Target target_;
  mutable std::vector<Attempt> steered_;
};

// All expansions of a search that is `planner`'s and has begun.
inline std::vector<Expansion> record(const RecordingSnake& snake, Planner& planner, float dt) {
  std::vector<Expansion> all;
  (void)snake.take();
  while (planner.status() == Status::searching) {
    std::size_t taken = 0;
    (void)planner.advance(1, [&](const float*, const float*) { ++taken; });
    Expansion expansion = snake.take();
    // After a last step that was taken only the plan is driven again; one that was not may follow.
    if (expansion.attempts.size() > taken + 1) expansion.attempts.resize(taken);
    for (Attempt& attempt : expansion.attempts) {
      attempt.next.resize(attempt.state.size());
      detail::propagate(snake, attempt.state.data(), attempt.control.data(), dt, attempt.next.data());
    }
    expansion.taken = taken;
    all.push_back(std::move(expansion));
  }
  return all;
}

}  // namespace krait::bench
