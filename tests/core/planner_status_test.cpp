// SPDX-License-Identifier: Apache-2.0
// Every answer of a planner is reached here, and says what it should.
#include <cmath>
#include <functional>
#include <limits>

#include "planner_fixture.hpp"
#include "search/adaptive_search.hpp"

namespace krait::test::planner_status_test {
namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kStart[] = {2, 6, 0};

std::uint32_t blame(Argument argument) { return static_cast<std::uint32_t>(argument); }

class PlannerStatus : public ::testing::Test {
 protected:
  using TestBench = Bench<Unicycle>;

  // What start says of a query in the room.
  static Failure answer_to(const Room& room, const Query& query) {
    TestBench bench(room, small_unicycle());
    EXPECT_TRUE(bench.init().ok());
    (void)bench.planner.start(query);
    EXPECT_EQ(bench.planner.statistics().iterations, 0U);
    EXPECT_TRUE(bench.planner.plan().empty() || bench.planner.status() == Status::solved);
    return bench.planner.failure();
  }
};

TEST_F(PlannerStatus, Solved) {
  TestBench bench(two_rooms(), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.planner.start({kStart}), Status::searching);
  EXPECT_TRUE(bench.planner.plan().empty());
  ASSERT_EQ(bench.planner.advance(1'000'000), Status::solved);
  EXPECT_FALSE(bench.planner.plan().empty());
  EXPECT_GT(bench.planner.statistics().iterations, 0U);
  EXPECT_GT(bench.planner.statistics().plan_steps, 10U);
  EXPECT_NE(bench.planner.statistics().hash, 0U);
}

TEST_F(PlannerStatus, SolvedWithoutAStepWhenTheStartIsInTheGoal) {
  TestBench bench(two_rooms(), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  const float start[] = {10.5F, 6.5F, 0};
  EXPECT_EQ(bench.planner.start({start}), Status::solved);
  EXPECT_EQ(bench.planner.plan().steps(), 0U);
  EXPECT_FALSE(bench.planner.plan().empty());
  EXPECT_TRUE(bench.planner.plan().cursor().done());
  EXPECT_EQ(bench.planner.plan().cursor().state()[0], 10.5F);
  EXPECT_EQ(bench.planner.plan().length(), 0.0F);
  EXPECT_NE(bench.planner.statistics().hash, 0U);
  EXPECT_EQ(bench.planner.statistics().iterations, 0U);
  EXPECT_EQ(bench.planner.advance(10), Status::solved);
  EXPECT_EQ(bench.planner.start({start, Goal::disc({10, 6}, 1)}), Status::solved);
}

TEST_F(PlannerStatus, NoRouteAtOnceThroughAWall) {
  EXPECT_EQ(answer_to(two_rooms(0), {kStart}).status, Status::no_route);
  EXPECT_EQ(answer_to(two_rooms(0), {kStart, Goal::disc({10, 2}, 0.5F)}).status, Status::no_route);
}

TEST_F(PlannerStatus, NoRouteAtOnceThroughADoorNarrowerThanTheRobot) {
  EXPECT_EQ(answer_to(two_rooms(0.3), {kStart}).status, Status::no_route);
  EXPECT_EQ(answer_to(two_rooms(0.6), {kStart}).status, Status::searching);
}

TEST_F(PlannerStatus, BudgetUsed) {
  TestBench bench(two_rooms(), small_unicycle());
  bench.limits.iterations = 3;
  bench.parameters.tuning.max_steps = 2;
  ASSERT_TRUE(bench.init().ok());
  EXPECT_EQ(bench.solve({kStart}), Status::budget_used);
  EXPECT_EQ(bench.planner.statistics().iterations, 3U);
  EXPECT_TRUE(bench.planner.plan().empty());
  EXPECT_EQ(bench.planner.statistics().hash, 0U);
}

TEST_F(PlannerStatus, TreeFullOfVertices) {
  TestBench bench(two_rooms(), small_unicycle());
  bench.limits.when_full = WhenFull::stop;
  for (const std::uint32_t vertices : {2U, 3U, 20U}) {
    bench.limits.vertices = vertices;
    bench.limits.expansions = 1000;
    ASSERT_TRUE(bench.init().ok());
    EXPECT_EQ(bench.solve({kStart}), Status::tree_full);
    EXPECT_EQ(detail::opened(bench.planner).tree().vertices(), vertices);
    EXPECT_EQ(bench.planner.statistics().recycled, 0U);
    EXPECT_TRUE(bench.planner.plan().empty());
  }
}

TEST_F(PlannerStatus, TreeFullOfExpansions) {
  TestBench bench(two_rooms(), small_unicycle());
  bench.limits.when_full = WhenFull::stop;
  bench.parameters.tuning.max_steps = 2;
  for (const std::uint32_t expansions : {2U, 3U, 9U}) {
    bench.limits.expansions = expansions;
    ASSERT_TRUE(bench.init().ok());
    EXPECT_EQ(bench.solve({kStart}), Status::tree_full);
    EXPECT_EQ(detail::opened(bench.planner).tree().expansions(), expansions);
    EXPECT_TRUE(bench.planner.plan().empty());
  }
}

TEST_F(PlannerStatus, SolvesAfterTreeFullWithMoreMemory) {
  TestBench bench(two_rooms(), small_unicycle());
  bench.limits.when_full = WhenFull::stop;
  bench.limits.vertices = 20;
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.solve({kStart}), Status::tree_full);
  bench.limits.vertices = 20'000;
  ASSERT_TRUE(bench.init().ok());
  EXPECT_EQ(bench.solve({kStart}), Status::solved);
}

TEST_F(PlannerStatus, TimeUsedWhenThePortSaysSo) {
  TestBench bench(two_rooms(), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.planner.start({kStart}), Status::searching);
  bench.planner.stop_for_time();
  EXPECT_EQ(bench.planner.status(), Status::time_used);
  EXPECT_EQ(bench.planner.advance(100), Status::time_used);
  EXPECT_EQ(bench.solve({kStart}), Status::solved);
  bench.planner.stop_for_time();
  EXPECT_EQ(bench.planner.status(), Status::solved);
}

TEST_F(PlannerStatus, AdvanceAfterTheEndChangesNothing) {
  TestBench bench(two_rooms(), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.solve({kStart}), Status::solved);
  const Statistics before = bench.planner.statistics();
  for (int i = 0; i < 10; ++i) ASSERT_EQ(bench.planner.advance(100), Status::solved);
  const Statistics after = bench.planner.statistics();
  EXPECT_EQ(after.iterations, before.iterations);
  EXPECT_EQ(after.vertices, before.vertices);
  EXPECT_EQ(bench.planner.plan().hash(), before.hash);
}

TEST_F(PlannerStatus, StartOutside) {
  for (const Vec2 at : {Vec2{-1, 4}, Vec2{13, 4}, Vec2{6, -0.001F}, Vec2{6, 1e30F}}) {
    const float start[] = {at.x, at.y, 0};
    EXPECT_EQ(answer_to(two_rooms(), {start}).status, Status::start_outside);
  }
}

TEST_F(PlannerStatus, StartInCollision) {
  for (const Vec2 at : {Vec2{6.1F, 1}, Vec2{5.9F, 1}, Vec2{0.1F, 4}, Vec2{4, 7.9F}}) {  // in, at, at the bounds
    const float start[] = {at.x, at.y, 0};
    EXPECT_EQ(answer_to(two_rooms(), {start}).status, Status::start_in_collision) << at.x << " " << at.y;
  }
}

TEST_F(PlannerStatus, GoalInObstacle) {
  EXPECT_EQ(answer_to(two_rooms(), {kStart, Goal::named(1)}).status, Status::goal_in_obstacle);
  EXPECT_EQ(answer_to(two_rooms(), {kStart, Goal::disc({6.125F, 1}, 0.1F)}).status, Status::goal_in_obstacle);
}

TEST_F(PlannerStatus, BadGoals) {
  for (const Goal& goal : {Goal::named(3), Goal::named(kNone), Goal::disc({-1, 4}, 1), Goal::disc({4, 4}, 0),
                           Goal::disc({4, kNan}, 1), Goal::disc({4, 4}, kInfinity)}) {
    const Failure failure = answer_to(two_rooms(), {kStart, goal});
    EXPECT_EQ(failure.status, Status::bad_argument);
    EXPECT_EQ(failure.element, blame(Argument::goal));
  }
}

TEST_F(PlannerStatus, BadStarts) {
  const auto expect_bad = [&](const float* start) {
    const Failure failure = answer_to(two_rooms(), {start});
    EXPECT_EQ(failure.status, Status::bad_argument);
    EXPECT_EQ(failure.element, blame(Argument::start));
  };
  expect_bad(nullptr);
  for (std::size_t i = 0; i < 3; ++i) {
    for (const float bad : {kNan, kInfinity, -kInfinity}) {
      float start[] = {2, 6, 0};
      start[i] = bad;
      expect_bad(start);
    }
  }
  const float dizzy[] = {2, 6, 1e30F};
  expect_bad(dizzy);
}

TEST_F(PlannerStatus, SceneNotOpened) {
  const Scene scene;
  const Unicycle robot = small_unicycle();
  alignas(Setup::kAlignment) std::byte block[1000];
  decltype(TestBench::planner) planner;
  const Failure failure = planner.init({block, sizeof block, &scene, robot});
  EXPECT_EQ(failure.status, Status::bad_argument);
  EXPECT_EQ(failure.element, blame(Argument::scene));
  EXPECT_EQ(planner.start({kStart}), Status::bad_argument);
}

TEST_F(PlannerStatus, SetupThatIsEmpty) {
  const OpenScene open(two_rooms());
  const Unicycle robot = small_unicycle();
  decltype(TestBench::planner) planner;
  const auto expect_bad = [&](const krait::Setup& setup, Status status, Argument argument) {
    const Failure failure = planner.init(setup);
    EXPECT_EQ(failure.status, status);
    EXPECT_EQ(failure.element, blame(argument));
    EXPECT_EQ(planner.start({kStart}), status);
  };
  expect_bad({}, Status::bad_argument, Argument::scene);
  expect_bad({nullptr, 0, nullptr, robot}, Status::bad_argument, Argument::scene);
  expect_bad({nullptr, 0, &open.scene, {}}, Status::bad_robot, Argument::robot_sizes);
  expect_bad({nullptr, 1'000'000, &open.scene, robot}, Status::bad_argument, Argument::block);
}

// The bytes change under the planner, or the scene becomes a view of others.
TEST_F(PlannerStatus, ASceneThatIsNoLongerThatOfInit) {
  TestBench bench(two_rooms(), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.solve({kStart}), Status::solved);
  const auto expect_bad = [&](const char* what) {
    EXPECT_EQ(bench.planner.start({kStart}), Status::bad_scene) << what;
    EXPECT_EQ(bench.planner.failure().section, Scene::kHeaderSection);
    EXPECT_EQ(bench.planner.failure().element, offsetof(format::Header, crc32));
    EXPECT_TRUE(bench.planner.plan().empty());
    EXPECT_EQ(bench.planner.advance(10), Status::bad_scene);
  };
  SceneBytes& bytes = bench.open.bytes;
  const SceneBytes sound = bytes;
  const std::size_t run = bytes.size() / 256 + 8;
  for (std::size_t first = 0; first < bytes.size(); first += run / 2) {
    const std::size_t end = std::min(first + run, bytes.size());
    for (std::size_t i = end - std::min(run, end); i < end; ++i)
      bytes.put(i, static_cast<std::uint8_t>(~bytes.data()[i]));
    expect_bad("a run of bytes");
    std::copy_n(sound.data(), sound.size(), bytes.data());
  }
  const Scene scene = bench.open.scene;
  const OpenScene larger(two_rooms(3));
  bench.open.scene = larger.scene;
  expect_bad("another view");
  bench.open.scene = Scene();
  expect_bad("no view");
  bench.open.scene = scene;
  EXPECT_EQ(bench.solve({kStart}), Status::solved);
}

// Another file of the same length differs in its check sum at least.
TEST_F(PlannerStatus, ASceneThatAnotherOneOfItsLengthReplaced) {
  TestBench bench(two_rooms(), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  SceneData data = data_of(two_rooms());
  data.names[0].back() ^= 1;
  const SceneBytes other = data.bytes();
  ASSERT_EQ(other.size(), bench.open.bytes.size());
  std::copy_n(other.data(), other.size(), bench.open.bytes.data());
  EXPECT_EQ(bench.planner.start({kStart}), Status::bad_scene);
}

TEST_F(PlannerStatus, BadRobot) {
  UnicycleParameters p;
  p.max_speed = kNan;
  TestBench bench(two_rooms(), Unicycle(p));
  const Failure failure = bench.init(1'000'000);
  EXPECT_EQ(failure.status, Status::bad_robot);
  EXPECT_EQ(failure.element, blame(Argument::robot_dimensions));
}

TEST_F(PlannerStatus, BadLimits) {
  const auto expect_bad = [](const Limits& limits, Argument argument) {
    TestBench bench(two_rooms(), small_unicycle());
    bench.limits = limits;
    const Failure failure = bench.init(1'000'000);
    EXPECT_EQ(failure.status, Status::bad_argument);
    EXPECT_EQ(failure.element, blame(argument));
  };
  Limits limits;
  for (const std::uint32_t bad : {1U, detail::MotionTree::kMostExpansions + 1, 0xFFFFFFFFU}) {
    limits.vertices = bad;
    expect_bad(limits, Argument::vertices);
  }
  limits.vertices = 2;
  for (const std::uint32_t bad : {1U, detail::MotionTree::kMostExpansions + 1, 0xFFFFFFFFU}) {
    limits.expansions = bad;
    expect_bad(limits, Argument::expansions);
  }
  limits.expansions = 2;
  limits.iterations = 0;
  expect_bad(limits, Argument::iterations);
}

TEST_F(PlannerStatus, BeforeInitAndStartNothingIsSolved) {
  TestBench bench(two_rooms(), small_unicycle());
  EXPECT_EQ(bench.planner.status(), Status::bad_argument);
  EXPECT_EQ(bench.planner.advance(10), Status::bad_argument);
  EXPECT_EQ(bench.planner.start({kStart}), Status::bad_argument);
  EXPECT_TRUE(bench.planner.plan().empty());
  EXPECT_EQ(bench.planner.plan().steps(), 0U);
  EXPECT_EQ(bench.planner.plan().hash(), 0U);
  ASSERT_TRUE(bench.init().ok());
  EXPECT_EQ(bench.planner.advance(10), Status::ready);
  EXPECT_TRUE(bench.planner.plan().empty());
}

TEST_F(PlannerStatus, BeforeInitNothingIsCounted) {
  const TestBench bench(two_rooms(), small_unicycle());
  const Statistics statistics = bench.planner.statistics();
  EXPECT_EQ(statistics.iterations, 0U);
  EXPECT_EQ(statistics.vertices, 0U);
  EXPECT_EQ(statistics.bytes_given, 0U);
  EXPECT_EQ(statistics.bytes_used, 0U);
}

TEST_F(PlannerStatus, ALaterInitCountsNothingOfTheSearchBefore) {
  TestBench bench(two_rooms(), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.solve({kStart}), Status::solved);
  TestBench fresh(two_rooms(), small_unicycle());
  for (const std::uint32_t vertices : {2U, 20'000U}) {
    fresh.limits.vertices = bench.limits.vertices = vertices;
    ASSERT_TRUE(fresh.init().ok());
    ASSERT_TRUE(bench.init().ok());
    EXPECT_EQ(bench.planner.statistics().bytes_used, fresh.planner.statistics().bytes_used) << vertices;
    EXPECT_LE(bench.planner.statistics().bytes_used, bench.planner.statistics().bytes_given) << vertices;
    EXPECT_EQ(bench.planner.statistics().collision_checks, 0U) << vertices;
  }
}

TEST_F(PlannerStatus, StartAfterAFailedInitGivesItsAnswerAgain) {
  TestBench bench(two_rooms(), small_unicycle());
  ASSERT_EQ(bench.init(1000).status, Status::arena_too_small);
  EXPECT_EQ(bench.planner.start({kStart}), Status::arena_too_small);
  EXPECT_GT(bench.planner.failure().bytes_needed, 1000U);
  EXPECT_EQ(bench.planner.advance(10), Status::arena_too_small);
}

TEST_F(PlannerStatus, AFailedStartHasNoPlanOfTheSearchBefore) {
  TestBench bench(two_rooms(), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.solve({kStart}), Status::solved);
  EXPECT_EQ(bench.planner.start({kStart, Goal::named(9)}), Status::bad_argument);
  EXPECT_TRUE(bench.planner.plan().empty());
  EXPECT_EQ(bench.planner.statistics().hash, 0U);
}

// A parameter's range: inside at both ends, outside just beyond, and never NaN.
struct ParameterRange {
  Argument argument;
  float low, high;
  bool low_open, high_open;
  std::function<void(Parameters&, float)> set;
};

std::vector<ParameterRange> float_ranges() {
  return {{Argument::alpha, 1, 64, false, false, [](auto& p, float x) { p.tuning.alpha = x; }},
          {Argument::beta, 0, 1, true, true, [](auto& p, float x) { p.tuning.beta = x; }},
          {Argument::epsilon, 0, 1, true, false, [](auto& p, float x) { p.tuning.epsilon = x; }},
          {Argument::gamma, 0, 1e6F, false, false, [](auto& p, float x) { p.tuning.gamma = x; }},
          {Argument::cost_length, 0, 10, false, false, [](auto& p, float x) { p.tuning.cost_length = x; }},
          {Argument::dt, 0.001F, 1, false, false, [](auto& p, float x) { p.dt = x; }},
          {Argument::path_lengths, 0, 100, false, false, [](auto& p, float x) { p.tuning.path_lengths = x; }},
          {Argument::near_radius, 0, 10, false, false, [](auto& p, float x) { p.tuning.near_radius = x; }},
          {Argument::goal_near_radius, 0, 10, false, false, [](auto& p, float x) { p.tuning.goal_near_radius = x; }},
          {Argument::stray_share, 0, 1, false, false, [](auto& p, float x) { p.tuning.stray_share = x; }},
          {Argument::gentle_share, 0, 1, false, false, [](auto& p, float x) { p.tuning.gentle_share = x; }},
          {Argument::slowest, 0.05F, 1, false, false, [](auto& p, float x) { p.tuning.slowest = x; }},
          {Argument::stopping_ways, 0, 10, false, false, [](auto& p, float x) { p.tuning.stopping_ways = x; }},
          {Argument::reverse_share, 0, 1, false, false, [](auto& p, float x) { p.tuning.reverse_share = x; }},
          {Argument::clearance, 0, 10, false, false, [](auto& p, float x) { p.clearance = x; }},
          {Argument::goal_margin, 0, 10, false, false, [](auto& p, float x) { p.goal_margin = x; }}};
}

Failure init_with(const std::function<void(Parameters&)>& change) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  change(bench.parameters);
  return bench.init();
}

TEST(PlannerParameters, DefaultsAndThePapersAreInRange) {
  EXPECT_EQ(Parameters{}.first_bad(), Argument::none);
  EXPECT_EQ(Parameters::paper().first_bad(), Argument::none);
  EXPECT_EQ(Parameters::paper().tuning.alpha, 8.0F);
  EXPECT_EQ(Parameters::paper().tuning.beta, 0.85F);
  EXPECT_EQ(Parameters::paper().tuning.gamma, 50.0F);
  EXPECT_EQ(Parameters::paper().tuning.kappa, 20U);
  EXPECT_EQ(Parameters::paper().tuning.path_regions, 8U);
  EXPECT_EQ(Parameters::paper().tuning.path_lengths, 0.0F);
  EXPECT_EQ(Parameters::paper().tuning.doomed_steps, 0U);
}

TEST(PlannerParameters, EachRangeIsStated) {
  for (const ParameterRange& range : float_ranges()) {
    const krait::ParameterRange stated = Parameters::range(range.argument);
    EXPECT_EQ(stated.least, range.low_open ? std::nextafter(range.low, 1.0F) : range.low) << to_string(range.argument);
    EXPECT_EQ(stated.most, range.high_open ? std::nextafter(range.high, 0.0F) : range.high)
        << to_string(range.argument);
  }
  EXPECT_EQ(Parameters::range(Argument::kappa).least, 1.0F);
  EXPECT_EQ(Parameters::range(Argument::kappa).most, 10000.0F);
  EXPECT_EQ(Parameters::range(Argument::end_speed).most, kInfinity);
  EXPECT_EQ(Parameters::range(Argument::scene).most, 0.0F);
}

TEST(PlannerParameters, EachFloatIsCheckedAtBothEnds) {
  for (const ParameterRange& range : float_ranges()) {
    const auto verdict = [&](float value) {
      const Failure failure = init_with([&](Parameters& p) { range.set(p, value); });
      if (failure.ok()) return true;
      EXPECT_EQ(failure.status, Status::bad_argument) << to_string(range.argument);
      EXPECT_EQ(failure.element, blame(range.argument)) << to_string(range.argument) << " " << value;
      return false;
    };
    EXPECT_EQ(verdict(range.low), !range.low_open) << to_string(range.argument);
    EXPECT_EQ(verdict(range.high), !range.high_open) << to_string(range.argument);
    EXPECT_TRUE(verdict(std::nextafter(range.low, range.high))) << to_string(range.argument);
    EXPECT_TRUE(verdict(std::nextafter(range.high, range.low))) << to_string(range.argument);
    EXPECT_FALSE(verdict(std::nextafter(range.low, -kInfinity))) << to_string(range.argument);
    EXPECT_FALSE(verdict(std::nextafter(range.high, kInfinity))) << to_string(range.argument);
    for (const float bad : {kNan, kInfinity, -kInfinity}) EXPECT_FALSE(verdict(bad)) << to_string(range.argument);
  }
}

// Unlike the others it may be infinite.
TEST(PlannerParameters, AnEndSpeedIsNoNegativeNumber) {
  for (const float good : {0.0F, 1e-30F, 2.5F, kInfinity}) {
    EXPECT_TRUE(init_with([&](Parameters& p) { p.end_speed = good; }).ok()) << good;
  }
  for (const float bad : {-1e-30F, -kInfinity, kNan}) {
    const Failure failure = init_with([&](Parameters& p) { p.end_speed = bad; });
    EXPECT_EQ(failure.status, Status::bad_argument) << bad;
    EXPECT_EQ(failure.element, blame(Argument::end_speed)) << bad;
  }
}

TEST(PlannerParameters, EachCountIsCheckedAtBothEnds) {
  const struct {
    Argument argument;
    std::uint32_t low, high;
    std::uint32_t SearchTuning::*member;
  } ranges[] = {{Argument::group_sample, 1, 65535, &SearchTuning::group_sample},
                {Argument::kappa, 1, 10000, &SearchTuning::kappa},
                {Argument::sight_tries, 0, 64, &SearchTuning::sight_tries},
                {Argument::candidates, 0, 8, &SearchTuning::candidates},
                {Argument::least_sketch, 0, 20, &SearchTuning::least_sketch},
                {Argument::update_regions, 0, 1'000'000, &SearchTuning::update_regions},
                {Argument::doomed_steps, 0, 3, &SearchTuning::doomed_steps},
                {Argument::restart_unit, 0, 1'000'000'000, &SearchTuning::restart_unit},
                {Argument::stuck_expansions, 0, 1'000'000'000, &SearchTuning::stuck_expansions},
                {Argument::max_steps, 1, 1000, &SearchTuning::max_steps},
                {Argument::open_steps, 0, 1000, &SearchTuning::open_steps},
                {Argument::path_regions, 1, 64, &SearchTuning::path_regions},
                {Argument::max_substeps, 1, 64, &SearchTuning::max_substeps}};
  for (const auto& range : ranges) {
    const auto init = [&](std::uint32_t value) {
      return init_with([&](Parameters& p) { p.tuning.*range.member = value; });
    };
    EXPECT_TRUE(init(range.low).ok()) << to_string(range.argument);
    EXPECT_TRUE(init(range.high).ok()) << to_string(range.argument);
    for (const std::uint32_t bad : {range.low - 1, range.high + 1, 0xFFFFFFFFU}) {
      EXPECT_EQ(init(bad).status, Status::bad_argument) << to_string(range.argument) << " " << bad;
      EXPECT_EQ(init(bad).element, blame(range.argument)) << to_string(range.argument) << " " << bad;
    }
  }
  EXPECT_EQ(init_with([](Parameters& p) { p.tuning.max_substeps = 12; }).element, blame(Argument::max_substeps));
}

TEST_F(PlannerStatus, ASceneWithoutRegionsTakesAsSmallABlockAsOneWithSome) {
  Room solid = two_rooms();
  solid.boxes = {solid.bounds};
  Bench<Unicycle> bench(solid, small_unicycle());
  ASSERT_EQ(bench.open.scene.triangle_count(), 0U);
  const Bench<Unicycle> rooms(two_rooms(), small_unicycle());
  EXPECT_LE(Planner::bytes_required(bench.open.scene, bench.robot, bench.limits),
            Planner::bytes_required(rooms.open.scene, rooms.robot, rooms.limits));
  ASSERT_TRUE(bench.init().ok());
  const std::vector<float> start = standing(bench.robot, {2, 2});
  EXPECT_EQ(bench.planner.start({start.data()}), Status::start_in_collision);
}

}  // namespace
}  // namespace krait::test::planner_status_test
