// A robot that a user writes in about twenty lines (user_robot.hpp) plans like one of ours.
#include <algorithm>

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
    for (const auto& state : Path(bench.planner.plan()).states) {
      ASSERT_EQ(state.size(), 2U);
      // The square of half a metre keeps off the wall and inside the door.
      const bool at_wall = state[0] > 5.75F && state[0] < 6.5F;
      if (at_wall) {
        ASSERT_GE(state[1], 3.25F);
        ASSERT_LE(state[1], 4.75F);
      }
    }
  }
}

TEST(UserRobotDefaults, MayBeLeftOut) {
  const Slider slider(0.5F, 1);
  EXPECT_EQ(self_collision_gap(slider), 2);
  EXPECT_FALSE(reversible(slider));
  const float s[] = {1, 2};
  const float u[] = {0, 0};
  EXPECT_FALSE(quick_bound(slider, StateView(s, 2), ControlView(u, 2), 0.1F, StateView(s, 2)).limited);
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

// One of any sizes, whose maxima are 3 states, 2 controls and 4 bodies.
class Sized : public Slider {
 public:
  static constexpr int kMaxState = 3, kMaxControl = 2, kMaxBodies = 4;
  Sized(int states, int controls, int bodies)
      : Slider(0.5F, 1), states_(states), controls_(controls), bodies_(bodies) {}
  int state_size() const { return states_; }
  int control_size() const { return controls_; }
  int body_count() const { return bodies_; }

 private:
  int states_, controls_, bodies_;
};

TEST(UserRobotDefaults, EachSizeIsHeldToItsRange) {
  for (int states = -1; states <= 5; ++states) {
    for (int controls = -1; controls <= 4; ++controls) {
      for (int bodies = -1; bodies <= 6; ++bodies) {
        const bool fits = 2 <= states && states <= 3 && 1 <= controls && controls <= 2 && 1 <= bodies && bodies <= 4;
        ASSERT_EQ(first_bad_of_robot(Sized(states, controls, bodies)), fits ? Argument::none : Argument::robot_sizes)
            << states << " " << controls << " " << bodies;
      }
    }
  }
}

TEST(UserRobotDefaults, TheLengthIsThatOfBody0WhicheverVertexIsFirst) {
  std::vector<Vec2> body = {{0.5F, -0.25F}, {0.75F, 0}, {0.5F, 0.25F}, {-0.25F, 0.25F}, {-0.5F, 0}};
  for (std::size_t first = 0; first < body.size(); ++first) {
    Unicycle robot({});
    robot.set_body(0, {body.data(), static_cast<int>(body.size())});
    EXPECT_EQ(robot_length(robot), 1.25F) << first;
    std::rotate(body.begin(), body.begin() + 1, body.end());
  }
}

}  // namespace
}  // namespace krait::test
