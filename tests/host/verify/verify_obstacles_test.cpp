// SPDX-License-Identifier: Apache-2.0
// Nearest obstacles against brute force over all sides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "host/verify/obstacles.hpp"
#include "host/verify/pieces.hpp"
#include "plans.hpp"

namespace krait::host::testing {
namespace {

double point_to_side(const Point& p, const Point& a, const Point& b) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const double along = ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length;
  const double t = std::clamp(along, 0.0, length) / length;
  return std::hypot(p.x - a.x - t * (b.x - a.x), p.y - a.y - t * (b.y - a.y));
}

double cross(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double side_to_side(const Point& a, const Point& b, const Point& c, const Point& d) {
  const bool crossing = cross(a, b, c) * cross(a, b, d) < 0 && cross(c, d, a) * cross(c, d, b) < 0;
  if (crossing) return 0;
  return std::min({point_to_side(a, c, d), point_to_side(b, c, d), point_to_side(c, a, b), point_to_side(d, a, b)});
}

double ring_to_ring(const Ring& a, const Ring& b) {
  if (inside(a, b[0]) || inside(b, a[0])) return 0;
  double nearest = 1e9;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      nearest = std::min(nearest, side_to_side(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()]));
    }
  }
  return nearest;
}

class RandomShapes : public ::testing::Test {
 protected:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }

  Ring box(double size) {
    const double angle = uniform(0, 3);
    const Point middle{uniform(1, 19), uniform(1, 19)};
    Ring ring;
    for (const Point& p : rectangle(-size, -size / 3, size, size / 2)) {
      ring.push_back({middle.x + std::cos(angle) * p.x - std::sin(angle) * p.y,
                      middle.y + std::sin(angle) * p.x + std::cos(angle) * p.y});
    }
    return ring;
  }

  std::mt19937 generator_{5};
};

TEST_F(RandomShapes, TheNearestDrawnObstacleIsTheNearestOfAll) {
  Workspace workspace;
  workspace.max = {20, 20};
  for (int i = 0; i < 30; ++i) workspace.obstacles.push_back({"obstacle", box(uniform(0.01, 0.6)), {}});
  const Obstacles obstacles(workspace);
  int overlaps = 0;
  for (int round = 0; round < 2000; ++round) {
    const Ring body = box(0.4);
    double nearest = 1;
    for (const Obstacle& obstacle : workspace.obstacles) {
      nearest = std::min(nearest, ring_to_ring(obstacle.outer, body));
    }
    const Contact contact = obstacles.nearest(hull_of(body), 1);
    EXPECT_NEAR(contact.distance, nearest, 1e-9);
    EXPECT_EQ(contact.distance == 0, nearest == 0);
    overlaps += nearest == 0 ? 1 : 0;
  }
  EXPECT_GT(overlaps, 100);
}

TEST_F(RandomShapes, TheNearestCellOfAYawedMapIsTheNearestOfAll) {
  Workspace workspace;
  workspace.min = {3, -2};
  workspace.max = {23, 18};
  CellMap map;
  map.columns = 40;
  map.rows = 30;
  map.resolution = 0.7;
  map.origin = {5, -4};
  map.yaw = 0.4;
  std::vector<Ring> squares;
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      map.occupied.push_back(uniform(0, 1) < 0.1 ? 1 : 0);
      if (!map.at(column, row)) continue;
      Ring square;
      for (const Point& p : rectangle(column, row, column + 1, row + 1)) {
        const Point m{p.x * 0.7, p.y * 0.7};
        square.push_back({5 + std::cos(0.4) * m.x - std::sin(0.4) * m.y - workspace.min.x,
                          -4 + std::sin(0.4) * m.x + std::cos(0.4) * m.y - workspace.min.y});
      }
      squares.push_back(square);
    }
  }
  workspace.cells = map;
  const Obstacles obstacles(workspace);
  for (int round = 0; round < 2000; ++round) {
    const Ring body = box(0.4);
    double nearest = 1;
    for (const Ring& square : squares) nearest = std::min(nearest, ring_to_ring(square, body));
    EXPECT_NEAR(obstacles.nearest(hull_of(body), 1).distance, nearest, 1e-9);
  }
}

TEST(Overlap, ItsDepthIsTheWayOut) {
  Workspace workspace;
  workspace.max = {20, 20};
  workspace.obstacles.push_back({"wall", rectangle(5, 5, 6, 15), {}});
  const Obstacles obstacles(workspace);
  const Contact contact = obstacles.nearest(hull_of(rectangle(5.9, 9, 7, 11)), 1);
  EXPECT_EQ(contact.obstacle, "wall");
  EXPECT_NEAR(contact.overlap, 0.1, 1e-12);
}

}  // namespace
}  // namespace krait::host::testing
