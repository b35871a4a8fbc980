// SPDX-License-Identifier: Apache-2.0
#include "host/import/drawing.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace krait::host {
namespace {

constexpr std::array<std::pair<std::string_view, Role>, 5> kWords = {{{"obstacle", Role::obstacle},
                                                                      {"bounds", Role::bounds},
                                                                      {"goal", Role::goal},
                                                                      {"start", Role::start},
                                                                      {"none", Role::none}}};

struct Box {
  Point min = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point max = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void include(const Point& p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
  }
};

Box box_of(const Ring& ring) {
  Box box;
  for (const Point& p : ring) box.include(p);
  return box;
}

bool is_corner(const Point& p, const Box& box) {
  return (p.x == box.min.x || p.x == box.max.x) && (p.y == box.min.y || p.y == box.max.y);
}

// Four different corners, one after the other along the sides.
bool is_box(const Ring& ring, const Box& box) {
  if (ring.size() != 4) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point& p = ring[i];
    const Point& next = ring[(i + 1) % 4];
    const Point& opposite = ring[(i + 2) % 4];
    if (!is_corner(p, box) || (p.x == next.x) == (p.y == next.y)) return false;
    if (p.x == opposite.x || p.y == opposite.y) return false;
  }
  return true;
}

std::string name_or(const std::string& name, const char* usual, std::size_t before) {
  if (!name.empty()) return name;
  return before == 0 ? usual : std::string(usual) + " " + std::to_string(before + 1);
}

// A frame, as wide as the box, around the polygon.
Obstacle outside(const Ring& polygon, const Box& box) {
  const double wide = box.max.x - box.min.x;
  const double high = box.max.y - box.min.y;
  const Point low = {box.min.x - wide, box.min.y - high};
  const Point far = {box.max.x + wide, box.max.y + high};
  return {"the outside of the bounds", {low, {far.x, low.y}, far, {low.x, far.y}}, {polygon}};
}

}  // namespace

std::optional<Role> role_of(std::string_view word) {
  for (const auto& [name, role] : kWords) {
    if (name == word) return role;
  }
  return std::nullopt;
}

void Drawing::add_goal(const std::string& name, Goal goal) {
  goal.name = name_or(name, "goal", workspace_.goals.size());
  workspace_.goals.push_back(std::move(goal));
}

void Drawing::add_start(const std::string& name, Start start) {
  start.name = name_or(name, "start", workspace_.starts.size());
  workspace_.starts.push_back(std::move(start));
}

void Drawing::set_bounds(const std::string& place, const Ring& polygon) {
  if (bounds_) throw InputError(file_ + ": " + place + ": there are bounds already: keep one shape in that role");
  bounds_ = polygon;
}

void Drawing::bound_all() {
  Box box;
  for (const Obstacle& obstacle : workspace_.obstacles) {
    for (const Point& p : obstacle.outer) box.include(p);
  }
  for (const Goal& goal : workspace_.goals) {
    for (const Point& p : goal.polygon) box.include(p);
  }
  for (const Start& start : workspace_.starts) box.include(start.position);
  if (box.min.x > box.max.x) throw InputError(file_ + ": is empty: it has no shape that krait reads");
  workspace_.min = box.min;
  workspace_.max = box.max;
  workspace_.warnings.push_back(file_ + ": has no bounds; they are the box around all its shapes");
}

Workspace Drawing::take() {
  if (bounds_) {
    const Box box = box_of(*bounds_);
    workspace_.min = box.min;
    workspace_.max = box.max;
    if (!is_box(*bounds_, box)) workspace_.obstacles.push_back(outside(*bounds_, box));
  } else {
    bound_all();
  }
  if (!(workspace_.min.x < workspace_.max.x && workspace_.min.y < workspace_.max.y)) {
    throw InputError(file_ + ": the bounds have no area: give a shape in the role bounds");
  }
  return std::move(workspace_);
}

}  // namespace krait::host
