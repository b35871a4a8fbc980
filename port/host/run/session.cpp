// SPDX-License-Identifier: Apache-2.0
#include "host/run/session.hpp"

#include <cmath>

#include "host/rivals/plain.hpp"
#include "host/rivals/prior.hpp"
#include "host/rivals/rrt.hpp"
#include "host/run/local_point.hpp"
#include "host/run/planner_session.hpp"
#include "host/run/robot_facts.hpp"
#include "host/run/why.hpp"
#include "host/workspace/heading.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

// To a millisecond, rounded down.
std::string longest_dt(double seconds) {
  const double milliseconds = std::floor(1000 * seconds);
  return printed("dt: at most %.3g s for a robot so fast and so short: try --dt %.3g", milliseconds / 1000,
                 milliseconds / 1000);
}

// That it is outside, and of what.
std::string outside(const char* what, const krait::Scene& scene) {
  const format::Header& header = scene.header();
  const Point low = world_of(scene, {header.bounds_min_x, header.bounds_min_y});
  const Point high = world_of(scene, {header.bounds_max_x, header.bounds_max_y});
  return printed("%s lies outside the bounds, %.8g,%.8g to %.8g,%.8g m", what, low.x, low.y, high.x, high.y);
}

// Which hitch is bent beyond its limit at the start; empty where none is. Angles are the trailers' own headings.
std::string bent_too_far(const krait::Scene& scene, const SearchRequest& request) {
  const Start start = resolve_start(scene, request);
  const auto limit = request.robot.parameters.find("max_hitch_angle");
  double before = start.heading;
  for (std::size_t k = 0; k < start.angles.size() && limit != request.robot.parameters.end(); ++k) {
    const double angle = start.angles[k];
    if (std::abs(angle - before) > limit->second) {
      return "start '" + start.name +
             printed(
                 "': the heading of trailer %zu, %.6g rad, bends its hitch by %.6g rad, and %.6g rad are allowed "
                 "(max_hitch_angle)",
                 k + 1, angle, std::abs(angle - before), limit->second) +
             (is_over_a_turn(angle) ? ": " + degrees_meant(angle) : "");
    }
    before = angle;
  }
  return "";
}

std::string explanation(const Failure& failure, const krait::Scene& scene, const SearchRequest& request) {
  const std::string argument = to_string(static_cast<Argument>(failure.element));
  switch (failure.status) {
    case Status::arena_too_small:
      return "--memory " + std::to_string(request.memory) +
             " bytes is too little: this scene and robot need at least " + std::to_string(failure.bytes_needed) +
             " bytes";
    case Status::start_outside:
      return outside("the start", scene);
    case Status::goal_in_obstacle:
      return why_no_goal(scene, request);
    case Status::bad_robot:
      return argument + " cannot be used";
    case Status::bad_argument:
      if (argument == to_string(Argument::goal)) return outside("the goal's centre", scene);
      if (failure.most > 0) return longest_dt(static_cast<double>(failure.most));
      if (argument == to_string(Argument::dt)) return argument + ": " + kNoTimeStep;
      if (argument == to_string(Argument::start)) {
        if (const std::string bent = bent_too_far(scene, request); !bent.empty()) return bent;
      }
      return argument +
             " is not finite or out of its range (numbers in metres, seconds and radians; krait plan --help)";
    case Status::bad_arithmetic:
      return "the program was built with contracted or relaxed floating point";
    default:
      return "unusable input";
  }
}

// Whether the status is a result of a search, or is refused in another form.
bool passes(Status status) {
  switch (status) {
    case Status::ok:
    case Status::ready:
    case Status::searching:
    case Status::solved:
    case Status::no_route:
    case Status::budget_used:
    case Status::tree_full:
    case Status::time_used:
    case Status::internal:
    case Status::start_in_collision:  // which is refused with the contact
      return true;
    default:
      return false;
  }
}

}  // namespace

void refuse(const Failure& failure, const krait::Scene& scene, const SearchRequest& request) {
  if (passes(failure.status)) return;
  const std::string line = std::string(to_string(failure.status)) + ": " + explanation(failure, scene, request);
  if (failure.status == Status::goal_in_obstacle) throw InObstacle(line, failure.status, goal_mark(scene, request));
  throw InputError(line);
}

void refuse(const Contact& at_start, const krait::Scene& scene, const SearchRequest& request) {
  constexpr Status kStatus = Status::start_in_collision;
  throw InObstacle(std::string(to_string(kStatus)) + ": " + why_not_there(at_start, scene, request), kStatus,
                   {local_point(at_start.at), at_start.distance > 0.0F ? "too near" : "in the way"});
}

std::unique_ptr<Session> start_session(const krait::Scene& scene, const SearchRequest& request, Block& block) {
  if (request.planner == "adaptive")
    return std::make_unique<PlannerSession<detail::AdaptiveSearch>>(scene, request, block);
  if (request.planner == "prior") return std::make_unique<PlannerSession<rivals::PriorPlanner>>(scene, request, block);
  if (request.planner == "plain") return std::make_unique<PlannerSession<rivals::PlainPlanner>>(scene, request, block);
  if (request.planner == "rrt") return std::make_unique<PlannerSession<rivals::RrtPlanner>>(scene, request, block);
  throw InputError("no planner '" + request.planner + "' (there is: adaptive, plain, prior, rrt)");
}

}  // namespace krait::host
