// SPDX-License-Identifier: Apache-2.0
// Plans that end with a heading: the last metres, which are judged in double here.
#include <cmath>
#include <numbers>

#include "last_metres/nimbleness.hpp"
#include "planner_fixture.hpp"
#include "search/adaptive_search.hpp"

namespace krait::test::planner_pose_test {
namespace {

constexpr int kSeeds = 10;
constexpr Vec2 kPoint{9.5F, 4};

ChainParameters chain(int trailers) {
  ChainParameters p;
  p.trailers = trailers;
  return p;
}

ChainParameters reversing() {
  ChainParameters p = Car::defaults();
  p.min_speed = -1;
  return p;
}

// A robot that says nothing of its turns and speed.
struct Silent : Unicycle {
  Silent() : Unicycle(small_unicycle()) {}
  void turning_radius() const = delete;
  void top_speed() const = delete;
};
static_assert(RobotModel<Silent>);

// A user's robot that turns on the spot until it faces the target, and only then drives; at half a turn in 45 seconds.
struct Turret : Unicycle {
  Turret() : Unicycle(small_unicycle()) {}
  bool reversible() const { return false; }
  void steer(StateView s, const Target& target, Steering&, ControlRef u) const {
    const float error = heading_error(s, target);
    const bool faces = math::absolute(error) < 0.1F;
    u << (faces ? target.speed : 0.0F), math::clamp(error / target.dt, -0.07F, 0.07F);
  }
};
static_assert(RobotModel<Turret>);

double between(double a, double b) { return std::abs(std::remainder(a - b, 2 * std::numbers::pi)); }

// The headings of a state's bodies, as the models have them.
std::vector<double> headings(const std::vector<float>& state, int bodies) {
  std::vector<double> all = {static_cast<double>(state[2])};
  for (int k = 1; k < bodies; ++k) all.push_back(static_cast<double>(state[static_cast<std::size_t>(4 + k)]));
  return all;
}

// By how much, in metres and radians, the state is off what the goal allows; at most 0 where it is inside.
double excess(const Goal& goal, const std::vector<float>& state, int bodies) {
  const Facing& facing = goal.facing();
  const double apart = std::hypot(static_cast<double>(state[0]) - static_cast<double>(goal.center().x),
                                  static_cast<double>(state[1]) - static_cast<double>(goal.center().y));
  const std::vector<double> all = headings(state, bodies);
  double off = between(all[0], static_cast<double>(facing.heading));
  if (facing.either_way) off = std::min(off, std::numbers::pi - off);
  double worst = std::max(apart - static_cast<double>(goal.radius()), off - static_cast<double>(facing.tolerance));
  for (std::size_t k = 1; k < all.size() && facing.hitches < kInfinity; ++k) {
    worst = std::max(worst, between(all[k], all[k - 1]) - static_cast<double>(facing.hitches));
  }
  return worst;
}

template <class R>
class Poses {
 public:
  explicit Poses(const R& robot) : Poses(robot, two_rooms(3), {3, 4}) {}
  Poses(const R& robot, const Room& room, Vec2 start) : bench_(room, robot), start_(standing(robot, start)) {}

  Bench<R>& bench() { return bench_; }
  Query query(const Goal& goal, std::uint64_t seed) const { return {start_.data(), goal, seed}; }

  // How far off the plan ends; infinite where there is none.
  double miss(const Goal& goal, std::uint64_t seed) {
    EXPECT_TRUE(bench_.init().ok());
    EXPECT_EQ(bench_.solve(query(goal, seed)), Status::solved) << "seed " << seed;
    return end_miss(goal);
  }

  double end_miss(const Goal& goal) const {
    if (bench_.planner.plan().empty()) return std::numeric_limits<double>::infinity();
    return excess(goal, Path(bench_.planner.plan()).states.back(), bench_.robot.body_count());
  }

 private:
  Bench<R> bench_;
  std::vector<float> start_;
};

template <class R>
void expect_poses(const R& robot, float hitches = kInfinity) {
  Poses<R> poses(robot);
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Facing facing{0.5F * kPi * static_cast<float>(quarter), 0.1F, false, hitches};
    const Goal goal = Goal::pose(kPoint, 0.1F, facing);
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      EXPECT_LE(poses.miss(goal, seed), 0) << "quarter " << quarter << ", seed " << seed;
      EXPECT_LE(poses.bench().planner.statistics().plan_end_speed, detail::kRestSpeed);
    }
  }
}

TEST(PlannerPose, EveryModelEndsInThePoseAtRest) {
  expect_poses(Car(Car::defaults()));
  expect_poses(Car(reversing()));
  expect_poses(Truck(chain(1)));
  expect_poses(Snake(chain(2)));
  expect_poses(DifferentialDrive(DifferentialDriveParameters()));
  expect_poses(small_unicycle());
}

// The most vertices of a plan to the point, of 200 seeds in each of four headings.
template <class R>
std::uint64_t most_vertices(Poses<R>& poses, Vec2 point) {
  poses.bench().limits.iterations = 1000;
  std::uint64_t most = 0;
  for (std::uint64_t seed = 1; seed <= 200 && !::testing::Test::HasFailure(); ++seed) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      const Goal goal = Goal::pose(point, 0.1F, 0.5F * kPi * static_cast<float>(quarter), 0.1F);
      EXPECT_LE(poses.miss(goal, seed), 0) << "quarter " << quarter << ", seed " << seed;
      EXPECT_LE(poses.bench().planner.statistics().plan_end_speed, detail::kRestSpeed);
      most = std::max(most, poses.bench().planner.statistics().vertices);
    }
  }
  return most;
}

// A closet of 0.85 m, its door of 0.6 m to the south; a robot of 0.5 m by 0.4 m has just the room to turn in it.
Room closet() {
  Room room;
  room.bounds = {0, 0, 8, 8};
  room.boxes = {
      {3.9, 4.95, 5.15, 5.1}, {3.9, 4, 4.1, 4.95}, {4.95, 4, 5.15, 4.95}, {4.1, 4, 4.225, 4.1}, {4.825, 4, 4.95, 4.1}};
  room.goals = {{6, 6, 7, 7}};
  return room;
}

TEST(PlannerPose, WhatTurnsOnTheSpotDoesSoInACloset) {
  Poses<Unicycle> unicycle(small_unicycle(), closet(), {1, 1});
  EXPECT_LE(most_vertices(unicycle, {4.525F, 4.525F}), 3000U);
  Poses<DifferentialDrive> drive(DifferentialDrive(DifferentialDriveParameters()), closet(), {1, 1});
  EXPECT_LE(most_vertices(drive, {4.525F, 4.525F}), 1500U);
}

TEST(PlannerPose, HalfATurnOnTheSpotMayTakeFortyFiveSeconds) {
  Poses<Turret> poses{Turret()};
  EXPECT_LE(most_vertices(poses, kPoint), 13000U);
}

// It needs no straight way before the pose: its plans take 75.0 steps each, and 80.1 where lines with short ends are
// considered only where no other is free.
TEST(PlannerPose, WhatTurnsOnTheSpotTakesShortEnds) {
  constexpr int kSearches = 200;
  Poses<Unicycle> poses(small_unicycle());
  double steps = 0;
  for (int i = 0; i < kSearches; ++i) {
    const Goal goal = Goal::pose(kPoint, 0.1F, 0.5F * kPi * static_cast<float>(i % 4), 0.1F);
    EXPECT_LE(poses.miss(goal, static_cast<std::uint64_t>(1 + i / 4)), 0) << i;
    steps += poses.bench().planner.statistics().plan_steps;
  }
  EXPECT_LE(steps / kSearches, 77.5);
}

// The robot stands in the goal, and only its heading is wrong.
TEST(PlannerPose, WhatStandsInThePlaceOnlyTurns) {
  Poses<DifferentialDrive> poses(DifferentialDrive(DifferentialDriveParameters()), two_rooms(3), kPoint);
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    EXPECT_LE(poses.miss(Goal::pose(kPoint, 0.1F, kPi, 0.1F), seed), 0) << seed;
    EXPECT_LE(poses.bench().planner.statistics().plan_length, 1.5F) << seed;
  }
}

TEST(PlannerPose, HitchesAreAsStraightAsAsked) {
  ChainParameters narrow = chain(1);
  narrow.body_width = 0.4F;
  expect_poses(Truck(narrow), 0.2F);
}

// In an empty hall. The last trailer follows last.
TEST(PlannerPose, TwoTrailersHaveTheRoomToStraighten) {
  Room hall;
  hall.bounds = {0, 0, 24, 24};
  hall.goals = {{20, 20, 21, 21}};
  Poses<Truck> poses(Truck(chain(2)), hall, {6, 6});
  std::uint64_t vertices = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      const Facing facing{0.5F * kPi * static_cast<float>(quarter), 0.1F, false, 0.2F};
      EXPECT_LE(poses.miss(Goal::pose({13, 13}, 0.1F, facing), seed), 0) << "quarter " << quarter << ", seed " << seed;
      vertices += poses.bench().planner.statistics().vertices;
    }
  }
  EXPECT_LE(vertices / 80, 150U);
}

TEST(PlannerPose, EitherWayTakesTheNearerEnd) {
  Poses<Car> poses{Car(Car::defaults())};
  bool there = false;
  bool opposite = false;
  for (std::uint64_t seed = 1; seed <= 3 * kSeeds; ++seed) {
    const Goal goal = Goal::pose(kPoint, 0.1F, Facing{0.5F * kPi, 0.1F, true, kInfinity});
    EXPECT_LE(poses.miss(goal, seed), 0);
    const double heading = static_cast<double>(Path(poses.bench().planner.plan()).states.back()[2]);
    (between(heading, std::numbers::pi / 2) < 1 ? there : opposite) = true;
  }
  EXPECT_TRUE(there && opposite);
}

TEST(PlannerPose, AUsersRobotWithoutTurningCircleIsSteeredThere) {
  Poses<Silent> poses{Silent()};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    EXPECT_LE(poses.miss(Goal::pose(kPoint, 0.1F, 0.5F * kPi, 0.1F), seed), 0);
  }
}

TEST(PlannerPose, ARobotThatCannotTurnKeepsItsHeading) {
  Poses<Slider> poses{Slider(0.5F, 1)};
  poses.bench().limits.iterations = 2000;
  ASSERT_TRUE(poses.bench().init().ok());
  EXPECT_EQ(poses.bench().solve(poses.query(Goal::pose(kPoint, 0.1F, 0, 0.1F), 1)), Status::solved);
  EXPECT_EQ(poses.bench().solve(poses.query(Goal::pose(kPoint, 0.1F, 1, 0.1F), 1)), Status::budget_used);
}

TEST(PlannerPose, CallsMayCutAShotAnywhere) {
  Poses<Car> poses{Car(Car::defaults())};
  const Goal goal = Goal::pose(kPoint, 0.1F, kPi, 0.1F);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    ASSERT_LE(poses.miss(goal, seed), 0);
    const Statistics whole = poses.bench().planner.statistics();
    ASSERT_TRUE(poses.bench().init().ok());
    Status status = poses.bench().planner.start(poses.query(goal, seed));
    while (status == Status::searching) status = poses.bench().planner.advance(1);
    EXPECT_EQ(poses.bench().planner.statistics().hash, whole.hash);
    EXPECT_EQ(poses.bench().planner.statistics().iterations, whole.iterations);
  }
}

TEST(PlannerPose, NoCallMakesMoreStepsThanItsExpansionsMay) {
  Poses<Car> poses{Car(Car::defaults())};
  poses.bench().parameters.tuning.max_steps = 7;
  ASSERT_TRUE(poses.bench().init().ok());
  Status status = poses.bench().planner.start(poses.query(Goal::pose(kPoint, 0.1F, kPi, 0.1F), 1));
  while (status == Status::searching) {
    const std::uint64_t before = poses.bench().planner.statistics().vertices;
    status = poses.bench().planner.advance(1);
    ASSERT_LE(poses.bench().planner.statistics().vertices - before, 7);
  }
  EXPECT_EQ(status, Status::solved);
}

TEST(PlannerPose, ImprovedPlansEndInThePoseToo) {
  Poses<Unicycle> poses{small_unicycle()};
  poses.bench().limits.way_legs = 500;
  const Goal goal = Goal::pose(kPoint, 0.1F, kPi, 0.1F);
  std::uint64_t improvements = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    ASSERT_LE(poses.miss(goal, seed), 0);
    ASSERT_EQ(poses.bench().planner.improve(3000), Status::solved);
    EXPECT_LE(poses.end_miss(goal), 0) << "seed " << seed;
    improvements += poses.bench().planner.statistics().improvements;
  }
  EXPECT_GT(improvements, 0U);
}

// A tree so small that it has no room for the legs of a whole shot must not write beyond its pools.
TEST(PlannerPose, ASmallTreeHoldsNoMoreThanItHasRoomFor) {
  for (const std::uint32_t vertices : {2U, 8U, 40U, 100U}) {
    Poses<Car> poses{Car(Car::defaults())};
    poses.bench().limits.vertices = vertices;
    poses.bench().limits.iterations = 2000;
    ASSERT_TRUE(poses.bench().init().ok());
    (void)poses.bench().solve(poses.query(Goal::pose(kPoint, 0.1F, kPi, 0.1F), 1));
    const detail::MotionTree& tree = detail::opened(poses.bench().planner).tree();
    EXPECT_LE(tree.most_expansions(), poses.bench().limits.kept_expansions());
  }
}

TEST(PlannerPose, AStartThatIsThePoseIsThePlan) {
  Poses<Car> poses{Car(Car::defaults())};
  EXPECT_LE(poses.miss(Goal::pose({3, 4}, 0.1F, 0, 0.1F), 1), 0);
  EXPECT_EQ(poses.bench().planner.statistics().plan_steps, 0U);
  EXPECT_LE(poses.miss(Goal::pose({3, 4}, 0.1F, 1, 0.1F), 1), 0);
  EXPECT_GT(poses.bench().planner.statistics().plan_steps, 0U);
}

Status answer(const Goal& goal) {
  Poses<Car> poses{Car(Car::defaults())};
  EXPECT_TRUE(poses.bench().init().ok());
  const Status status = poses.bench().planner.start(poses.query(goal, 1));
  if (status == Status::bad_argument) {
    EXPECT_EQ(poses.bench().planner.failure().element, static_cast<std::uint32_t>(Argument::goal));
  }
  return status;
}

TEST(PlannerPose, NumbersOutOfTheirRangesAreRefused) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(answer(Goal::pose(kPoint, 0.1F, 1, kPi)), Status::searching);
  EXPECT_EQ(answer(Goal::pose(kPoint, 0.1F, Facing{1, 0.1F, false, 0.01F})), Status::searching);
  EXPECT_EQ(answer(Goal::pose(kPoint, 0, 1, 0.1F)), Status::bad_argument);
  for (const float heading : {nan, kInfinity, -2 * kMaxAngle}) {
    EXPECT_EQ(answer(Goal::pose(kPoint, 0.1F, heading, 0.1F)), Status::bad_argument);
  }
  for (const float tolerance : {0.0F, -0.1F, 3.15F, nan}) {
    EXPECT_EQ(answer(Goal::pose(kPoint, 0.1F, 1, tolerance)), Status::bad_argument);
  }
  for (const float hitches : {0.0F, -1.0F, nan}) {
    EXPECT_EQ(answer(Goal::pose(kPoint, 0.1F, Facing{1, 0.1F, false, hitches})), Status::bad_argument);
  }
}

// A body's length behind the pose is a wall: only a line that is an arc almost to its end is free.
TEST(PlannerPose, NeedsNoStraightWayBehindIt) {
  Poses<Car> poses{Car(Car::defaults())};
  const Goal goal = Goal::pose({7.5F, 1.5F}, 0.1F, 0, 0.1F);
  std::uint64_t most = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    EXPECT_LE(poses.miss(goal, seed), 0) << seed;
    most = std::max(most, poses.bench().planner.statistics().iterations);
  }
  EXPECT_LE(most, 6000U);
}

// A line of kilometres is looked at in a bounded number of places, however short the robot is.
TEST(PlannerPose, LooksAlongALineAreBounded) {
  Room room;
  room.bounds = {-1950, -1950, 1950, 1950};
  room.spacing = 1000;
  room.clearance_cell = 50;
  room.bucket_size = 500;
  ChainParameters p = Car::defaults();
  p.body_length = 2e-4F;
  p.body_width = 2e-4F;
  p.wheelbase = 20;
  p.max_steering = 0.01F;
  Bench<Car> bench(room, Car(p));
  ASSERT_TRUE(bench.init().ok());
  const std::vector<float> start = standing(bench.robot, {-1800, 0});
  const Goal goal = Goal::pose({1900, 0}, 5, 0, 0.1F);
  (void)bench.planner.start({start.data(), goal, 1});
  (void)bench.planner.advance(3);
  EXPECT_GE(bench.planner.statistics().iterations, 1U);
}

// A start on the goal's edge, where floats and doubles differ on which side it is.
TEST(PlannerPose, AStartOnTheEdgeIsNoPlanUnlessItIsInside) {
  Poses<Car> poses{Car(Car::defaults())};
  ASSERT_TRUE(poses.bench().init().ok());
  const Vec2 center{3.3F, 4.1F};
  int at_once = 0;
  for (int i = 0; i < 400; ++i) {
    const SinCos to = math::sin_cos(static_cast<float>(i) * 0.0157F);
    const float radius = i % 2 == 0 ? 0.7F : 0.699F;  // of the start, about the goal of 0.7 m
    std::vector<float> start = standing(poses.bench().robot, center + radius * Vec2{to.cos, to.sin});
    if (poses.bench().planner.start({start.data(), Goal::disc(center, 0.7F), 1}) != Status::solved) continue;
    ++at_once;
    const double apart = std::hypot(static_cast<double>(start[0]) - static_cast<double>(center.x),
                                    static_cast<double>(start[1]) - static_cast<double>(center.y));
    EXPECT_LE(apart, static_cast<double>(0.7F)) << i;
  }
  EXPECT_EQ(at_once, 200);
}

// At its brakes' most it slows down to 0 in what is left, v^2 = 2 a s; near the end some time steps are what counts.
TEST(Pace, IsOneThatTheBrakesAreEnoughFor) {
  detail::Nimbleness robot{};
  robot.top_speed = 2;
  robot.dt = 0.1F;
  const auto speed = [&](float left, float now, float acceleration, float braking) {
    return robot.top_speed * detail::pace(robot, left, now, 0.5F * now * now / acceleration, braking);
  };
  EXPECT_NEAR(speed(1, 2, 0.5F, 1), 1, 1e-5);
  EXPECT_NEAR(speed(1, 1.5F, 0.5F, 1), 1, 1e-5) << "whatever it drives at";
  EXPECT_NEAR(speed(1, 2, 0.5F, 0.25F), 0.5, 1e-5);
  EXPECT_NEAR(speed(0.15F, 2, 5, 1), 0.5, 1e-5) << "e^-1 of the way is left after three time steps";
  EXPECT_EQ(speed(100, 2, 5, 1), robot.top_speed);
  EXPECT_GT(speed(0, 2, 5, 1), 0) << "it arrives";
}

}  // namespace
}  // namespace krait::test::planner_pose_test
