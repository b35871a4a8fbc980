// SPDX-License-Identifier: Apache-2.0
// Why there is no plan: the bottleneck of ten blocked rooms, what a start lies against, and where a search has tried.
#include <cmath>

#include "planner_fixture.hpp"
#include "search/adaptive_search.hpp"

namespace krait::test::planner_why_test {
namespace {

constexpr float kStart[] = {2, 6, 0};

// Walls of 0.25 m across a room of 12 by 8 m, each with one door.
struct Door {
  double x, y, width;  // of the wall's left side, and the door's middle
};
Room walled(const std::vector<Door>& doors) {
  Room room;
  room.bounds = {0, 0, 12, 8};
  room.goals = {{9.5, 5.5, 11.5, 7.5}};
  for (const Door& door : doors) {
    if (door.y - door.width / 2 > 0) room.boxes.push_back({door.x, 0, door.x + 0.25, door.y - door.width / 2});
    if (door.y + door.width / 2 < 8) room.boxes.push_back({door.x, door.y + door.width / 2, door.x + 0.25, 8});
  }
  return room;
}

struct Blocked {
  std::vector<Door> doors;
  std::size_t narrowest;
};

const std::vector<Blocked> kBlocked = {{{{6, 4, 0.3}}, 0},
                                       {{{6, 4, 0.38}}, 0},
                                       {{{6, 1, 0.2}}, 0},
                                       {{{6, 7, 0.1}}, 0},
                                       {{{4, 2, 1}, {7, 5, 0.3}}, 1},
                                       {{{4, 2, 0.3}, {7, 5, 1}}, 0},
                                       {{{4, 2, 0.35}, {7, 5, 0.25}}, 1},
                                       {{{4, 2, 0.25}, {7, 5, 0.35}}, 0},
                                       {{{3, 6, 2}, {5, 2, 0.2}, {8, 6, 0.3}}, 1},
                                       {{{3, 6, 0.3}, {5, 2, 2}, {8, 6, 0.1}}, 2}};

TEST(PlannerWhy, NamesTheNarrowestPlaceOfTheWidestWay) {
  for (std::size_t i = 0; i < kBlocked.size(); ++i) {
    const Door& door = kBlocked[i].doors[kBlocked[i].narrowest];
    Bench<Unicycle> bench(walled(kBlocked[i].doors), small_unicycle());
    ASSERT_TRUE(bench.init().ok());
    ASSERT_EQ(bench.planner.start({kStart}), Status::no_route) << i;
    const Bottleneck bottleneck = bench.planner.bottleneck();
    EXPECT_NEAR(static_cast<double>(bottleneck.width), door.width, 0.02) << i;
    EXPECT_FLOAT_EQ(bottleneck.needed, 2 * (0.2F + bench.parameters.clearance)) << i;
    EXPECT_NEAR(static_cast<double>(bottleneck.at.x), door.x + 0.125, 0.13) << i;
    EXPECT_NEAR(static_cast<double>(bottleneck.at.y), door.y, door.width / 2) << i;
    EXPECT_FALSE(bottleneck.at_goal) << i;
  }
}

TEST(PlannerWhy, OfTwoDoorsTheWiderOneIsTheBottleneck) {
  Room room = walled({{6, 2, 0.2}});
  room.boxes = {{6, 0, 6.25, 1.9}, {6, 2.1, 6.25, 5.85}, {6, 6.15, 6.25, 8}};
  Bench<Unicycle> bench(room, small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.planner.start({kStart}), Status::no_route);
  EXPECT_NEAR(static_cast<double>(bench.planner.bottleneck().width), 0.3, 0.02);
  EXPECT_NEAR(static_cast<double>(bench.planner.bottleneck().at.y), 6, 0.15);
}

TEST(PlannerWhy, OfAWallWithoutADoorTheWidthIsZero) {
  Bench<Unicycle> bench(two_rooms(0), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.planner.start({kStart}), Status::no_route);
  EXPECT_EQ(bench.planner.bottleneck().width, 0.0F);
  EXPECT_GT(bench.planner.bottleneck().needed, 0.4F);
}

TEST(PlannerWhy, AGoalWhereTheRobotCannotStandIsRefusedAtOnce) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  const struct {
    Vec2 center;
    float radius, room;                           // the most clearance where a plan may end, a tenth of the size inside
  } cramped[] = {{{0.1F, 0.1F}, 0.05F, 0.129F},   // in a corner
                 {{11.95F, 3}, 0.1F, 0.132F},     // at the bounds
                 {{6.3F, 1}, 0.1F, 0.132F},       // behind the wall
                 {{5.9F, 7.5F}, 0.05F, 0.141F}};  // before it
  for (const auto& goal : cramped) {
    ASSERT_EQ(bench.planner.start({kStart, Goal::disc(goal.center, goal.radius)}), Status::no_route);
    const Bottleneck bottleneck = bench.planner.bottleneck();
    EXPECT_TRUE(bottleneck.at_goal);
    EXPECT_NEAR(static_cast<double>(bottleneck.width), 2 * static_cast<double>(goal.room), 0.02);
    EXPECT_LE(length(bottleneck.at - goal.center), goal.radius + 0.02F);
  }
  EXPECT_EQ(bench.planner.start({kStart, Goal::disc({0.25F, 0.25F}, 0.05F)}), Status::searching);
}

// A plan ends 3 cm inside, where this goal's room is less than at its border.
TEST(PlannerWhy, AGoalWithRoomOnlyAtItsBorderIsRefusedAtOnce) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  const Goal goal = Goal::disc({0, 4}, 0.22F);
  ASSERT_EQ(bench.planner.start({kStart, goal}), Status::no_route);
  EXPECT_TRUE(bench.planner.bottleneck().at_goal);
  EXPECT_NEAR(static_cast<double>(bench.planner.bottleneck().width), 2 * 0.19, 0.02);
  bench.parameters.goal_margin = 0.0F;
  ASSERT_TRUE(bench.init().ok());
  EXPECT_EQ(bench.solve({kStart, goal}), Status::solved);
}

TEST(PlannerWhy, TheBottleneckLeavesTheCostsAsTheyWere) {
  Bench<Unicycle> bench(walled({{4, 2, 1}, {7, 5, 0.3}}), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.planner.start({kStart}), Status::no_route);
  const auto costs = [&] {
    std::vector<float> all;
    for (Index t = 0; t < bench.open.scene.triangle_count(); ++t)
      all.push_back(detail::opened(bench.planner).regions().cost(t));
    return all;
  };
  const std::vector<float> before = costs();
  bench.planner.bottleneck();
  EXPECT_EQ(costs(), before);
}

// The goal is hard to hit, so that the last expansions are past the narrow door.
TEST(PlannerWhy, OfASearchInVainItIsOnTheWayFromTheStart) {
  int in_vain = 0;
  for (std::uint64_t iterations = 50; iterations <= 500; iterations += 50) {
    Bench<Unicycle> bench(walled({{3, 6, 0.5}, {6, 2, 0.8}}), small_unicycle());
    bench.limits.iterations = iterations;
    ASSERT_TRUE(bench.init().ok());
    if (bench.solve({kStart, Goal::disc({10.5F, 6.5F}, 1e-6F)}) != Status::budget_used) continue;
    ++in_vain;
    const Bottleneck bottleneck = bench.planner.bottleneck();
    EXPECT_NEAR(static_cast<double>(bottleneck.width), 0.5, 0.02) << iterations;
    EXPECT_NEAR(static_cast<double>(bottleneck.at.x), 3.125, 0.13) << iterations;
  }
  EXPECT_GT(in_vain, 3);
}

TEST(PlannerWhy, ThereIsNoneWhereTheSearchEndsOtherwise) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  EXPECT_EQ(bench.planner.bottleneck().needed, 0.0F);
  EXPECT_EQ(bench.planner.contact().kind, ContactKind::none);
  ASSERT_TRUE(bench.init().ok());
  EXPECT_EQ(bench.planner.contact().kind, ContactKind::none);
  ASSERT_EQ(bench.solve({kStart}), Status::solved);
  EXPECT_EQ(bench.planner.bottleneck().needed, 0.0F);
  EXPECT_EQ(bench.planner.contact().kind, ContactKind::none);
}

// Its position may be nearer to a wall behind it than the middle of its body to one at its side.
TEST(PlannerWhy, AGoalWhereACarsAxleHasNoRoomIsRefusedAtOnce) {
  Bench<Car> bench(two_rooms(), Car(Car::defaults()));
  ASSERT_TRUE(bench.init().ok());
  float start[Car::kMaxState];
  bench.robot.rest({2, 6}, 0.0F, nullptr, start);
  ASSERT_EQ(bench.planner.start({start, Goal::disc({11.9F, 0.1F}, 0.05F)}), Status::no_route);
  EXPECT_TRUE(bench.planner.bottleneck().at_goal);
  EXPECT_FLOAT_EQ(bench.planner.bottleneck().needed, 2 * (0.2F + bench.parameters.clearance));
}

Contact contact_at(float x, float y, float clearance = 0.001F) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  bench.parameters.clearance = clearance;
  EXPECT_TRUE(bench.init().ok());
  const float start[] = {x, y, 0};
  EXPECT_EQ(bench.planner.start({start}), Status::start_in_collision);
  const std::uint64_t checks = bench.planner.statistics().collision_checks;
  const Contact contact = bench.planner.contact();
  EXPECT_EQ(bench.planner.statistics().collision_checks, checks);
  return contact;
}

TEST(PlannerWhy, AStartThatOverlapsAnObstacle) {
  const Contact contact = contact_at(5.9F, 1);  // the body's front at 6.15, the wall from 6
  EXPECT_EQ(contact.kind, ContactKind::obstacle);
  EXPECT_EQ(contact.body, 0U);
  EXPECT_EQ(contact.other, 0U);
  EXPECT_EQ(contact.distance, 0.0F);
  EXPECT_GT(contact.needed, 0.001F);
  EXPECT_NEAR(static_cast<double>(contact.at.x), 6.075, 0.08);
  EXPECT_NEAR(static_cast<double>(contact.at.y), 1, 0.21);
}

TEST(PlannerWhy, AStartThatDoesNotKeepTheClearance) {
  const Contact contact = contact_at(5.7F, 7, 0.1F);  // 5 cm before the other wall
  EXPECT_EQ(contact.kind, ContactKind::obstacle);
  EXPECT_EQ(contact.other, 1U);
  EXPECT_NEAR(static_cast<double>(contact.distance), 0.05, 1e-4);
  EXPECT_NEAR(static_cast<double>(contact.needed), 0.1, 2e-3);
  EXPECT_GT(contact.needed, 0.1F);
  EXPECT_NEAR(static_cast<double>(contact.at.x), 5.975, 1e-3);
}

TEST(PlannerWhy, AStartAcrossTheBounds) {
  const Contact beyond = contact_at(0.1F, 4);
  EXPECT_EQ(beyond.kind, ContactKind::bounds);
  EXPECT_EQ(beyond.distance, 0.0F);
  EXPECT_NEAR(static_cast<double>(beyond.at.x), -0.15, 1e-4);
  const Contact near = contact_at(4, 7.7F, 0.2F);
  EXPECT_EQ(near.kind, ContactKind::bounds);
  EXPECT_NEAR(static_cast<double>(near.distance), 0.1, 1e-4);
}

TEST(PlannerWhy, AChainThatStartsFoldedOntoItself) {
  ChainParameters p;
  p.trailers = 5;
  Room room = two_rooms();
  room.goals[0] = {10, 5, 11, 6};
  Bench<Snake> bench(room, Snake(p));
  ASSERT_TRUE(bench.init().ok());
  const float angles[] = {-1.3F, -2.6F, -3.9F, -5.2F, -6.5F};
  float start[Snake::kMaxState];
  bench.robot.rest({3, 4}, 0.0F, angles, start);
  ASSERT_EQ(bench.planner.start({start}), Status::start_in_collision);
  const Contact contact = bench.planner.contact();
  EXPECT_EQ(contact.kind, ContactKind::body);
  EXPECT_GE(contact.other, contact.body + 2);
  EXPECT_EQ(contact.distance, 0.0F);
  Pose poses[Snake::kMaxBodies];
  bench.robot.place({start, bench.robot.state_size()}, poses);
  EXPECT_LT(length(contact.at - poses[contact.body].position), 0.5F);
  EXPECT_LT(length(contact.at - poses[contact.other].position), 0.5F);
}

// Whatever stands in the block, which is not zero here.
TEST(PlannerWhy, WithoutASearchThereIsNoEffortAndNoCost) {
  Bench<Unicycle> bench(walled({}), small_unicycle());
  const auto expect_none = [&](const char* when) {
    EXPECT_EQ(bench.planner.effort().tries, 0U) << when;
    EXPECT_EQ(bench.planner.cost_to_go(), kInfinity) << when;
  };
  expect_none("before init");
  ASSERT_EQ(bench.init(1000).status, Status::arena_too_small);
  expect_none("after an init that failed");
  ASSERT_TRUE(bench.init().ok());
  expect_none("before a start");
  ASSERT_EQ(bench.planner.start({kStart}), Status::searching);
  ASSERT_EQ(bench.planner.advance(3), Status::searching);
  EXPECT_GT(bench.planner.effort().tries, 0U);
  EXPECT_LT(bench.planner.cost_to_go(), kInfinity);
  ASSERT_TRUE(bench.init().ok());
  expect_none("after another init");
  EXPECT_EQ(bench.planner.init({}).status, Status::bad_argument);
  expect_none("after an init without a scene");
}

TEST(PlannerWhy, TheEffortIsWhereMostExpansionsGrewFrom) {
  Bench<Unicycle> bench(two_rooms(0.41), small_unicycle());  // a door that is hard to meet
  bench.limits.iterations = 300;
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.solve({kStart}), Status::budget_used);
  EXPECT_NEAR(static_cast<double>(bench.planner.bottleneck().width), 0.41, 0.02);
  EXPECT_GE(bench.planner.bottleneck().width, bench.planner.bottleneck().needed);
  const Effort effort = bench.planner.effort();
  EXPECT_GT(effort.tries, 0U);
  std::uint32_t most = 0;
  Index where = kNone;
  for (Index t = 0; t < bench.open.scene.triangle_count(); ++t) {
    if (detail::opened(bench.planner).groups().selections(t) <= most) continue;
    most = detail::opened(bench.planner).groups().selections(t);
    where = t;
  }
  EXPECT_EQ(effort.tries, most);
  EXPECT_EQ(length(effort.at - bench.open.scene.centroid(where)), 0.0F);
}

}  // namespace
}  // namespace krait::test::planner_why_test
