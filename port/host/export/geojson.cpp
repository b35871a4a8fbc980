// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "host/export/cell_boxes.hpp"
#include "host/export/export.hpp"
#include "host/input/facing.hpp"

namespace krait::host {
namespace {

Json closed(Ring ring) {
  ring.push_back(ring.front());
  return to_json(ring);
}

Json polygon(const Ring& outer, const std::vector<Ring>& holes = {}) {
  Json rings = Json::array({closed(outer)});
  for (const Ring& hole : holes) rings.push_back(closed(hole));
  return {{"type", "Polygon"}, {"coordinates", rings}};
}

Json feature(const char* role, Json geometry) {
  return {{"type", "Feature"}, {"properties", {{"role", role}}}, {"geometry", std::move(geometry)}};
}

Json point(const Point& at, const Workspace& workspace) {
  const Point p = unshifted(at, workspace);
  return {{"type", "Point"}, {"coordinates", {p.x, p.y}}};
}

Json feature_of(const Goal& goal, const Workspace& workspace) {
  Json json =
      feature("goal", goal.pose ? point(goal.pose->position, workspace) : polygon(unshifted(goal.polygon, workspace)));
  Json& properties = json["properties"];
  properties["name"] = goal.name;
  if (!goal.pose) return json;
  properties["radius"] = goal.pose->radius;
  add_facing(goal.pose->facing, properties);
  return json;
}

Json feature_of(const Start& start, const Workspace& workspace) {
  Json json = feature("start", point(start.position, workspace));
  json["properties"]["name"] = start.name;
  json["properties"]["heading"] = start.heading;
  if (!start.angles.empty()) json["properties"]["angles"] = start.angles;
  return json;
}

Ring bounds_of(const Workspace& workspace) {
  const Point& min = workspace.min;
  const Point& max = workspace.max;
  return unshifted(Ring{min, {max.x, min.y}, max, {min.x, max.y}}, workspace);
}

}  // namespace

std::string geojson(const Workspace& workspace) {
  Json features = Json::array({feature("bounds", polygon(bounds_of(workspace)))});
  for (const Obstacle& obstacle : all_obstacles(workspace)) {
    features.push_back(feature("obstacle", polygon(obstacle.outer, obstacle.holes)));
  }
  for (const Goal& goal : workspace.goals) features.push_back(feature_of(goal, workspace));
  for (const Start& start : workspace.starts) features.push_back(feature_of(start, workspace));
  const Json json = {{"type", "FeatureCollection"}, {"name", workspace.name}, {"unit", 1}, {"features", features}};
  return json.dump(1) + "\n";
}

}  // namespace krait::host
