// SPDX-License-Identifier: Apache-2.0
// A goal's heading in JSON, in the words of the command line: heading, heading_tolerance, either_way, hitch_tolerance.
#pragma once

#include "host/input/json.hpp"

namespace krait::host {

// Of an object that has a heading; what else it leaves out is as without the options. Throws InputError.
GoalFacing read_facing(const Field& goal);

// Throws InputError where the object has a tolerance of a heading, but no heading.
void require_no_tolerance(const Field& goal);

void add_facing(const GoalFacing& facing, Json& goal);

}  // namespace krait::host
