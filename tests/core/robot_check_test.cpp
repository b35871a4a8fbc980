// SPDX-License-Identifier: Apache-2.0
// check_robot finds nothing in the library's models, and names what a wrong robot does wrong.
#include "krait/robot_check.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "checked_robots.hpp"
#include "motion/rk4.hpp"
#include "robot_oracle.hpp"

namespace krait {
namespace test {

// Trusted, and takes one number that is not finite for a speed.
class TrustedCart : public Cart {
 public:
  explicit TrustedCart(float taken) : taken_(taken) {}
  bool within_limits(StateView s) const { return Cart::within_limits(s) || is_taken(s[3]); }

 private:
  bool is_taken(float speed) const { return std::isnan(taken_) ? std::isnan(speed) : speed == taken_; }

  float taken_;
};

}  // namespace test

template <>
inline constexpr bool kAnswersProven<test::TrustedCart> = true;

}  // namespace krait

namespace krait::test::robot_check_test {
namespace {

using ::testing::HasSubstr;

template <class R>
requires kTows<R> RobotRanges ranges_of(const R& chain) {
  constexpr int kCar = R::kCarState;
  const auto& p = chain.parameters();
  const float hitch = 0.999F * p.max_hitch_angle;
  RobotRanges ranges;
  ranges.state = {{-10, 10}, {-10, 10}, {-3, 3}};
  if constexpr (std::is_base_of_v<Chain, R>) {
    ranges.state.push_back({p.min_speed, p.max_speed});
    ranges.state.push_back({-p.max_steering, p.max_steering});
  }
  ranges.headings = {2};
  for (int i = 0; i < p.trailers; ++i) {
    ranges.state.push_back({-hitch, hitch});
    ranges.headings.push_back(kCar + i);
  }
  for (const Range range : control_limits(chain)) ranges.control.push_back({range.low, range.high});
  ranges.complete_state = [](std::vector<float>& s) {
    for (std::size_t i = kCar; i < s.size(); ++i) s[i] += i == kCar ? s[2] : s[i - 1];
  };
  ranges.leaving_share = p.trailers > 0 ? 0.5F : 0.0F;  // a hitch that is bent to its limit folds, whatever is steered
  return ranges;
}

template <class R>
requires std::derived_from<R, PlanarBody> RobotRanges ranges_of(const R& robot) {
  RobotRanges ranges;
  ranges.state = {{-10, 10}, {-10, 10}, {-3, 3}};
  ranges.headings = {2};
  for (const Range range : motion_limits(robot)) ranges.state.push_back({range.low, range.high});
  for (const Range range : control_limits(robot)) ranges.control.push_back({range.low, range.high});
  return ranges;
}

template <class R>
class RobotCheck : public ::testing::Test {};
TYPED_TEST_SUITE(RobotCheck, Models, ModelNames);

TYPED_TEST(RobotCheck, FindsNothingInTheModelsOfTheLibrary) {
  for (const TypeParam& robot : instances<TypeParam>()) {
    RobotRanges ranges = ranges_of(robot);
    ranges.dt = {0.025F, 0.1F, 0.2F};
    const RobotReport report = check_robot(robot, ranges, 100);
    EXPECT_TRUE(report.ok()) << report.text();
    EXPECT_EQ(report.samples, 100);
  }
}

// Of a robot that lasts as long as the call.
template <class R>
RobotReport report_of(const R& robot, const RobotRanges& ranges, int samples = 1000) {
  return check_robot(robot, ranges, samples);
}

struct Expected {
  Wrong wrong;
  const char* function;
  const char* promise;
  const char* says;  // part of the message
};
void PrintTo(const Expected& expected, std::ostream* out) { *out << expected.function << " " << expected.promise; }

const RobotFault* find(const RobotReport& report, const std::string& function, const std::string& promise) {
  for (const RobotFault& fault : report.faults) {
    if (fault.function == function && fault.promise == promise) return &fault;
  }
  return nullptr;
}

void expect_named(const RobotReport& report, const char* function, const char* promise, const char* says) {
  const RobotFault* fault = find(report, function, promise);
  ASSERT_NE(fault, nullptr) << report.text();
  EXPECT_THAT(fault->message, HasSubstr(says));
  EXPECT_GT(fault->samples, 0);
  EXPECT_LE(fault->samples, report.samples);
  EXPECT_THAT(report.text(), HasSubstr(std::string(function) + " (" + promise + "): " + fault->message));
}

TEST(RobotCheckCart, FindsNothingWrong) {
  const RobotReport report = report_of(Cart(), cart_ranges(), 1000);
  EXPECT_TRUE(report.ok()) << report.text();
}

class RobotCheckNames : public ::testing::TestWithParam<Expected> {};

TEST_P(RobotCheckNames, WhatIsWrong) {
  const Expected& expected = GetParam();
  const RobotReport report = report_of(Cart(expected.wrong), cart_ranges(), 300);
  expect_named(report, expected.function, expected.promise, expected.says);
}

INSTANTIATE_TEST_SUITE_P(
    Functions, RobotCheckNames,
    ::testing::Values(
        Expected{Wrong::derivative_nan, "derivative", "finite", "number 1 of its result is "},
        Expected{Wrong::derivative_counts_its_calls, "derivative", "pure", "no counter, no clock"},
        Expected{Wrong::derivative_leaves_a_rate_unwritten, "derivative", "complete", "leaves number 3"},
        Expected{Wrong::derivative_depends_on_the_place, "derivative", "anywhere", "the rate of component 2 is"},
        Expected{Wrong::derivative_mixes_sine_and_cosine, "derivative", "direction", "the rate of component 0 is"},
        Expected{Wrong::derivative_leaps_to_and_fro, "derivative", "smooth", "do not tell where it leads"},
        Expected{Wrong::limits_count_their_calls, "within_limits", "pure", "and then"},
        Expected{Wrong::limits_depend_on_the_place, "within_limits", "anywhere", "is not within the limits"},
        Expected{Wrong::body_grows, "body", "pure", "another shape"},
        Expected{Wrong::place_nan_heading_of_the_second_body, "place", "finite", "the frame of body 1 has the heading"},
        Expected{Wrong::place_long_heading, "place", "unit", "the heading of body 1 has the length 1.0"},
        Expected{Wrong::place_short_heading, "place", "unit", "the heading of body 1 has the length 0.5,"},
        Expected{Wrong::place_off_the_position, "place", "origin", "is 0.25 m away"},
        Expected{Wrong::place_leaps, "place", "continuous", "the frame of body 1 leaps by 0.50"},
        Expected{Wrong::place_leaves_a_frame_unwritten, "place", "complete", "leaves number 4"},
        Expected{Wrong::place_keeps_to_the_north, "place", "direction", "the frame of body 1 is off by"},
        Expected{Wrong::travel_negative, "travel", "number", "the bound of body 1 is ["},
        Expected{Wrong::travel_nan, "travel", "number", "nan"},
        Expected{Wrong::travel_leaves_a_body_unwritten, "travel", "complete", "leaves number 5"},
        Expected{Wrong::travel_path_too_small, "travel", "path", "where body 1 moved by"},
        Expected{Wrong::travel_turn_too_small, "travel", "turn", "where body 0 moved by"},
        Expected{Wrong::travel_bend_too_small, "travel", "bend", "Raise bend"},
        Expected{Wrong::travel_twist_too_small, "travel", "twist", "Raise twist"},
        Expected{Wrong::travel_vouches_for_limits_that_break, "travel", "limits", "is beyond them"},
        Expected{Wrong::travel_depends_on_the_heading, "travel", "direction", "the bound of body 0 is ["},
        Expected{Wrong::quick_path_too_small, "quick_bound", "path", "Raise path"},
        Expected{Wrong::quick_negative, "quick_bound", "number", "(path, turn, bend, twist)"},
        Expected{Wrong::quick_separation_too_large, "quick_bound", "separation", "separation is 1.1 m"},
        Expected{Wrong::quick_separation_nan, "quick_bound", "separation", "separation is NaN"},
        Expected{Wrong::quick_vouches_for_limits_that_break, "quick_bound", "limits", "is beyond them"},
        Expected{Wrong::steer_beyond_its_limits, "steer", "control", "not within -2 and 2"},
        Expected{Wrong::steer_below_its_limits, "steer", "control", "not within -2 and 2"},
        Expected{Wrong::steer_nan_at_the_target, "steer", "control", "0 / 0"},
        Expected{Wrong::steer_too_fast, "steer", "limits", "it leads beyond the limits, to ["},
        Expected{Wrong::steer_counts_its_calls, "steer", "pure", "called again it returns"},
        Expected{Wrong::steer_remembers_its_calls, "steer", "pure", "what it leaves in its Steering"},
        Expected{Wrong::steer_never_brakes, "steer", "brake", "toward a target whose speed is 0 it goes from "},
        Expected{Wrong::speed_is_never_0, "steer", "brake", "it goes from 0.1 to 0.1 m/s"},
        Expected{Wrong::rate_too_small, "fastest_rate", "step", "at 0.1 1/s a Runge-Kutta step of 0.4 s"},
        Expected{Wrong::rate_nan, "fastest_rate", "number", "fastest_rate is"}),
    [](const auto& expected) {
      return std::to_string(static_cast<int>(expected.param.wrong)) + "_" + expected.param.function + "_" +
             expected.param.promise;
    });

// Says how fast it is, how it stops and turns.
struct PacedCart : Cart {
  float share = 1;
  float way = -0.1F;
  float radius = 0;
  float top = 1;

  float speed(StateView s) const { return share * s[3]; }
  float stopping_way(StateView) const { return way; }
  float turning_radius() const { return radius; }
  float top_speed() const { return top; }
};

TEST(RobotCheckPacedCart, FindsNothingWrong) {
  const RobotReport report = report_of(PacedCart(), cart_ranges(), 20);
  EXPECT_TRUE(report.ok()) << report.text();
}

TEST(RobotCheckPacedCart, NamesNumbersThatNoSearchCanUse) {
  const float nan = std::nanf("");
  const float infinite = std::numeric_limits<float>::infinity();
  const auto expect_wrong = [](float PacedCart::*number, const std::vector<float>& values, const char* function) {
    for (const float value : values) {
      PacedCart cart;
      cart.*number = value;
      const RobotReport report = report_of(cart, cart_ranges(), 20);
      EXPECT_NE(find(report, function, "number"), nullptr) << function << " " << value << ": " << report.text();
    }
  };
  expect_wrong(&PacedCart::share, {nan, -1, infinite}, "speed");
  expect_wrong(&PacedCart::way, {nan, -infinite}, "stopping_way");
  expect_wrong(&PacedCart::radius, {nan, -1}, "turning_radius");
  expect_wrong(&PacedCart::top, {nan, 0, -1, infinite}, "top_speed");
}

struct ExpectedOfFront {
  WrongFront wrong;
  const char* function;
  const char* promise;
  const char* says;
};

TEST(RobotCheckFront, NamesWhatIsWrongWithLeadingComponents) {
  ChainParameters parameters;
  parameters.trailers = 2;
  const RobotRanges ranges = ranges_of(Truck(parameters));
  EXPECT_EQ(report_of(FrontTruck(parameters, WrongFront::nothing), ranges, 200).text(), "");
  for (const ExpectedOfFront& e :
       {ExpectedOfFront{WrongFront::size, "leading_size", "range", "leading_size is 99"},
        ExpectedOfFront{WrongFront::derivative, "leading_size", "derivative", "of the whole state ["},
        ExpectedOfFront{WrongFront::place, "leading_size", "place", "writes other bodies than body 0"},
        ExpectedOfFront{WrongFront::place_alone, "leading_size", "place", "puts body 0 elsewhere"},
        ExpectedOfFront{WrongFront::lead_step, "integrate_lead", "step", "to component 0, where"},
        ExpectedOfFront{WrongFront::rest_step, "integrate_rest", "step", "to component 5, where"},
        ExpectedOfFront{WrongFront::lead_alone, "integrate_lead", "leading", "of the leading components alone"},
        ExpectedOfFront{WrongFront::rest_unwritten, "integrate_rest", "complete", "leaves number 5"}}) {
    SCOPED_TRACE(e.says);
    expect_named(report_of(FrontTruck(parameters, e.wrong), ranges, 200), e.function, e.promise, e.says);
  }
}

// What keeps the check from beginning is a fault, too.
TEST(RobotCheckRanges, ThatDoNotFitAreNamed) {
  RobotRanges ranges = cart_ranges();
  ranges.state.pop_back();
  EXPECT_THAT(report_of(Cart(), ranges).text(), HasSubstr("there are 3 ranges of states, 2 of controls and 3"));
  ranges = cart_ranges();
  ranges.dt.clear();
  EXPECT_THAT(report_of(Cart(), ranges).text(), HasSubstr("0 time steps"));
  for (const int heading : {-1, 1, 4}) {
    ranges = cart_ranges();
    ranges.headings = {heading};
    EXPECT_THAT(report_of(Cart(), ranges).text(), HasSubstr("of the state is named a heading; those from 2 to 3"));
  }
  ranges.headings = {2, 2};
  EXPECT_THAT(report_of(Cart(), ranges).text(), HasSubstr("component 2 of the state is named a heading twice."));
  EXPECT_THAT(report_of(Cart(), cart_ranges(), 0).text(), HasSubstr("no sample was asked for"));
  EXPECT_THAT(report_of(Cart(Wrong::limits_nowhere), cart_ranges()).text(),
              HasSubstr("narrow the ranges of the state"));
  EXPECT_THAT(report_of(Cart(Wrong::body_clockwise), cart_ranges()).text(), HasSubstr("robot_polygon"));
}

// Neither blamed on the robot nor taken for a reason to check less.
TEST(RobotCheckRanges, ThatCannotBeUsedAreNamedBeforeAnySample) {
  const float nan = std::nanf("");
  const auto expect_refused = [](const char* promise, const char* says, const auto& spoil) {
    SCOPED_TRACE(says);
    RobotRanges ranges = cart_ranges();
    spoil(ranges);
    const RobotReport report = report_of(Cart(), ranges, 20);
    EXPECT_EQ(report.samples, 0);
    EXPECT_EQ(report.faults.size(), 1U);
    ASSERT_NE(find(report, "ranges", promise), nullptr) << report.text();
    EXPECT_THAT(report.text(), HasSubstr(says));
  };
  for (const float dt : {0.0F, -0.1F, nan, kInfinity}) {
    expect_refused("dt", "a time step is ", [dt](RobotRanges& r) { r.dt[1] = dt; });
  }
  for (const RobotRange& bad : {RobotRange{nan, 1}, RobotRange{1, nan}, RobotRange{1, -1}, RobotRange{-kInfinity, 1},
                                RobotRange{0, kInfinity}, RobotRange{-3e38F, 3e38F}}) {
    expect_refused("state", "the range of component 3 of the state is [", [&](RobotRanges& r) { r.state[3] = bad; });
    expect_refused("control", "component 1 of the control is [", [&](RobotRanges& r) { r.control[1] = bad; });
  }
  for (const float bad : {-0.1F, nan, kInfinity}) {
    expect_refused("leaving_share", "it must be from 0 to 1", [bad](RobotRanges& r) { r.leaving_share = bad; });
    expect_refused("step_rate", "step_rate is ", [bad](RobotRanges& r) { r.step_rate = bad; });
    expect_refused("step_error", "step_error is ", [bad](RobotRanges& r) { r.step_error = bad; });
  }
  expect_refused("leaving_share", "leaving_share is 1.5", [](RobotRanges& r) { r.leaving_share = 1.5F; });
}

TEST(RobotCheckRanges, MayBeOfASinglePoint) {
  RobotRanges ranges = cart_ranges();
  ranges.state[3] = {1, 1};
  ranges.step_rate = 0.0F;
  ranges.leaving_share = 1.0F;
  EXPECT_EQ(report_of(Cart(), ranges, 20).text(), "");
}

TEST(RobotCheckRanges, HaveTheStepRateOfTheTree) { EXPECT_EQ(RobotRanges().step_rate, detail::kStepRate); }

// Does not say how fast its motion changes, so that every time step counts as short enough.
class QuietCart : public Cart {
 public:
  float fastest_rate(float) const = delete;
};

TEST(RobotCheckRate, IsNotCheckedWhereThereIsNone) {
  RobotRanges ranges = cart_ranges();
  ranges.step_error = 0.0F;
  EXPECT_NE(find(report_of(Cart(), ranges, 50), "fastest_rate", "step"), nullptr);
  EXPECT_EQ(report_of(QuietCart(), ranges, 50).text(), "");
}

// Its bodies are not tested against each other, so that their origins may be said to be as far apart as one likes.
class LooseCart : public Cart {
 public:
  using Cart::Cart;
  int self_collision_gap() const { return 2; }
  QuickBound quick_bound(StateView s, ControlView u, float dt, StateView next) const {
    QuickBound bound = Cart::quick_bound(s, u, dt, next);
    bound.separation += kInfinity;
    return bound;
  }
};

TEST(RobotCheckSeparation, MayBeInfiniteWhereNoTwoBodiesAreTestedAgainstEachOther) {
  EXPECT_EQ(report_of(LooseCart(), cart_ranges(), 50).text(), "");
  const LooseCart nan(Wrong::quick_separation_nan);
  expect_named(report_of(nan, cart_ranges(), 50), "quick_bound", "separation", "separation is NaN");
}

TEST(RobotCheckTrust, ARobotThatTakesWhatIsNotFiniteForAStateMustNotBeTrusted) {
  const auto expect_found = [](float taken, const char* says) {
    expect_named(report_of(TrustedCart(taken), cart_ranges(), 50), "within_limits", "finite", says);
  };
  expect_found(std::nanf(""), "component 3 may be nan");
  expect_found(kInfinity, "component 3 may be inf");
  expect_found(-kInfinity, "component 3 may be -inf");
}

TEST(RobotCheckLeaving, MoreStepsThanAllowedAreNamed) {
  RobotRanges ranges = cart_ranges();
  ranges.leaving_share = 0.001F;
  const RobotReport report = report_of(Cart(Wrong::steer_too_fast), ranges, 200);
  EXPECT_EQ(find(report, "steer", "limits"), nullptr);
  ASSERT_NE(find(report, "steer", "leaving"), nullptr) << report.text();
  EXPECT_THAT(find(report, "steer", "leaving")->message, HasSubstr("more than the 0.1 % that the ranges allow"));
  EXPECT_GT(find(report, "steer", "leaving")->amount, 0);
  EXPECT_LE(find(report, "steer", "leaving")->amount, 0.999);
  EXPECT_EQ(find(report, "steer", "leaving")->samples, 0);
  ranges.leaving_share = 1.0F;
  EXPECT_EQ(report_of(Cart(Wrong::steer_too_fast), ranges, 200).text(), "");
}

// Speeds up by more than its limits in a second, whatever its control, and says that it stays where it is.
class Sprinter : public Cart {
 public:
  void derivative(StateView s, ControlView u, StateRef ds) const {
    Cart::derivative(s, u, ds);
    ds[3] += kAcceleration + 1.01F * kSpeed;
  }
  bool travel(StateView, ControlView, float, StateView, Travel* travel) const {
    travel[0] = travel[1] = Travel{0.0F, 0.0F, 0.0F, 0.0F};
    return true;
  }
};

TEST(RobotCheckDriven, ATimeStepThatNoControlEndsWithinTheLimitsIsNamed) {
  constexpr const char* kSays = "samples with a time step of 1 s none of 20 controls ends it within the limits";
  RobotRanges ranges = cart_ranges();
  ranges.leaving_share = 1.0F;
  ranges.step_rate = 0.0F;
  ranges.dt = {1.0F};
  const RobotReport blind = report_of(Sprinter(), ranges, 50);
  EXPECT_EQ(blind.faults.size(), 1U) << blind.text();
  ASSERT_NE(find(blind, "ranges", "motion"), nullptr);
  EXPECT_THAT(find(blind, "ranges", "motion")->message, HasSubstr(std::string("in 50 of 50 ") + kSays));

  ranges.dt = {0.1F, 1.0F};
  const RobotReport half = report_of(Sprinter(), ranges, 50);
  expect_named(half, "travel", "path", "Raise path");
  ASSERT_NE(find(half, "ranges", "motion"), nullptr) << half.text();
  EXPECT_THAT(find(half, "ranges", "motion")->message, HasSubstr(kSays));
}

TEST(RobotCheckReport, TellsStateControlAndStepOfTheWorst) {
  const RobotReport report = report_of(Cart(Wrong::travel_bend_too_small), cart_ranges(), 300);
  const RobotFault* fault = find(report, "travel", "bend");
  ASSERT_NE(fault, nullptr);
  EXPECT_THAT(fault->message, HasSubstr("at the state ["));
  EXPECT_THAT(fault->message, HasSubstr("under the control ["));
  EXPECT_THAT(fault->message, HasSubstr("for 0.400000006 s"));
  // With a bar of a metre that turns at 2 rad/s for 0.4 s, the bend that is left out is at most 0.08 m.
  EXPECT_GT(fault->amount, 0.05);
  EXPECT_LT(fault->amount, 0.0801);
}

TEST(RobotCheckReport, TellsNoSamplesOfAFaultOfTheWholeCheck) {
  const RobotReport refused = report_of(Cart(Wrong::body_clockwise), cart_ranges());
  ASSERT_EQ(refused.faults.size(), 1U);
  EXPECT_EQ(refused.faults[0].amount, static_cast<double>(kInfinity));
  EXPECT_EQ(refused.faults[0].samples, 0);
  EXPECT_EQ(refused.text(), "body (robot_polygon): " + refused.faults[0].message + "\n");
}

TEST(RobotCheckReport, IsTheSameForTheSameSeed) {
  const Cart cart(Wrong::travel_path_too_small);
  const std::string first = check_robot(cart, cart_ranges(), 100, 7).text();
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(check_robot(cart, cart_ranges(), 100, 7).text(), first);
  EXPECT_NE(check_robot(cart, cart_ranges(), 100, 8).text(), first);
}

}  // namespace
}  // namespace krait::test::robot_check_test
