// SPDX-License-Identifier: Apache-2.0
// Whether a plan is whole, and speaks of the robot, start and goal that were asked for.
#pragma once

#include "host/verify/complaints.hpp"
#include "host/verify/dynamics.hpp"
#include "host/verify/verify.hpp"

namespace krait::host {

void check_robot(const RobotSpec& planned, const RobotSpec& asked, Complaints& complaints);

// Status, counts, sizes, finiteness, and a time step that a planner may have. False if states and controls cannot be
// looked at any further.
bool check_form(const PlanFile& plan, const Dynamics& dynamics, Complaints& complaints);

// For a plan whose form is sound, as the others below.
void check_dt(const PlanFile& plan, const Asked& asked, Complaints& complaints);

void check_start(const PlanFile& plan, const Start& asked, const Dynamics& dynamics, Complaints& complaints);

void check_goal(const PlanFile& plan, const Asked& asked, Complaints& complaints);

// How deep inside the asked goal a point of the world lies, in metres; negative outside.
double goal_depth(const Asked& asked, const Point& point);

}  // namespace krait::host
