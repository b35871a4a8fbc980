// SPDX-License-Identifier: Apache-2.0
#include "synthetic.hpp"

#include <cmath>
#include <limits>
#include <queue>
#include <random>
#include <utility>

namespace krait::host::test {

namespace {

constexpr int kCells = 25;
constexpr double kCell = 2;  // metres
constexpr int kLinks = 15;
constexpr double kHitch = 0.8;
constexpr double kWheelbase = 0.8;

struct Box {
  double left, bottom, right, top;
  bool holds(double x, double y) const { return x > left && x < right && y > bottom && y < top; }
};

const std::vector<Box> kWalls = {{0, 16, 10, 18}, {12, 16, 36, 18}, {14, 32, 50, 34}, {44, 0, 46, 6},
                                 {44, 6, 50, 8},  {20, 22, 24, 24}, {30, 38, 32, 40}};

bool in_wall(double x, double y) {
  for (const Box& wall : kWalls) {
    if (wall.holds(x, y)) return true;
  }
  return false;
}

Ring corners(const Box& box) {
  return {{box.left, box.bottom}, {box.right, box.bottom}, {box.right, box.top}, {box.left, box.top}};
}

bool free_cell(int column, int row) {
  const bool inside = column >= 0 && row >= 0 && column < kCells && row < kCells;
  return inside && !in_wall((column + 0.5) * kCell, (row + 0.5) * kCell);
}

// Shortest distances to the goal's cell over cells; crossing the narrow gap costs `penalty` more.
std::vector<double> cell_costs(double penalty) {
  const auto at = [](int column, int row) { return static_cast<std::size_t>(row * kCells + column); };
  std::vector<double> costs(kCells * kCells, std::numeric_limits<double>::infinity());
  std::priority_queue<std::pair<double, std::pair<int, int>>> open;  // by the negative cost
  costs[at(20, 20)] = 0;
  open.push({0, {20, 20}});
  while (!open.empty()) {
    const auto [negative, cell] = open.top();
    const auto [column, row] = cell;
    open.pop();
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        if (!free_cell(column + dx, row + dy) || !free_cell(column + dx, row) || !free_cell(column, row + dy)) continue;
        const bool narrow = column + dx == 5 && row + dy == 8;
        const double cost = -negative + kCell * std::hypot(dx, dy) + (narrow ? penalty : 0);
        if (cost >= costs[at(column + dx, row + dy)]) continue;
        costs[at(column + dx, row + dy)] = cost;
        open.push({-cost, {column + dx, row + dy}});
      }
    }
  }
  return costs;
}

void add_triangles(Picture& picture) {
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      if (!free_cell(column, row)) continue;
      const Point a{column * kCell, row * kCell}, b{a.x + kCell, a.y}, c{a.x + kCell, a.y + kCell}, d{a.x, a.y + kCell};
      picture.triangles.push_back({{a, b, c}});
      picture.triangles.push_back({{a, c, d}});
    }
  }
  for (unsigned step = 0; step <= 30; ++step) {
    CostFrame frame{step * 200, {}};
    const std::vector<double> costs = cell_costs(2.0 * step);
    for (const Triangle& triangle : picture.triangles) {
      const int column = static_cast<int>(triangle.corners[0].x / kCell);
      const int row = static_cast<int>(triangle.corners[0].y / kCell);
      frame.costs.push_back(static_cast<float>(costs[static_cast<std::size_t>(row * kCells + column)]));
    }
    picture.frames.push_back(frame);
  }
}

void add_tree(Picture& picture) {
  std::mt19937 random(7);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<double> headings = {0};
  picture.tree.push_back({20, 8, 0, 0});
  for (std::uint32_t iteration = 1; picture.tree.size() < 6000; ++iteration) {
    auto parent = static_cast<std::uint32_t>(std::cbrt(uniform()) * static_cast<double>(picture.tree.size()));
    double heading = headings[parent];
    for (int step = 0; step < 12; ++step) {
      heading += 0.7 * (uniform() - 0.5);
      const double x = static_cast<double>(picture.tree[parent].x) + 0.35 * std::cos(heading);
      const double y = static_cast<double>(picture.tree[parent].y) + 0.35 * std::sin(heading);
      if (in_wall(x, y) || x < 0 || y < 0 || x > 50 || y > 50) break;
      picture.tree.push_back({static_cast<float>(x), static_cast<float>(y), parent, iteration * 6});
      headings.push_back(heading);
      parent = static_cast<std::uint32_t>(picture.tree.size() - 1);
    }
  }
}

void drive(PlanFile& plan) {
  const std::vector<Point> way = {{34, 8},   {42, 13}, {43, 22}, {36, 27.5}, {14, 26},
                                  {6.5, 31}, {7, 38},  {14, 42}, {40.5, 41}};
  std::vector<double> state(5 + kLinks, 0.0);  // x y theta0 v psi theta1 ...
  state[0] = 20;
  state[1] = 8;
  std::size_t target = 0;
  plan.dt = 0.1;
  while (target < way.size() && plan.states.size() < 2000) {
    plan.states.emplace_back(state.begin(), state.end());
    const double dx = way[target].x - state[0];
    const double dy = way[target].y - state[1];
    if (std::hypot(dx, dy) < (target + 1 == way.size() ? 0.5 : 3.5)) ++target;
    const double error = std::remainder(std::atan2(dy, dx) - state[2], 2 * std::acos(-1.0));
    const double wanted = std::min(0.55, std::max(-0.55, 0.8 * error));
    for (int sub = 0; sub < 20; ++sub) {
      const double h = plan.dt / 20;
      state[3] = std::min(2.0, state[3] + h);
      state[4] += std::min(2 * h, std::max(-2 * h, wanted - state[4]));
      state[0] += h * state[3] * std::cos(state[2]) * std::cos(state[4]);
      state[1] += h * state[3] * std::sin(state[2]) * std::cos(state[4]);
      const double head = state[2];
      state[2] += h * state[3] * std::sin(state[4]) / kWheelbase;
      double speed = state[3];
      double ahead = head;
      for (std::size_t i = 5; i < state.size(); ++i) {
        const double before = state[i];
        state[i] += h * speed / kHitch * std::sin(ahead - before);
        speed *= std::cos(ahead - before);
        ahead = before;
      }
    }
  }
  plan.controls.assign(plan.states.size() - 1, {0.0F, 0.0F});
}

}  // namespace

Picture bare_picture(double width, double height) {
  Picture picture;
  picture.title = "bare";
  picture.max = {width, height};
  return picture;
}

Picture synthetic_picture() {
  Picture picture = bare_picture(50, 50);
  picture.title = "synthetic S";
  for (const Box& wall : kWalls) picture.obstacle_pieces.push_back(corners(wall));
  add_triangles(picture);
  add_tree(picture);
  PlanFile& plan = picture.plan;
  plan.status = "solved";
  plan.planner = "adaptive";
  plan.robot.model = "snake";
  plan.robot.links = kLinks;
  plan.robot.parameters = {{"hitch_length", kHitch}, {"wheelbase", kWheelbase}};
  plan.robot.bodies.assign(kLinks + 1, {{-0.35, -0.25}, {0.35, -0.25}, {0.35, 0.25}, {-0.35, 0.25}});
  plan.state_names = {"x", "y", "theta0", "v", "psi"};
  for (int i = 1; i <= kLinks; ++i) plan.state_names.push_back("theta" + std::to_string(i));
  plan.goal_name = "dock";
  plan.goal_polygon = corners({39, 39, 44, 43});
  drive(plan);
  return picture;
}

Picture driven_by(const std::string& model) {
  Picture picture = synthetic_picture();
  PlanFile& plan = picture.plan;
  const std::size_t size = model == "unicycle" ? 3 : 5;
  plan.robot.model = model;
  plan.robot.links = 0;
  plan.robot.bodies = {{{-0.4, -0.5}, {1.2, -0.5}, {1.2, 0.5}, {-0.4, 0.5}}};
  for (std::vector<float>& state : plan.states) state.resize(size);
  plan.state_names.resize(size);
  if (model == "diff_drive") {
    plan.state_names[3] = "left";
    plan.state_names[4] = "right";
  }
  return picture;
}

Picture scaled(Picture picture, double factor) {
  const auto scale = [&](Ring& ring) {
    for (Point& point : ring) point = {point.x * factor, point.y * factor};
  };
  const auto scale_float = [&](float& value) { value = static_cast<float>(static_cast<double>(value) * factor); };
  picture.max = {picture.max.x * factor, picture.max.y * factor};
  for (Ring& ring : picture.obstacle_pieces) scale(ring);
  for (Triangle& triangle : picture.triangles) {
    for (Point& corner : triangle.corners) corner = {corner.x * factor, corner.y * factor};
  }
  for (CostFrame& frame : picture.frames) {
    for (float& cost : frame.costs) scale_float(cost);
  }
  for (TreeVertex& vertex : picture.tree) {
    scale_float(vertex.x);
    scale_float(vertex.y);
  }
  scale(picture.plan.goal_polygon);
  for (Ring& body : picture.plan.robot.bodies) scale(body);
  for (auto& state : picture.plan.states) {
    scale_float(state[0]);
    scale_float(state[1]);
  }
  for (auto& [name, value] : picture.plan.robot.parameters) value *= factor;
  return picture;
}

}  // namespace krait::host::test
