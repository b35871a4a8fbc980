// What the robot does that is driven by a plan's controls and nothing else. A plan's states each carry the rounding of
// the step before and its truncation on to the next; here a state carries what rounding took from it along, and goes by
// half steps, whose truncation is a sixteenth. Only as much of the state as the position depends on.
#pragma once

#include "krait/motion/rk4.hpp"

namespace krait {

template <Robot R>
class OpenLoop {
 public:
  // Where to start: state_size() floats, copied. The robot must outlive this.
  void begin(const R& robot, const float* state) {
    robot_ = &robot;
    size_ = leading_size(robot);
    for (int i = 0; i < size_; ++i) {
      state_[i] = state[i];
      rest_[i] = 0.0F;
    }
  }

  // Holds the control for dt seconds. Two Runge-Kutta steps.
  void step(const float* control, float dt) {
    for (int half = 0; half < 2; ++half) {
      const StateView state(state_, size_);
      robot_->place(state, poses_);
      float d[R::kMaxState];
      motion_.integrate_lead(*robot_, state, poses_, control, 0.5F * dt, d);
      for (int i = 0; i < size_; ++i) add(i, d[i]);
    }
  }

  Vec2 position() const { return {state_[0], state_[1]}; }

 private:
  // Kahan's sum: state_ + rest_ is the state.
  void add(int i, float increment) {
    const float corrected = increment + rest_[i];
    const float sum = state_[i] + corrected;
    rest_[i] = corrected - (sum - state_[i]);
    state_[i] = sum;
  }

  const R* robot_ = nullptr;
  int size_ = 0;
  float state_[R::kMaxState];
  float rest_[R::kMaxState];
  Pose poses_[R::kMaxBodies];
  Motion<R> motion_;
};

}  // namespace krait
