// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include "host/export/cell_boxes.hpp"
#include "host/export/export.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

// A map's y points up, a drawing's down.
std::string points(const Ring& ring) {
  std::string all;
  for (const Point& p : ring) all.append(all.empty() ? "" : " ").append(printed("%.17g,%.17g", p.x, 0 - p.y));
  return all;
}

std::string outline(const Obstacle& obstacle) {
  std::string data;
  data.append("M").append(points(obstacle.outer)).append("Z");
  for (const Ring& hole : obstacle.holes) data.append("M").append(points(hole)).append("Z");
  return data;
}

pugi::xml_node add(pugi::xml_node& parent, const char* name, const char* role) {
  pugi::xml_node node = parent.append_child(name);
  node.append_attribute("class") = role;
  return node;
}

void set_title(pugi::xml_node& node, const std::string& title) {
  if (!title.empty()) node.append_child("title").text() = title.c_str();
}

void add_polygon(pugi::xml_node& parent, const char* role, const std::string& name, const Ring& ring) {
  pugi::xml_node node = add(parent, "polygon", role);
  node.append_attribute("points") = points(ring).c_str();
  node.append_attribute("fill") = "none";
  node.append_attribute("stroke") = "black";
  node.append_attribute("stroke-width") = "0.05";
  set_title(node, name);
}

// From the last trailer to where the robot looks, a metre for each body.
Ring chain(const Start& start, const Point& position) {
  Ring ring = {position};
  for (const double angle : start.angles) {
    const Point& last = ring.back();
    ring.push_back({last.x - std::cos(angle), last.y - std::sin(angle)});
  }
  Ring turned(ring.rbegin(), ring.rend());
  turned.push_back({position.x + std::cos(start.heading), position.y + std::sin(start.heading)});
  return turned;
}

void add_chain(pugi::xml_node& parent, const char* role, const Start& start, const Workspace& workspace) {
  pugi::xml_node node = add(parent, "polyline", role);
  node.append_attribute("points") = points(chain(start, unshifted(start.position, workspace))).c_str();
  node.append_attribute("fill") = "none";
  node.append_attribute("stroke") = "black";
  node.append_attribute("stroke-width") = "0.1";
  set_title(node, start.name);
}

// A pose's line holds neither its radius nor its tolerances.
void add_goal(pugi::xml_node& parent, const Goal& goal, const Workspace& workspace) {
  if (!goal.pose) return add_polygon(parent, "goal", goal.name, unshifted(goal.polygon, workspace));
  add_chain(parent, "goal", {goal.name, goal.pose->position, goal.pose->facing.heading, {}}, workspace);
}

void add_page(pugi::xml_node& svg, const Point& min, const Point& max) {
  const double width = max.x - min.x;
  const double height = max.y - min.y;
  svg.append_attribute("xmlns") = "http://www.w3.org/2000/svg";
  svg.append_attribute("width") = printed("%.17gmm", 1000 * width).c_str();
  svg.append_attribute("height") = printed("%.17gmm", 1000 * height).c_str();
  svg.append_attribute("viewBox") = printed("%.17g %.17g %.17g %.17g", min.x, 0 - max.y, width, height).c_str();
}

}  // namespace

std::string svg(const Workspace& workspace) {
  pugi::xml_document document;
  pugi::xml_node page = document.append_child("svg");
  const Point min = unshifted(workspace.min, workspace);
  const Point max = unshifted(workspace.max, workspace);
  add_page(page, min, max);
  set_title(page, workspace.name);
  add_polygon(page, "bounds", "", {min, {max.x, min.y}, max, {min.x, max.y}});
  for (const Obstacle& obstacle : all_obstacles(workspace)) {
    pugi::xml_node path = add(page, "path", "obstacle");
    path.append_attribute("d") = outline(obstacle).c_str();
    path.append_attribute("fill") = "grey";
    path.append_attribute("fill-rule") = "evenodd";
  }
  for (const Goal& goal : workspace.goals) add_goal(page, goal, workspace);
  for (const Start& start : workspace.starts) add_chain(page, "start", start, workspace);
  std::ostringstream out;
  document.save(out, " ");
  return out.str();
}

}  // namespace krait::host
