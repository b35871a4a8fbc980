// SPDX-License-Identifier: Apache-2.0
#include "host/run/query.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/run/scene_names.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

constexpr int kDiscCorners = 64;  // of the polygon that stands for a disc goal in the plan's file

Start scene_start(const krait::Scene& scene, Index index, int links) {
  const ScenePose pose = scene.start(index);
  Start start{scene.start_name(index), world_of(scene, pose.position), static_cast<double>(pose.heading), {}};
  if (links > 0) start.angles.assign(pose.angles, pose.angles + pose.angle_count);
  return start;
}

Ring disc_polygon(Vec2 center, float radius) {
  Ring ring;
  for (int i = 0; i < kDiscCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kDiscCorners;
    ring.push_back({static_cast<double>(center.x) + static_cast<double>(radius) * std::cos(angle),
                    static_cast<double>(center.y) + static_cast<double>(radius) * std::sin(angle)});
  }
  return ring;
}

Ring goal_ring(const krait::Scene& scene, const krait::Goal& goal) {
  if (goal.is_disc()) return disc_polygon(goal.center(), goal.radius());
  Ring ring;
  const Polygon polygon = scene.goal_polygon(goal.index());
  for (int i = 0; i < polygon.count; ++i) {
    ring.push_back({static_cast<double>(polygon[i].x), static_cast<double>(polygon[i].y)});
  }
  return ring;
}

// The workspace knows nothing of the library.
static_assert(static_cast<float>(GoalFacing().tolerance) == Facing().tolerance);

Facing facing_of(const GoalFacing& from) {
  const float hitches = from.hitches ? static_cast<float>(*from.hitches) : kInfinity;
  return {static_cast<float>(from.heading), static_cast<float>(from.tolerance), from.either_way, hitches};
}

std::string goal_name(const krait::Scene& scene, const SearchRequest& request, const krait::Goal& goal) {
  if (!goal.is_disc()) return scene.goal_name(goal.index());
  if (!request.goal_name.empty()) return request.goal_name;
  return goal.is_pose() ? "pose" : "disc";
}

}  // namespace

Start resolve_start(const krait::Scene& scene, const SearchRequest& request) {
  if (request.start) return {"start", request.start->position, request.start->heading, {}};
  if (request.start_name.empty() && scene.start_count() > 0) return scene_start(scene, 0, request.robot.links);
  const std::vector<std::string> starts = names_of(scene).starts;
  const auto index = static_cast<Index>(std::find(starts.begin(), starts.end(), request.start_name) - starts.begin());
  if (index < starts.size()) return scene_start(scene, index, request.robot.links);
  throw InputError(request.start_name.empty() ? "the scene has no start: give --start X,Y,HEADING"
                                              : "the scene has no start '" + request.start_name +
                                                    "' (it has: " + listed(starts) + "; or give --start X,Y,HEADING)");
}

krait::Goal resolve_goal(const krait::Scene& scene, const SearchRequest& request) {
  if (request.goal) {
    const Vec2 center = local_of(scene, request.goal->center);
    const auto radius = static_cast<float>(request.goal->radius);
    return request.facing ? krait::Goal::pose(center, radius, facing_of(*request.facing))
                          : krait::Goal::disc(center, radius);
  }
  if (request.goal_name.empty() && scene.goal_count() > 0) return krait::Goal::named(0);
  const Index index = scene.find_goal(request.goal_name.c_str());
  if (index != kNone) return krait::Goal::named(index);
  const std::string known = listed(names_of(scene).goals);
  throw InputError(request.goal_name.empty() ? "the scene has no goal: give --goal X,Y,RADIUS"
                                             : "the scene has no goal '" + request.goal_name + "' (it has: " + known +
                                                   "; or give --goal X,Y,RADIUS)");
}

Asked asked_of(const krait::Scene& scene, const SearchRequest& request, const Start& start, const krait::Goal& goal) {
  Asked asked;
  asked.robot = request.robot;
  asked.start = start;
  asked.dt = static_cast<double>(request.parameters.dt);
  asked.end_speed = request.end_speed();
  if (goal.is_disc()) {
    asked.disc_center = request.goal->center;
    asked.disc_radius = request.goal->radius;
    asked.facing = request.facing;
  } else {
    for (const Point& p : goal_ring(scene, goal)) {
      asked.goal.push_back({p.x + scene.header().origin_x, p.y + scene.header().origin_y});
    }
  }
  return asked;
}

PlanFile plan_form(const krait::Scene& scene, const SearchRequest& request, const krait::Goal& goal) {
  PlanFile form;
  form.scene = scene.name();
  form.seed = request.seed;
  form.planner = request.planner;
  form.robot = request.robot;
  form.dt = static_cast<double>(request.parameters.dt);
  form.goal_name = goal_name(scene, request, goal);
  form.goal_facing = request.facing;
  form.goal_polygon = goal_ring(scene, goal);
  form.state_names = state_names(request.robot);
  form.origin = {scene.header().origin_x, scene.header().origin_y};
  return form;
}

std::vector<float> state_at(const Robot& robot, const krait::Scene& scene, const Start& start) {
  std::vector<float> state(static_cast<std::size_t>(robot.state_size()));
  const std::vector<float> angles(start.angles.begin(), start.angles.end());
  if (!robot.rest(local_of(scene, start.position), static_cast<float>(start.heading), angles.data(),
                  static_cast<std::uint32_t>(angles.size()), state.data())) {
    throw InputError("start '" + start.name + "' gives " + counted(angles.size(), "trailer angle") +
                     ", the robot has " + counted(static_cast<std::size_t>(robot.body_count() - 1), "trailer"));
  }
  return state;
}

ResolvedQuery resolve(const krait::Scene& scene, const Robot& robot, const SearchRequest& request) {
  const Start start = resolve_start(scene, request);
  const krait::Goal goal = resolve_goal(scene, request);
  return {state_at(robot, scene, start), goal, asked_of(scene, request, start, goal), plan_form(scene, request, goal)};
}

}  // namespace krait::host
