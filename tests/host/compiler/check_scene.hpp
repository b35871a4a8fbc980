// SPDX-License-Identifier: GPL-3.0-or-later
// What every compiled scene must satisfy, by brute force against the workspace that it came from.
#pragma once

#include "host/compiler/compiler.hpp"
#include "scene_view.hpp"

namespace krait::host::test {

// Compiles, checks with GoogleTest's EXPECT macros, and returns the scene.
SceneView checked(const Workspace& workspace, double tolerance = -1, int samples = 2000);

Ring box(double x0, double y0, double x1, double y1);
Ring rotated_box(Point center, double width, double height, double angle);
Workspace empty_room(double width, double height);

}  // namespace krait::host::test
