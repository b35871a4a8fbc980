// SPDX-License-Identifier: Apache-2.0
// What a plan's file says of its own motion, held against its states and controls.
#pragma once

#include "host/plan_file/plan_file.hpp"
#include "host/verify/complaints.hpp"
#include "host/verify/dynamics.hpp"

namespace krait::host {

// Of a plan of sound form: number of steps, length, duration, speed at the end, and hash, those that are there. Each
// that differs by more than float rounding is named.
void check_statistics(const PlanFile& plan, const Dynamics& dynamics, Complaints& complaints);

}  // namespace krait::host
