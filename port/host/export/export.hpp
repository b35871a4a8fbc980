// SPDX-License-Identifier: Apache-2.0
// Writes a workspace as a file that the importers read back: bounds, obstacles, goals and starts, in the coordinates of
// the file that it came from (a shift of a far map is undone). Occupied cells become rectangles.
#pragma once

#include <string>

#include "host/workspace/workspace.hpp"

namespace krait::host {

// krait's JSON. Every number reads back to its bits.
std::string native_json(const Workspace& workspace);

// A FeatureCollection in metres ("unit": 1). Every number reads back to its bits.
std::string geojson(const Workspace& workspace);

// A page of the bounds' size, a metre of which is 1000 mm. Reads back to a billionth of each coordinate; holes that
// touch their outline or one another are filled then.
std::string svg(const Workspace& workspace);

}  // namespace krait::host
