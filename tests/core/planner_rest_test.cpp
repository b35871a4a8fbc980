// SPDX-License-Identifier: Apache-2.0
// Plans end at rest, or as slow as asked: the brake is a part of them.
#include "krait/robots/detail/defaults.hpp"
#include "planner_fixture.hpp"
#include "robot_oracle.hpp"
#include "search/adaptive_search.hpp"

namespace krait::test::planner_rest_test {
namespace {

constexpr int kSeeds = 20;

template <class R>
class Rests {
 public:
  explicit Rests(const R& robot) : bench_(two_rooms(), robot), start_(standing(robot, {4, 6})) {}

  Bench<R>& bench() { return bench_; }

  // The speed that the plan ends at, which lies in the goal.
  float end_speed(const Goal& goal, std::uint64_t seed) {
    EXPECT_TRUE(bench_.init().ok());
    EXPECT_EQ(bench_.solve({start_.data(), goal, seed}), Status::solved);
    if (bench_.planner.plan().empty()) return kInfinity;
    const Path path(bench_.planner.plan());
    const std::vector<float>& last = path.states.back();
    EXPECT_TRUE(goal.contains(bench_.open.scene, {last[0], last[1]}, 0.0F));
    const float speed = detail::speed_of(bench_.robot, StateView(last.data(), bench_.robot.state_size()));
    EXPECT_EQ(speed, bench_.planner.statistics().plan_end_speed);
    return speed;
  }

  float slowest_end(const Goal& goal) {
    float least = kInfinity;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) least = std::min(least, end_speed(goal, seed));
    return least;
  }
  float fastest_end(const Goal& goal) {
    float most = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) most = std::max(most, end_speed(goal, seed));
    return most;
  }

 private:
  Bench<R> bench_;
  std::vector<float> start_;
};

template <class R>
void expect_rest(const R& robot) {
  Rests<R> rests(robot);
  EXPECT_LE(rests.fastest_end(Goal::named(0)), detail::kRestSpeed);
  EXPECT_LE(rests.fastest_end(Goal::disc({10.5F, 3}, 0.15F)), detail::kRestSpeed)
      << "far smaller than the stopping distance";
}

TEST(PlannerRest, EveryModelEndsAtRestByDefault) {
  AllRobots<Each>::call([]<class R>() {
    SCOPED_TRACE(ModelNames::GetName<R>(0));
    if constexpr (detail::HasSpeed<R>) expect_rest(default_robot<R>(2));
  });
}

TEST(PlannerRest, AnEndSpeedIsKeptAndMadeUseOf) {
  Rests<Car> rests(Car(Car::defaults()));
  rests.bench().parameters.end_speed = 1.0F;
  EXPECT_LE(rests.fastest_end(Goal::named(0)), 1.0F + detail::kRestSpeed);
  EXPECT_GT(rests.slowest_end(Goal::named(0)), 0.4F) << "braking stops where the plan is slow enough";
  rests.bench().parameters.end_speed = kInfinity;
  EXPECT_GT(rests.slowest_end(Goal::named(0)), 2.0F);
}

TEST(PlannerRest, WeakBrakesBeginFarFromTheGoal) {
  ChainParameters p = Car::defaults();
  p.max_acceleration = 0.5F;  // a stopping distance of 6.25 m, half of the scene
  Rests<Car> rests{Car(p)};
  EXPECT_LE(rests.fastest_end(Goal::named(0)), detail::kRestSpeed);
}

// A finishing line, which is shrunk by less than other goals, so that something of it is left.
TEST(PlannerRest, StopsOnALineOfTwoCentimetres) {
  Room room = two_rooms();
  room.goals[0] = {9.5, 1, 9.52, 7};
  Bench<Car> bench(room, Car(Car::defaults()));
  ASSERT_TRUE(bench.init().ok());
  const std::vector<float> start = standing(bench.robot, {3, 4});
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    EXPECT_EQ(bench.solve({start.data(), Goal::named(0), seed}), Status::solved) << seed;
  }
}

TEST(PlannerRest, TheStateOfAUnicycleHasNoSpeed) {
  Rests<Unicycle> rests(small_unicycle());
  EXPECT_EQ(rests.fastest_end(Goal::named(0)), 0.0F);
  const std::uint64_t hash = rests.bench().planner.statistics().hash;
  rests.bench().parameters.end_speed = kInfinity;
  rests.fastest_end(Goal::named(0));
  EXPECT_EQ(rests.bench().planner.statistics().hash, hash);
}

TEST(PlannerRest, IsNotThePapers) { EXPECT_EQ(Parameters::paper().end_speed, kInfinity); }

TEST(PlannerRest, AStartInTheGoalIsAPlanWhereItIsSlowEnough) {
  Bench<Car> bench(two_rooms(), Car(Car::defaults()));
  ASSERT_TRUE(bench.init().ok());
  std::vector<float> start = standing(bench.robot, {10, 6.5F});
  EXPECT_EQ(bench.planner.start({start.data()}), Status::solved);
  EXPECT_EQ(bench.planner.plan().steps(), 0U);
  start[3] = 2.0F;
  EXPECT_EQ(bench.solve({start.data()}), Status::solved);
  EXPECT_GT(bench.planner.plan().steps(), 0U);
  EXPECT_LE(bench.planner.statistics().plan_end_speed, detail::kRestSpeed);
  bench.parameters.end_speed = 2.0F;
  ASSERT_TRUE(bench.init().ok());
  EXPECT_EQ(bench.planner.start({start.data()}), Status::solved);
}

// A call ends in the middle of a brake as well.
TEST(PlannerRest, DoesNotDependOnHowASearchIsCutIntoCalls) {
  ChainParameters p = Car::defaults();
  p.max_acceleration = 0.5F;  // brakes of 50 steps
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    std::uint64_t hashes[2];
    for (int whole = 0; whole < 2; ++whole) {
      Bench<Car> bench(two_rooms(), Car(p));
      bench.parameters.tuning.max_steps = 7;
      ASSERT_TRUE(bench.init().ok());
      const std::vector<float> start = standing(bench.robot, {4, 6});
      ASSERT_EQ(bench.planner.start({start.data(), Goal::named(0), seed}), Status::searching);
      while (bench.planner.advance(whole == 1 ? 1'000'000 : 1) == Status::searching) {
      }
      hashes[whole] = bench.planner.statistics().hash;
    }
    EXPECT_EQ(hashes[0], hashes[1]);
  }
}

// The brake has its own place in the tree however few expansions are kept.
TEST(PlannerRest, NeedsNoMoreMemory) {
  int solved = 0;
  for (const WhenFull when_full : {WhenFull::recycle, WhenFull::stop}) {
    for (const std::uint32_t expansions : {2U, 3U, 5U, 30U, 1000U}) {
      for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        Bench<Car> bench(two_rooms(), Car(Car::defaults()));
        bench.limits = {200, expansions, 300, when_full};
        ASSERT_TRUE(bench.init().ok());
        const std::vector<float> start = standing(bench.robot, {8, 4});
        const Status status = bench.solve({start.data(), Goal::named(0), seed});
        EXPECT_LE(detail::opened(bench.planner).tree().most_expansions(), expansions);
        if (status != Status::solved) continue;
        ++solved;
        EXPECT_LE(bench.planner.statistics().plan_end_speed, detail::kRestSpeed);
      }
    }
  }
  EXPECT_GT(solved, 100);
}

// A robot that states its speed, and no stopping way; it stops within a step, or never.
class Sled : public Slider {
 public:
  static constexpr int kMaxState = 4;

  explicit Sled(bool brakes) : Slider(0.5F, 1.5F), brakes_(brakes) {}

  int state_size() const { return 4; }
  float speed(StateView s) const { return length({s[2], s[3]}); }
  void derivative(StateView s, ControlView u, StateRef ds) const { ds << s[2], s[3], u[0], u[1]; }
  void steer(StateView s, const Target& target, Steering&, ControlRef u) const {
    const Vec2 to = target.point - position(s);
    const float gain = (target.speed == 0.0F && !brakes_ ? 1.0F : target.speed) * 1.5F / (length(to) + 1e-3F);
    u << (gain * to.x - s[2]) / target.dt, (gain * to.y - s[3]) / target.dt;
  }
  bool within_limits(StateView s) const { return finite(position(s)) && speed(s) < 1e3F; }
  bool travel(StateView s, ControlView u, float dt, StateView next, Travel* travel) const {
    travel[0] = {dt * (speed(s) + speed(next)), 0.0F, 0.125F * dt * dt * length({u[0], u[1]}), 0.0F};
    return true;
  }

 private:
  bool brakes_;
};

TEST(PlannerRest, ARobotOfOnesOwnNeedsOnlySayHowFastItIs) {
  Rests<Sled> rests(Sled(true));
  EXPECT_LE(rests.fastest_end(Goal::named(0)), detail::kRestSpeed);
  rests.bench().parameters.end_speed = kInfinity;
  EXPECT_GT(rests.slowest_end(Goal::named(0)), 1.0F);
}

// It brakes wherever it is in the goal, and often comes to rest beside it: no such way is driven as a plan.
TEST(PlannerRest, ABrakeThatEndsBesideTheGoalIsNoPlan) {
  Rests<Sled> rests(Sled(true));
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    rests.end_speed(Goal::disc({10.5F, 3}, 0.05F), seed);
    EXPECT_EQ(rests.bench().planner.statistics().plans_refused, 0U);
  }
}

TEST(PlannerRest, ARobotThatNeverStopsHasNoPlan) {
  Bench<Sled> bench(two_rooms(), Sled(false));
  bench.limits.iterations = 500;
  ASSERT_TRUE(bench.init().ok());
  const float start[] = {2, 6, 0, 0};
  EXPECT_EQ(bench.solve({start}), Status::budget_used);
}

}  // namespace
}  // namespace krait::test::planner_rest_test
