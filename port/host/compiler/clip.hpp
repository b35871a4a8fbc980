// SPDX-License-Identifier: GPL-3.0-or-later
// Rings of the world, brought onto the grid.
#pragma once

#include <string>

#include "host/compiler/frame.hpp"

namespace krait::host::compiler {

// The ring clipped to the frame's bounds and rounded to the grid, without repeated points; empty if it lies outside.
// Winding numbers within the bounds stay as they were.
GridRing place_within(const Ring& world, const Frame& frame);

// The same of a ring on the grid.
GridRing clip_within(const GridRing& ring, const GridBox& bounds);

// Throws InputError, naming the label, if a coordinate is NaN, infinite or beyond 1e9 m.
void check_finite(const Ring& ring, const std::string& label);

}  // namespace krait::host::compiler
