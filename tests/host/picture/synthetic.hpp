// SPDX-License-Identifier: Apache-2.0
// A made-up picture: 50 m x 50 m, two walls with wide gaps and one with a narrow gap too, a closed room, a snake of 15
// trailers that drives an S through the wide gaps, costs that rise at the narrow gap, and a wandering tree.
#pragma once

#include <string>

#include "host/picture/picture.hpp"

namespace krait::host::test {

Picture synthetic_picture();

// The same numbers times `factor`, the robot's too; speeds stay.
Picture scaled(Picture picture, double factor);

// The same drive by a model without trailers: "car", "unicycle" or "diff_drive" (its wheel speeds are made up).
Picture driven_by(const std::string& model);

// A scene alone: bounds, no triangles, no search, no plan.
Picture bare_picture(double width, double height);

}  // namespace krait::host::test
