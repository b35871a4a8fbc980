// SPDX-License-Identifier: Apache-2.0
// The shortest way against that around the corners of doors, found by hand.
#include "host/run/shortest_way.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
    for (const Goal& goal : {Goal::named(0), Goal::disc(to, 0.1F)}) {
      const double found = host::shortest_way(open.scene, goal, 0.5F, from, to);
      EXPECT_GE(found, length(way) - 1e-3) << diagonals;
      EXPECT_LE(found, 1.06 * length(way)) << diagonals;
    }
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

TEST(ShortestWay, LeavesOutDoorsThatAreTooNarrow) {
  const OpenScene open(room_with({{6, 0, 6.5, 3}, {6, 3.4, 6.5, 6.5}}));
  const Ring short_way = {{2, 3.2}, {10, 3.2}};
  const Ring long_way = {{2, 3.2}, {6, 6.5}, {6.5, 6.5}, {10, 3.2}};
  EXPECT_NEAR(host::shortest_way(open.scene, Goal::named(0), 0.2F, {2, 3.2F}, {10, 3.2F}), length(short_way), 0.5);
  EXPECT_NEAR(host::shortest_way(open.scene, Goal::named(0), 0.8F, {2, 3.2F}, {10, 3.2F}), length(long_way), 0.6);
}

TEST(ShortestWay, IsNoneThroughAWall) {
  const OpenScene open(room_with({{6, 0, 6.5, 8}}));
  EXPECT_TRUE(std::isnan(host::shortest_way(open.scene, Goal::named(0), 0.0F, {2, 1}, {10, 1})));
  EXPECT_TRUE(std::isnan(host::shortest_way(open.scene, Goal::named(0), 0.0F, {6.25F, 1}, {10, 1})));
}

}  // namespace
}  // namespace krait::test
