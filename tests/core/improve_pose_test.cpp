// SPDX-License-Identifier: Apache-2.0
// improve where the goal is a pose: plans get better and end as it asks, whatever the calls.
#include <cmath>
#include <numbers>

#include "improve_fixture.hpp"
#include "plan/ending.hpp"

namespace krait::test::improve_pose_test {
namespace {

constexpr Vec2 kPoint{14.5F, 1.5F};
constexpr float kNear = 0.1F;  // metres and radians
constexpr std::uint32_t kManyLegs = 256;
constexpr std::uint64_t kSeed = 10'001;

Goal pose(int quarter, float hitches = kInfinity) {
  return Goal::pose(kPoint, kNear, {0.5F * kPi * static_cast<float>(quarter), kNear, false, hitches});
}

double between(double a, double b) { return std::abs(std::remainder(a - b, 2 * std::numbers::pi)); }

void expect_in_pose(const std::vector<Frame>& bodies, const Goal& goal) {
  const Facing& facing = goal.facing();
  EXPECT_LE(std::hypot(bodies[0].x - wide(kPoint.x), bodies[0].y - wide(kPoint.y)), wide(kNear));
  EXPECT_LE(between(bodies[0].angle, wide(facing.heading)), wide(facing.tolerance));
  for (std::size_t k = 1; k < bodies.size() && facing.hitches < kInfinity; ++k) {
    EXPECT_LE(between(bodies[k].angle, bodies[k - 1].angle), wide(facing.hitches));
  }
}

// The steps of better plans, of those of the first ones: of two seeds in each of four headings.
template <class R>
double share_of_steps(const R& robot, float hitches = kInfinity, float heading = 0.0F, std::uint32_t legs = kLegs,
                      std::uint64_t iterations = 1500) {
  double first = 0;
  double better = 0;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Goal goal = pose(quarter, hitches);
    for (std::uint64_t seed = kSeed; seed < kSeed + 2; ++seed) {
      SCOPED_TRACE(testing::Message() << "quarter " << quarter << ", seed " << seed);
      Solved<R> bench(robot, seed, legs, goal, heading);
      const std::uint32_t steps = bench.planner.plan().steps();
      EXPECT_EQ(bench.planner.improve(iterations), Status::solved);
      EXPECT_LE(bench.planner.plan().steps(), steps);
      EXPECT_LE(bench.planner.statistics().plan_end_speed, detail::kRestSpeed);
      expect_in_pose(frames(robot, drive_alone(bench, Path(bench.planner.plan()))), goal);
      first += steps;
      better += bench.planner.plan().steps();
    }
  }
  return better / first;
}

TEST(ImprovePose, PlansOfEveryModelGetBetter) {
  EXPECT_LE(share_of_steps(small_car()), 0.82);
  EXPECT_LE(share_of_steps(DifferentialDrive(DifferentialDriveParameters())), 0.9);
  EXPECT_LE(share_of_steps(small_unicycle()), 0.91);
  EXPECT_LE(share_of_steps(Truck(small_chain(1))), 0.85);
  EXPECT_LE(share_of_steps(Truck(small_chain(2))), 0.85);
  EXPECT_LE(share_of_steps(Snake(small_chain(3)), kInfinity, 0.0F, kLegs, 6000), 0.83);
  EXPECT_LE(share_of_steps(Truck(small_chain(1)), 0.2F), 0.8);
}

// Its top speed takes it a metre or more while it turns by a radian, so that a turn on the spot costs it much.
Unicycle slow_to_turn(float rate = 1.0F) {
  UnicycleParameters p = small_unicycle().parameters();
  p.max_turn_rate = rate;
  return Unicycle(p);
}

// By collision checks, of which shots that begin early would take most.
TEST(ImprovePose, ARobotThatIsSlowToTurnShootsWhereThatHelps) {
  constexpr int kSearches = 48;
  double steps = 0;
  for (std::uint64_t seed = kSeed; seed < kSeed + kSearches; ++seed) {
    Solved<Unicycle> bench(slow_to_turn(0.5F), seed, kManyLegs, pose(static_cast<int>(seed % 4)));
    improve_by_checks(bench.planner, 3);
    steps += bench.planner.plan().steps();
  }
  EXPECT_LE(steps / kSearches, 331);
}

// Facing away from the way, and from the goal where that asks for the same heading.
TEST(ImprovePose, ARobotThatFacesAwayDrivesBackwards) {
  EXPECT_LE(share_of_steps(slow_to_turn(), kInfinity, kPi, kManyLegs), 0.83);
  Solved<Unicycle> bench(slow_to_turn(0.3F), kSeed, kManyLegs, pose(2), kPi);
  EXPECT_EQ(bench.planner.improve(1500), Status::solved);
  const Path path(bench.planner.plan());
  const auto backwards = std::count_if(path.controls.begin(), path.controls.end(),
                                       [](const std::vector<float>& control) { return control[0] < 0.0F; });
  EXPECT_GE(static_cast<double>(backwards), 0.9 * static_cast<double>(path.controls.size()));
}

// A kink that is 0.6 m wide, or the way around: dynobench's kink_0.
Room kink() {
  Room room;
  room.bounds = {0, 0, 7, 6};
  room.boxes = {{2.5, 4.4, 5.5, 6}, {4.3, 3.6, 5.5, 4.4}, {2.5, 3, 3.7, 3.8}, {2.5, 1, 5.5, 3}};
  room.goals = {{6, 3.5, 6.5, 4.5}};
  return room;
}

// The steps of plans improved by so many times the first plans' checks, of those of the first ones: of 32 seeds.
template <class R>
double share_of_steps_through_kink(const R& robot, float hitches, std::uint64_t times) {
  constexpr int kSearches = 32;
  std::vector<float> start = start_of(robot, 0.5F * kPi);
  start[0] = 1.5F;
  start[1] = 4;
  const Goal goal = Goal::pose({6.5F, 4}, kNear, {0.5F * kPi, kNear, false, hitches});
  double first = 0;
  double better = 0;
  for (std::uint64_t seed = kSeed; seed < kSeed + kSearches; ++seed) {
    Bench<R> bench(kink(), robot);
    bench.limits.way_legs = kManyLegs;
    EXPECT_TRUE(bench.init().ok());
    EXPECT_EQ(bench.solve({start.data(), goal, seed}), Status::solved);
    first += bench.planner.plan().steps();
    improve_by_checks(bench.planner, times);
    better += bench.planner.plan().steps();
  }
  return better / first;
}

// First plans lead around the outside: behind the kink the trailer can be straightened on tight arcs only. Where the
// line through the kink is taken no more often for being much shorter, it is 0.628.
TEST(ImprovePose, ATruckTakesTheShorterWayThroughAKink) {
  EXPECT_LE(share_of_steps_through_kink(car_with_trailer(), kNear, 80), 0.615);
}

// A robot that takes two seconds to its top speed: 0.516. It is 0.537 where lines are pulled for discs that do not fit
// into the kink, 0.544 where drives past a corner do not look ahead, and 0.534 where none returns to the corner before
// one that it does not get past.
TEST(ImprovePose, ARobotThatIsSlowToStopGetsThroughAKink) {
  Unicycle2Parameters p = sluggish();
  p.body_width = 0.25F;
  EXPECT_LE(share_of_steps_through_kink(Unicycle2(p), kInfinity, 60), 0.525);
}

// A goal to the side of a machine that turns slowly: shots that turn much are slow. By collision
// checks; where turns count as no time, plans take 126 steps.
TEST(ImprovePose, ShotsThatTurnTooSlowlyTakeNoChecks) {
  constexpr int kSearches = 40;
  Unicycle2Parameters p = sluggish();
  p.body_width = 0.25F;
  Room room;
  room.bounds = {0, 0, 12, 12};
  double steps = 0;
  for (std::uint64_t seed = kSeed; seed < kSeed + kSearches; ++seed) {
    Bench<Unicycle2> bench(room, Unicycle2(p));
    bench.limits.way_legs = kManyLegs;
    ASSERT_TRUE(bench.init().ok());
    const std::vector<float> start = standing(bench.robot, {4, 6});
    const Goal goal = Goal::pose({6, 8}, kNear, {0.0F, kNear, false, kInfinity});
    ASSERT_EQ(bench.solve({start.data(), goal, seed}), Status::solved);
    improve_by_checks(bench.planner, 10);
    steps += bench.planner.plan().steps();
  }
  EXPECT_LE(steps / kSearches, 118);
}

TEST(ImprovePose, ThePlanDoesNotDependOnHowCallsAreCut) {
  expect_independent_of_cuts(small_car(), pose(1));
  expect_independent_of_cuts(DifferentialDrive(DifferentialDriveParameters()), pose(1));
  expect_independent_of_cuts(Truck(small_chain(2)), pose(3));
}

// The shots of the next search, too, are those of a fresh planner.
TEST(ImprovePose, TheNextStartForgetsThem) {
  Solved<Car> used(small_car(), kSeed, kLegs, pose(1));
  EXPECT_EQ(used.planner.improve(2000), Status::solved);
  ASSERT_GT(used.planner.statistics().improvements, 0U);
  Solved<Car> fresh(small_car(), kSeed + 1, kLegs, pose(2));
  ASSERT_EQ(used.solve({used.start.data(), pose(2), kSeed + 1}), Status::solved);
  EXPECT_EQ(used.planner.plan().hash(), fresh.planner.plan().hash());
}

}  // namespace
}  // namespace krait::test::improve_pose_test
