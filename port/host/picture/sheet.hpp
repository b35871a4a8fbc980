// SPDX-License-Identifier: Apache-2.0
// A painting as the bytes of a file.
#pragma once

#include <cairo.h>

#include <functional>
#include <string>

namespace krait::host {

using Paint = std::function<void(cairo_t* context)>;

// Width and height in points, whole numbers; `name` is for screen readers. Each throws InputError where Cairo fails.
std::string svg_sheet(double width, double height, const std::string& name, const Paint& paint);
std::string png_sheet(double width, double height, const Paint& paint);  // kPixelsPerPoint pixels a point

}  // namespace krait::host
