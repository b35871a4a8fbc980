// SPDX-License-Identifier: Apache-2.0
// Points of the core in double precision, as the workstation computes.
#pragma once

#include "host/workspace/workspace.hpp"
#include "krait/geometry.hpp"

namespace krait::host {

// In the scene's own coordinates; world_of (query.hpp) adds the scene's origin.
inline Point local_point(Vec2 p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

}  // namespace krait::host
