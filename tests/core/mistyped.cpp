// SPDX-License-Identifier: Apache-2.0
// Robots with functions that would not be called: none of them compiles.
#include "user_robot.hpp"

namespace krait::test {

struct InDouble : Slider {
  double speed(StateView) const { return 0.0; }
};
struct Changing : Slider {
  bool reversible() { return true; }
};
struct Asking : Slider {
  float top_speed(StateView) const { return 1.0F; }
};
struct HalfLeading : Slider {
  void integrate_lead(StateView, const Pose*, ControlView, float, float*) const {}
};

Robot view(const InDouble& robot) { return robot; }
Robot view(const Changing& robot) { return robot; }
Robot view(const Asking& robot) { return robot; }
Robot view(const HalfLeading& robot) { return robot; }

}  // namespace krait::test
