// What a solved plan holds, for every model and planner: it replays bit for bit, keeps the limits, touches nothing.
#include "krait/plan.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "planner_fixture.hpp"
#include "robot_oracle.hpp"
#include "step_oracle.hpp"

namespace krait::test {
namespace {

template <class R>
R small_robot();
template <>
Snake small_robot<Snake>() {
  ChainParameters p;
  p.trailers = 3;
  p.body_length = 0.4F;
  p.body_width = 0.3F;
  p.wheelbase = 0.4F;
  p.hitch_length = 0.45F;
  return Snake(p);
}
template <>
Truck small_robot<Truck>() {
  ChainParameters p = small_robot<Snake>().parameters();
  p.trailers = 1;
  p.min_speed = -0.5F;
  return Truck(p);
}
template <>
Car small_robot<Car>() {
  ChainParameters p = small_robot<Snake>().parameters();
  p.body_length = 0.6F;
  return Car(p);
}
template <>
Unicycle small_robot<Unicycle>() {
  return small_unicycle();
}
template <>
DifferentialDrive small_robot<DifferentialDrive>() {
  return DifferentialDrive({});
}

// FNV-1a of 64 bits over bytes, from its description.
class Fnv {
 public:
  void add(float value) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    for (int i = 0; i < 4; ++i) {
      hash_ ^= (bits >> (8 * i)) & 255U;
      hash_ *= 1099511628211ULL;
    }
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 14695981039346656037ULL;
};

template <class R>
class PlanOf : public ::testing::Test {
 protected:
  void SetUp() override {
    start_ = std::vector<float>(static_cast<std::size_t>(bench_.robot.state_size()), 0.0F);
    start_[0] = 2;
    start_[1] = 6;
    ASSERT_TRUE(bench_.init().ok());
    ASSERT_EQ(bench_.solve({start_.data()}), Status::solved);
    plan_ = bench_.planner.plan();
    ASSERT_GT(plan_.steps(), 5U);
  }
  std::vector<float> state(std::uint32_t i) const { return {plan_.state(i), plan_.state(i) + plan_.state_size()}; }
  std::vector<float> control(std::uint32_t i) const {
    return {plan_.control(i), plan_.control(i) + plan_.control_size()};
  }

  Bench<R> bench_{two_rooms(), small_robot<R>()};
  std::vector<float> start_;
  Plan plan_;
};
TYPED_TEST_SUITE(PlanOf, Models, ModelNames);

TYPED_TEST(PlanOf, BeginsAtTheStartAndEndsInTheGoal) {
  EXPECT_EQ(this->state(0), this->start_);
  const auto last = this->state(this->plan_.steps());
  EXPECT_GE(last[0], 9.53F);
  EXPECT_LE(last[0], 11.47F);
  EXPECT_GE(last[1], 5.53F);
  EXPECT_LE(last[1], 7.47F);
}

TYPED_TEST(PlanOf, ReplaysBitForBit) {
  for (std::uint32_t i = 0; i < this->plan_.steps(); ++i) {
    ASSERT_EQ(step(this->bench_.robot, this->state(i), this->control(i), this->plan_.dt()), this->state(i + 1)) << i;
  }
}

TYPED_TEST(PlanOf, KeepsItsLimits) {
  const auto limits = control_limits(this->bench_.robot);
  for (std::uint32_t i = 0; i < this->plan_.steps(); ++i) {
    const auto u = this->control(i);
    for (std::size_t k = 0; k < u.size(); ++k) {
      ASSERT_GE(u[k], limits[k].low);
      ASSERT_LE(u[k], limits[k].high);
    }
    ASSERT_TRUE(this->bench_.robot.within_limits(StateView(this->plan_.state(i + 1), this->plan_.state_size())));
  }
}

TYPED_TEST(PlanOf, TouchesNothingAtAnyTime) {
  for (std::uint32_t i = 0; i < this->plan_.steps(); ++i) {
    ASSERT_GT(separation_of_step(this->bench_.robot, this->bench_.open.scene, this->state(i), this->control(i),
                                 this->plan_.dt(), 50),
              0)
        << i;
  }
}

TYPED_TEST(PlanOf, CopyIsWhatTheCursorShows) {
  const Plan& plan = this->plan_;
  const auto n = static_cast<std::size_t>(plan.state_size()), m = static_cast<std::size_t>(plan.control_size());
  std::vector<float> states((plan.steps() + 1) * n), controls(plan.steps() * m);
  plan.copy(states.data(), controls.data());
  for (std::size_t i = 0; i <= plan.steps(); ++i) {
    for (std::size_t k = 0; k < n; ++k) ASSERT_EQ(states[i * n + k], plan.state(static_cast<std::uint32_t>(i))[k]);
    for (std::size_t k = 0; i < plan.steps() && k < m; ++k) {
      ASSERT_EQ(controls[i * m + k], plan.control(static_cast<std::uint32_t>(i))[k]);
    }
  }
}

TYPED_TEST(PlanOf, HashIsFnv1aOverStatesAndControlsInTurn) {
  Fnv fnv;
  for (std::uint32_t i = 0; i <= this->plan_.steps(); ++i) {
    for (const float x : this->state(i)) fnv.add(x);
    if (i < this->plan_.steps()) {
      for (const float x : this->control(i)) fnv.add(x);
    }
  }
  EXPECT_EQ(this->plan_.hash(), fnv.value());
  EXPECT_EQ(this->bench_.planner.statistics().hash, fnv.value());
}

TYPED_TEST(PlanOf, LengthAndDurationAreThoseOfItsStates) {
  double length = 0;
  for (std::uint32_t i = 0; i < this->plan_.steps(); ++i) {
    const auto a = this->state(i), b = this->state(i + 1);
    length += std::hypot(wide(b[0]) - wide(a[0]), wide(b[1]) - wide(a[1]));
  }
  EXPECT_NEAR(wide(this->plan_.length()), length, 1e-4);
  EXPECT_GT(length, 7.0);
  EXPECT_NEAR(wide(this->plan_.duration()), 0.1 * this->plan_.steps(), 1e-4);
  const Statistics statistics = this->bench_.planner.statistics();
  EXPECT_EQ(statistics.plan_steps, this->plan_.steps());
  EXPECT_EQ(statistics.plan_length, this->plan_.length());
  EXPECT_EQ(statistics.plan_duration, this->plan_.duration());
}

TYPED_TEST(PlanOf, FollowsTheTreeFromTheRoot) {
  const MotionTree& tree = this->bench_.planner.tree();
  EXPECT_EQ(tree.parent(this->plan_.vertex(0)), kNone);
  for (std::uint32_t i = 0; i < this->plan_.steps(); ++i)
    ASSERT_EQ(tree.parent(this->plan_.vertex(i + 1)), this->plan_.vertex(i));
}

TEST(PlanFnv, TestsOwnHashGivesTheKnownValue) {
  Fnv fnv;
  fnv.add(std::bit_cast<float>(0x626F6F66U));  // the bytes "foob"
  EXPECT_EQ(fnv.value(), 0xDD120E790C2512AFULL);
}

TEST(PlanEmpty, IsHarmless) {
  const Plan plan;
  EXPECT_TRUE(plan.empty());
  EXPECT_EQ(plan.steps(), 0U);
  EXPECT_EQ(plan.hash(), 0U);
  EXPECT_EQ(plan.length(), 0.0F);
  EXPECT_EQ(plan.duration(), 0.0F);
  plan.copy(nullptr, nullptr);
}

// Every planner, over random scenes: whatever it calls solved touches nothing.
template <class P>
class PlanByPlanner : public ::testing::Test {};
TYPED_TEST_SUITE(PlanByPlanner, Planners, PlannerNames);

TYPED_TEST(PlanByPlanner, TouchesNothingInRandomScenes) {
  int solved = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    Bench<Snake, TypeParam> bench(random_room(seed), small_robot<Snake>());
    bench.limits.iterations = 3000;
    ASSERT_TRUE(bench.init().ok());
    std::mt19937 random(seed);
    Status status = Status::start_in_collision;
    std::vector<float> start(8, 0.0F);
    for (int i = 0; i < 100 && status == Status::start_in_collision; ++i) {
      start[0] = uniform_float(random, 1, 11);
      start[1] = uniform_float(random, 1, 11);
      status = bench.solve({start.data(), Goal::named(0), seed});
    }
    if (status != Status::solved) continue;
    ++solved;
    const Plan plan = bench.planner.plan();
    for (std::uint32_t i = 0; i < plan.steps(); ++i) {
      const std::vector<float> s(plan.state(i), plan.state(i) + 8), u(plan.control(i), plan.control(i) + 2);
      ASSERT_GT(separation_of_step(bench.robot, bench.open.scene, s, u, plan.dt(), 30), 0)
          << "seed " << seed << " step " << i;
    }
  }
  EXPECT_GE(solved, 6);
}

}  // namespace
}  // namespace krait::test
