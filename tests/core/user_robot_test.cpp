// SPDX-License-Identifier: Apache-2.0
// A robot that a user writes in about twenty lines (user_robot.hpp) plans like one of ours; one that breaks its word
// gets no plan through the place where it does.
#include <algorithm>
#include <limits>

#include "host/rivals/plain.hpp"
#include "krait/robots/detail/defaults.hpp"
#include "planner_fixture.hpp"
#include "robot/shape.hpp"

namespace krait::test::user_robot_test {
namespace {

static_assert(RobotModel<Slider>);

TEST(UserRobot, PlansThroughADoor) {
  Bench<Slider> bench(two_rooms(), Slider(0.5F, 1.5F));
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

TEST(UserRobot, ThatStatesRatesPlansAsOneThatStatesItsTravel) {
  static_assert(RobotModel<RatedSlider> && !StatesTravel<RatedSlider>);
  Bench<Slider> one(two_rooms(), Slider(0.5F, 1.5F));
  Bench<RatedSlider> other(two_rooms(), RatedSlider(0.5F, 1.5F));
  ASSERT_TRUE(one.init().ok());
  ASSERT_TRUE(other.init().ok());
  const float start[] = {2, 6};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    ASSERT_EQ(one.solve({start, Goal::named(0), seed}), Status::solved);
    ASSERT_EQ(other.solve({start, Goal::named(0), seed}), Status::solved);
    EXPECT_EQ(one.planner.plan().hash(), other.planner.plan().hash());
  }
}

// Members that are none of the optional functions: one of two may be meant for others, and numbers are not called.
struct Overloaded : Slider {
  float speed(StateView) const { return 0.0F; }
  double speed() const { return 0.0; }
};
struct WithNumbers : Slider {
  float top_speed = 1.0F;
  bool reversible = true;
};
static_assert(detail::types_match<Overloaded>() && detail::types_match<WithNumbers>());

// Travel's own words: A dt^2 / 8, (W + (turn / dt)^2) dt^2 / 8, and never more than half of path and turn.
TEST(UserRobotDefaults, TravelFollowsFromRates) {
  const Travel slow = detail::travel_of({2.0F, 0.5F, 4.0F, 1.0F}, 0.5F);
  EXPECT_FLOAT_EQ(slow.path, 1.0F);
  EXPECT_FLOAT_EQ(slow.turn, 0.25F);
  EXPECT_FLOAT_EQ(slow.bend, 0.125F);
  EXPECT_FLOAT_EQ(slow.twist, 1.25F * 0.25F / 8);
  const Travel jerky = detail::travel_of({1.0F, 1.0F, 100.0F, 100.0F}, 0.5F);
  EXPECT_FLOAT_EQ(jerky.bend, 0.25F);
  EXPECT_FLOAT_EQ(jerky.twist, 0.25F);
}

TEST(UserRobotDefaults, MayBeLeftOut) {
  const Slider slider(0.5F, 1);
  EXPECT_EQ(detail::self_collision_gap(slider), 2);
  EXPECT_FALSE(detail::reversible(slider));
  const float s[] = {1, 2};
  const float u[] = {0, 0};
  EXPECT_FALSE(detail::quick_bound(slider, StateView(s, 2), ControlView(u, 2), 0.1F, StateView(s, 2)).limits_kept);
  EXPECT_TRUE(detail::sound(slider));
  EXPECT_EQ(detail::first_bad_of_robot(slider), Argument::none);
}

// Of a robot that need not last.
template <RobotModel R>
Argument first_bad(const R& robot) {
  return detail::first_bad_of_robot(robot);
}

TEST(UserRobotDefaults, UnusableBodyIsRefused) {
  EXPECT_EQ(first_bad(Slider(0.0F, 1)), Argument::robot_polygon);
  EXPECT_EQ(first_bad(Slider(-1.0F, 1)), Argument::none);  // mirrored twice it is the same square
}

// A robot that lies about its sizes.
class Oversized : public Slider {
 public:
  using Slider::Slider;
  int state_size() const { return size_; }

 private:
  int size_ = 3;
};

TEST(UserRobotDefaults, SizesBeyondTheMaximaAreRefused) {
  EXPECT_EQ(first_bad(Oversized(0.5F, 1)), Argument::robot_sizes);
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
        ASSERT_EQ(first_bad(Sized(states, controls, bodies)), fits ? Argument::none : Argument::robot_sizes)
            << states << " " << controls << " " << bodies;
      }
    }
  }
}

class Gapped : public Slider {
 public:
  explicit Gapped(int gap) : Slider(0.5F, 1), gap_(gap) {}
  int self_collision_gap() const { return gap_; }

 private:
  int gap_;
};

TEST(UserRobotDefaults, AGapBelowOneIsRefused) {
  for (const int gap : {1, 2, 1000}) EXPECT_EQ(first_bad(Gapped(gap)), Argument::none) << gap;
  for (const int gap : {0, -1, -1000}) EXPECT_EQ(first_bad(Gapped(gap)), Argument::robot_sizes) << gap;
}

TEST(UserRobotDefaults, TheLengthIsThatOfBody0WhicheverVertexIsFirst) {
  std::vector<Vec2> body = {{0.5F, -0.25F}, {0.75F, 0}, {0.5F, 0.25F}, {-0.25F, 0.25F}, {-0.5F, 0}};
  for (std::size_t first = 0; first < body.size(); ++first) {
    Unicycle robot({});
    robot.set_body(0, {body.data(), static_cast<int>(body.size())});
    EXPECT_EQ(detail::robot_length(robot), 1.25F) << first;
    std::rotate(body.begin(), body.begin() + 1, body.end());
  }
}

const float kNan = std::numeric_limits<float>::quiet_NaN();

class OwnCar : public Car {};
static_assert(kAnswersProven<Car> && !kAnswersProven<OwnCar> && !kAnswersProven<Slider>);

// What a train answers beyond x = 5 m.
enum class Lie {
  none,
  heading_of_the_second_body,
  heading_of_the_last_body,
  infinite_heading,
  nan_component,
  infinite_component,
  infinitely_negative_component,
  nan_control,
  infinite_control,
  nan_position_of_the_last_body,
  negative_path,
  negative_turn,
  negative_bend,
  negative_twist,
  negative_travel_of_the_last_body,
  nan_path,
  nan_turn,
  nan_bend,
  nan_twist,
  negative_quick_bound,
  nan_quick_bound
};

// Three squares in a row. Nothing depends on the last component of its state and of its control, and within_limits
// looks at its position only.
class Train : public Slider {
 public:
  static constexpr int kMaxState = 3, kMaxControl = 3, kMaxBodies = 3;
  explicit Train(Lie lie) : Slider(0.3F, 1.5F), lie_(lie) {}

  int state_size() const { return 3; }
  int control_size() const { return 3; }
  int body_count() const { return 3; }

  void derivative(StateView s, ControlView u, StateRef ds) const {
    ds << u[0], u[1], 0.0F;
    if (at(s, Lie::nan_component)) ds[2] = kNan;
    if (at(s, Lie::infinite_component)) ds[2] = kInfinity;
    if (at(s, Lie::infinitely_negative_component)) ds[2] = -kInfinity;
  }

  void steer(StateView s, const Target& target, Steering& steering, ControlRef u) const {
    Slider::steer(s, target, steering, ControlRef(u.data(), 2));
    u[2] = at(s, Lie::nan_control) ? kNan : at(s, Lie::infinite_control) ? kInfinity : 0.0F;
  }

  void place(StateView s, Pose* poses) const {
    for (int k = 0; k < 3; ++k) {
      poses[k] = {position(s) + Vec2{-0.5F * static_cast<float>(k), 0.0F}, {0.0F, 1.0F}};
    }
    if (at(s, Lie::heading_of_the_second_body)) poses[1].heading = {kNan, 1.0F};
    if (at(s, Lie::heading_of_the_last_body)) poses[2].heading = {0.0F, kNan};
    if (at(s, Lie::infinite_heading)) poses[1].heading = {kInfinity, -kInfinity};
    if (at(s, Lie::nan_position_of_the_last_body)) poses[2].position.y = kNan;
  }

  bool travel(StateView s, ControlView u, float dt, StateView, Travel* travel) const {
    for (int k = 0; k < 3; ++k) travel[k] = honest(u, dt);
    if (at(s, Lie::negative_path)) travel[0].path = -1.0F;
    if (at(s, Lie::negative_turn)) travel[0].turn = -1.0F;
    if (at(s, Lie::negative_bend)) travel[0].bend = -1.0F;
    if (at(s, Lie::negative_twist)) travel[0].twist = -1.0F;
    if (at(s, Lie::negative_travel_of_the_last_body)) travel[2] = {-1.0F, -1.0F, -1.0F, -1.0F};
    if (at(s, Lie::nan_path)) travel[1].path = kNan;
    if (at(s, Lie::nan_turn)) travel[1].turn = kNan;
    if (at(s, Lie::nan_bend)) travel[1].bend = kNan;
    if (at(s, Lie::nan_twist)) travel[1].twist = kNan;
    return !quick_lies();
  }

  // Only a train whose lie it is has one that says anything; its travel proves nothing then.
  QuickBound quick_bound(StateView s, ControlView u, float dt, StateView) const {
    QuickBound bound{quick_lies(), 0.0F, honest(u, dt)};
    if (at(s, Lie::negative_quick_bound)) bound.most.path = -1.0F;
    if (at(s, Lie::nan_quick_bound)) bound.most.bend = kNan;
    return bound;
  }

 private:
  bool at(StateView s, Lie lie) const { return lie_ == lie && s[0] > 5.0F; }
  bool quick_lies() const { return lie_ == Lie::negative_quick_bound || lie_ == Lie::nan_quick_bound; }
  static Travel honest(ControlView u, float dt) { return {dt * length({u[0], u[1]}), 0.0F, 0.0F, 0.0F}; }

  Lie lie_;
};

bool all_finite(const std::vector<std::vector<float>>& rows) {
  return std::all_of(rows.begin(), rows.end(), [](const std::vector<float>& row) {
    return std::all_of(row.begin(), row.end(), [](float x) { return finite(x); });
  });
}

std::vector<Lie> every_lie() {
  std::vector<Lie> lies;
  for (int i = 0; i <= static_cast<int>(Lie::nan_quick_bound); ++i) lies.push_back(static_cast<Lie>(i));
  return lies;
}

// The way to the goal leads past x = 5 m, on which side of the door there is room.
template <class P>
void expect_no_plan_through(Lie lie, bool continuous) {
  Bench<Train, P> bench(two_rooms(4), Train(lie));
  bench.parameters.tuning.continuous = continuous;
  bench.limits.iterations = 300;
  ASSERT_TRUE(bench.init().ok());
  const float start[] = {3, 6, 0};
  const Status status = bench.solve({start});
  EXPECT_EQ(status, lie == Lie::none ? Status::solved : Status::budget_used)
      << to_string(status) << " continuous " << continuous;
  EXPECT_EQ(bench.planner.statistics().plans_refused, 0U) << "no way leads through what the tree never kept";
  if (bench.planner.plan().empty()) return;
  const Path path(bench.planner.plan());
  EXPECT_TRUE(all_finite(path.states));
  EXPECT_TRUE(all_finite(path.controls));
}

// A machine that says how fast its state changes, or what is no rate.
class Rated : public Unicycle {
 public:
  explicit Rated(float rate) : Unicycle(small_unicycle()), rate_(rate) {}
  float fastest_rate(float) const { return rate_; }

 private:
  float rate_;
};

Failure init_rated(float rate) {
  Bench<Rated> bench(two_rooms(), Rated(rate));
  return bench.init();
}

TEST(UserRobot, WhoseFastestRateIsNoneIsRefused) {
  for (const float rate : {kNan, -1.0F, kInfinity}) {
    const Failure failure = init_rated(rate);
    EXPECT_EQ(failure.status, Status::bad_argument) << rate;
    EXPECT_EQ(failure.element, static_cast<std::uint32_t>(Argument::dt)) << rate;
    EXPECT_EQ(failure.most, 0.0F) << rate;
  }
  for (const float rate : {0.0F, -0.0F, 1.0F}) EXPECT_TRUE(init_rated(rate).ok()) << rate;
}

class LyingTrain : public ::testing::TestWithParam<Lie> {};

TEST_P(LyingTrain, GetsNoPlanThroughItsLie) {
  for (const bool continuous : {true, false}) {
    expect_no_plan_through<Planner>(GetParam(), continuous);
    expect_no_plan_through<rivals::PlainPlanner>(GetParam(), continuous);
  }
}

INSTANTIATE_TEST_SUITE_P(Lies, LyingTrain, ::testing::ValuesIn(every_lie()),
                         [](const auto& lie) { return std::to_string(static_cast<int>(lie.param)); });

}  // namespace
}  // namespace krait::test::user_robot_test
