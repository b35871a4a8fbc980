// SPDX-License-Identifier: Apache-2.0
// The shortest way against that around the corners of doors, found by hand.
#include "host/run/shortest_way.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "../../core/scene_builder.hpp"

namespace krait::test {
namespace {

double length(const Ring& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += std::hypot(way[i].x - way[i - 1].x, way[i].y - way[i - 1].y);
  return length;
}

Room room_with(std::vector<Rect> walls) {
  Room room;
  room.bounds = {0, 0, 12, 8};
  room.boxes = std::move(walls);
  room.goals = {{9, 0.5, 11.5, 7.5}};
  return room;
}

void expect_way(const std::vector<Rect>& walls, const Ring& way) {
  for (unsigned diagonals = 1; diagonals <= 5; ++diagonals) {
    Room room = room_with(walls);
    room.diagonals = diagonals;
    const OpenScene open(room);
    const Vec2 from{static_cast<float>(way.front().x), static_cast<float>(way.front().y)};
    const Vec2 to{static_cast<float>(way.back().x), static_cast<float>(way.back().y)};
    EXPECT_NEAR(host::shortest_way(open.scene, 0.5F, from, to), length(way), 1e-3) << diagonals;
    EXPECT_NEAR(host::shortest_way(open.scene, 0.5F, to, from), length(way), 1e-3) << diagonals;
  }
}

TEST(ShortestWay, IsStraightInTheOpen) { expect_way({}, {{1, 4}, {10, 4.5}}); }

TEST(ShortestWay, BendsAroundTheCornersOfADoor) {
  expect_way({{6, 0, 6.5, 5}}, {{2, 1}, {6, 5}, {6.5, 5}, {10, 1}});
  expect_way({{6, 3, 6.5, 8}}, {{2, 7}, {6, 3}, {6.5, 3}, {10, 7}});
}

TEST(ShortestWay, BendsBothWaysBetweenTwoWalls) {
  expect_way({{4, 0, 4.5, 6}, {7, 2, 7.5, 8}}, {{1, 1}, {4, 6}, {4.5, 6}, {7, 2}, {7.5, 2}, {10, 7}});
}

// Whether the line passes through the inside of the box.
bool crosses(const Point& a, const Point& b, const Rect& box) {
  constexpr double kInside = 1e-9;
  double begin = 0;
  double end = 1;
  const auto cut = [&](double from, double along, double low, double high) {
    if (along == 0) {
      if (from <= low || from >= high) end = -1;
      return;
    }
    const double first = (low - from) / along;
    const double second = (high - from) / along;
    begin = std::max(begin, std::min(first, second));
    end = std::min(end, std::max(first, second));
  };
  cut(a.x, b.x - a.x, box.x0, box.x1);
  cut(a.y, b.y - a.y, box.y0, box.y1);
  return end - begin > kInside;
}

// By Dijkstra over the corners of the boxes, as far as they see each other.
double around_boxes(const std::vector<Rect>& boxes, const Point& from, const Point& to) {
  std::vector<Point> places = {from, to};
  for (const Rect& box : boxes) {
    for (const Point& corner : {Point{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}}) {
      places.push_back(corner);
    }
  }
  std::vector<double> least(places.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> done(places.size());
  least[0] = 0;
  for (;;) {
    std::size_t at = places.size();
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!done[i] && (at == places.size() || least[i] < least[at])) at = i;
    }
    if (at == 1) return least[1];
    done[at] = true;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto hides = [&](const Rect& box) { return crosses(places[at], places[i], box); };
      if (std::any_of(boxes.begin(), boxes.end(), hides)) continue;
      least[i] = std::min(least[i], least[at] + std::hypot(places[i].x - places[at].x, places[i].y - places[at].y));
    }
  }
}

TEST(ShortestWay, IsThatAroundTheCornersOfBoxes) {
  std::mt19937 random(7);
  const auto number = [&](double low, double high) {
    return std::round(64 * std::uniform_real_distribution<double>(low, high)(random)) / 64;
  };
  for (int room = 0; room < 40; ++room) {
    std::vector<Rect> boxes;
    for (double x = 1; x < 8; x += 2) {  // a column each, so that none overlap
      const double y = number(0.25, 4);
      boxes.push_back({number(x, x + 0.75), y, number(x + 1, x + 1.75), number(y + 0.5, 7.75)});
    }
    const OpenScene open(room_with(boxes));
    for (int query = 0; query < 10; ++query) {
      const Point from{number(0.1, 0.9), number(0.1, 7.9)};
      const Point to{number(8.8, 11.9), number(0.1, 7.9)};
      const auto found = host::shortest_way(open.scene, 0.0F, {static_cast<float>(from.x), static_cast<float>(from.y)},
                                            {static_cast<float>(to.x), static_cast<float>(to.y)});
      EXPECT_NEAR(found, around_boxes(boxes, from, to), 1e-6) << "room " << room << ", query " << query;
    }
  }
}

// On a vertex of the regions, or an edge, ways may begin and end, too.
TEST(ShortestWay, BeginsAndEndsAnywhere) {
  const OpenScene open(room_with({{6, 2, 6.5, 5}}));
  std::vector<Vec2> places;
  for (Index triangle = 0; triangle < open.scene.triangle_count(); triangle += 5) {
    for (int i = 0; i < 3; ++i) {
      const Vec2 corner = open.scene.corner(triangle, i);
      places.push_back(corner);
      places.push_back(0.5F * (corner + open.scene.corner(triangle, (i + 1) % 3)));
    }
  }
  for (const Vec2 from : places) {
    for (const Vec2 to : places) {
      const Point a{static_cast<double>(from.x), static_cast<double>(from.y)};
      const Point b{static_cast<double>(to.x), static_cast<double>(to.y)};
      EXPECT_NEAR(host::shortest_way(open.scene, 0.0F, from, to), around_boxes({{6, 2, 6.5, 5}}, a, b), 1e-4);
    }
  }
}

TEST(ShortestWay, LeavesOutDoorsThatAreTooNarrow) {
  const OpenScene open(room_with({{6, 0, 6.5, 3}, {6, 3.4, 6.5, 6.5}}));
  const Ring short_way = {{2, 3.2}, {10, 3.2}};
  const Ring long_way = {{2, 3.2}, {6, 6.5}, {6.5, 6.5}, {10, 3.2}};
  EXPECT_NEAR(host::shortest_way(open.scene, 0.2F, {2, 3.2F}, {10, 3.2F}), length(short_way), 1e-3);
  EXPECT_NEAR(host::shortest_way(open.scene, 0.8F, {2, 3.2F}, {10, 3.2F}), length(long_way), 1e-3);
}

TEST(ShortestWay, IsNoneThroughAWall) {
  const OpenScene open(room_with({{6, 0, 6.5, 8}}));
  EXPECT_TRUE(std::isnan(host::shortest_way(open.scene, 0.0F, {2, 1}, {10, 1})));
  EXPECT_TRUE(std::isnan(host::shortest_way(open.scene, 0.0F, {6.25F, 1}, {10, 1})));
}

}  // namespace
}  // namespace krait::test
