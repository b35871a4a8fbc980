// SPDX-License-Identifier: Apache-2.0
// Distances between the cells of a map (Meijster, Roerdink and Hesselink 2000): exact, in integers, linear in the
// cells.
#pragma once

#include <cstdint>
#include <vector>

namespace krait::host {

// By cell, 0 or 1; row-major, `columns` of them in a row.
using CellMask = std::vector<std::uint8_t>;

enum class Beyond { unmarked, marked };  // how cells off the map count

// For each cell the square of the distance from its centre to the nearest marked cell's, in cells; 0 for marked cells,
// kFarSquared where none is nearer than that.
inline constexpr std::uint32_t kFarSquared = std::uint32_t{1} << 31U;
std::vector<std::uint32_t> squared_distances(const CellMask& marked, int columns, Beyond beyond);

}  // namespace krait::host
