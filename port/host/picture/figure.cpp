// SPDX-License-Identifier: Apache-2.0
#include "host/picture/figure.hpp"

#include <algorithm>
#include <cmath>

#include "host/picture/poses.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {

namespace {

constexpr double kLargestSide = 1e5;  // metres
constexpr std::size_t kLongestText = 200;

constexpr double kHead = 62;  // points
constexpr double kFoot = 104;
constexpr double kMostMapWidth = 1080;
constexpr double kMostMapHeight = 900;
constexpr double kLeastContentWidth = 760;  // the legend needs this much
constexpr double kFarthest = 1e5;           // points; beyond it Cairo's fixed-point coordinates overflow

[[noreturn]] void fail(const std::string& what) { throw InputError("picture: " + what); }

std::string element(const char* list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

void check_point(double x, double y, const std::string& where) {
  if (!std::isfinite(x) || !std::isfinite(y)) fail(where + " has a coordinate that is not finite");
}

void check_ring(const Ring& ring, const std::string& where) {
  for (const Point& point : ring) check_point(point.x, point.y, where);
}

void check_bounds(const Picture& picture) {
  const double width = picture.max.x - picture.min.x;
  const double height = picture.max.y - picture.min.y;
  const bool sound = width > 0 && height > 0 && width <= kLargestSide && height <= kLargestSide;
  check_point(picture.min.x, picture.min.y, "bounds.min");
  if (!sound) fail("the bounds' sides must be more than 0 and at most 100000 m");
}

void check_scene(const Picture& picture) {
  for (std::size_t i = 0; i < picture.obstacle_pieces.size(); ++i) {
    check_ring(picture.obstacle_pieces[i], element("obstacle_pieces", i));
  }
  for (std::size_t i = 0; i < picture.triangles.size(); ++i) {
    for (const Point& corner : picture.triangles[i].corners) check_point(corner.x, corner.y, element("triangles", i));
  }
  check_ring(picture.plan.goal_polygon, "plan.goal");
}

void check_search(const Picture& picture) {
  for (std::size_t i = 0; i < picture.frames.size(); ++i) {
    const CostFrame& frame = picture.frames[i];
    if (frame.costs.size() != picture.triangles.size()) {
      fail(element("frames", i) + " has " + std::to_string(frame.costs.size()) + " costs for " +
           std::to_string(picture.triangles.size()) + " triangles");
    }
    if (std::any_of(frame.costs.begin(), frame.costs.end(), [](float cost) { return std::isnan(cost); })) {
      fail(element("frames", i) + " has a cost that is NaN");
    }
    if (i > 0 && frame.iteration < picture.frames[i - 1].iteration) fail("frames are not ascending by iteration");
  }
  for (std::size_t i = 0; i < picture.tree.size(); ++i) {
    const TreeVertex& vertex = picture.tree[i];
    check_point(vertex.x, vertex.y, element("tree", i));
    if (vertex.parent > i) fail(element("tree", i) + " has a parent that comes after it");
    if (i > 0 && vertex.iteration < picture.tree[i - 1].iteration) fail("tree is not ascending by iteration");
  }
  for (std::size_t i = 0; i < picture.marks.size(); ++i) {
    check_point(picture.marks[i].at.x, picture.marks[i].at.y, element("marks", i));
  }
}

void check_state(const std::vector<float>& state, std::size_t size, const std::string& where) {
  if (state.size() != size) {
    fail(where + " has " + std::to_string(state.size()) + " values where the robot has " + std::to_string(size));
  }
  if (!std::all_of(state.begin(), state.end(), [](float value) { return std::isfinite(value); })) {
    fail(where + " has a value that is not finite");
  }
}

void check_plan(const PlanFile& plan, const std::vector<float>& start) {
  if (plan.states.empty() && start.empty()) return;
  if (plan.robot.links < 0) fail("robot.links is negative");
  const std::size_t size = state_size(plan.robot);
  const auto bodies = static_cast<std::size_t>(plan.robot.links) + 1;
  if (plan.robot.bodies.size() != bodies) {
    fail("robot.bodies has " + std::to_string(plan.robot.bodies.size()) + " bodies where links + 1 are " +
         std::to_string(bodies));
  }
  for (std::size_t k = 0; k < bodies; ++k) check_ring(plan.robot.bodies[k], element("robot.bodies", k));
  if (!start.empty()) check_state(start, size, "start");
  if (!std::isfinite(plan.dt) || plan.dt <= 0) fail("plan.dt is not positive");
  for (std::size_t i = 0; i < plan.states.size(); ++i) {
    check_state(plan.states[i], size, element("plan.states", i));
  }
}

std::string fixed(double value, int digits) { return printed("%.*f", digits, value); }

double path_length(const PlanFile& plan) {
  double length = 0;
  for (std::size_t i = 1; i < plan.states.size(); ++i) {
    length += std::hypot(static_cast<double>(plan.states[i][0]) - static_cast<double>(plan.states[i - 1][0]),
                         static_cast<double>(plan.states[i][1]) - static_cast<double>(plan.states[i - 1][1]));
  }
  return length;
}

std::string robot_name(const RobotSpec& robot) {
  std::string name = robot.model == "diff_drive" ? "differential drive" : printable(robot.model);
  if (robot.links == 1) name += " with 1 trailer";
  if (robot.links > 1) name += " with " + std::to_string(robot.links) + " trailers";
  return name;
}

}  // namespace

void check(const Picture& picture) {
  check_bounds(picture);
  check_scene(picture);
  check_search(picture);
  check_plan(picture.plan, picture.start);
}

std::string printable(const std::string& text) {
  std::string clean;
  std::size_t characters = 0;
  for (const char c : safe_to_print(text)) {
    if ((static_cast<unsigned char>(c) & 0xC0) != 0x80 && characters++ == kLongestText) break;
    clean += c;
  }
  for (const char* forbidden : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) {  // U+FFFE and U+FFFF: XML has no way to hold them
    for (auto at = clean.find(forbidden); at != std::string::npos; at = clean.find(forbidden)) {
      clean.replace(at, 3, "\xEF\xBF\xBD");
    }
  }
  return clean;
}

std::vector<std::string> facts(const Picture& picture) {
  const PlanFile& plan = picture.plan;
  std::vector<std::string> all;
  if (!plan.robot.model.empty()) all.push_back(robot_name(plan.robot));
  if (!plan.planner.empty()) all.push_back(printable(plan.planner));
  all.push_back("seed " + std::to_string(plan.seed));
  if (plan.states.empty()) {
    all.push_back(plan.status.empty() ? "no plan" : "no plan: " + printable(plan.status));
    int number = 0;
    for (const Mark& mark : picture.marks) all.push_back(std::to_string(++number) + " " + printable(mark.text));
    return all;
  }
  if (!plan.status.empty()) all.push_back(printable(plan.status));
  all.push_back(fixed(static_cast<double>(plan.states.size() - 1) * plan.dt, 1) + " s");
  all.push_back(fixed(path_length(plan), 1) + " m");
  return all;
}

double round_length(double limit) {
  const double power = std::pow(10, std::floor(std::log10(limit)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= limit) return factor * power;
  }
  return power;
}

std::string short_number(double value) { return printed("%.6g", value); }

Point Figure::at(Point local) const {
  return {std::clamp(left + (local.x - min.x) * scale, -kFarthest, kFarthest),
          std::clamp(top + (max.y - local.y) * scale, -kFarthest, kFarthest)};
}

std::vector<Ring> goal_arrows(const PlanFile& plan) {
  if (!plan.goal_facing || plan.goal_polygon.empty() || plan.robot.bodies.empty()) return {};
  Point middle{};
  for (const Point& corner : plan.goal_polygon) {
    const auto share = 1.0 / static_cast<double>(plan.goal_polygon.size());
    middle = {middle.x + share * corner.x, middle.y + share * corner.y};
  }
  double size = 0;
  for (const Point& corner : plan.robot.bodies.front()) size = std::max(size, 1.3 * std::hypot(corner.x, corner.y));
  std::vector<Ring> arrows;
  for (const double side : {1.0, -1.0}) {
    if (side < 0 && !plan.goal_facing->either_way) break;
    const double c = side * std::cos(plan.goal_facing->heading);
    const double s = side * std::sin(plan.goal_facing->heading);
    const auto at = [&](double ahead, double left) {
      return Point{middle.x + size * (ahead * c - left * s), middle.y + size * (ahead * s + left * c)};
    };
    arrows.push_back({at(0, 0), at(1, 0), at(0.7, 0.25), at(1, 0), at(0.7, -0.25)});
  }
  return arrows;
}

Ring front_mark(const RobotSpec& robot) {
  if (robot.bodies.empty()) return {};
  const Ring& body = robot.bodies.front();
  const auto [back, front] =
      std::minmax_element(body.begin(), body.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  const auto [right, left] =
      std::minmax_element(body.begin(), body.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
  const double size = std::min(front->x - back->x, left->y - right->y) / 2;
  const double middle = (left->y + right->y) / 2;
  const double base = front->x - 0.9 * size;
  return {{base, middle + 0.6 * size}, {front->x - 0.3 * size, middle}, {base, middle - 0.6 * size}};
}

Figure layout(const Picture& picture) {
  Figure figure;
  figure.min = picture.min;
  figure.max = picture.max;
  const double width = picture.max.x - picture.min.x;
  const double height = picture.max.y - picture.min.y;
  figure.scale = std::min(kMostMapWidth / width, kMostMapHeight / height);
  figure.map_width = width * figure.scale;
  figure.map_height = height * figure.scale;
  figure.width = std::ceil(std::max(figure.map_width, kLeastContentWidth) + 2 * kMargin);
  figure.height = std::ceil(kHead + figure.map_height + kFoot);
  figure.left = (figure.width - figure.map_width) / 2;
  figure.top = kHead;
  return figure;
}

}  // namespace krait::host
