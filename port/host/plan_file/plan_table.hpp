// SPDX-License-Identifier: Apache-2.0
// A plan as a table of comma-separated values, for spreadsheets and scripts.
#pragma once

#include <string>

#include "host/plan_file/plan_file.hpp"

namespace krait::host {

// A line of names, then a line a state: its time in seconds, the state in the map's coordinates, and the control that
// is held from it on; the last state has none. A float has 9 digits; a position far from 0 has more.
std::string plan_table(const PlanFile& plan);

}  // namespace krait::host
