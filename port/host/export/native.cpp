// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "host/export/cell_boxes.hpp"
#include "host/export/export.hpp"
#include "host/input/facing.hpp"

namespace krait::host {
namespace {

Json json_of(const Point& p) { return {p.x, p.y}; }

Json json_of(const Obstacle& obstacle) {
  Json json = {{"polygon", to_json(obstacle.outer)}};
  for (const Ring& hole : obstacle.holes) json["holes"].push_back(to_json(hole));
  return json;
}

Json json_of(const Start& start, const Workspace& workspace) {
  Json json = {
      {"name", start.name}, {"position", json_of(unshifted(start.position, workspace))}, {"heading", start.heading}};
  if (!start.angles.empty()) json["angles"] = start.angles;
  return json;
}

Json json_of(const Goal& goal, const Workspace& workspace) {
  Json json = {{"name", goal.name}};
  if (!goal.pose) {
    json["polygon"] = to_json(unshifted(goal.polygon, workspace));
    return json;
  }
  json["position"] = json_of(unshifted(goal.pose->position, workspace));
  json["radius"] = goal.pose->radius;
  add_facing(goal.pose->facing, json);
  return json;
}

}  // namespace

std::string native_json(const Workspace& workspace) {
  Json json = Json::object();
  if (!workspace.name.empty()) json["name"] = workspace.name;
  json["bounds"] = {{"min", json_of(unshifted(workspace.min, workspace))},
                    {"max", json_of(unshifted(workspace.max, workspace))}};
  for (const char* list : {"obstacles", "goals", "starts"}) json[list] = Json::array();
  for (const Obstacle& obstacle : all_obstacles(workspace)) json["obstacles"].push_back(json_of(obstacle));
  for (const Goal& goal : workspace.goals) json["goals"].push_back(json_of(goal, workspace));
  for (const Start& start : workspace.starts) json["starts"].push_back(json_of(start, workspace));
  return json.dump(1) + "\n";
}

}  // namespace krait::host
