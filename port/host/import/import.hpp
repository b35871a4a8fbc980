// SPDX-License-Identifier: Apache-2.0
// Reads a map or drawing of any known format into a Workspace.
#pragma once

#include <optional>
#include <string>

#include "host/workspace/workspace.hpp"

namespace krait::host {

enum class Unknown { map, free, occupied };  // how a map's unknown cells count; map: by the file's thresholds

struct ImportOptions {
  Unknown unknown = Unknown::map;
};

// Chooses the format by content and name: compiled scene, native JSON, ROS map_server YAML,
// MovingAI .map, dynobench YAML, TPCAP case.
// Throws InputError.
Workspace import_workspace(const std::string& path, const ImportOptions& options);

}  // namespace krait::host
