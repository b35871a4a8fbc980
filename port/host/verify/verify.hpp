// SPDX-License-Identifier: Apache-2.0
// Judges a plan against the input map, trusting nothing that the plan says of robot, start, goal or map. Double
// precision throughout, Boost's integrator and Boost's geometry. No code of the planner or of the scene compiler; the
// readers of maps, robots and plans are those of the other programs of the workstation.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "host/plan_file/plan_file.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

// What was asked of the planner, in world coordinates.
struct Asked {
  RobotSpec robot;
  Start start;
  Ring goal;  // polygon; a disc is given by center and radius instead
  std::optional<Point> disc_center;
  double disc_radius = 0;
  std::optional<GoalFacing> facing;  // how the robot must be turned at the end; absent: in any way
  std::optional<double> dt;          // seconds, the time step; absent: not known, any from 0.001 to 1 s is accepted
  std::optional<double> end_speed;   // m/s, how fast the plan may end; absent: at any speed
};

struct Verdict {
  bool holds = false;
  std::vector<std::string> complaints;  // one line each: what, which step, by how much; 20, then "and N more"

  // The worst of the whole plan. A figure whose check had to be left out (the plan's form is wrong) is NaN. "As driven"
  // is the motion that the controls lead to from the plan's first state, without a look at any other.
  double step_error = std::numeric_limits<double>::quiet_NaN();      // m, rad, m/s, rad/s, largest change of a stored
                                                                     // state's difference to the driven one in a step
  double drift = std::numeric_limits<double>::quiet_NaN();           // the same units, largest of these differences
  double clearance = std::numeric_limits<double>::quiet_NaN();       // m, smallest distance of a body, as driven, to
                                                                     // an obstacle or bound, at most
                                                                     // kLargestClearance; 0: overlap, negative:
                                                                     // outside by that much
  double self_clearance = std::numeric_limits<double>::quiet_NaN();  // m, smallest distance of two bodies that are
                                                                     // tested, as driven; infinite if none are
  double heading_error = std::numeric_limits<double>::quiet_NaN();  // rad, of the driven end from the heading asked for
  double goal_depth = std::numeric_limits<double>::quiet_NaN();     // m, how deep inside the goal the driven end
                                                                    // lies; negative outside
  double end_speed = std::numeric_limits<double>::quiet_NaN();      // m/s, of the driven end
  double sweep_error = std::numeric_limits<double>::quiet_NaN();    // m, how far a body strays between two poses from
                                                                    // the hull that was checked (at most 2e-5)
};

inline constexpr double kLargestClearance = 1.0;  // m, obstacles further away are not looked for

// Holds the plan to everything that was asked.
// 1. Its form is whole; robot, start, goal and (where it is known) time step are those that were asked for; the time
//    step lies in 0.001 to 1 s.
// 2. The controls are driven from the plan's first state to its end, open loop, in sub-steps so fine that truncation is
//    negligible (drive.hpp). On this motion no body touches an obstacle of the workspace, leaves its bounds or meets
//    another body, between sub-steps too, true to 2e-5 m; limits hold to 1e-4 of their size, between sub-steps too; and
//    its end lies in the goal and is no faster than asked, to 1e-2 m/s. A car is as fast as its front wheels, a
//    differential drive as its faster wheel; a robot whose control is its speed, as a unicycle's is, ends at rest.
// 3. Each stored state differs in no component by more than 5e-3 (m, rad, m/s, rad/s), 5e-6 a metre of way and float
//    rounding from the driven one, and that difference changes in one step by no more than 1e-2 a second of the step
//    and float rounding. Each keeps the limits and is free itself, and the last lies in the goal and is as slow.
// 4. What the plan's statistics say of its steps, length, duration, end speed and hash agrees with its states and
//    controls, those that they name. Looked at in a plan that holds in all else.
// A body or a quantity that fails is named once, with the first place where it does, and only the first stored state
// that disagrees is named. Once a plan is refused, no more than half a million bodies times sub-steps are looked at.
// Throws InputError if the workspace or the asked robot itself is unusable; a bad plan is a verdict, never an error.
// O(steps). `tell`, which may be empty, is called with the number of each step before it is driven.
Verdict verify(const Workspace& workspace, const PlanFile& plan, const Asked& asked,
               const std::function<void(std::size_t)>& tell = {});

}  // namespace krait::host
