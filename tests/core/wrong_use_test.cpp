// SPDX-License-Identifier: Apache-2.0
// Wrong use is answered with a status, never a wrong plan: blocks, poses, parameters at their ends, robots that break
// their word.
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <new>

#include "planner_fixture.hpp"
#include "search/adaptive_search.hpp"
#include "step_oracle.hpp"

namespace krait::test::wrong_use_test {
namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kStart[] = {2, 6, 0};

std::uint32_t blame(Argument argument) { return static_cast<std::uint32_t>(argument); }

bool ended(Status status) {
  return status == Status::solved || status == Status::no_route || status == Status::budget_used ||
         status == Status::tree_full;
}

// Every number of the plan is finite and every step free, by code of the tests' own.
template <class R>
void expect_holds(const R& robot, const Scene& scene, const Plan& plan, int parts) {
  ASSERT_FALSE(plan.empty());
  const auto row = [](const float* values, int count) { return std::vector<float>(values, values + count); };
  std::uint32_t step = 0;
  for (PlanCursor at = plan.cursor(); !at.done(); at.advance()) {
    const auto state = row(at.state(), plan.state_size()), control = row(at.control(), plan.control_size());
    for (const float value : state) ASSERT_TRUE(finite(value));
    for (const float value : control) ASSERT_TRUE(finite(value));
    ASSERT_GT(separation_of_step(robot, scene, state, control, plan.dt(), parts), 0.0) << "step " << step++;
  }
}

TEST(WrongUse, ABlockOfEverySizeUpToEnough) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  bench.limits.vertices = 2;
  const std::uint64_t needed = bench.planner.bytes_required(bench.open.scene, bench.robot, bench.limits);
  std::vector<std::uint64_t> block(needed / 8 + 2, 0x5151515151515151ULL);
  const auto init = [&](std::uint64_t bytes) {
    return bench.planner.init({block.data(), bytes, &bench.open.scene, bench.robot}, bench.parameters, bench.limits);
  };
  for (std::uint64_t bytes = 0; bytes < needed; ++bytes) {
    const Failure failure = init(bytes);
    ASSERT_EQ(failure.status, Status::arena_too_small) << bytes;
    ASSERT_EQ(failure.bytes_needed, needed) << bytes;
    ASSERT_EQ(bench.planner.start({kStart}), Status::arena_too_small) << bytes;
  }
  for (const std::uint64_t word : block) ASSERT_EQ(word, 0x5151515151515151ULL) << "written before it was enough";
  EXPECT_TRUE(init(needed).ok());
  EXPECT_TRUE(init(needed + 1).ok());
  EXPECT_EQ(bench.planner.start({kStart}), Status::searching);
}

// Start-up code that clears memory and runs no constructors leaves zeros where a static planner is.
TEST(WrongUse, APlannerWhoseConstructorNeverRanPlansAsAnother) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  alignas(Planner) std::byte zeros[sizeof(Planner)] = {};
  Planner& cleared = *std::launder(reinterpret_cast<Planner*>(zeros));
  const std::uint64_t bytes = Planner::bytes_required(bench.open.scene, bench.robot, bench.limits);
  std::vector<std::uint64_t> block((bytes + 7) / 8);
  const Goal goal = Goal::pose({10, 2}, 0.2F, 1.0F, 0.2F);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    ASSERT_TRUE(bench.init().ok());
    ASSERT_EQ(bench.solve({kStart, goal, seed}), Status::solved);
    ASSERT_TRUE(
        cleared.init({block.data(), bytes, &bench.open.scene, bench.robot}, bench.parameters, bench.limits).ok());
    ASSERT_EQ(cleared.start({kStart, goal, seed}), Status::searching);
    ASSERT_EQ(cleared.advance(100'000), Status::solved);
    EXPECT_EQ(cleared.statistics().hash, bench.planner.statistics().hash) << seed;
    EXPECT_EQ(cleared.statistics().iterations, bench.planner.statistics().iterations) << seed;
  }
}

TEST(WrongUse, AFailedInitTakesNoMemoryAndALaterOneWorks) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  bench.parameters.tuning.gamma = kNan;
  ASSERT_EQ(bench.init().status, Status::bad_argument);
  EXPECT_EQ(bench.solve({kStart}), Status::bad_argument);
  bench.parameters.tuning.gamma = 50;
  ASSERT_TRUE(bench.init().ok());
  EXPECT_EQ(bench.solve({kStart}), Status::solved);
}

// At one vertex less than a search used, at exactly as many, and at one more.
TEST(WrongUse, ATreeOfOneVertexLessAndOfOneMore) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  bench.limits.expansions = 10'000;
  bench.limits.when_full = WhenFull::stop;
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.solve({kStart}), Status::solved);
  const std::uint32_t used = detail::opened(bench.planner).tree().most_vertices();
  const std::uint64_t hash = bench.planner.statistics().hash;
  for (const std::uint32_t vertices : {used - 1, used, used + 1}) {
    bench.limits.vertices = vertices;
    ASSERT_TRUE(bench.init().ok());
    const Status status = bench.solve({kStart});
    if (vertices >= used) {
      EXPECT_EQ(status, Status::solved) << vertices;
      EXPECT_EQ(bench.planner.statistics().hash, hash) << vertices;
    } else {
      EXPECT_EQ(status, Status::tree_full) << vertices;
      EXPECT_TRUE(bench.planner.plan().empty());
      EXPECT_EQ(bench.planner.advance(1000), Status::tree_full);
    }
    EXPECT_LE(detail::opened(bench.planner).tree().most_vertices(), vertices);
  }
  EXPECT_EQ(bench.solve({kStart}), Status::solved) << "a query again, after all of that";
}

// A budget that ends one expansion before the solution, at it, and after.
TEST(WrongUse, ABudgetOfOneLessAndOfOneMore) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.solve({kStart}), Status::solved);
  const std::uint64_t used = bench.planner.statistics().iterations;
  for (const std::uint64_t iterations : {used - 1, used, used + 1}) {
    bench.limits.iterations = iterations;
    ASSERT_TRUE(bench.init().ok());
    EXPECT_EQ(bench.solve({kStart}), iterations >= used ? Status::solved : Status::budget_used);
  }
}

TEST(WrongUse, ASceneThatWasNeverOpenedHoldsNoStart) {
  const Scene scene;
  const Unicycle robot = small_unicycle();
  Planner planner;
  Limits limits;
  limits.vertices = 100;
  std::vector<std::uint64_t> block(Planner::bytes_required(scene, robot, limits) / 8 + 1);
  (void)planner.init({block.data(), block.size() * 8, &scene, robot}, {}, limits);
  const float start[] = {0, 0, 0};
  for (const Goal& goal : {Goal::named(0), Goal::disc({0, 0}, 1)}) {
    (void)planner.start({start, goal});
    EXPECT_TRUE(planner.status() == Status::bad_argument || planner.status() == Status::start_outside);
    EXPECT_EQ(planner.advance(10), planner.status());
    EXPECT_TRUE(planner.plan().empty());
  }
}

// Each parameter at both ends of its range, alone: the search ends, and a plan holds.
TEST(WrongUse, ParametersAtTheEndsOfTheirRangesPlanOrEnd) {
  const std::function<void(Parameters&)> extremes[] = {
      [](Parameters& p) { p.tuning.alpha = 1; },
      [](Parameters& p) { p.tuning.alpha = 64; },
      [](Parameters& p) { p.tuning.beta = 1e-30F; },
      [](Parameters& p) { p.tuning.beta = std::nextafter(1.0F, 0.0F); },
      [](Parameters& p) { p.tuning.epsilon = 1e-38F; },
      [](Parameters& p) { p.tuning.epsilon = 1; },
      [](Parameters& p) { p.tuning.gamma = 1e-38F; },
      [](Parameters& p) { p.tuning.gamma = 1e6F; },
      [](Parameters& p) { p.tuning.cost_length = 0; },
      [](Parameters& p) { p.tuning.cost_length = 10; },
      [](Parameters& p) { p.tuning.kappa = 1; },
      [](Parameters& p) { p.tuning.kappa = 10000; },
      [](Parameters& p) { p.tuning.update_regions = 0; },
      [](Parameters& p) { p.tuning.update_regions = 1; },
      [](Parameters& p) { p.dt = 0.001F; },
      [](Parameters& p) { p.dt = 1; },
      [](Parameters& p) { p.tuning.max_steps = 1; },
      [](Parameters& p) { p.tuning.max_steps = 1000; },
      [](Parameters& p) { p.tuning.open_steps = 0; },
      [](Parameters& p) { p.tuning.open_steps = 1000; },
      [](Parameters& p) { p.tuning.path_regions = 1; },
      [](Parameters& p) { p.tuning.path_regions = 64; },
      [](Parameters& p) { p.tuning.path_lengths = 0; },
      [](Parameters& p) { p.tuning.path_lengths = 100; },
      [](Parameters& p) { p.tuning.near_radius = 0; },
      [](Parameters& p) { p.tuning.near_radius = 10; },
      [](Parameters& p) { p.tuning.goal_near_radius = 10; },
      [](Parameters& p) { p.tuning.stray_share = 1; },
      [](Parameters& p) { p.tuning.gentle_share = 1; },
      [](Parameters& p) { p.tuning.sight_tries = 0; },
      [](Parameters& p) { p.tuning.sight_tries = 64; },
      [](Parameters& p) { p.tuning.candidates = 0; },
      [](Parameters& p) { p.tuning.candidates = 8; },
      [](Parameters& p) { p.tuning.least_sketch = 0; },
      [](Parameters& p) { p.tuning.least_sketch = 20; },
      [](Parameters& p) { p.tuning.doomed_steps = 0; },
      [](Parameters& p) { p.tuning.doomed_steps = 3; },
      [](Parameters& p) { p.tuning.restart_unit = 0; },
      [](Parameters& p) { p.tuning.restart_unit = 1; },
      [](Parameters& p) { p.tuning.stuck_expansions = 0; },
      [](Parameters& p) { p.tuning.stuck_expansions = 1; },
      [](Parameters& p) { p.tuning.slowest = 0.05F; },
      [](Parameters& p) { p.tuning.slowest = 1; },
      [](Parameters& p) { p.tuning.stopping_ways = 0; },
      [](Parameters& p) { p.tuning.stopping_ways = 10; },
      [](Parameters& p) { p.tuning.reverse_share = 1; },
      [](Parameters& p) { p.clearance = 0; },
      [](Parameters& p) { p.clearance = 10; },
      [](Parameters& p) { p.tuning.max_substeps = 1; },
      [](Parameters& p) { p.tuning.max_substeps = 64; },
      [](Parameters& p) { p.goal_margin = 0; },
      [](Parameters& p) { p.goal_margin = 10; }};
  int solved = 0;
  for (std::size_t i = 0; i < std::size(extremes); ++i) {
    SCOPED_TRACE(i);
    Bench<Unicycle> bench(two_rooms(), small_unicycle());
    extremes[i](bench.parameters);
    bench.limits.iterations = 300;
    ASSERT_TRUE(bench.init().ok());
    const Status status = bench.solve({kStart});
    ASSERT_TRUE(ended(status) || status == Status::start_in_collision) << to_string(status);
    if (status != Status::solved) continue;
    ++solved;
    expect_holds(bench.robot, bench.open.scene, bench.planner.plan(), bench.parameters.dt > 0.5F ? 64 : 8);
  }
  EXPECT_GT(solved, 5);
}

// What a user's robot may do wrong, beyond x = `where`.
enum class Fault {
  none,
  derivative_nan,
  derivative_infinite,
  steer_nan,
  steer_infinite,
  steer_far_too_fast,
  place_nan,
  place_nan_heading,
  travel_nan,
  travel_infinite,
  never_within_limits
};

class Faulty : public Slider {
 public:
  Faulty(Fault fault, float where) : Slider(0.5F, 1.5F), fault_(fault), where_(where) {}

  void derivative(StateView s, ControlView u, StateRef ds) const {
    Slider::derivative(s, u, ds);
    if (at(s, Fault::derivative_nan)) ds[1] = kNan;
    if (at(s, Fault::derivative_infinite)) ds[0] = kInfinity;
  }
  void steer(StateView s, const Target& target, Steering& steering, ControlRef u) const {
    Slider::steer(s, target, steering, u);
    if (at(s, Fault::steer_nan)) u[0] = kNan;
    if (at(s, Fault::steer_infinite)) u[1] = -kInfinity;
    if (at(s, Fault::steer_far_too_fast)) u[0] = 100.0F;
  }
  bool within_limits(StateView s) const { return !at(s, Fault::never_within_limits) && Slider::within_limits(s); }
  void place(StateView s, Pose* poses) const {
    Slider::place(s, poses);
    if (at(s, Fault::place_nan)) poses[0].position.x = kNan;
    if (at(s, Fault::place_nan_heading)) poses[0].heading = {kNan, kNan};
  }
  bool travel(StateView s, ControlView u, float dt, StateView next, Travel* travel) const {
    const bool proven = Slider::travel(s, u, dt, next, travel);
    if (at(s, Fault::travel_nan)) travel[0] = {kNan, kNan, kNan, kNan};
    if (at(s, Fault::travel_infinite)) travel[0] = {kInfinity, kInfinity, kInfinity, kInfinity};
    return proven;
  }

 private:
  bool at(StateView s, Fault fault) const { return fault_ == fault && s[0] > where_; }

  Fault fault_;
  float where_;
};

// Where a fault begins at the wall, no plan leads through; where it is none, one does.
TEST(WrongUse, ARobotThatBreaksItsWordGetsNoPlanThroughTheFault) {
  for (int fault = 0; fault <= static_cast<int>(Fault::never_within_limits); ++fault) {
    SCOPED_TRACE(fault);
    Bench<Faulty> bench(two_rooms(), Faulty(static_cast<Fault>(fault), 5.0F));
    bench.limits.iterations = 500;
    ASSERT_TRUE(bench.init().ok());
    const float start[] = {2, 6};
    const Status status = bench.solve({start});
    if (static_cast<Fault>(fault) == Fault::none) {
      EXPECT_EQ(status, Status::solved);
    } else if (static_cast<Fault>(fault) == Fault::steer_far_too_fast) {
      EXPECT_TRUE(ended(status));  // its travel grows with its control: what is proven is proven
    } else {
      EXPECT_TRUE(status == Status::budget_used || status == Status::tree_full) << to_string(status);
    }
    const Plan plan = bench.planner.plan();
    if (plan.empty()) continue;
    for (PlanCursor at = plan.cursor(); !at.done(); at.advance()) {
      ASSERT_TRUE(finite(Vec2{at.state()[0], at.state()[1]}));
    }
  }
}

TEST(WrongUse, ARobotThatIsFaultyAtTheStartCannotStart) {
  for (const Fault fault : {Fault::place_nan, Fault::place_nan_heading}) {
    Bench<Faulty> bench(two_rooms(), Faulty(fault, 0.0F));
    ASSERT_TRUE(bench.init().ok());
    const float start[] = {2, 6};
    EXPECT_EQ(bench.planner.start({start}), Status::start_in_collision);
  }
  Bench<Faulty> bench(two_rooms(), Faulty(Fault::never_within_limits, 0.0F));
  ASSERT_TRUE(bench.init().ok());
  const float start[] = {2, 6};
  EXPECT_EQ(bench.planner.start({start}), Status::bad_argument);
}

// A robot whose body is whatever it is given.
class Shaped : public Slider {
 public:
  explicit Shaped(std::vector<Vec2> vertices) : Slider(0.5F, 1.5F), vertices_(std::move(vertices)) {}
  Polygon body(int) const { return {vertices_.data(), static_cast<int>(vertices_.size())}; }

 private:
  std::vector<Vec2> vertices_;
};

std::vector<Vec2> regular(int corners) {
  std::vector<Vec2> vertices;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307 * i / corners;
    vertices.push_back({static_cast<float>(0.3 * std::cos(angle)), static_cast<float>(0.3 * std::sin(angle))});
  }
  return vertices;
}

TEST(WrongUse, ADegenerateBodyIsRefused) {
  std::vector<Vec2> clockwise = regular(5);
  std::reverse(clockwise.begin(), clockwise.end());
  const std::vector<Vec2> bodies[] = {{},
                                      {{0, 0}},
                                      {{0, 0}, {1, 0}},
                                      {{0, 0}, {1, 0}, {2, 0}},
                                      {{0, 0}, {1, 0}, {1, 0}, {0, 1}},
                                      {{0, 0}, {1, 0}, {0.2F, 0.2F}, {0, 1}},
                                      {{0, 3}, {-2, -3}, {3, 1}, {-3, 1}, {2, -3}},
                                      {{0, 0}, {kNan, 0}, {0, 1}},
                                      {{0, 0}, {kInfinity, 0}, {0, 1}},
                                      {{0, 0}, {200, 0}, {0, 1}},
                                      {{0, 0}, {1e-5F, 0}, {0, 1e-5F}},
                                      clockwise,
                                      regular(9)};
  for (std::size_t i = 0; i < std::size(bodies); ++i) {
    Bench<Shaped> bench(two_rooms(), Shaped(bodies[i]));
    const Failure failure = bench.init(1'000'000);
    EXPECT_EQ(failure.status, Status::bad_robot) << i;
    EXPECT_EQ(failure.element, blame(Argument::robot_polygon)) << i;
    const float start[] = {2, 6};
    EXPECT_EQ(bench.planner.start({start}), Status::bad_robot) << i;
  }
  Bench<Shaped> bench(two_rooms(), Shaped(regular(8)));
  EXPECT_TRUE(bench.init().ok());
}

// NaN and infinity in every component of every robot's start.
template <class R>
void expect_bad_starts(const R& robot) {
  Bench<R> bench(two_rooms(), robot);
  bench.limits.vertices = 100;
  ASSERT_TRUE(bench.init().ok());
  for (int i = 0; i < robot.state_size(); ++i) {
    for (const float bad : {kNan, kInfinity, -kInfinity, 3e38F}) {
      std::vector<float> start(static_cast<std::size_t>(robot.state_size()), 0.0F);
      start[0] = 2;
      start[1] = 6;
      start[static_cast<std::size_t>(i)] = bad;
      (void)bench.planner.start({start.data()});
      const Status status = bench.planner.status();
      EXPECT_TRUE(status == Status::bad_argument || (i < 2 && status == Status::start_outside))
          << i << " " << bad << " " << to_string(status);
      EXPECT_EQ(bench.planner.advance(5), status);
    }
  }
}

template <class R>
class WrongStart : public ::testing::Test {};
TYPED_TEST_SUITE(WrongStart, Models, ModelNames);

TYPED_TEST(WrongStart, IsRefusedWithANumberThatIsNone) { expect_bad_starts(small_robot<TypeParam>()); }

TEST(WrongUse, GoalsAtTheEndsOfAllNumbersEnd) {
  for (const float radius : {1e-38F, 1e-4F, 1e4F, 3e38F}) {
    Bench<Unicycle> bench(two_rooms(), small_unicycle());
    bench.limits.iterations = 50;
    ASSERT_TRUE(bench.init().ok());
    const Status status = bench.solve({kStart, Goal::disc({10, 6}, radius)});
    const bool refused = status == Status::bad_argument;
    EXPECT_TRUE(refused || (radius > 1 ? status == Status::solved : ended(status)))
        << radius << " " << to_string(status);
  }
}

}  // namespace
}  // namespace krait::test::wrong_use_test
