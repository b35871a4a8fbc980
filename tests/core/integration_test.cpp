// SPDX-License-Identifier: Apache-2.0
// How many Runge-Kutta steps a time step is divided into, and how far they are from the true motion, over the whole
// range of parameters that init accepts (lib/DESIGN.md, "Integration").
#include <gtest/gtest.h>

#include <cmath>

#include "motion/rk4.hpp"
#include "planner_fixture.hpp"
#include "robot_oracle.hpp"

namespace krait::test::integration_test {
namespace {

struct Errors {
  double angle = 0;     // radians
  double position = 0;  // of the way of a time step

  void add(const Numbers& truth, const Numbers& s, double way) {
    for (std::size_t i = 2; i < s.size(); ++i) angle = std::max(angle, std::abs(truth[i] - s[i]));
    position = std::max(position, std::hypot(truth[0] - s[0], truth[1] - s[1]) / way);
  }
};

template <class R>
class IntegrationOf : public ::testing::Test {
 protected:
  // The worst truncation of `draws` time steps whose Runge-Kutta steps are as long as step_rate allows.
  static Errors worst(float step_rate, int draws) {
    Errors errors;
    std::mt19937 random(5);
    for (int i = 0; i < draws; ++i) {
      const R robot = random_robot<R>(random);
      const float dt = log_uniform(random, 0.001, 1);
      if (!detail::can_integrate(robot, dt)) continue;
      const std::vector<float> s = random_state(robot, random, 0.01);
      const std::vector<float> u = random_control(robot, s, dt, random);
      const int parts = detail::parts_of(dt, detail::longest_step(robot, dt, step_rate), detail::kMostPlanParts);
      const Numbers exact = truth(robot, s, u, dt, 8 * parts);
      if (within_limits(robot, exact)) {
        errors.add(exact, truth(robot, s, u, dt, parts), largest_speed(robot) * wide(dt));
      }
    }
    return errors;
  }

 private:
  static bool within_limits(const R& robot, const Numbers& state) {
    const std::vector<float> rounded(state.begin(), state.end());
    return robot.within_limits(StateView(rounded.data(), robot.state_size()));
  }

  static Numbers truth(const R& robot, const std::vector<float>& s, const std::vector<float>& u, float dt, int parts) {
    Numbers state = doubles(s);
    for (int part = 0; part < parts; ++part) state = rk4(robot, state, doubles(u), wide(dt) / parts);
    return state;
  }
};
TYPED_TEST_SUITE(IntegrationOf, Models, ModelNames);

TYPED_TEST(IntegrationOf, KeepsItsBoundsOverAllParameters) {
  const int draws = kTows<TypeParam> ? 2000 : 10'000;
  const Errors tree = this->worst(detail::kStepRate, draws);
  EXPECT_LT(tree.angle, 2e-3);
  EXPECT_LT(tree.position, 5e-4);
  const Errors plan = this->worst(detail::kPlanStepRate, draws);
  EXPECT_LT(plan.angle, 1e-4);
  EXPECT_LT(plan.position, 5e-5);
  const Errors fine = this->worst(detail::kFinePlanStepRate, draws / 4);
  EXPECT_LT(fine.angle, 1e-6);
  EXPECT_LT(fine.position, 5e-7);
  std::printf("tree %.2g rad, %.2g of the way; plan %.2g rad, %.2g of the way; fine %.2g rad, %.2g of the way\n",
              tree.angle, tree.position, plan.angle, plan.position, fine.angle, fine.position);
}

// The default robots are accurate in one Runge-Kutta step of the default time step.
TEST(IntegrationSteps, AreOneForTheDefaultRobots) {
  const float dt = Parameters().dt;
  const auto parts = [&](const auto& robot) {
    return detail::parts_of(dt, detail::longest_tree_step(robot, dt), detail::kMostParts);
  };
  AllRobots<Each>::call([&]<class R>() { EXPECT_EQ(parts(default_robot<R>(15)), 1) << ModelNames::GetName<R>(0); });
  ChainParameters p;
  p.trailers = 15;
  p.hitch_length = 0.15F;
  EXPECT_EQ(parts(Truck(p)), 6);
  EXPECT_EQ(parts(Slider(0.5F, 1.5F)), 1) << "a robot that does not state its rate";
}

TEST(IntegrationSteps, PartsAreAtMostTheLongestStep) {
  EXPECT_EQ(detail::parts_of(0.1F, kInfinity, 64), 1);
  EXPECT_EQ(detail::parts_of(0.1F, 0.1F, 64), 1);
  EXPECT_EQ(detail::parts_of(0.1F, 0.06F, 64), 2);
  EXPECT_EQ(detail::parts_of(1.0F, 0.01F, 64), 64);
}

// What would need more than kMostParts is refused, with the longest time step that would do.
TEST(IntegrationSteps, ThatWouldBeTooManyAreRefused) {
  ChainParameters p;
  p.trailers = 1;
  p.hitch_length = 0.01F;
  p.max_speed = 5.0F;
  Bench<Truck> bench(two_rooms(), Truck(p));
  bench.parameters.dt = 0.5F;
  const Failure failure = bench.init();
  EXPECT_EQ(failure.status, Status::bad_argument);
  EXPECT_EQ(failure.element, static_cast<std::uint32_t>(Argument::dt));
  EXPECT_NEAR(wide(failure.most), 16 * 0.32 * 0.01 / 5, 1e-5);
  bench.parameters.dt = failure.most;
  EXPECT_TRUE(bench.init().ok());
  p.hitch_length = 1e-5F;
  bench.robot = Truck(p);
  EXPECT_EQ(bench.init().most, 0.0F) << "no time step that is long enough would do";
}

}  // namespace
}  // namespace krait::test::integration_test
