// SPDX-License-Identifier: Apache-2.0
#include "host/plan_file/plan_table.hpp"

#include <cstddef>

#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

std::string place(double origin, float local) {
  return printed(origin == 0 ? ",%.9g" : ",%.13g", origin + static_cast<double>(local));
}

}  // namespace

std::string plan_table(const PlanFile& plan) {
  std::string text = "t";
  for (const std::string& name : plan.state_names) text += "," + name;
  const std::vector<std::string> controls = control_names(plan.robot);
  for (const std::string& name : controls) text += "," + name;
  text += "\n";
  for (std::size_t i = 0; i < plan.states.size(); ++i) {
    const std::vector<float>& state = plan.states[i];
    text += printed("%.9g", plan.dt * static_cast<double>(i));
    text += place(plan.origin.x, state[0]) + place(plan.origin.y, state[1]);
    for (std::size_t k = 2; k < state.size(); ++k) text += printed(",%.9g", static_cast<double>(state[k]));
    const bool is_last = i == plan.controls.size();
    for (std::size_t k = 0; k < controls.size(); ++k) {
      text += is_last ? "," : printed(",%.9g", static_cast<double>(plan.controls[i][k]));
    }
    text += "\n";
  }
  return text;
}

}  // namespace krait::host
