// A robot that a user writes in about twenty lines (user_robot.hpp) plans like one of ours.
#include "planner_fixture.hpp"

namespace krait::test {
namespace {

static_assert(Robot<Slider>);

template <class P>
class UserRobot : public ::testing::Test {};
TYPED_TEST_SUITE(UserRobot, Planners, PlannerNames);

TYPED_TEST(UserRobot, PlansThroughADoor) {
  Bench<Slider, TypeParam> bench(two_rooms(), Slider(0.5F, 1.5F));
  ASSERT_TRUE(bench.init().ok());
  const float start[] = {2, 6};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    ASSERT_EQ(bench.solve({start, Goal::named(0), seed}), Status::solved);
    const Plan plan = bench.planner.plan();
    EXPECT_EQ(plan.state_size(), 2);
    for (std::uint32_t i = 0; i < plan.steps(); ++i) {
      // The square of half a metre keeps off the wall and inside the door.
      const float x = plan.state(i)[0], y = plan.state(i)[1];
      const bool at_wall = x > 5.75F && x < 6.5F;
      if (at_wall) {
        ASSERT_GE(y, 3.25F);
        ASSERT_LE(y, 4.75F);
      }
    }
  }
}

TEST(UserRobotDefaults, MayBeLeftOut) {
  const Slider slider(0.5F, 1);
  EXPECT_EQ(self_collision_gap(slider), 2);
  EXPECT_FALSE(reversible(slider));
  EXPECT_TRUE(sound(slider));
  EXPECT_EQ(first_bad_of_robot(slider), Argument::none);
}

TEST(UserRobotDefaults, UnusableBodyIsRefused) {
  EXPECT_EQ(first_bad_of_robot(Slider(0.0F, 1)), Argument::robot_polygon);
  EXPECT_EQ(first_bad_of_robot(Slider(-1.0F, 1)), Argument::none);  // mirrored twice it is the same square
}

// A robot that lies about its sizes.
class Oversized : public Slider {
 public:
  using Slider::Slider;
  int state_size() const { return 3; }
};

TEST(UserRobotDefaults, SizesBeyondTheMaximaAreRefused) {
  EXPECT_EQ(first_bad_of_robot(Oversized(0.5F, 1)), Argument::robot_sizes);
}

}  // namespace
}  // namespace krait::test
