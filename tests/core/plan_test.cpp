// SPDX-License-Identifier: Apache-2.0
// What a solved plan holds, for every model and planner: it replays bit for bit, keeps the limits, touches nothing.
#include "krait/plan.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <set>
#include <utility>

#include "plan/plan_meter.hpp"
#include "planner_fixture.hpp"
#include "robot_oracle.hpp"
#include "step_oracle.hpp"

namespace krait::test::plan_test {
namespace {

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
    start_ = standing(bench_.robot, {2, 6});
    ASSERT_TRUE(bench_.init().ok());
    ASSERT_EQ(bench_.solve({start_.data()}), Status::solved);
    plan_ = bench_.planner.plan();
    ASSERT_GT(plan_.steps(), 5U);
    const Path path(plan_);
    states_ = path.states;
    controls_ = path.controls;
  }
  const std::vector<float>& state(std::uint32_t i) const { return states_.at(i); }
  const std::vector<float>& control(std::uint32_t i) const { return controls_.at(i); }

  Bench<R> bench_{two_rooms(), small_robot<R>()};
  std::vector<float> start_;
  Plan plan_;
  std::vector<std::vector<float>> states_, controls_;
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

TYPED_TEST(PlanOf, StatesAreWhatTheControlsLeadTo) {
  Numbers truth = doubles(this->start_);
  for (std::uint32_t i = 0; i < this->plan_.steps(); ++i) {
    for (int part = 0; part < 8; ++part) {
      truth = rk4(this->bench_.robot, truth, doubles(this->control(i)), wide(this->plan_.dt()) / 8);
    }
    for (std::size_t k = 0; k < truth.size(); ++k) ASSERT_NEAR(wide(this->state(i + 1)[k]), truth[k], 5e-5) << i;
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
    ASSERT_TRUE(this->bench_.robot.within_limits(StateView(this->state(i + 1).data(), this->plan_.state_size())));
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
  const auto& plan = this->plan_;
  ASSERT_EQ(this->states_.size(), plan.steps() + 1U);
  ASSERT_EQ(this->controls_.size(), plan.steps());
  const auto n = static_cast<std::size_t>(plan.state_size()), m = static_cast<std::size_t>(plan.control_size());
  std::vector<float> states((plan.steps() + 1) * n), controls(plan.steps() * m);
  plan.copy(states.data(), controls.data());
  for (std::size_t i = 0; i <= plan.steps(); ++i) {
    for (std::size_t k = 0; k < n; ++k) ASSERT_EQ(states[i * n + k], this->states_[i][k]);
    for (std::size_t k = 0; i < plan.steps() && k < m; ++k) {
      ASSERT_EQ(controls[i * m + k], this->controls_[i][k]);
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

TYPED_TEST(PlanOf, EveryStateIsBesideOneThatTheTreeGrewTo) {
  std::vector<std::vector<float>> grown = {this->start_};
  const auto n = this->start_.size();
  const auto watch = [&](const float*, const float* to) { grown.emplace_back(to, to + n); };
  EXPECT_EQ(this->bench_.planner.start({this->start_.data()}), Status::searching);
  ASSERT_EQ(this->bench_.planner.advance(1'000'000, watch), Status::solved);
  const auto beside = [](const std::vector<float>& a, const std::vector<float>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), [](float x, float y) { return std::abs(x - y) <= 2e-3F; });
  };
  for (std::uint32_t i = 0; i <= this->plan_.steps(); ++i) {
    const auto near = [&](const std::vector<float>& state) { return beside(state, this->state(i)); };
    ASSERT_TRUE(std::any_of(grown.begin(), grown.end(), near)) << i;
  }
}

TYPED_TEST(PlanOf, CursorsAreIndependentOfEachOther) {
  auto one = this->plan_.cursor();
  for (int i = 0; i < 3; ++i) one.advance();
  auto two = this->plan_.cursor();
  auto copy = one;
  one.advance();
  const auto n = this->start_.size();
  EXPECT_EQ(std::vector<float>(two.state(), two.state() + n), this->state(0));
  EXPECT_EQ(std::vector<float>(copy.state(), copy.state() + n), this->state(3));
  EXPECT_EQ(std::vector<float>(one.state(), one.state() + n), this->state(4));
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
  EXPECT_EQ(plan.state_size(), 0);
  EXPECT_EQ(plan.control_size(), 0);
  EXPECT_EQ(plan.hash(), 0U);
  EXPECT_EQ(plan.length(), 0.0F);
  EXPECT_EQ(plan.duration(), 0.0F);
  plan.copy(nullptr, nullptr);
  const PlanCursor at = plan.cursor();
  EXPECT_TRUE(at.done());
  EXPECT_EQ(at.state_size(), 0);
  EXPECT_EQ(at.control_size(), 0);
}

// A robot that is no pure function: from its n-th control on it steers a little otherwise.
class Fickle : public Slider {
 public:
  explicit Fickle(const int* after) : Slider(0.5F, 1.5F), after_(after) {}
  void steer(StateView s, const Target& target, Steering& steering, ControlRef u) const {
    Slider::steer(s, target, steering, u);
    if (++calls > *after_) u[0] *= 0.99F;
  }

  mutable int calls = 0;

 private:
  const int* after_;
};

// The plan is driven again before it is given out: what cannot be repeated is not.
TEST(PlanReplay, ThatEndsElsewhereIsAnInternalError) {
  const float start[] = {2, 6};
  int after = 1'000'000'000;
  Bench<Fickle> bench(two_rooms(), Fickle(&after));
  ASSERT_TRUE(bench.init().ok());
  int growing = 0;
  ASSERT_EQ(bench.planner.start({start}), Status::searching);
  while (bench.planner.status() == Status::searching) {
    growing = bench.robot.calls;  // at the beginning of the last expansion
    (void)bench.planner.advance(1);
  }
  ASSERT_EQ(bench.planner.status(), Status::solved);
  const std::uint64_t hash = bench.planner.statistics().hash;
  // The tree grows as before; it is driven again later than all of that, or in the middle of the last expansion.
  after = growing;
  bench.robot.calls = 0;
  const Status status = bench.solve({start});
  EXPECT_EQ(status, Status::internal);
  EXPECT_TRUE(bench.planner.plan().empty());
  EXPECT_EQ(bench.planner.statistics().hash, 0U);
  EXPECT_EQ(bench.planner.advance(10), Status::internal);
  after = 1'000'000'000;
  ASSERT_EQ(bench.solve({start}), Status::solved);
  EXPECT_EQ(bench.planner.statistics().hash, hash);
}

// Every planner, over random scenes: whatever it calls solved touches nothing.

TEST(PlanByPlanner, TouchesNothingInRandomScenes) {
  int solved = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    Bench<Snake> bench(random_room(seed), small_robot<Snake>());
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
    const Path path(bench.planner.plan());
    for (std::size_t i = 0; i < path.controls.size(); ++i) {
      ASSERT_GT(separation_of_step(bench.robot, bench.open.scene, path.states[i], path.controls[i], 0.1F, 30), 0)
          << "seed " << seed << " step " << i;
    }
  }
  EXPECT_GE(solved, 6);
}

}  // namespace
}  // namespace krait::test::plan_test
