// SPDX-License-Identifier: Apache-2.0
// Room in a goal against random poses of it: between four walls, with gaps where they would meet.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "../../core/scene_builder.hpp"
#include "host/run/goal_room.hpp"
#include "host/run/own_check.hpp"
#include "host/run/query.hpp"

namespace krait::test {
namespace {

constexpr Point kMiddle{5, 5};

// Walls of 1 m around a square of that side, whose corners are open.
Room pit(double side) {
  const double half = side / 2, open = 0.1 * side;
  Room room;
  room.bounds = {0, 0, 10, 10};
  room.boxes = {{5 - half + open, 5 + half, 5 + half - open, 6 + half},
                {5 - half + open, 4 - half, 5 + half - open, 5 - half},
                {4 - half, 5 - half + open, 5 - half, 5 + half - open},
                {5 + half, 5 - half + open, 6 + half, 5 + half - open}};
  room.goals = {{4.9, 4.9, 5.1, 5.1}};
  return room;
}

host::SearchRequest request_for(const char* model, double length, double radius) {
  host::SearchRequest request;
  request.robot = host::parse_robot(model);
  request.robot.parameters.at("body_length") = length;
  request.robot.parameters.at("body_width") = 0.3;
  request.robot.bodies = host::default_bodies(request.robot);
  request.goal = host::GoalDisc{{kMiddle.x, kMiddle.y}, radius};
  return request;
}

// Every hitch by at most as much as is asked for.
void bend(const host::SearchRequest& request, std::minstd_rand& draw, std::vector<float>& state) {
  if (!request.facing || !request.facing->hitches) return;
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto trailers = static_cast<std::size_t>(request.robot.links);
  for (std::size_t i = 0, at = state.size() - trailers; i < trailers; ++i, ++at)
    state[at] = (i == 0 ? state[2] : state[at - 1]) + static_cast<float>(*request.facing->hitches * unit(draw));
}

// How many of so many random poses that the request allows are free.
int free_poses(const Scene& scene, const host::SearchRequest& request, int count, std::minstd_rand& draw) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const host::CoreRobot core(request.robot);
  host::OwnCheck check(core.view(), scene, request.parameters);
  int free = 0;
  for (int i = 0; i < count; ++i) {
    const double out = request.goal->radius * std::sqrt(std::abs(unit(draw))), way = std::numbers::pi * unit(draw);
    double heading = request.facing ? request.facing->heading + request.facing->tolerance * unit(draw)
                                    : std::numbers::pi * unit(draw);
    if (request.facing && request.facing->either_way && unit(draw) > 0) heading += std::numbers::pi;
    const host::Point at{kMiddle.x + out * std::cos(way), kMiddle.y + out * std::sin(way)};
    std::vector<float> state = host::state_at(core.view(), scene, {"", at, heading, {}});
    bend(request, draw, state);
    free += static_cast<int>(check.free(state.data()));
  }
  return free;
}

// What was said of goals.
struct Rooms {
  int none = 0, found = 0;

  // Of 500 random poses none is free where there is no room, and hardly any where none was found.
  void expect_as_random_poses(const Scene& scene, const host::SearchRequest& request, int hardly,
                              std::minstd_rand& draw) {
    const host::GoalRoom room = host::room_in_goal(scene, request);
    EXPECT_FALSE(room.none && room.found);
    none += static_cast<int>(room.none);
    found += static_cast<int>(room.found);
    if (room.found) return;
    EXPECT_LE(free_poses(scene, request, 500, draw), room.none ? 0 : hardly);
  }
};

TEST(RoomInGoal, IsProvenToBeNoneOnlyWhereNoPoseIsFree) {
  std::minstd_rand draw(1);
  std::uniform_real_distribution<double> unit(0, 1);
  Rooms rooms;
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    const OpenScene open(pit(1 + unit(draw)));
    host::SearchRequest request = request_for(i % 2 == 0 ? "unicycle" : "car", 0.8 + 2 * unit(draw), 0.3 * unit(draw));
    if (i % 3 > 0) request.facing = host::GoalFacing{3 * unit(draw), 0.5 * unit(draw), i % 3 > 1, {}};
    rooms.expect_as_random_poses(open.scene, request, 10, draw);
  }
  EXPECT_GT(rooms.none, 30);
  EXPECT_GT(rooms.found, 20);
  EXPECT_GT(rooms.none + rooms.found, 92) << "hardly one ends undecided";
}

TEST(RoomInGoal, OfTrailersToo) {
  std::minstd_rand draw(2);
  std::uniform_real_distribution<double> unit(0, 1);
  Rooms rooms;
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    const OpenScene open(pit(1 + 1.5 * unit(draw)));
    const char* const models[] = {"truck:1", "kinematic_truck:2", "snake:2"};
    host::SearchRequest request = request_for(models[i % 3], 0.3 + 0.5 * unit(draw), 0.3 * unit(draw));
    request.facing = host::GoalFacing{3 * unit(draw), 0.3 * unit(draw), i % 2 > 0, 0.3 * unit(draw)};
    rooms.expect_as_random_poses(open.scene, request, 25, draw);
  }
  EXPECT_GT(rooms.none, 30);
  EXPECT_GT(rooms.found, 40);
}

// A car fits into a slot of 1.2 m, and the trailer behind it does not.
TEST(RoomInGoal, TrailersCountWhereTheirHitchesAreAskedToBeStraight) {
  const OpenScene open(pit(1.2));
  host::SearchRequest request = request_for("truck:1", 0.8, 0.05);
  request.facing = host::GoalFacing{0, 0.1, false, {}};
  EXPECT_TRUE(host::room_in_goal(open.scene, request).found);
  request.facing->hitches = 0.2;
  const host::GoalRoom room = host::room_in_goal(open.scene, request);
  EXPECT_TRUE(room.none);
  EXPECT_EQ(room.at_middle.body, 1U);
}

// A square of 1.5 m has room for a body of 1.7 m by 0.3 m along its diagonal.
TEST(RoomInGoal, IsLookedForInTheWholeTurn) {
  const OpenScene open(pit(1.5));
  host::SearchRequest request = request_for("unicycle", 1.7, 0.1);
  EXPECT_TRUE(host::room_in_goal(open.scene, request).found);
  request.facing = host::GoalFacing{0, 0.2, false, {}};
  EXPECT_TRUE(host::room_in_goal(open.scene, request).none);
  request.facing->tolerance = 0.79;
  EXPECT_TRUE(host::room_in_goal(open.scene, request).found);
  request = request_for("unicycle", 3, 0.1);
  EXPECT_TRUE(host::room_in_goal(open.scene, request).none);
}

// A car's body is ahead of where its pose places it.
TEST(RoomInGoal, IsLookedForInTheOppositeHeading) {
  const OpenScene open(pit(1.5));
  host::SearchRequest request = request_for("car", 1, 0.02);
  request.goal->center.x += 0.2;
  request.facing = host::GoalFacing{0, 0.1, false, {}};
  EXPECT_TRUE(host::room_in_goal(open.scene, request).none);
  request.facing->either_way = true;
  EXPECT_TRUE(host::room_in_goal(open.scene, request).found);
}

TEST(RoomInGoal, IsLookedForInTheGoalsOfTheMapAndTakesTheClearance) {
  const OpenScene open(pit(1.5));
  host::SearchRequest request = request_for("unicycle", 1.7, 0.1);
  request.goal.reset();
  EXPECT_TRUE(host::room_in_goal(open.scene, request).found);
  request.parameters.clearance = 0.1F;
  EXPECT_TRUE(host::room_in_goal(open.scene, request).none);
  EXPECT_TRUE(host::room_in_goal(open.scene, request, 0.14).found) << "a smaller body";
}

}  // namespace
}  // namespace krait::test
