// SPDX-License-Identifier: Apache-2.0
// Narrow places are left: the ways out that a car is driven along, when, and that nothing else changes by them.
#include <cmath>

#include "last_metres/pull_outs.hpp"
#include "parking_fixture.hpp"
#include "search/adaptive_search.hpp"
#include "user_robot.hpp"

namespace krait::test::planner_departure_test {
namespace {

using namespace parking;

constexpr float kParallel[] = {kSpace - kAxle, 2.11F, 0, 0, 0};  // in the space
const Goal kDownTheAisle = Goal::disc({11, 0.8F}, 0.3F);
constexpr std::uint64_t kSeeds = 10;

// How many searches of a car that stands in the space are solved.
template <class R>
int count_left(const R& robot, double lengths, std::uint32_t stuck_expansions = 16) {
  Bench<R> bench(aisle(lengths), robot);
  bench.limits.iterations = 2000;
  bench.parameters.tuning.stuck_expansions = stuck_expansions;
  EXPECT_TRUE(bench.init().ok());
  int count = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    if (bench.solve({kParallel, kDownTheAisle, seed}) != Status::solved) continue;
    const std::vector<float> end = Path(bench.planner.plan()).states.back();
    EXPECT_LE(std::hypot(end[0] - kDownTheAisle.center().x, end[1] - kDownTheAisle.center().y), 0.3F);
    ++count;
  }
  return count;
}

TEST(PlannerDeparture, ACarLeavesASpaceThatIsHardlyLonger) {
  const Car car(reversing());
  for (const double lengths : {1.18, 1.2, 1.22, 1.25, 1.4, 1.6}) EXPECT_EQ(count_left(car, lengths), kSeeds) << lengths;
  EXPECT_LE(count_left(car, 1.25, 0), 1);
  EXPECT_LE(count_left(Unparked(), 1.25), 1);
}

TEST(PlannerDeparture, AKinematicCarDoesToo) {
  const KinematicTruck car(kinematic());
  for (const double lengths : {1.25, 1.4, 1.6}) EXPECT_EQ(count_left(car, lengths), kSeeds) << lengths;
}

TEST(PlannerDeparture, ACarBacksOutOfABay) {
  Room room;
  room.bounds = {0, 0, 12, 3.6};
  room.boxes = {{0, 2.1, 1.6, 3.6}, {2.4, 2.1, 12, 3.6}};
  room.goals = {{10.5, 0.3, 11.7, 1.5}};
  Bench<Car> bench(room, Car(reversing()));
  bench.limits.iterations = 3000;
  ASSERT_TRUE(bench.init().ok());
  const float nose_in[] = {2.0F, 2.4F, 0.5F * kPi, 0, 0};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    EXPECT_EQ(bench.solve({nose_in, Goal::named(0), seed}), Status::solved) << seed;
  }
}

// A start that moves, with turned wheels, is left as one at rest.
TEST(PlannerDeparture, ACarThatMovesStopsFirst) {
  Bench<Car> bench(aisle(1.6), Car(reversing()));
  bench.limits.iterations = 2000;
  ASSERT_TRUE(bench.init().ok());
  const float moving[] = {kSpace - kAxle, 2.11F, 0, 0.3F, 0.2F};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    EXPECT_EQ(bench.solve({moving, kDownTheAisle, seed}), Status::solved) << seed;
  }
}

TEST(PlannerDeparture, PlansDoNotDependOnHowCallsAreCut) {
  Bench<Car> whole(aisle(1.25), Car(reversing()));
  Bench<Car> cut(aisle(1.25), Car(reversing()));
  ASSERT_TRUE(whole.init().ok());
  ASSERT_TRUE(cut.init().ok());
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    ASSERT_EQ(whole.solve({kParallel, kDownTheAisle, seed}), Status::solved);
    ASSERT_EQ(cut.planner.start({kParallel, kDownTheAisle, seed}), Status::searching);
    while (cut.planner.advance(1) == Status::searching) {
    }
    EXPECT_EQ(cut.planner.statistics().hash, whole.planner.statistics().hash);
    EXPECT_EQ(cut.planner.statistics().vertices, whole.planner.statistics().vertices);
  }
}

// Neither by a query that ended while a way was driven, nor by what it had found.
TEST(PlannerDeparture, DoNotDependOnTheQueryBefore) {
  for (std::uint64_t before = 1; before <= 60; ++before) {
    Bench<Car> used(aisle(1.25), Car(reversing()));
    ASSERT_TRUE(used.init().ok());
    ASSERT_EQ(used.planner.start({kParallel, kDownTheAisle, 1}), Status::searching);
    (void)used.planner.advance(before);
    ASSERT_EQ(used.solve({kParallel, kDownTheAisle, 2}), Status::solved);
    Bench<Car> fresh(aisle(1.25), Car(reversing()));
    ASSERT_TRUE(fresh.init().ok());
    ASSERT_EQ(fresh.solve({kParallel, kDownTheAisle, 2}), Status::solved);
    EXPECT_EQ(used.planner.statistics().hash, fresh.planner.statistics().hash) << before;
  }
}

// What a search does: its expansions from vertices, and where its last step has led.
struct Watching {
  std::uint32_t* expansions;
  Vec2* last;

  void expands(Index, const Target&) const { ++*expansions; }
  void operator()(const float*, const float* to) const { *last = {to[0], to[1]}; }
};

// A search from the space whose every iteration expands from a vertex or is one of a departure.
struct Leaving : Bench<Car, detail::AdaptiveSearch> {
  Leaving() : Bench(aisle(1.25), Car(reversing())) { parameters.tuning.candidates = 0; }

  // Makes iterations until one is part of a departure, and as many more.
  void depart(std::uint32_t more) {
    ASSERT_TRUE(init().ok());
    ASSERT_EQ(planner.start({kParallel, kDownTheAisle, 1}), Status::searching);
    const Watching watch{&expansions, &last};
    std::uint32_t iterations = 0;
    for (; expansions == iterations; ++iterations) (void)planner.advance(1, watch);
    (void)planner.advance(more, watch);
    EXPECT_EQ(expansions, parameters.tuning.stuck_expansions);
  }

  std::uint32_t expansions = 0;
  Vec2 last;
};

TEST(PlannerDeparture, WaitsUntilTheTreeIsStuck) {
  for (const std::uint32_t patience : {1U, 16U, 40U}) {
    Leaving bench;
    bench.parameters.tuning.stuck_expansions = patience;
    bench.depart(0);
  }
}

// A goal on a way is reached where that passes it, and ends it.
TEST(PlannerDeparture, AGoalOnAWayEndsIt) {
  Leaving bench;
  bench.depart(3);
  bench.parameters.end_speed = kInfinity;
  bench.limits.iterations = bench.parameters.tuning.stuck_expansions + 20;
  ASSERT_TRUE(bench.init().ok());
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    EXPECT_EQ(bench.solve({kParallel, Goal::disc(bench.last, 0.005F), seed}), Status::solved) << seed;
  }
}

TEST(PlannerDeparture, AreNotThePapers) { EXPECT_EQ(Parameters::paper().tuning.stuck_expansions, 0U); }

// The tree comes away at once there, though it goes on for more expansions than it would wait.
TEST(PlannerDeparture, NothingChangesWhereThereIsRoom) {
  Statistics statistics[2];
  for (const std::uint32_t patience : {0U, 1U}) {
    Bench<Car> bench(two_rooms(), Car(reversing()));
    bench.parameters.tuning.stuck_expansions = patience;
    ASSERT_TRUE(bench.init().ok());
    const float start[] = {2, 4, 0, 0, 0};
    ASSERT_EQ(bench.solve({start, Goal::named(0), 1}), Status::solved);
    statistics[patience] = bench.planner.statistics();
  }
  EXPECT_GE(statistics[0].iterations, 5U);
  EXPECT_EQ(statistics[0].hash, statistics[1].hash);
  EXPECT_EQ(statistics[0].vertices, statistics[1].vertices);
}

// The search of a pose keeps its own ways, those into the goal, beside those from the start.
TEST(PlannerDeparture, LeadsFromOneSpaceToAnother) {
  Room room = aisle(1.4);
  const double half = 0.7 * static_cast<double>(kLength);
  room.bounds = {0, 0, 20, 2.5};
  room.boxes = {{1, 1.75, 6 - half, 2.5}, {6 + half, 1.75, 14 - half, 2.5}, {14 + half, 1.75, 19, 2.5}};
  Bench<Car> bench(room, Car(reversing()));
  bench.limits.iterations = 10'000;
  ASSERT_TRUE(bench.init().ok());
  const Goal other = Goal::pose({14 - kAxle, 2.11F}, 0.05F, 0.0F, 0.1F);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    EXPECT_EQ(bench.solve({kParallel, other, seed}), Status::solved) << seed;
  }
}

// The search goes on where the tree has no room for a way, though each of its steps is an iteration.
TEST(PlannerDeparture, ASmallTreeHasNoRoomForLegs) {
  Room room = aisle(1.25);
  room.goals = {{10.5, 0.5, 11.5, 1.1}};
  for (const std::uint32_t vertices : {8U, 20U, 60U, 200U}) {
    for (const std::uint32_t max_steps : {1U, 40U}) {
      Bench<Car> bench(room, Car(reversing()));
      bench.parameters.tuning.max_steps = max_steps;
      bench.limits.vertices = vertices;
      bench.limits.iterations = 2000;
      expect_nothing_written_outside(bench, kParallel);
      const Status ended = bench.planner.status();
      EXPECT_TRUE(ended == Status::solved || ended == Status::budget_used) << vertices << " " << to_string(ended);
    }
  }
}

// A try is not over in the middle of a way, whose iterations are one expansion of it.
TEST(PlannerDeparture, AWayIsOneExpansionOfItsTry) {
  Bench<Car> bench(aisle(1.25), Car(reversing()));
  bench.parameters.tuning.max_steps = 5;
  bench.parameters.tuning.restart_unit = 200;  // of which the tries of a short way last a tenth
  bench.limits.iterations = 3000;
  ASSERT_TRUE(bench.init().ok());
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    EXPECT_EQ(bench.solve({kParallel, kDownTheAisle, seed}), Status::solved) << seed;
  }
}

// Every other search that improves a plan begins without, since a way out that is found by chance has fewer stops.
TEST(PlannerDeparture, ABetterPlanMayDoWithout) {
  InABay bench(300);
  double first = 0;
  double better = 0;
  for (std::uint64_t seed = 10'001; seed <= 10'010; ++seed) {
    ASSERT_TRUE(bench.init().ok());
    ASSERT_EQ(bench.solve({InABay::kNoseIn, Goal::named(0), seed}), Status::solved);
    first += bench.planner.plan().steps();
    ASSERT_EQ(bench.planner.improve(30'000), Status::solved);
    better += bench.planner.plan().steps();
  }
  EXPECT_LE(better, 0.75 * first);
}

// Where the car is walled in there is no way out, and the search goes on as one that does not look for any.
TEST(PlannerDeparture, NothingChangesWhereThereIsNoWay) {
  Room room;
  room.bounds = {0, 0, 12, 4};
  room.boxes = {{0, 0, 1, 4}, {1, 0, 2.6, 1.65}, {1, 2.35, 2.6, 4}, {2.4, 1.65, 2.6, 1.85}, {2.4, 2.15, 2.6, 2.35}};
  room.goals = {{8, 1, 10, 3}};
  std::uint64_t vertices[2];
  for (const std::uint32_t patience : {0U, 16U}) {
    Bench<Car> bench(room, Car(reversing()));
    bench.parameters.tuning.stuck_expansions = patience;
    bench.parameters.tuning.prune_portals = false;
    bench.limits.iterations = 500;
    ASSERT_TRUE(bench.init().ok());
    const float start[] = {1.3F, 2, 0, 0, 0};
    ASSERT_EQ(bench.solve({start, Goal::named(0), 1}), Status::budget_used);
    vertices[patience / 16] = bench.planner.statistics().vertices;
  }
  EXPECT_EQ(vertices[0], vertices[1]);
}

class WaysOut : public ::testing::Test {
 protected:
  void find(const Room& room, const Pose& at, float short_cost = 0.0F) {
    const OpenScene open(room);
    const Car car(reversing());
    ways.find(open.scene, at, {car.body(0), kLength, kRadius, 0.001F, short_cost});
  }
  static Room beside_a_wall() {
    Room room;
    room.bounds = {0, 0, 12, 6};
    room.boxes = {{6.9, 0, 7.1, 3}};
    room.goals = {{9, 1, 11, 3}};
    return room;
  }

  static constexpr float kRadius = 1.3F;
  detail::PullOuts ways;
};

TEST_F(WaysOut, MovesAreTheSameFromEitherEnd) {
  find(aisle(1.4), {{kSpace - kAxle, 2.11F}, math::sin_cos(0.0F)});
  ASSERT_GT(ways.count(), 0);
  for (int number = 0; number < ways.moves(0); ++number) {
    const detail::Move move = ways.move(0, number);
    const detail::Move back = move.reversed();
    EXPECT_NE(back.backward, move.backward);
    for (const float share : {0.0F, 0.3F, 1.0F}) {
      const Pose one = move.at(share * move.length);
      const Pose other = back.at((1 - share) * move.length);
      EXPECT_LE(length(one.position - other.position), 1e-5F);
      EXPECT_LE(angle_between(one.heading, other.heading), 1e-5F);
    }
  }
}

TEST_F(WaysOut, LongLastArcsComeFirstWhereShortOnesAreDear) {
  const Pose at{{kSpace - kAxle, 2.11F}, math::sin_cos(0.0F)};
  const auto last = [this] { return ways.move(0, ways.moves(0) - 1).length; };
  find(aisle(1.6), at);
  const float cheapest = last();
  find(aisle(1.6), at, 5.0F);
  EXPECT_GT(last(), 1.5F * cheapest);
}

// The rear of a car swings out when it turns, the less the wider the turn is.
TEST_F(WaysOut, AreWiderBesideAWall) {
  const auto radius_with = [this](float gap) {
    find(beside_a_wall(), {{5, 0.5F * reversing().body_width + gap}, math::sin_cos(0.0F)});
    return ways.count() > 0 ? ways.move(0, ways.moves(0) - 1).radius : 0.0F;
  };
  EXPECT_EQ(radius_with(0.018F), kRadius);
  EXPECT_EQ(radius_with(0.013F), 2 * kRadius);
  EXPECT_EQ(radius_with(0.009F), 4 * kRadius);
  EXPECT_EQ(radius_with(0.005F), 0.0F);
}

}  // namespace
}  // namespace krait::test::planner_departure_test
