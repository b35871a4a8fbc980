// SPDX-License-Identifier: Apache-2.0
// One robot of every model that the workstation knows, as --robot has it: a new model needs no other list.
#pragma once

#include <string>
#include <vector>

#include "host/robot_file/robot_file.hpp"

namespace krait::host {

// With so many trailers where the model may have any.
inline std::vector<std::string> every_robot(int trailers) {
  std::vector<std::string> robots;
  for (const std::string& model : robot_models()) {
    robots.push_back(most_links(model) > 0 ? model + ":" + std::to_string(trailers) : model);
  }
  return robots;
}

}  // namespace krait::host
