// SPDX-License-Identifier: Apache-2.0
// The outlines of SVG's path data, curves as polygons.
#pragma once

#include <cstddef>
#include <vector>

#include "host/import/svg_scanner.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

struct Flatness {
  double tolerance;      // in the path's own units: how far a polygon may be from the curve
  std::size_t& corners;  // that may still be made of the whole drawing
};

// Each subpath, in order: open ones too, which are filled as if closed. A last point that repeats the first is dropped.
std::vector<Ring> read_path(SvgScanner& data, const Flatness& flatness);

}  // namespace krait::host
