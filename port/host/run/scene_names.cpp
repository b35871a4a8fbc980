// SPDX-License-Identifier: Apache-2.0
#include "host/run/scene_names.hpp"

namespace krait::host {

SceneNames names_of(const krait::Scene& scene) {
  const char* at = scene.name();
  const auto next = [&at] {
    while (*at != '\0') ++at;
    return std::string(++at);
  };
  SceneNames names;
  for (Index i = 0; i < scene.goal_count(); ++i) names.goals.push_back(next());
  for (Index i = 0; i < scene.start_count(); ++i) names.starts.push_back(next());
  return names;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

}  // namespace krait::host
