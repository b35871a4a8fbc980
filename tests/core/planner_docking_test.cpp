// SPDX-License-Identifier: Apache-2.0
// Docks that trailers are pushed into backwards.
#include <algorithm>
#include <cmath>

#include "plan/ending.hpp"
#include "planner_fixture.hpp"

namespace krait::test::planner_docking_test {
namespace {

constexpr double kHitch = 0.8;     // metres, axle to axle
constexpr double kWidth = 0.5;     // of all bodies
constexpr double kDock = 10;       // where the middle of the dock is
constexpr float kOff = 0.1F;       // metres and radians that body 0 may be off,
constexpr float kHitchOff = 0.2F;  // and radians that a hitch may

template <class R>
R backing(int trailers) {
  typename R::Parameters p;
  p.trailers = trailers;
  p.min_speed = -1;
  return R(p);
}

// Where body 0 stands when the last trailer is at the wall.
Vec2 docked(int trailers) { return {static_cast<float>(kDock), static_cast<float>(0.5 + trailers * kHitch)}; }

// A yard with a dock between two blocks as deep as `deep` trailers, and something that stands about in front of it.
Room yard(int deep) {
  const double half = 0.75 * kWidth;
  const double depth = 0.5 + deep * kHitch;
  Room room;
  room.bounds = {0, 0, 20, 14};
  room.boxes = {{kDock - half - 1, 0, kDock - half, depth},
                {kDock + half, 0, kDock + half + 1, depth},
                {4, 7, 4.8, 8},
                {14.5, 5, 15, 6.5}};
  room.goals = {{kDock - 0.2, 0.2, kDock + 0.2, depth}};
  return room;
}

Goal dock(int trailers) { return Goal::pose(docked(trailers), kOff, {kPi / 2, kOff, false, kHitchOff}); }

double between(float a, float b) {
  return std::fabs(std::remainder(static_cast<double>(a) - static_cast<double>(b), 2 * 3.14159265358979));
}

template <class R>
void expect_docked(const Planner& planner, int trailers) {
  const std::vector<float> end = Path(planner.plan()).states.back();
  EXPECT_LE(length(Vec2{end[0], end[1]} - docked(trailers)), kOff);
  EXPECT_LE(between(end[2], kPi / 2), kOff);
  for (int k = 0; k < trailers; ++k) {
    const auto at = static_cast<std::size_t>(R::kCarState + k);
    EXPECT_LE(between(end[k == 0 ? 2 : at - 1], end[at]), kHitchOff);
  }
  EXPECT_LE(planner.statistics().plan_end_speed, detail::kRestSpeed);
}

// Of ten searches those that end in the dock, each from a place and direction of its own.
template <class R>
int solved(const R& robot, int trailers, int deep, std::uint64_t iterations) {
  Bench<R> bench(yard(deep), robot);
  bench.limits.iterations = iterations;
  bench.limits.vertices = 100'000;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EXPECT_TRUE(bench.init().ok());
    std::vector<float> start(static_cast<std::size_t>(robot.state_size()));
    const float turn = 0.6F * static_cast<float>(seed);
    robot.rest({6.0F + 0.8F * static_cast<float>(seed), 10.5F}, turn, nullptr, start.data());
    if (bench.solve({start.data(), dock(trailers), seed}) != Status::solved) continue;
    expect_docked<R>(bench.planner, trailers);
    ++count;
  }
  return count;
}

TEST(PlannerDocking, OneTrailerIsPushedIntoADeepDock) {
  EXPECT_EQ(solved(backing<Truck>(1), 1, 2, 5000), 10);
  EXPECT_EQ(solved(backing<KinematicTruck>(1), 1, 2, 5000), 10);
}

// There is no room to pull ahead: the truck backs from where it stands.
TEST(PlannerDocking, ATruckBeforeItsDockBacksIntoItAtOnce) {
  Room room = yard(2);
  room.bounds = {0, 0, 20, 4.2};
  room.boxes.resize(2);
  Bench<Truck> bench(room, backing<Truck>(1));
  bench.limits.iterations = 1000;
  std::vector<float> start(6);
  bench.robot.rest({10.02F, 3.0F}, kPi / 2, nullptr, start.data());
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    ASSERT_TRUE(bench.init().ok());
    ASSERT_EQ(bench.solve({start.data(), dock(1), seed}), Status::solved);
    expect_docked<Truck>(bench.planner, 1);
  }
}

TEST(PlannerDocking, SoAreTwo) {
  EXPECT_GE(solved(backing<Truck>(2), 2, 3, 60'000), 9);
  EXPECT_GE(solved(backing<KinematicTruck>(2), 2, 3, 60'000), 9);
}

TEST(PlannerDocking, AndThreeIntoAShallowOne) { EXPECT_GE(solved(backing<KinematicTruck>(3), 3, 1, 30'000), 8); }

TEST(PlannerDocking, ABetterPlanDocksAsWell) {
  Bench<Truck> bench(yard(2), backing<Truck>(1));
  bench.limits.way_legs = 500;
  const float start[] = {6, 10, 0, 0, 0, 0};
  double first = 0;
  double better = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    ASSERT_TRUE(bench.init().ok());
    ASSERT_EQ(bench.solve({start, dock(1), seed}), Status::solved);
    first += bench.planner.plan().steps();
    ASSERT_EQ(bench.planner.improve(500), Status::solved);
    expect_docked<Truck>(bench.planner, 1);
    better += bench.planner.plan().steps();
  }
  EXPECT_LT(better, first);
}

// A tractor of real size with a semitrailer, whose wheels turn by 0.03 rad a step.
TEST(PlannerDocking, ASemitrailerIsPushedIntoItsDock) {
  ChainParameters p;
  p.trailers = 1;
  p.body_length = 5.6F;
  p.body_width = 2.4F;
  p.body_offset = 1.9F;
  p.wheelbase = 3.8F;
  p.hitch_length = 8.4F;
  p.max_speed = 3;
  p.min_speed = -1.5F;
  p.max_steering = 0.354F;
  p.max_acceleration = 1;
  p.max_steering_rate = 0.3F;
  p.max_hitch_angle = 1.2F;
  Room room;
  room.bounds = {0, 0, 120, 70};
  room.boxes = {{55, 0, 58.4, 9}, {61.6, 0, 65, 9}};
  room.goals = {{59, 1, 61, 9}};
  Bench<Truck> bench(room, Truck(p));
  const Goal goal = Goal::pose({60, 11.5F}, 0.3F, {kPi / 2, kOff, false, kHitchOff});
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    ASSERT_TRUE(bench.init().ok());
    std::vector<float> start(6);
    bench.robot.rest({30.0F + 5.0F * static_cast<float>(seed), 45}, 0, nullptr, start.data());
    if (bench.solve({start.data(), goal, seed}) == Status::solved) ++count;
  }
  EXPECT_EQ(count, 10);
}

// Between two vehicles, 1.5 m apart, where a straight way in as long as the hitch has no room. `side`: 1 where the
// robot comes from the left of its goal, and -1 from the right.
Room gap(double side) {
  const auto box = [side](double x) {
    const double a = side * 0.075;
    const double b = side * 0.325;
    return Rect{x - 0.25, std::min(a, b), x + 0.25, std::max(a, b)};
  };
  Room room;
  room.bounds = {0, side > 0 ? -0.5 : -2.5, 3.5, side > 0 ? 2.5 : 0.5};
  room.boxes = {box(0.7), box(2.7)};
  room.goals = {{1.8, side * 0.2 - 0.1, 2.0, side * 0.2 + 0.1}};
  return room;
}

TEST(PlannerDocking, ATrailerIsStraightenedByASwingWhereAStraightWayHasNoRoom) {
  for (const float side : {1.0F, -1.0F}) {
    Bench<KinematicTruck> bench(gap(static_cast<double>(side)), car_with_trailer());
    bench.limits.iterations = 2000;
    const float start[] = {0.7F, side * 0.6F, 0, 0};
    const Goal goal = Goal::pose({1.9F, side * 0.2F}, 0.1F, {0, 0.1F, false, 0.1F});
    int count = 0;
    std::vector<std::uint64_t> iterations;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      ASSERT_TRUE(bench.init().ok());
      if (bench.solve({start, goal, seed}) != Status::solved) continue;
      ++count;
      iterations.push_back(bench.planner.statistics().iterations);
      const std::vector<float> end = Path(bench.planner.plan()).states.back();
      EXPECT_LE(length(Vec2{end[0], end[1]} - goal.center()), 0.1F);
      EXPECT_LE(between(end[2], 0), 0.1);
      EXPECT_LE(between(end[2], end[3]), 0.1);
    }
    EXPECT_GE(count, 19) << side;
    std::sort(iterations.begin(), iterations.end());
    EXPECT_LE(iterations[iterations.size() / 2], 20U) << side;
  }
}

// A first plan that ends in a push of some metres at 0.1 m/s takes 600 steps, one that drives forwards 200. Where no
// line leads to a better way, other searches do: without them the plans take 4,700 steps, with them 3,100.
TEST(PlannerDocking, APlanThatEndsInASlowPushIsImproved) {
  Room room;
  room.bounds = {0, 0, 6, 6};
  room.boxes = {
      {4.4, 1.4, 4.6, 4.6}, {1.4, 1.4, 4.6, 1.6}, {1.4, 4.4, 4.6, 4.6}, {1.4, 3.5, 1.6, 4.6}, {1.4, 1.4, 1.6, 2.5}};
  room.goals = {{5.1, 2.9, 5.3, 3.1}};
  Bench<KinematicTruck> bench(room, car_with_trailer());
  bench.limits.way_legs = 1000;
  const float start[] = {3.4F, 3, 3.14F, 3.14F};
  const Goal goal = Goal::pose({5.2F, 3}, 0.1F, {1.55F, 0.1F, false, 0.1F});
  std::uint32_t longest = 0;
  std::uint32_t sum = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    ASSERT_TRUE(bench.init().ok());
    ASSERT_EQ(bench.solve({start, goal, seed}), Status::solved);
    longest = std::max(longest, bench.planner.plan().steps());
    ASSERT_EQ(bench.planner.improve(1500), Status::solved);
    sum += bench.planner.plan().steps();
  }
  EXPECT_GE(longest, 500U);
  EXPECT_LE(sum, 4000U);
}

// A user's robot that does not say which body it backs with.
struct Silent : Truck {
  using Truck::Truck;
  void backing_body() const = delete;
};
static_assert(RobotModel<Silent>);

TEST(PlannerDocking, NothingIsPushedWhereNoBackingBodyIsStated) {
  EXPECT_EQ(solved(Silent(backing<Truck>(1).parameters()), 1, 2, 2000), 0);
}

struct Misplaced : Truck {
  Misplaced(int trailers, int body) : Truck(backing<Truck>(trailers)), body_(body) {}
  int backing_body() const { return body_; }

 private:
  int body_;
};

TEST(PlannerDocking, ABackingBodyThatTheRobotHasNotIsRefused) {
  for (const int body : {-1, 2, 3}) {
    Bench<Misplaced> bench(yard(2), Misplaced(1, body));
    EXPECT_EQ(bench.init().status, Status::bad_robot) << body;
  }
  Bench<Misplaced> bench(yard(2), Misplaced(1, 1));
  EXPECT_TRUE(bench.init().ok());
}

// The bits of a plan do not depend on how its search is cut into calls.
TEST(PlannerDocking, CallsMayCutAPushAnywhere) {
  Bench<Truck> bench(yard(2), backing<Truck>(1));
  const float start[] = {6, 10, 0, 0, 0, 0};
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.solve({start, dock(1), 3}), Status::solved);
  const std::uint64_t whole = bench.planner.statistics().hash;
  (void)bench.planner.start({start, dock(1), 3});
  while (bench.planner.advance(1) == Status::searching) {
  }
  EXPECT_EQ(bench.planner.statistics().hash, whole);
}

}  // namespace
}  // namespace krait::test::planner_docking_test
