// SPDX-License-Identifier: Apache-2.0
// Planners and settings by their names.
#pragma once

#include <string>

#include "host/workspace/workspace.hpp"

namespace krait::bench {

// The element of a list whose `name` it is; throws host::InputError that lists those that there are of `kind`.
template <class List>
const auto& named(const List& list, const std::string& kind, const std::string& name) {
  std::string known;
  for (const auto& element : list) {
    if (element.name == name) return element;
    known += (known.empty() ? "" : ", ") + std::string(element.name);
  }
  throw host::InputError("no " + kind + " '" + name + "' (there is: " + known + ")");
}

// Throws host::InputError where a setting's value is not from `least` to `most`.
inline void refuse_outside(const std::string& setting, double value, double least, double most) {
  if (value >= least && value <= most) return;
  throw host::InputError("set " + setting + ": must be from " + std::to_string(least) + " to " + std::to_string(most));
}

}  // namespace krait::bench
