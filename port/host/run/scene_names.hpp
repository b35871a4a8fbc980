// SPDX-License-Identifier: Apache-2.0
// The names of a scene's starts and goals, which lie one behind the other in its bytes: krait::Scene finds one name in
// the time that it takes to walk over those before it.
#pragma once

#include <string>
#include <vector>

#include "krait/scene.hpp"

namespace krait::host {

struct SceneNames {
  std::vector<std::string> goals, starts;  // in the scene's order
};

// O(bytes of the names).
SceneNames names_of(const krait::Scene& scene);

// "a, b, c", or "none".
std::string listed(const std::vector<std::string>& names);

}  // namespace krait::host
