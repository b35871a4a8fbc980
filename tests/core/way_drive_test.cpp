// SPDX-License-Identifier: Apache-2.0
// A robot that is driven along a route: where its legs begin, where it begins to shoot, and how a way ends.
#include "improve/way_drive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <optional>

#include "planner_fixture.hpp"
#include "robot/shape.hpp"

namespace krait::test::way_drive_test {
namespace {

using Outcome = detail::WayDrive::Outcome;
constexpr float kDt = 0.1F;
constexpr float kMargin = 0.01F;  // metres
constexpr float kReach = 3.0F;
constexpr std::uint32_t kHold = 4;
constexpr std::uint32_t kManySteps = 100'000;

// A hall, with a wall between its halves or none.
Room hall(bool walled) {
  Room room;
  room.bounds = {0, 0, 16, 6};
  if (walled) room.boxes = {{8, 0, 8.25, 6}};
  return room;
}

// A unicycle at (2, 3) that is to come to (14, 3), both times with the heading 0.
struct Driver {
  explicit Driver(bool walled = false) : Driver(hall(walled)) {}
  explicit Driver(const Room& room, float facing = 0.0F)
      : goal(Goal::pose({14, 3}, 0.1F, {facing, 0.1F, false, kInfinity})),
        open(room),
        robot(small_unicycle()),
        start(standing(robot, {2, 3})),
        block(1U << 14),
        arena(block.data(), block.size() * sizeof(std::uint64_t)) {
    check.allocate(arena, robot);
    check.assign(robot, open.scene, kMargin, static_cast<int>(parameters.tuning.max_substeps), true);
    driven.assign(robot, kDt);
    braked.assign(robot, kDt);
    ending.assign(robot, open.scene, goal, 0.0F);
    last_metres.assign(open.scene, goal, nimbleness());
    const detail::TargetGrid grid(open.scene.bounds());
    tools = {robot, &open.scene, &parameters,  &check, &driven,     &braked,
             grid,  &ending,     &last_metres, 0.0F,   start.data()};
    way.allocate(arena, 512, robot.state_size());
    none.allocate(arena, 512, robot.state_size());
    none.clear();
    drives.allocate(arena, robot.state_size());
    route.allocate(arena, 8);
    route.clear();
    for (const float x : {2.0F, 8.0F, 14.0F}) route.add({{x, 3}, 1.0F, 1.0F, 0.0F});
    route.measure();
  }

  detail::Nimbleness nimbleness() const {
    const Robot seen(robot);
    const Polygon outline = seen.body(0);
    const float length = detail::robot_length(seen);
    const float far = detail::farthest(outline.vertices, outline.count);
    const float near = detail::inner_radius(outline, {});
    return {length,
            length,
            seen.turning_radius(length),
            seen.top_speed(length),
            near,
            far,
            false,
            0,
            kDt,
            kMargin,
            outline,
            nullptr,
            nullptr};
  }

  // Outcome of a drive along the route, from a way's first legs on.
  Outcome drive(const detail::Way& from, std::uint32_t legs, std::uint32_t bound = kManySteps,
                float until = kInfinity) {
    drives.assign(tools, {kHold, 0.1F, kReach, 0.1F});
    return drive_once_more(from, legs, bound, until);
  }
  // The same with what the last drive has left.
  Outcome drive_once_more(const detail::Way& from, std::uint32_t legs, std::uint32_t bound = kManySteps,
                          float until = kInfinity) {
    drives.begin(way, from, legs, route, bound, until);
    shots.clear();
    Outcome outcome = Outcome::drives;
    for (int calls = 0; outcome == Outcome::drives && calls < 10'000; ++calls) {
      outcome = drives.advance(1);
      note_shot();
    }
    return outcome;
  }
  Outcome drive() { return drive(none, 0); }

  // Where a shot has come to its second leg: metres of the route that were left when it began.
  void note_shot() {
    const std::uint32_t last = way.count() - 1;
    if (way.count() < 2 || way[last].arc != detail::Leg::kOffRoute || way[last - 1].arc == detail::Leg::kOffRoute)
      return;
    const float remaining = route.length() - way[last - 1].arc;
    if (shots.empty() || shots.back() != remaining) shots.push_back(remaining);
  }

  // Metres along the route where the last leg begins that follows it. None if no leg leaves it.
  std::optional<float> first_shot() const {
    for (std::uint32_t i = 1; i < way.count(); ++i) {
      if (way[i].arc == detail::Leg::kOffRoute) return way[i - 1].arc;
    }
    return {};
  }

  const Goal goal;
  OpenScene open;
  Unicycle robot;
  Parameters parameters;
  std::vector<float> start;
  std::vector<std::uint64_t> block;
  detail::Arena arena;
  detail::MotionCheck check;
  detail::Drive driven, braked;
  detail::Ending ending;
  detail::LastMetres last_metres;
  detail::WayTools tools;
  detail::Way way, none;
  detail::Route route;
  detail::WayDrive drives;
  std::vector<float> shots;  // of the last drive: see note_shot
};

// Whether both came to the same last state.
bool ended_alike(const Driver& a, const Driver& b) {
  const std::size_t bytes = sizeof(float) * static_cast<std::size_t>(a.robot.state_size());
  return std::memcmp(a.braked.state(), b.braked.state(), bytes) == 0;
}

TEST(WayDrive, ShotsBeginNoEarlierThanTheRouteSays) {
  constexpr float kLeg = 0.5F;  // metres, longer than the robot drives in one
  Driver anywhere;
  const float length = anywhere.route.length();
  ASSERT_EQ(anywhere.drive(), Outcome::reached);
  ASSERT_TRUE(anywhere.first_shot());
  ASSERT_GT(anywhere.last_metres.capture(), 2.5F);
  EXPECT_NEAR(*anywhere.first_shot(), length - anywhere.last_metres.capture(), kLeg);
  for (const float within : {1.0F, 1.75F}) {
    Driver bounded;
    bounded.route.shoot_within(within);
    ASSERT_EQ(bounded.drive(), Outcome::reached);
    ASSERT_TRUE(bounded.first_shot());
    EXPECT_GE(*bounded.first_shot(), length - within);
    EXPECT_LE(*bounded.first_shot(), length - within + kLeg);
  }
}

TEST(WayDrive, AWayEndsInThePose) {
  Driver driver;
  ASSERT_EQ(driver.drive(), Outcome::reached);
  const float* const end = driver.braked.state();
  EXPECT_LE(std::hypot(end[0] - 14, end[1] - 3), 0.1F);
  EXPECT_LE(std::abs(end[2]), 0.1F);
}

// The wall is 6 m ahead: the robot ends before it, and not far from it.
TEST(WayDrive, AWallEndsAWay) {
  Driver driver(true);
  EXPECT_EQ(driver.drive(), Outcome::blocked);
  EXPECT_LT(driver.driven.state()[0], 8.0F - 0.25F);
  EXPECT_GT(driver.driven.state()[0], 6.5F);
}

TEST(WayDrive, AWayThatWouldBeTooLongIsGivenUp) {
  Driver driver;
  ASSERT_EQ(driver.drive(), Outcome::reached);
  const std::uint32_t steps = driver.way.steps();
  EXPECT_EQ(driver.drive(driver.none, 0, steps + 1), Outcome::reached);
  EXPECT_EQ(driver.drive(driver.none, 0, steps / 2), Outcome::too_long);
  EXPECT_LT(driver.way.steps(), steps / 8);  // since the rest of the route is too long
}

TEST(WayDrive, AWayEndsWhereItWasToCome) {
  Driver driver;
  EXPECT_EQ(driver.drive(driver.none, 0, kManySteps, 4.0F), Outcome::passed);
  EXPECT_GE(driver.drives.arc(), 4.0F);
  EXPECT_LT(driver.drives.arc(), 5.0F);
}

TEST(WayDrive, AWayGoesOnFromAnyOfItsLegsToTheSameBits) {
  Driver whole;
  ASSERT_EQ(whole.drive(), Outcome::reached);
  for (const std::uint32_t legs : {1U, 5U, 15U, 16U, 17U}) {
    ASSERT_LT(legs, whole.way.count());
    ASSERT_NE(whole.way[legs].arc, detail::Leg::kOffRoute);
    Driver again;
    ASSERT_EQ(again.drive(whole.way, legs), Outcome::reached);
    EXPECT_EQ(again.way.steps(), whole.way.steps());
    EXPECT_TRUE(ended_alike(again, whole));
  }
}

// Driven again only the first time; what it leaves behind is of the way that had begun then.
TEST(WayDrive, AWayGoesOnFromTheSameLegOnceMoreAndThenFromAnother) {
  Driver whole;
  ASSERT_EQ(whole.drive(), Outcome::reached);
  Driver again;
  ASSERT_EQ(again.drive(whole.way, 17), Outcome::reached);
  for (const std::uint32_t legs : {17U, 17U, 5U, 5U, 16U, 0U}) {
    ASSERT_EQ(again.drive_once_more(whole.way, legs), Outcome::reached);
    EXPECT_EQ(again.way.steps(), whole.way.steps()) << legs;
    EXPECT_TRUE(ended_alike(again, whole)) << legs;
  }
}

TEST(WayDrive, AWayThatBeginsWithAsManyLegsOfAnotherOneIsNotTheLastWay) {
  Driver low, high;
  for (const float y : {2.0F, 4.0F}) {
    Driver& driver = y < 3 ? low : high;
    driver.route[1].at.y = y;
    driver.route.measure();
    ASSERT_EQ(driver.drive(), Outcome::reached);
  }
  Driver again;
  again.route.copy(high.route);
  ASSERT_EQ(again.drive(low.way, 9), Outcome::reached);
  ASSERT_EQ(again.drive(high.way, 9), Outcome::reached);
  EXPECT_TRUE(ended_alike(again, high));
}

// A gap that lets the disc of the shots' looks through, but not the robot: every shot fails there.
TEST(WayDrive, AfterShotsThatFailTheNextOnesBeginMuchNearerToTheEnd) {
  constexpr float kLeg = 0.5F;  // metres, longer than the robot drives in one
  Room room = hall(false);
  room.boxes = {{13, 0, 13.1F, 2.81F}, {13, 3.19F, 13.1F, 6}};
  Driver driver(room);
  ASSERT_EQ(driver.drive(), Outcome::blocked);
  ASSERT_GE(driver.shots.size(), 2U);
  for (std::size_t i = 1; i < driver.shots.size(); ++i) {
    EXPECT_LE(driver.shots[i], 0.7F * driver.shots[i - 1]);
    EXPECT_GE(driver.shots[i], 0.6F * driver.shots[i - 1] - kLeg);
  }
}

// The goal's heading is that of the way back: the last turn takes more time than there is.
TEST(WayDrive, ShotsWhoseTurnsTakeTooLongAreNotDriven) {
  Driver driver(hall(false), kPi);
  const UnicycleParameters& p = driver.robot.parameters();
  ASSERT_EQ(driver.drive(), Outcome::reached);
  const std::uint32_t steps = driver.way.steps();
  const auto checks_within = [&driver](std::uint32_t bound) {
    const std::uint64_t before = driver.check.checks();
    EXPECT_NE(driver.drive(driver.none, 0, bound), Outcome::reached);
    return driver.check.checks() - before;
  };
  const std::uint32_t bound = steps - 5;
  const std::uint64_t unaware = checks_within(bound);
  driver.last_metres.count_turns(p.max_speed / p.max_turn_rate);
  EXPECT_LT(checks_within(bound), unaware / 2);
  EXPECT_EQ(driver.drive(driver.none, 0, steps + 1), Outcome::reached);
  EXPECT_EQ(driver.way.steps(), steps);
}

}  // namespace
}  // namespace krait::test::way_drive_test
