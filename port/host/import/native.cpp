// SPDX-License-Identifier: Apache-2.0
// krait's own scene: JSON, metres and radians.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "host/import/format.hpp"
#include "host/import/json_keys.hpp"
#include "host/import/shapes.hpp"
#include "host/input/facing.hpp"

namespace krait::host {
namespace {

// A YAML file may be one map in braces, which looks like an object.
bool recognise(const Source& source) { return is_json_object(source.content) && !kMapServer.recognise(source); }

using RoundRing = Ring (*)(const Point& center, double radius);

Ring read_circle(const Field& circle, RoundRing round) {
  circle.keys({"center", "radius"});
  return round(circle.at("center").point(kMaxFarCoordinate),
               circle.at("radius").number(kMinLength, kMaxCoordinate, "metres"));
}

// The one of "polygon", "box" and "circle" that the object has.
Ring read_shape(const Field& field, RoundRing round) {
  const int shapes = (field.has("polygon") ? 1 : 0) + (field.has("box") ? 1 : 0) + (field.has("circle") ? 1 : 0);
  if (shapes != 1) field.fail("must have one of polygon, box and circle, has " + std::to_string(shapes));
  if (field.has("polygon")) return field.at("polygon").ring(SIZE_MAX, kMaxFarCoordinate);
  if (field.has("box")) {
    const Field box = field.at("box");
    box.keys({"center", "size", "angle"});
    return read_box(box, {"angle"});
  }
  return read_circle(field.at("circle"), round);
}

Obstacle read_obstacle(const Field& field) {
  field.keys({"polygon", "holes", "box", "circle"});
  Obstacle obstacle{field.place(), read_shape(field, ring_around_circle), {}};
  if (!field.has("holes")) return obstacle;
  const Field holes = field.at("holes");
  if (!field.has("polygon")) holes.fail("only a polygon can have holes");
  for (std::size_t i = 0; i < holes.size(); ++i)
    obstacle.holes.push_back(holes.item(i).ring(SIZE_MAX, kMaxFarCoordinate));
  return obstacle;
}

// A position with a radius, or a circle.
GoalPose read_pose(const Field& field) {
  const bool circle = field.has("circle");
  const Field place = circle ? field.at("circle") : field;
  if (circle) place.keys({"center", "radius"});
  return {place.at(circle ? "center" : "position").point(kMaxFarCoordinate),
          place.at("radius").number(kMinLength, kMaxCoordinate, "metres"), read_facing(field)};
}

Goal read_goal(const Field& field) {
  field.keys({"name", "polygon", "box", "circle", "position", "radius", "heading", "heading_tolerance", "either_way",
              "hitch_tolerance"});
  const std::string name = field.at("name").name();
  const bool region = field.has("polygon") || field.has("box");
  const bool circle = field.has("circle");
  const bool place = field.has("position") || field.has("radius");
  if (place && (region || circle)) field.fail("must have one of polygon, box, circle, and position with radius");
  if (place && !field.has("heading")) field.fail("position and radius need a heading; without one, give a circle");
  if (region && field.has("heading")) {
    field.at("heading").fail("needs a circle, or position and radius: a polygon or box holds robots turned in any way");
  }
  if (place || (circle && field.has("heading"))) return pose_goal(name, read_pose(field));
  require_no_tolerance(field);
  return {name, read_shape(field, ring_inside_circle)};
}

Start read_start(const Field& field) {
  field.keys({"name", "position", "heading", "angles"});
  Start start{field.at("name").name(),
              field.at("position").point(kMaxFarCoordinate),
              field.at("heading").number(-kMaxAngle, kMaxAngle, "radians"),
              {}};
  if (!field.has("angles")) return start;
  const Field angles = field.at("angles");
  for (std::size_t i = 0; i < angles.size(0, kMaxLinks); ++i) {
    start.angles.push_back(angles.item(i).number(-kMaxAngle, kMaxAngle, "radians"));
  }
  return start;
}

template <class Item>
void require_distinct_names(const Field& list, const std::vector<Item>& items) {
  std::set<std::string> names;
  for (const Item& item : items) {
    if (!names.insert(item.name).second) list.fail("the name \"" + item.name + "\" is given twice");
  }
}

template <class Item>
std::vector<Item> read_list(const Field& document, const char* key, Item (*read)(const Field&)) {
  std::vector<Item> items;
  if (!document.has(key)) return items;
  const Field list = document.at(key);
  for (std::size_t i = 0; i < list.size(); ++i) items.push_back(read(list.item(i)));
  return items;
}

void read_bounds(const Field& bounds, Workspace& workspace) {
  bounds.keys({"min", "max"});
  workspace.min = bounds.at("min").point(kMaxFarCoordinate);
  workspace.max = bounds.at("max").point(kMaxFarCoordinate);
  if (!(workspace.min.x < workspace.max.x && workspace.min.y < workspace.max.y)) {
    bounds.fail("max must be greater than min in x and in y");
  }
}

Workspace read(const Source& source, const ImportOptions&) {
  const Json document = parse_json(source.content, source.path);
  const Field field(document, source.path);
  field.keys({"name", "bounds", "obstacles", "goals", "starts"});
  Workspace workspace;
  if (field.has("name")) workspace.name = field.at("name").name();
  read_bounds(field.at("bounds"), workspace);
  workspace.obstacles = read_list(field, "obstacles", read_obstacle);
  workspace.goals = read_list(field, "goals", read_goal);
  workspace.starts = read_list(field, "starts", read_start);
  if (field.has("goals")) require_distinct_names(field.at("goals"), workspace.goals);
  if (field.has("starts")) require_distinct_names(field.at("starts"), workspace.starts);
  return workspace;
}

}  // namespace

const Format kNative = {"krait's JSON", ".json", recognise, read};

}  // namespace krait::host
