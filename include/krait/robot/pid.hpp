// SPDX-License-Identifier: Apache-2.0
// A PID controller in discrete time.
#pragma once

namespace krait {

struct PidGains {
  float proportional;
  float integral;
  float derivative;
};

class Pid {
 public:
  // The output for an error held over dt seconds.
  float operator()(const PidGains& gains, float error, float dt) {
    sum_ = sum_ + error * dt;
    const float slope = fresh_ ? 0.0F : (error - last_) / dt;
    last_ = error;
    fresh_ = false;
    return gains.proportional * error + gains.integral * sum_ + gains.derivative * slope;
  }

 private:
  float sum_ = 0.0F;
  float last_ = 0.0F;
  bool fresh_ = true;
};

}  // namespace krait
