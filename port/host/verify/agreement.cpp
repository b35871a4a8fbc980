// SPDX-License-Identifier: Apache-2.0
#include "host/verify/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "host/verify/pieces.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

constexpr double kParameterTolerance = 1e-6;  // relative
constexpr double kBodyTolerance = 1e-6;       // m
constexpr double kPositionTolerance = 1e-3;   // m, and float rounding
constexpr double kAngleTolerance = 1e-4;      // rad
constexpr double kRestTolerance = 1e-6;       // speed, steering, wheel speeds at the start
constexpr double kGoalTolerance = 1e-3;       // m: the compiler snaps a goal to a grid
constexpr double kDtTolerance = 1e-6;         // relative: float rounding
constexpr double kLeastDt = 1e-3;             // s, the planner's range
constexpr double kMostDt = 1;                 // s
constexpr double kMostLocal = 8192;           // m from the plan's origin: beyond, a float is coarser than 1 mm

// A plan's file may hold numbers near the ends of their range, of which distance() of bodies.hpp takes no care.
double point_distance(const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y); }

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point along{b.x - a.x, b.y - a.y};
  const double square = along.x * along.x + along.y * along.y;
  if (square == 0) return point_distance(p, a);
  const double t = std::clamp(((p.x - a.x) * along.x + (p.y - a.y) * along.y) / square, 0.0, 1.0);
  return point_distance(p, {a.x + t * along.x, a.y + t * along.y});
}

double distance_to_ring(const Ring& ring, const Point& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    nearest = std::min(nearest, distance_to_segment(p, ring[i], ring[(i + 1) % ring.size()]));
  }
  return nearest;
}

// The largest distance of a corner, or of the middle of a side, of `from` to the outline of `to`.
double stray(const Ring& from, const Ring& to) {
  double worst = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Point& a = from[i];
    const Point& b = from[(i + 1) % from.size()];
    worst = std::max({worst, distance_to_ring(to, a), distance_to_ring(to, {(a.x + b.x) / 2, (a.y + b.y) / 2})});
  }
  return worst;
}

// The largest distance of a corner of `from` to the nearest corner of `to`.
double corner_difference(const Ring& from, const Ring& to) {
  double worst = 0;
  for (const Point& a : from) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point& b : to) nearest = std::min(nearest, point_distance(a, b));
    worst = std::max(worst, nearest);
  }
  return worst;
}

double float_rounding(double value) {
  return std::abs(value) * static_cast<double>(std::numeric_limits<float>::epsilon());
}

template <typename Row>
bool all_finite(const Row& row) {
  return std::all_of(row.begin(), row.end(), [](auto value) { return std::isfinite(value); });
}

void check_parameter(const std::string& name, const RobotSpec& planned, const RobotSpec& asked,
                     Complaints& complaints) {
  const auto is = planned.parameters.find(name);
  const auto should = asked.parameters.find(name);
  if (is == planned.parameters.end() || should == asked.parameters.end()) {
    const bool missing = is == planned.parameters.end();
    if (name == "min_speed" && (missing ? should : is)->second == 0) return;  // the default, spelled out
    complaints.add("robot: parameter " + name + (missing ? " is missing" : " was not asked for"));
  } else if (!(std::abs(is->second - should->second) <= kParameterTolerance * std::abs(should->second))) {
    complaints.add("robot: " + name + " is " + text(is->second) + ", asked " + text(should->second) + " (differs by " +
                   text(is->second - should->second) + ")");
  }
}

void check_body(std::size_t index, const Ring& planned, const Ring& asked, Complaints& complaints) {
  const std::string body = "robot: body " + text(index);
  if (planned.size() != asked.size()) {
    complaints.add(body + " has " + text(planned.size()) + " corners, asked " + text(asked.size()));
    return;
  }
  const double difference = std::max(corner_difference(planned, asked), corner_difference(asked, planned));
  if (!(difference <= kBodyTolerance)) complaints.add(body + " differs by " + text(difference) + " m");
}

bool check_row(const char* what, std::size_t index, const std::vector<float>& row, std::size_t size,
               Complaints& complaints) {
  const std::string name = std::string(what) + " " + text(index);
  if (row.size() != size) {
    complaints.add(name + " has " + text(row.size()) + " numbers instead of " + text(size));
    return false;
  }
  if (!all_finite(row)) {
    complaints.add(name + " has a number that is not finite");
    return false;
  }
  return true;
}

bool check_rows(const PlanFile& plan, const Dynamics& dynamics, Complaints& complaints) {
  bool sound = true;
  for (std::size_t i = 0; i < plan.states.size(); ++i) {
    sound &= check_row("state", i, plan.states[i], dynamics.state_size(), complaints);
  }
  for (std::size_t i = 0; i < plan.controls.size(); ++i) {
    sound &= check_row("control", i, plan.controls[i], dynamics.control_size(), complaints);
  }
  return sound;
}

bool check_reach(const PlanFile& plan, Complaints& complaints) {
  for (std::size_t i = 0; i < plan.states.size(); ++i) {
    const float reach = std::max(std::abs(plan.states[i][0]), std::abs(plan.states[i][1]));
    if (static_cast<double>(reach) <= kMostLocal) continue;
    complaints.add("state " + text(i) + " lies " + text(static_cast<double>(reach)) +
                   " m from the plan's origin, where a float is too coarse");
    return false;
  }
  return true;
}

void check_disc(const Ring& planned, const Point& center, double radius, Complaints& complaints) {
  double furthest = 0;
  for (const Point& point : planned) furthest = std::max(furthest, point_distance(point, center));
  if (!(furthest <= radius + kGoalTolerance)) {
    complaints.add("goal: the plan's polygon reaches " + text(furthest - radius) + " m out of the disc asked for");
  }
  if (!inside(planned, center)) complaints.add("goal: the plan's polygon misses the center of the disc asked for");
}

// " (it is a disc: --goal 18,8,0.1 asks for that)"; empty where it is none. Its corners are points of a circle.
std::string remedy_for_disc(const Ring& planned) {
  constexpr std::size_t kLeastCorners = 16;
  constexpr double kRounding = 1e-6;  // m
  Point center;
  for (const Point& p : planned) center = {center.x + p.x, center.y + p.y};
  const auto count = static_cast<double>(planned.size());
  center = {center.x / count, center.y / count};
  const double radius = point_distance(planned.front(), center);
  const auto is_on = [&](const Point& p) { return std::abs(point_distance(p, center) - radius) <= kRounding; };
  if (planned.size() < kLeastCorners || !std::all_of(planned.begin(), planned.end(), is_on)) return "";
  const auto rounded = [](double x) { return std::round(x / kRounding) * kRounding; };
  return printed(" (it is a disc: --goal %.10g,%.10g,%.6g asks for that)", rounded(center.x), rounded(center.y),
                 radius);
}

bool same_angle(double planned, double asked) {
  return std::abs(std::remainder(planned - asked, 2 * std::numbers::pi)) <= kAngleTolerance;
}

bool same(const GoalFacing& planned, const GoalFacing& asked) {
  const bool hitches = planned.hitches.has_value() == asked.hitches.has_value() &&
                       (!asked.hitches || std::abs(*planned.hitches - *asked.hitches) <= kAngleTolerance);
  return hitches && same_angle(planned.heading, asked.heading) && planned.either_way == asked.either_way &&
         std::abs(planned.tolerance - asked.tolerance) <= kAngleTolerance;
}

}  // namespace

void check_robot(const RobotSpec& planned, const RobotSpec& asked, Complaints& complaints) {
  if (planned.model != asked.model) {
    complaints.add("robot: model is \"" + planned.model + "\", asked \"" + asked.model + "\"");
    return;
  }
  if (planned.links != asked.links) {
    complaints.add("robot: has " + std::to_string(planned.links) + " links, asked " + std::to_string(asked.links));
    return;
  }
  std::set<std::string> names;
  for (const auto& [name, value] : planned.parameters) names.insert(name);
  for (const auto& [name, value] : asked.parameters) names.insert(name);
  for (const std::string& name : names) check_parameter(name, planned, asked, complaints);
  if (planned.bodies.size() != asked.bodies.size()) {
    complaints.add("robot: has " + text(planned.bodies.size()) + " bodies, asked " + text(asked.bodies.size()));
    return;
  }
  for (std::size_t i = 0; i < asked.bodies.size(); ++i) check_body(i, planned.bodies[i], asked.bodies[i], complaints);
}

bool check_form(const PlanFile& plan, const Dynamics& dynamics, Complaints& complaints) {
  if (plan.status != "solved") complaints.add("status: is \"" + plan.status + "\", not \"solved\"");
  if (plan.states.empty()) {
    complaints.add("states: there are none");
    return false;
  }
  if (plan.states.size() != plan.controls.size() + 1) {
    complaints.add("states: " + text(plan.states.size()) + " do not go with " + text(plan.controls.size()) +
                   " controls; there must be one more");
    return false;
  }
  if (!(plan.dt >= kLeastDt && plan.dt <= kMostDt)) {
    complaints.add("dt: is " + text(plan.dt) + " s, must be from " + text(kLeastDt) + " to " + text(kMostDt) + " s");
    return false;
  }
  if (!std::isfinite(plan.origin.x) || !std::isfinite(plan.origin.y)) {
    complaints.add("origin: is not finite");
    return false;
  }
  return check_rows(plan, dynamics, complaints) && check_reach(plan, complaints);
}

void check_dt(const PlanFile& plan, const Asked& asked, Complaints& complaints) {
  if (!asked.dt || std::abs(plan.dt - *asked.dt) <= kDtTolerance * *asked.dt) return;
  complaints.add("dt: is " + text(plan.dt) + " s, asked " + text(*asked.dt) + " s");
}

void check_start(const PlanFile& plan, const Start& asked, const Dynamics& dynamics, Complaints& complaints) {
  const std::vector<float>& first = plan.states.front();
  const State state(first.begin(), first.end());
  const Point position{plan.origin.x + state[0], plan.origin.y + state[1]};
  const double rounding = float_rounding(state[0]) + float_rounding(state[1]);
  const double away = point_distance(position, asked.position);
  if (!(away <= kPositionTolerance + rounding)) {
    complaints.add("start: state 0 lies " + text(away) + " m from the start asked for");
  }
  const State rest = dynamics.at_rest(asked.position, asked.heading, asked.angles);
  for (std::size_t i = 2; i < state.size(); ++i) {
    double difference = state[i] - rest[i];
    if (dynamics.is_heading(i)) difference = std::remainder(difference, 2 * std::numbers::pi);
    const double tolerance = dynamics.is_heading(i) ? kAngleTolerance : kRestTolerance;
    if (std::abs(difference) <= tolerance) continue;
    complaints.add("start: " + dynamics.state_names()[i] + " of state 0 is " + text(state[i]) + ", asked " +
                   text(rest[i]) + " (differs by " + text(difference) + ")");
  }
}

void check_goal(const PlanFile& plan, const Asked& asked, Complaints& complaints) {
  Ring planned = plan.goal_polygon;
  for (Point& point : planned) point = {plan.origin.x + point.x, plan.origin.y + point.y};
  const bool finite = std::all_of(planned.begin(), planned.end(),
                                  [](const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
  if (planned.size() < 3 || !finite) {
    complaints.add("goal: the plan states no polygon");
    return;
  }
  if (asked.facing && !(plan.goal_facing && same(*plan.goal_facing, *asked.facing))) {
    complaints.add("goal: the plan was not made for the heading and the tolerances asked for");
  }
  if (asked.disc_center) {
    check_disc(planned, *asked.disc_center, asked.disc_radius, complaints);
    return;
  }
  const double difference = std::max(stray(planned, asked.goal), stray(asked.goal, planned));
  if (!(difference <= kGoalTolerance)) {
    complaints.add("goal: the plan's polygon differs by " + text(difference) + " m from the one asked for" +
                   remedy_for_disc(planned));
  }
}

double goal_depth(const Asked& asked, const Point& point) {
  if (asked.disc_center) return asked.disc_radius - point_distance(point, *asked.disc_center);
  const double to_outline = distance_to_ring(asked.goal, point);
  return inside(asked.goal, point) ? to_outline : -to_outline;
}

}  // namespace krait::host
