// SPDX-License-Identifier: Apache-2.0
#include "host/run/why.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "decomposition/locate.hpp"
#include "host/run/depth.hpp"
#include "host/run/hindrance.hpp"
#include "host/run/local_point.hpp"
#include "host/run/query.hpp"
#include "host/run/robot_facts.hpp"
#include "host/run/shortest_way.hpp"
#include "host/run/standing.hpp"
#include "host/workspace/printed.hpp"
#include "motion/rk4.hpp"
#include "robot/shape.hpp"

namespace krait::host {
namespace {

constexpr std::uint64_t kManyExpansions = 1000;  // of which one leads away from any start with room to move

// To a tenth of a millimetre.
std::string metres(double length) { return printed("%.4g m", std::round(1e4 * length) / 1e4); }

std::string place(const krait::Scene& scene, Vec2 at) {
  const Point world = world_of(scene, at);
  return printed("%.10g,%.10g", std::round(100 * world.x) / 100, std::round(100 * world.y) / 100);
}

std::string body_name(const RobotSpec& robot, Index body) {
  if (robot.links == 0) return "the robot";
  return body == 0 ? "the car (body 0)" : "trailer " + std::to_string(body) + " (body " + std::to_string(body) + ")";
}

std::string obstacle_name(const Contact& contact, const krait::Scene& scene, const SearchRequest& request) {
  const std::string name = request.obstacle_at ? request.obstacle_at(world_of(scene, contact.at)) : "";
  return "an obstacle (" + (name.empty() ? "piece " + std::to_string(contact.other) : name) + ")";
}

std::string other_name(const Contact& contact, const krait::Scene& scene, const SearchRequest& request) {
  switch (contact.kind) {
    case ContactKind::obstacle:
      return obstacle_name(contact, scene, request);
    case ContactKind::body:
      return body_name(request.robot, contact.other);
    default:
      return "the bounds of the workspace";
  }
}

// Obstacles may have been grown when the scene was compiled, and a passage narrowed from both of its sides.
std::string grown(const krait::Scene& scene, double lacking) {
  const auto tolerance = static_cast<double>(scene.header().tolerance);
  if (!(tolerance > 0) || lacking > 2 * tolerance) return "";
  return "; when the map was compiled, obstacles were grown by up to " + metres(tolerance) +
         " a side, which may be why: --tolerance 0 leaves them as they are, unless --cell makes cells larger";
}

// The same of a start in a body's way, which growth is not to blame for where the robot reaches deeper.
std::string grown_around(const Start& start, const krait::Scene& scene, const RobotSpec& robot) {
  const CoreRobot core(robot);
  const auto tolerance = static_cast<double>(scene.header().tolerance);
  return reaches_deeper(robot, state_at(core.view(), scene, start), scene, tolerance) ? "" : grown(scene, 0);
}

// Whether the robot may have room in the goal where obstacles are as they were before they were grown.
bool growth_takes_the_goal(const krait::Scene& scene, const SearchRequest& request) {
  const auto tolerance = static_cast<double>(scene.header().tolerance);
  return tolerance > 0 && !room_in_goal(scene, request, tolerance).none;
}

std::string why_no_route(const Bottleneck& bottleneck, const krait::Scene& scene, const SearchRequest& request) {
  if (bottleneck.needed == 0.0F || bottleneck.width == 0.0F) {
    const krait::Goal goal = resolve_goal(scene, request);
    const bool inside = goal.is_disc() && detail::locate(scene, goal.center()) == kNone;
    return inside
               ? "the goal's middle, " + place(scene, goal.center()) + ", lies in an obstacle, and no way leads to it"
               : "no way leads from the start to the goal: obstacles or the bounds close it off" + grown(scene, 0);
  }
  const double width = static_cast<double>(bottleneck.width);
  const double needed = static_cast<double>(bottleneck.needed);
  const double kept = 2 * static_cast<double>(request.parameters.clearance);
  const std::string at = place(scene, bottleneck.at);
  std::string why =
      bottleneck.at_goal
          ? "the robot cannot stand in the goal: its roomiest place is " + metres(width) + " wide at " + at
          : "every way to the goal is narrower than the robot: " + metres(width) + " at " + at;
  why += ", it needs " + metres(needed);
  if (needed - kept < width) why += "; without the --clearance on both sides it would need " + metres(needed - kept);
  return why + grown(scene, needed - width);
}

// Whether the widest way is hardly wider than the robot.
bool is_tight(const Bottleneck& bottleneck) {
  constexpr float kTight = 1.5F;  // times what the robot needs
  return bottleneck.needed > 0.0F && bottleneck.width <= kTight * bottleneck.needed;
}

std::vector<std::string> where_it_is_tight(const Bottleneck& bottleneck, const krait::Scene& scene) {
  if (!is_tight(bottleneck)) return {};
  return {"the widest way to the goal is " + metres(static_cast<double>(bottleneck.width)) + " wide at " +
          place(scene, bottleneck.at) + ", where the robot needs at least " +
          metres(static_cast<double>(bottleneck.needed)) + grown(scene, 0)};
}

// A disc so small that a plan hits it by chance.
bool is_tiny(const std::optional<GoalDisc>& goal) {
  constexpr double kTiny = 0.01;  // metres
  return goal && goal->radius < kTiny;
}

// Empty where nothing is known to.
std::string what_stops_it(const Hindrances& found, const krait::Scene& scene, const SearchRequest& request) {
  const auto share = [&](int ways) { return printed("%d of %d ways from there end ", ways, found.ways); };
  if (found.beyond > found.stopped) {
    return share(found.beyond) + (request.robot.links > 0 ? "where its trailers fold" : "at a limit of the robot");
  }
  if (found.ways == 0 && is_tiny(request.goal)) return "ways from there hardly ever hit so small a goal";
  if (found.stopped == 0) return "";
  return share(found.stopped) + "with " + body_name(request.robot, found.contact.body) + " at " +
         other_name(found.contact, scene, request) + ", as at " + place(scene, found.contact.at);
}

bool cannot_reverse(const RobotSpec& robot) {
  const auto speed = robot.parameters.find("min_speed");
  return speed != robot.parameters.end() && speed->second >= 0;
}

bool pushes_trailers(const RobotSpec& robot) { return robot.links > 0 && !cannot_reverse(robot); }

Vec2 middle_of(const krait::Scene& scene, const krait::Goal& goal) {
  if (goal.is_disc()) return goal.center();
  return detail::middle(scene.goal_polygon(goal.index()));
}

// Whether the way of a disc of that width is straight, and so is that of one with room beside it for the turn by which
// the robot comes to look along it, and it may end in any heading: then no bend is at fault, nor that it cannot
// reverse.
bool is_straight_on(const krait::Scene& scene, const SearchRequest& request, float width) {
  constexpr double kLonger = 1.01, kOff = 0.5;  // times the straight line; radians
  if (request.facing) return false;
  const Start start = resolve_start(scene, request);
  const Vec2 from = local_of(scene, start.position), to = middle_of(scene, resolve_goal(scene, request));
  const auto along = static_cast<double>(std::atan2(to.y - from.y, to.x - from.x));
  const double off = std::abs(std::remainder(along - start.heading, 2 * std::numbers::pi));
  const double radius = lock_radius(request.robot), straight = static_cast<double>(length(to - from));
  if (off > kOff || 2 * radius * std::sin(off) > straight) return false;
  const auto aside = static_cast<float>(radius * (1 - std::cos(off)));
  return shortest_way(scene, width + 2 * aside, from, to) <= kLonger * straight;
}

// What may be asked for less of how the robot stands at the end. "any heading" names no option: a map's heading takes
// --any-heading, which the line about the goal says, and one of the command line is left out.
std::string less_of(const GoalFacing& facing) {
  std::string text = facing.tolerance < 3.14 ? "a larger --heading-tolerance, " : "";
  if (!facing.either_way) text += "--either-way, ";
  if (facing.hitches) text += "a larger --hitch-tolerance, ";
  return text.empty() ? "any heading" : text + "or any heading";
}

// That time steps, shorter than the usual ones, are too short for the robot to get anywhere in an expansion.
std::string why_longer_steps(const SearchRequest& request) {
  const Parameters& parameters = request.parameters;
  const CoreRobot core(request.robot);
  const float way = static_cast<float>(parameters.tuning.max_steps) * parameters.dt * core.extremes().speed;
  const bool longer = parameters.dt < Parameters{}.dt && detail::can_integrate(core.view(), 2 * parameters.dt);
  if (!longer || way >= detail::robot_length(core.view())) return "";
  return "try a longer --dt: an expansion of " + std::to_string(parameters.tuning.max_steps) +
         " steps moves the robot by " + metres(static_cast<double>(way)) + " at most";
}

void advise_less_clearance(const SearchRequest& request, std::vector<std::string>& lines) {
  if (request.parameters.clearance > Parameters{}.clearance) lines.push_back("try a smaller --clearance");
}

void advise_reversing(const SearchRequest& request, std::vector<std::string>& lines) {
  if (cannot_reverse(request.robot)) lines.push_back("try a ROBOT.json that may reverse, with a min_speed below 0");
}

// Where no motion led away from the start, what lies farther on is not to blame.
std::vector<std::string> how_to_leave(const Statistics& statistics, const SearchRequest& request) {
  std::vector<std::string> lines = {"none of " + std::to_string(statistics.iterations) +
                                    " expansions led away from the start: try another --start"};
  advise_less_clearance(request, lines);
  advise_reversing(request, lines);
  return lines;
}

std::vector<std::string> what_to_try(Status status, const Statistics& statistics, const SearchRequest& request,
                                     bool straight_on) {
  if (statistics.vertices == 1 && statistics.iterations >= kManyExpansions) return how_to_leave(statistics, request);
  std::vector<std::string> lines;
  if (is_tiny(request.goal))
    lines.push_back("the goal is tiny, with a radius of " + metres(request.goal->radius) + ": try 0.05 m or more");
  if (std::string longer = why_longer_steps(request); !longer.empty()) lines.push_back(std::move(longer));
  if (status == Status::time_used && !request.time_limit) return lines;
  if (status == Status::time_used) lines.push_back("try a longer --time-limit");
  if (status == Status::budget_used) lines.push_back("try more --iterations");
  if (status == Status::tree_full || statistics.recycled > 0) lines.push_back("try more --memory");
  if (statistics.plans_refused > 0) {
    lines.push_back(counted(statistics.plans_refused, "way") +
                    " reached the goal but did not hold as driven: try a larger goal" +
                    (pushes_trailers(request.robot) ? ", or room to pull forward between pushing trailers back" : ""));
  }
  if (request.facing) lines.push_back("try " + less_of(*request.facing));
  advise_less_clearance(request, lines);
  if (straight_on) return lines;
  advise_reversing(request, lines);
  if (const double radius = lock_radius(request.robot); radius > 0) {
    lines.push_back("it turns with a radius of " + metres(radius) + ": has every bend so much room?");
  }
  return lines;
}

}  // namespace

std::string why_not_there(const Contact& contact, const krait::Scene& scene, const SearchRequest& request) {
  const std::string at = place(scene, contact.at);
  if (contact.kind == ContactKind::ground) {
    return "the position " + at + " lies in an obstacle, though no body does" + grown(scene, 0);
  }
  const std::string body = body_name(request.robot, contact.body);
  const std::string other = other_name(contact, scene, request);
  if (!(contact.distance > 0.0F)) {
    const bool outside = contact.kind == ContactKind::bounds;
    const std::string line = body + (outside ? " reaches to or beyond " : " overlaps ") + other + " at " + at;
    if (contact.kind != ContactKind::obstacle) return line;
    return line + grown_around(resolve_start(scene, request), scene, request.robot);
  }
  const double distance = static_cast<double>(contact.distance);
  const double clearance = static_cast<double>(request.parameters.clearance);
  const double rounding = static_cast<double>(contact.needed) - clearance;
  const std::string margin = metres(static_cast<double>(contact.needed)) + " (--clearance " + metres(clearance) +
                             ", and " + metres(rounding) + " for what a motion is off by)";
  const std::string where = body + " is " + metres(distance) + " from " + other + " at " + at;
  const std::string line = "the start does not keep the clearance: " + where + ", and must keep " + margin;
  return contact.kind == ContactKind::obstacle
             ? line + grown(scene, 2 * (static_cast<double>(contact.needed) - distance))
             : line;
}

std::string why_not_at_goal(const GoalRoom& room, const krait::Scene& scene, const SearchRequest& request) {
  const Contact& there = room.at_middle;
  const double distance = static_cast<double>(there.distance);
  const bool trailed = there.body > 0;
  std::string why = (trailed ? "the robot" : body_name(request.robot, 0)) + " has no room in the goal " +
                    (request.facing ? "as it is asked to be turned" : "in any heading");
  if (!room.none) why += ": it stands free in none of " + std::to_string(room.poses) + " poses that were tried";
  why += request.facing ? "; in the goal's middle " : "; in the goal's middle, with heading 0, ";
  why += trailed ? body_name(request.robot, there.body) + ' ' : "it ";
  why += distance > 0 ? "is only " + metres(distance) + " from " : "meets ";
  why += other_name(there, scene, request) + " at " + place(scene, there.at);
  if (growth_takes_the_goal(scene, request)) why += grown(scene, 0);
  if (!request.facing) return why + ": try another goal, or a larger one";
  return why + ": try another --heading, a larger --heading-tolerance, " +
         (trailed ? "a larger --hitch-tolerance, " : "") + "or another goal";
}

std::string why_no_goal(const krait::Scene& scene, const SearchRequest& request) {
  const krait::Goal goal = resolve_goal(scene, request);
  const std::string middle = place(scene, middle_of(scene, goal));
  const std::string what = goal.is_disc()
                               ? "all that lies within " + metres(static_cast<double>(goal.radius())) + " of " + middle
                               : "all of goal '" + std::string(scene.goal_name(goal.index())) + "', around " + middle;
  return "no free part of the goal is left: " + what + ", is in obstacles or outside" + grown(scene, 0) +
         ": give another --goal" + (goal.is_disc() ? " or a larger radius" : "");
}

Mark goal_mark(const krait::Scene& scene, const SearchRequest& request) {
  return {local_point(middle_of(scene, resolve_goal(scene, request))), "the goal"};
}

std::vector<std::string> why_no_plan(Session& session, const krait::Scene& scene, const SearchRequest& request) {
  switch (session.status()) {
    case Status::no_route:
      return {why_no_route(session.bottleneck(), scene, request)};
    case Status::budget_used:
    case Status::time_used:
    case Status::tree_full:
      break;
    default:
      return {};
  }
  if (std::optional<std::string> no_room = why_it_hardly_ends(scene, request)) return {*std::move(no_room)};
  const Bottleneck bottleneck = session.bottleneck();
  std::vector<std::string> lines = where_it_is_tight(bottleneck, scene);
  if (const Effort effort = session.effort(); effort.tries > 0) {
    const std::string stops = what_stops_it(hindrances_of(session, scene, request.parameters), scene, request);
    lines.push_back("most expansions, " + std::to_string(effort.tries) + ", grew from around " +
                    place(scene, effort.at) + (stops.empty() ? "" : ": " + stops));
  }
  const bool straight_on = is_straight_on(scene, request, bottleneck.needed);
  for (std::string& line : what_to_try(session.status(), session.statistics(), request, straight_on)) {
    lines.push_back(line);
  }
  return lines;
}

std::vector<Mark> where_no_plan(Session& session, const krait::Scene& scene, const SearchRequest& request) {
  if (session.status() != Status::no_route) {
    const GoalRoom room = room_in_goal(scene, request);
    if (!room.found) return {{local_point(room.at_middle.at), "no room"}};
  }
  std::vector<Mark> marks;
  const Bottleneck bottleneck = session.bottleneck();
  if (bottleneck.width > 0.0F && is_tight(bottleneck)) {
    marks.push_back({local_point(bottleneck.at), bottleneck.at_goal ? "roomiest place" : "narrowest place"});
  }
  if (const Effort effort = session.effort(); effort.tries > 0) marks.push_back({local_point(effort.at), "tried most"});
  const Hindrances found = hindrances_of(session, scene, request.parameters);
  if (found.stopped > 0 && found.stopped >= found.beyond) {
    const std::string body = request.robot.links > 0 ? " body " + std::to_string(found.contact.body) : " it";
    marks.push_back({local_point(found.contact.at), "stops" + body});
  }
  return marks;
}

}  // namespace krait::host
