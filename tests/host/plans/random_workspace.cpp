// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_workspace.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace krait::host::test {
namespace {

class Draw {
 public:
  explicit Draw(std::mt19937_64& random) : random_(random) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  bool chance(double share) { return uniform(0, 1) < share; }
  double angle() { return uniform(0, 2 * std::numbers::pi); }
  Point within(const Workspace& w, double margin) {
    const double x = uniform(w.min.x + margin, w.max.x - margin);
    return {x, uniform(w.min.y + margin, w.max.y - margin)};
  }

 private:
  std::mt19937_64& random_;
};

Point moved(Point center, double angle, double along, double across) {
  return {center.x + std::cos(angle) * along - std::sin(angle) * across,
          center.y + std::sin(angle) * along + std::cos(angle) * across};
}

Ring box(Point center, double length, double width, double angle) {
  return {moved(center, angle, -length / 2, -width / 2), moved(center, angle, length / 2, -width / 2),
          moved(center, angle, length / 2, width / 2), moved(center, angle, -length / 2, width / 2)};
}

Ring any_shape(Draw& draw, Point center, double size) {
  const double angle = draw.chance(0.4) ? 0 : draw.angle();
  switch (draw.whole(0, 4)) {
    case 0:  // a wall, down to a millimetre
      return box(center, draw.uniform(1, 3 * size), draw.chance(0.3) ? 0.001 : draw.uniform(0.02, 0.4), angle);
    case 1: {
      Ring ring;
      for (int i = 0; i < 24; ++i) ring.push_back(moved(center, i * std::numbers::pi / 12, size / 2, 0));
      return ring;
    }
    case 2: {  // crosses itself as it likes
      Ring ring;
      for (int corners = draw.whole(3, 9); corners > 0; --corners) {
        ring.push_back(moved(center, draw.angle(), draw.uniform(0.1, size), 0));
      }
      return ring;
    }
    default:
      return box(center, draw.uniform(0.2, size), draw.uniform(0.2, size), angle);
  }
}

CellMap cells(Draw& draw, const Workspace& w) {
  CellMap map;
  map.resolution = draw.uniform(0.05, 0.5);
  map.columns = std::min(400, static_cast<int>((w.max.x - w.min.x) / map.resolution));
  map.rows = std::min(400, static_cast<int>((w.max.y - w.min.y) / map.resolution));
  map.origin = w.min;
  map.occupied.assign(static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows), 0);
  for (int blots = draw.whole(3, 30); blots > 0; --blots) {
    const int column = draw.whole(0, map.columns - 1), row = draw.whole(0, map.rows - 1), reach = draw.whole(0, 12);
    for (int y = std::max(0, row - reach); y <= std::min(map.rows - 1, row + reach); ++y) {
      for (int x = std::max(0, column - reach); x <= std::min(map.columns - 1, column + reach); ++x) {
        const bool inside = (x - column) * (x - column) + (y - row) * (y - row) <= reach * reach;
        if (inside)
          map.occupied[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.columns) +
                       static_cast<std::size_t>(x)] = 1;
      }
    }
  }
  return map;
}

void scale(RobotSpec& robot, const char* name, double factor) {
  const auto found = robot.parameters.find(name);
  if (found != robot.parameters.end()) found->second *= factor;
}

// Larger or smaller, faster or slower; the bodies follow.
RobotSpec of_own_size(RobotSpec robot, Draw& draw) {
  const double size = draw.uniform(0.6, 1.6), speed = draw.uniform(0.5, 1.5);
  for (auto& [name, value] : robot.parameters) {
    if (unit_of(robot.model, name) == "metres") value *= size;
  }
  for (const char* rate :
       {"max_speed", "max_acceleration", "max_turn_rate", "max_turn_acceleration", "max_wheel_speed"})
    scale(robot, rate, speed);
  for (Ring& body : robot.bodies) {
    for (Point& p : body) p = {p.x * size, p.y * size};
  }
  return robot;
}

RobotSpec any_robot(Draw& draw) {
  static const std::vector<std::string> models = robot_models();
  std::string name = models[static_cast<std::size_t>(draw.whole(0, static_cast<int>(models.size()) - 1))];
  const int most = most_links(name);
  if (most > 0) name += ':' + std::to_string(draw.whole(0, draw.chance(0.5) ? 3 : most));
  const RobotSpec robot = parse_robot(name);
  return draw.chance(0.5) ? of_own_size(robot, draw) : robot;
}

GoalFacing any_facing(Draw& draw) {
  GoalFacing facing;
  facing.heading = draw.angle();
  facing.tolerance = draw.uniform(0.05, 0.5);
  facing.either_way = draw.chance(0.3);
  if (draw.chance(0.3)) facing.hitches = draw.uniform(0.2, 1);
  return facing;
}

}  // namespace

Workspace random_workspace(std::mt19937_64& random) {
  Draw draw(random);
  Workspace w;
  w.name = "random";
  const double width = draw.chance(0.2) ? draw.uniform(50, 200) : draw.uniform(12, 50);
  const double height = width * draw.uniform(0.5, 1);
  if (draw.chance(0.5)) w.min = {draw.uniform(-100, 100), draw.uniform(-100, 100)};
  if (draw.chance(0.15)) w.min = {draw.uniform(-5e5, 5e5), draw.uniform(-5e5, 5e5)};
  w.max = {w.min.x + width, w.min.y + height};
  if (draw.chance(0.25)) w.cells = cells(draw, w);
  const double largest = 0.2 * height;
  for (int i = draw.whole(0, 25); i > 0; --i) {
    w.obstacles.push_back({"obstacle", any_shape(draw, draw.within(w, 0), draw.uniform(0.3, largest)), {}});
  }
  return w;
}

SearchRequest random_request(const Workspace& workspace, std::mt19937_64& random) {
  Draw draw(random);
  SearchRequest request;
  request.robot = any_robot(draw);
  request.planner = draw.chance(0.8) ? "adaptive" : draw.chance(0.5) ? "prior" : "rrt";
  request.start = StartPose{draw.within(workspace, 1), draw.angle()};
  request.goal = GoalDisc{draw.within(workspace, 0.5), draw.uniform(0.2, 2)};
  request.seed = random();
  request.iterations = 5000;
  request.memory = 32U << 20U;
  if (draw.chance(0.3)) request.facing = any_facing(draw);
  if (draw.chance(0.5)) request.improve = draw.uniform(0.5, 5);
  return request;
}

}  // namespace krait::host::test
