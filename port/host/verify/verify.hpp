// Judges a plan against the input map, sharing no code with the planner and trusting nothing that the plan says
// of robot, start, goal or map. Double precision throughout, Boost's integrator and Boost's geometry.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "host/plan/plan.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

// What was asked of the planner, in world coordinates.
struct Asked {
  RobotSpec robot;
  Start start;
  Ring goal;  // polygon; a disc is given by center and radius instead
  std::optional<Point> disc_center;
  double disc_radius = 0;
};

struct Verdict {
  bool holds = false;
  std::vector<std::string> complaints;  // one line each: what, which step, by how much; 20, then "and N more"

  // The worst of the whole plan. A figure whose check had to be left out (the plan's form is wrong) is NaN.
  double step_error = std::numeric_limits<double>::quiet_NaN();      // largest difference of a stored state to the
                                                                     // integrated one (limit 5e-3)
  double drift = std::numeric_limits<double>::quiet_NaN();           // m, end of the open-loop replay to the stored
                                                                     // end (limit 0.05)
  double clearance = std::numeric_limits<double>::quiet_NaN();       // m, smallest distance of a swept body to an
                                                                     // obstacle or bound, at most kLargestClearance;
                                                                     // 0: overlap, negative: outside by that much
  double self_clearance = std::numeric_limits<double>::quiet_NaN();  // m, smallest distance of two bodies that are
                                                                     // tested; infinite if none are
  double goal_depth = std::numeric_limits<double>::quiet_NaN();      // m, how deep inside the goal the replayed end
                                                                     // lies; negative outside
  double sweep_error = std::numeric_limits<double>::quiet_NaN();     // m, how far a body strays between two poses from
                                                                     // the hull that was checked (at most 2e-5)
};

inline constexpr double kLargestClearance = 1.0;  // m, obstacles further away are not looked for

// Holds the plan to everything that was asked: its form; robot, start and goal as asked; each step within 5e-3 of
// RK4 with 8 sub-steps; the open-loop replay within 0.05 m of the stored end and inside the goal; limits to 1e-4
// relative, in between too; no body swept from sub-step to sub-step touches an obstacle of the workspace, leaves its
// bounds or meets another body. A step that bends is cut finer until the hull of consecutive poses is true to 2e-5 m.
// Throws InputError if the workspace or the asked robot itself is unusable; a bad plan is a verdict, never an error.
Verdict verify(const Workspace& workspace, const PlanFile& plan, const Asked& asked);

}  // namespace krait::host
