// SPDX-License-Identifier: Apache-2.0
// Maps of cells, drawn in the tests' sources.
#pragma once

#include <string>
#include <vector>

#include "host/workspace/workspace.hpp"

namespace krait::host::test {

// '#' is occupied, rows from the top.
inline CellMap cells(const std::vector<std::string>& rows, double resolution = 1) {
  CellMap map;
  map.rows = static_cast<int>(rows.size());
  map.columns = static_cast<int>(rows.front().size());
  map.resolution = resolution;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) map.occupied.push_back(c == '#');
  }
  return map;
}

}  // namespace krait::host::test
