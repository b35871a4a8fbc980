// SPDX-License-Identifier: Apache-2.0
// improve: plans only get better, whatever the calls; every plan is driven and proven; memory and misuse.
#include <algorithm>

#include "planner_fixture.hpp"
#include "robot_oracle.hpp"
#include "search/adaptive_search.hpp"

namespace krait::test {
namespace {

constexpr std::uint32_t kLegs = 64;

// Three walls with doors at their ends, so that first plans wind.
Room winding() {
  Room room;
  room.bounds = {0, 0, 16, 8};
  room.boxes = {{4, 0, 4.25, 5.5}, {8, 2.5, 8.25, 8}, {12, 0, 12.25, 5.5}};
  room.goals = {{13.5, 0.5, 15.5, 2.5}, {0.5, 0.5, 3, 3}};
  return room;
}

Car small_car() {
  ChainParameters p = Car::defaults();
  p.body_length = 0.6F;
  p.body_width = 0.3F;
  p.wheelbase = 0.4F;
  return Car(p);
}

template <class R>
std::vector<float> start_of(const R& robot) {
  std::vector<float> state(static_cast<std::size_t>(robot.state_size()));
  if constexpr (std::is_base_of_v<Chain, R>) {
    robot.rest({2, 2}, 0.0F, nullptr, state.data());
  } else {
    robot.rest({2, 2}, 0.0F, state.data());
  }
  return state;
}

// A planner with a first plan in the winding room.
template <class R>
struct Solved : Bench<R> {
  explicit Solved(const R& r, std::uint64_t seed = 1, std::uint32_t legs = kLegs) : Bench<R>(winding(), r) {
    this->limits.way_legs = legs;
    EXPECT_TRUE(this->init().ok());
    start = start_of(r);
    EXPECT_EQ(this->solve({start.data(), Goal::named(0), seed}), Status::solved);
  }
  std::vector<float> start;
};

bool same(const Statistics& a, const Statistics& b) {
  return a.hash == b.hash && a.plan_steps == b.plan_steps && a.improvements == b.improvements &&
         a.collision_checks == b.collision_checks;
}

TEST(Improve, PlansOnlyGetBetterAndDo) {
  int better = 0;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Solved<Car> bench(small_car(), seed);
    std::uint32_t steps = bench.planner.plan().steps();
    std::uint64_t improvements = 0;
    for (int i = 0; i < 1500; ++i) {
      ASSERT_EQ(bench.planner.improve(1), Status::solved);
      const Plan plan = bench.planner.plan();
      const Statistics statistics = bench.planner.statistics();
      const bool found = statistics.improvements > improvements;
      improvements = statistics.improvements;
      ASSERT_TRUE(found ? plan.steps() < steps : plan.steps() == steps);
      steps = plan.steps();
      if (!found) continue;
      ++better;
      EXPECT_EQ(statistics.plan_steps, plan.steps());
      EXPECT_EQ(statistics.plan_duration, plan.duration());
      EXPECT_EQ(statistics.plan_length, plan.length());
      EXPECT_EQ(statistics.hash, plan.hash());
    }
  }
  EXPECT_GE(better, 3);
}

template <class R>
void expect_independent_of_cuts(const R& robot) {
  Solved<R> whole(robot);
  Solved<R> single(robot);
  Solved<R> mixed(robot);
  EXPECT_EQ(whole.planner.improve(600), Status::solved);
  for (int i = 0; i < 600; ++i) EXPECT_EQ(single.planner.improve(1), Status::solved);
  for (int i = 0; i < 600;) {
    const int cut = i % 7 + 1 < 600 - i ? i % 7 + 1 : 600 - i;
    EXPECT_EQ(mixed.planner.improve(static_cast<std::uint64_t>(cut)), Status::solved);
    i += cut;
  }
  EXPECT_GT(whole.planner.statistics().improvements, 0U);
  EXPECT_TRUE(same(whole.planner.statistics(), single.planner.statistics()));
  EXPECT_TRUE(same(whole.planner.statistics(), mixed.planner.statistics()));
  EXPECT_EQ(whole.planner.plan().hash(), single.planner.plan().hash());
}

TEST(ImproveCalls, ThePlanDoesNotDependOnHowTheyAreCut) {
  expect_independent_of_cuts(small_car());
  expect_independent_of_cuts(small_unicycle());
  expect_independent_of_cuts(Truck(small_chain(2)));
}

// A planner that has improved before is as a fresh one.
TEST(ImproveCalls, TheNextStartForgetsThem) {
  Solved<Car> used(small_car(), 5);
  EXPECT_EQ(used.planner.improve(700), Status::solved);
  ASSERT_GT(used.planner.statistics().improvements, 0U);
  Solved<Car> fresh(small_car(), 2);
  ASSERT_EQ(used.solve({used.start.data(), Goal::named(0), 2}), Status::solved);
  EXPECT_EQ(used.planner.statistics().improvements, 0U);
  EXPECT_EQ(used.planner.plan().hash(), fresh.planner.plan().hash());
  EXPECT_EQ(used.planner.improve(700), Status::solved);
  EXPECT_EQ(fresh.planner.improve(700), Status::solved);
  EXPECT_TRUE(same(used.planner.statistics(), fresh.planner.statistics()));
}

// Whether a line along an edge of the body or a side of the box keeps them apart.
bool apart(const std::vector<Numbers>& body, const Rect& box) {
  const std::vector<Numbers> corners = {{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}};
  std::vector<Numbers> axes = {{1, 0}, {0, 1}};
  for (std::size_t i = 0; i < body.size(); ++i) {
    const Numbers& next = body[(i + 1) % body.size()];
    axes.push_back({next[1] - body[i][1], body[i][0] - next[0]});
  }
  const auto reach = [](const std::vector<Numbers>& points, const Numbers& axis) {
    std::pair<double, double> range{1e9, -1e9};
    for (const Numbers& p : points) {
      const double along = axis[0] * p[0] + axis[1] * p[1];
      range = {std::min(range.first, along), std::max(range.second, along)};
    }
    return range;
  };
  return std::any_of(axes.begin(), axes.end(), [&](const Numbers& axis) {
    const auto a = reach(body, axis);
    const auto b = reach(corners, axis);
    return a.second < b.first || b.second < a.first;
  });
}

// The plan's controls alone, from the start, in double precision and fine steps: the robot meets its plan's states and
// no wall, and ends in the goal.
template <class R>
void expect_sound(const Solved<R>& bench, const Path& path) {
  ASSERT_EQ(path.states.front(), bench.start);
  constexpr int kParts = 10;
  Numbers state(bench.start.begin(), bench.start.end());
  for (std::size_t i = 0; i < path.controls.size(); ++i) {
    const Numbers control(path.controls[i].begin(), path.controls[i].end());
    for (int part = 0; part < kParts; ++part) {
      state = rk4(bench.robot, state, control, wide(bench.parameters.dt) / kParts);
      const std::vector<Numbers> body = vertices(bench.robot.body(0), frames(bench.robot, state)[0]);
      for (const Rect& box : winding().boxes) ASSERT_TRUE(apart(body, box)) << "step " << i;
    }
    for (std::size_t k = 0; k < state.size(); ++k) {
      ASSERT_NEAR(wide(path.states[i + 1][k]), state[k], 1e-3) << "step " << i << ", component " << k;
    }
  }
  const Rect goal = winding().goals[0];
  EXPECT_TRUE(state[0] > goal.x0 && state[0] < goal.x1 && state[1] > goal.y0 && state[1] < goal.y1);
}

TEST(ImproveProof, EveryBetterPlanIsSound) {
  for (const std::uint64_t seed : {1U, 2U}) {
    Solved<Car> bench(small_car(), seed);
    for (std::uint64_t found = 0; found < 3;) {
      EXPECT_EQ(bench.planner.improve(1), Status::solved);
      if (bench.planner.statistics().improvements == found) continue;
      ++found;
      expect_sound(bench, Path(bench.planner.plan()));
    }
  }
}

TEST(ImproveMemory, IsPartOfTheBytesRequired) {
  Bench<Car> bench(winding(), small_car());
  const auto without = bench.planner.bytes_required(bench.open.scene, bench.robot, bench.limits);
  bench.limits.way_legs = kLegs;
  const auto with = bench.planner.bytes_required(bench.open.scene, bench.robot, bench.limits);
  // Three ways of 20 bytes a leg, two of them with a state for every 16 legs and one more, each padded to 8 bytes, two
  // routes of 64 vias, and two lines of 256 points.
  constexpr std::uint64_t kStates = (5 * 4 * (kLegs / 16 + 1) + 7) / 8 * 8;
  EXPECT_EQ(with - without, 3 * 20 * kLegs + 2 * kStates + 2 * 64 * 20 + 2 * 256 * 8);
  const Failure failure = bench.init(with - 1);
  EXPECT_EQ(failure.status, Status::arena_too_small);
  EXPECT_EQ(failure.bytes_needed, with);
  EXPECT_TRUE(bench.init(with).ok());
  EXPECT_EQ(detail::opened(bench.planner).arena().needed(detail::Pool::improvement), with - without);
}

TEST(ImproveMemory, LimitsForLeaveRoomForIt) {
  const OpenScene open(winding());
  const Car car = small_car();
  const Limits limits = Planner::limits_for(60'000, open.scene, car, kLegs);
  EXPECT_EQ(limits.way_legs, kLegs);
  EXPECT_LE(Planner::bytes_required(open.scene, car, limits), 60'000U);
  EXPECT_LT(limits.vertices, Planner::limits_for(60'000, open.scene, car).vertices);
}

TEST(ImproveMemory, NothingOutsideTheBlockIsWritten) {
  Bench<Car> bench(winding(), small_car());
  bench.limits.vertices = 1000;
  bench.limits.way_legs = 16;  // legs are longer then
  const auto needed = bench.planner.bytes_required(bench.open.scene, bench.robot, bench.limits);
  std::vector<std::uint64_t> block(needed / 8 + 64, 0x5151515151515151ULL);
  ASSERT_TRUE(
      bench.planner.init({block.data() + 32, needed, &bench.open.scene, bench.robot}, bench.parameters, bench.limits)
          .ok());
  const std::vector<float> start = start_of(bench.robot);
  ASSERT_EQ(bench.solve({start.data(), Goal::named(0), 3}), Status::solved);
  EXPECT_EQ(bench.planner.improve(3000), Status::solved);
  for (std::size_t i = 0; i < 32; ++i) {
    ASSERT_EQ(block[i], 0x5151515151515151ULL);
    ASSERT_EQ(block[32 + needed / 8 + i], 0x5151515151515151ULL);
  }
}

TEST(ImproveMisuse, WithoutRoomItIsRefusedAndThePlanStays) {
  Solved<Car> bench(small_car(), 1, 0);
  const std::uint64_t hash = bench.planner.plan().hash();
  EXPECT_EQ(bench.planner.improve(100), Status::bad_argument);
  EXPECT_EQ(bench.planner.status(), Status::solved);
  EXPECT_EQ(bench.planner.plan().hash(), hash);
}

TEST(ImproveMisuse, BeforeThereIsAPlanNothingHappens) {
  Bench<Car> bench(winding(), small_car());
  EXPECT_EQ(bench.planner.improve(10), Status::bad_argument);
  bench.limits.way_legs = kLegs;
  ASSERT_TRUE(bench.init().ok());
  EXPECT_EQ(bench.planner.improve(10), Status::ready);
  const std::vector<float> start = start_of(bench.robot);
  ASSERT_EQ(bench.planner.start({start.data(), Goal::named(0), 1}), Status::searching);
  const std::uint64_t checks = bench.planner.statistics().collision_checks;
  EXPECT_EQ(bench.planner.improve(10), Status::searching);
  EXPECT_EQ(bench.planner.statistics().collision_checks, checks);
  EXPECT_EQ(bench.planner.advance(1'000'000), Status::solved);
}

TEST(ImproveMisuse, APlanWithoutStepsIsTheBest) {
  Solved<Car> bench(small_car());
  ASSERT_EQ(bench.solve({bench.start.data(), Goal::named(1), 1}), Status::solved);
  EXPECT_EQ(bench.planner.improve(100), Status::solved);
  EXPECT_EQ(bench.planner.plan().steps(), 0U);
  EXPECT_EQ(bench.planner.statistics().improvements, 0U);
}

TEST(ImproveMisuse, LegsHaveARange) {
  Bench<Car> bench(winding(), small_car());
  for (const std::uint32_t legs : {1U, 15U, 1'000'001U}) {
    bench.limits.way_legs = legs;
    EXPECT_EQ(bench.limits.first_bad(), Argument::way_legs) << legs;
  }
  for (const std::uint32_t legs : {0U, 16U, 1'000'000U}) {
    bench.limits.way_legs = legs;
    EXPECT_EQ(bench.limits.first_bad(), Argument::none) << legs;
  }
}

}  // namespace
}  // namespace krait::test
