// SPDX-License-Identifier: Apache-2.0
// Parking spaces: what leads out of one, and that a car drives in where no line of one gear leads.
#include <algorithm>
#include <cmath>

#include "last_metres/pull_outs.hpp"
#include "parking_fixture.hpp"
#include "plan/ending.hpp"

namespace krait::test::planner_parking_test {
namespace {

using namespace parking;

struct Parked : Car {
  Parked() : Car(reversing()) {}
};
struct KinematicParked : KinematicTruck {
  KinematicParked() : KinematicTruck(kinematic()) {}
};
struct KinematicUnparked : KinematicTruck {
  KinematicUnparked() : KinematicTruck(kinematic()) {}
};

}  // namespace
}  // namespace krait::test::planner_parking_test

template <>
inline constexpr bool krait::kParks<krait::test::planner_parking_test::KinematicUnparked> = false;

namespace krait::test::planner_parking_test {
namespace {

template <class R>
int solved(const R& robot, double lengths) {
  Bench<R> bench(aisle(lengths), robot);
  bench.limits.iterations = 2000;
  const std::vector<float> start = {1.0F, 0.8F, 0, 0, 0};
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EXPECT_TRUE(bench.init().ok());
    if (bench.solve({start.data(), space(), seed}) != Status::solved) continue;
    const std::vector<float> end = Path(bench.planner.plan()).states.back();
    EXPECT_LE(std::hypot(end[0] - space().center().x, end[1] - space().center().y), space().radius());
    EXPECT_LE(std::abs(end[2]), 0.1F);
    EXPECT_LE(bench.planner.statistics().plan_end_speed, detail::kRestSpeed);
    ++count;
  }
  return count;
}

TEST(PlannerParking, ACarDrivesIntoASpaceThatIsHardlyLonger) {
  for (const double lengths : {1.25, 1.4, 1.6}) EXPECT_EQ(solved(Parked(), lengths), 10) << lengths;
}

TEST(PlannerParking, AKinematicCarDoesToo) {
  for (const double lengths : {1.25, 1.4, 1.6}) EXPECT_EQ(solved(KinematicParked(), lengths), 10) << lengths;
}

TEST(PlannerParking, ABetterPlanParksAsWell) {
  Bench<Parked> bench(aisle(1.4), Parked());
  bench.limits.way_legs = 300;
  const std::vector<float> start = {1.0F, 0.8F, 0, 0, 0};
  double first = 0;
  double better = 0;
  for (std::uint64_t seed = 10'001; seed <= 10'010; ++seed) {
    ASSERT_TRUE(bench.init().ok());
    ASSERT_EQ(bench.solve({start.data(), space(), seed}), Status::solved);
    first += bench.planner.plan().steps();
    ASSERT_EQ(bench.planner.improve(1000), Status::solved);
    const std::vector<float> end = Path(bench.planner.plan()).states.back();
    EXPECT_LE(std::hypot(end[0] - space().center().x, end[1] - space().center().y), space().radius());
    EXPECT_LE(std::abs(end[2]), 0.1F);
    EXPECT_LE(bench.planner.statistics().plan_end_speed, detail::kRestSpeed);
    better += bench.planner.plan().steps();
  }
  EXPECT_LE(better, 0.95 * first);
}

TEST(PlannerParking, ABetterPlanBacksOutAsThePlanDid) {
  InABay bench(300);
  bench.parameters.tuning.stuck_expansions = 0;  // so that many a first plan is driven backwards
  double first = 0;
  double better = 0;
  int ahead = 0;
  for (std::uint64_t seed = 10'001; seed <= 10'010; ++seed) {
    ASSERT_TRUE(bench.init().ok());
    ASSERT_EQ(bench.solve({InABay::kNoseIn, Goal::named(0), seed}), Status::solved);
    first += bench.planner.plan().steps();
    ASSERT_EQ(bench.planner.improve(30'000), Status::solved);
    const Path path(bench.planner.plan());
    better += static_cast<double>(path.states.size()) - 1;
    const auto fastest = std::max_element(path.states.begin(), path.states.end(),
                                          [](const auto& a, const auto& b) { return a[3] < b[3]; });
    ahead += (*fastest)[3] > 2.0F ? 1 : 0;
  }
  EXPECT_GE(ahead, 9);
  EXPECT_LE(better, 0.6 * first);
}

// A plan may have more legs than a way has room for, which are as many as are kept at most.
void expect_better_with_few_legs(InABay& bench, const Goal& goal) {
  for (std::uint64_t seed = 10'001; seed <= 10'010; ++seed) {
    ASSERT_TRUE(bench.init().ok());
    ASSERT_EQ(bench.solve({InABay::kNoseIn, goal, seed}), Status::solved);
    const Path first(bench.planner.plan());
    ASSERT_EQ(bench.planner.improve(3000), Status::solved);
    const Path better(bench.planner.plan());
    if (bench.planner.statistics().improvements == 0) {
      EXPECT_EQ(better.states, first.states);
    } else {
      EXPECT_LT(better.states.size(), first.states.size());
    }
    EXPECT_GT(better.states.back()[0], 22.0F);
  }
}

TEST(PlannerParking, NoMoreLegsAreKeptThanAWayHasRoomFor) {
  InABay bench(Limits::kLeastLegs);
  bench.parameters.tuning.stuck_expansions = 0;
  expect_better_with_few_legs(bench, Goal::named(0));
}

// The plan ends with a shot, whose legs are two steps each, so that it has some fifty legs.
TEST(PlannerParking, NorOfAPlanOfManyLegs) {
  InABay bench(Limits::kLeastLegs);
  expect_better_with_few_legs(bench, Goal::pose({22.7F, 1.0F}, 0.3F, {0.0F, 0.3F, false, kInfinity}));
}

TEST(PlannerParking, NoLineOfOneGearLeadsThere) {
  EXPECT_LE(solved(Unparked(), 1.25), 2);
  EXPECT_EQ(solved(KinematicUnparked(), 1.25), 0);
}

class PullOuts : public ::testing::Test {
 protected:
  void find(double lengths, float radius = 1.3F) {
    const OpenScene open(aisle(lengths));
    const Parked car;
    Goal goal = Goal::pose(space().center(), 0.05F, {0.0F, 0.1F, false, kInfinity});
    ways.find(open.scene, goal, {car.body(0), kLength, radius, 0.001F});
  }

  detail::PullOuts ways;
};

// By small steps of the motion that a move stands for.
TEST_F(PullOuts, MovesJoinAndEndWhereTheWayEnds) {
  find(1.4);
  ASSERT_GT(ways.count(), 0);
  for (int way = 0; way < ways.count(); ++way) {
    Pose at{space().center(), math::sin_cos(0.0F)};
    for (int number = 0; number < ways.moves(way); ++number) {
      const detail::Move move = ways.move(way, number);
      EXPECT_LE(length(move.inner.position - at.position), 1e-4F);
      EXPECT_LE(angle_between(move.inner.heading, at.heading), 1e-4F);
      double x = static_cast<double>(at.position.x), y = static_cast<double>(at.position.y);
      double heading = std::atan2(static_cast<double>(at.heading.sin), static_cast<double>(at.heading.cos));
      const double step = (move.backward ? -1 : 1) * static_cast<double>(move.length) / 2000;
      for (int i = 0; i < 2000; ++i) {
        const double turned = step * move.turn / static_cast<double>(move.radius);
        x += step * std::cos(heading + turned / 2);
        y += step * std::sin(heading + turned / 2);
        heading += turned;
      }
      at = move.outer();
      EXPECT_NEAR(static_cast<double>(at.position.x), x, 1e-4);
      EXPECT_NEAR(static_cast<double>(at.position.y), y, 1e-4);
      const detail::Move::Offset off = move.offset(move.at(0.4F * move.length));
      EXPECT_NEAR(off.way, 0.4F * move.length, 1e-4F);
      EXPECT_NEAR(off.aside, 0, 1e-4F);
      EXPECT_NEAR(off.turned, 0, 1e-4F);
    }
    EXPECT_LE(length(ways.end(way).position - at.position), 1e-3F);
  }
}

TEST_F(PullOuts, AreCheapestFirstAndFewer) {
  find(1.25);
  ASSERT_GT(ways.count(), 0);
  EXPECT_LE(ways.count(), detail::PullOuts::kMost);
  const int tight = ways.moves(0);
  find(1.8);
  EXPECT_LE(ways.moves(0), tight);
}

// Arcs of such a radius are straight, and half a turn has more steps than an int can count.
TEST_F(PullOuts, OfACarThatHardlySteersLeadStraightOn) {
  for (const float radius : {1e6F, 1e9F, 1e12F}) {
    find(4, radius);
    EXPECT_GT(ways.count(), 0) << radius;
  }
}

TEST_F(PullOuts, ThereAreNoneOutOfASpaceThatIsTooShort) {
  find(1.02);
  EXPECT_EQ(ways.count(), 0);
}

}  // namespace
}  // namespace krait::test::planner_parking_test
