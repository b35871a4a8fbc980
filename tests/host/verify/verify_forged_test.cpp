// SPDX-License-Identifier: Apache-2.0
// Ten families of forged plans. Each is drawn for several robots and seeds, is made from a plan that holds, and is
// refused by a sentence that names what is forged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "plans.hpp"

namespace krait::host::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double kInside = 1.0;  // m, from the end of a plan to the sides of its goal

void expect_holds(const Case& c) {
  const Verdict verdict = c.verdict();
  EXPECT_TRUE(verdict.holds);
  for (const std::string& line : verdict.complaints) ADD_FAILURE() << line;
}

template <typename Matcher>
void expect_refused(const Case& c, const Matcher& sentence) {
  const Verdict verdict = c.verdict();
  EXPECT_FALSE(verdict.holds);
  EXPECT_THAT(verdict.complaints, Contains(sentence));
}

struct Draw {
  std::string model;
  int links;
  unsigned seed;
};

std::vector<Draw> draws() {
  std::vector<Draw> all;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    for (const RobotSpec& spec : every_robot(4)) all.push_back({spec.model, spec.links, seed});
  }
  return all;
}

// Draws plans that hold. All of them drive forward at about 1 m/s once they are at speed.
class ForgedPlan : public ::testing::TestWithParam<Draw> {
 protected:
  ForgedPlan() {
    if (spec_.model == "diff_drive") spec_.parameters["max_wheel_acceleration"] = 12;
  }

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double any_side() { return uniform(0, 1) < 0.5 ? 1 : -1; }
  bool is_car_like() const { return has_front_axle(spec_.model); }
  // Whether its controls are speeds, of which its states have none.
  bool is_first_order() const { return spec_.model == "unicycle" || spec_.model == "kinematic_truck"; }

  // Controls that bring the robot to speed within the first second, then keep it; `turning` rad/s.
  Row cruise(double time, double dt, double turning) const {
    const bool starts = time + dt <= 1 + 1e-9;
    if (spec_.model == "unicycle") return {1, turning};
    if (spec_.model == "kinematic_truck") return {1, std::atan(0.8 * turning)};
    if (!starts) return {0, 0};
    if (spec_.model == "unicycle2") return {1, turning};
    if (spec_.model == "diff_drive") return {10 - 2 * turning, 10 + 2 * turning};
    return {1, std::asin(0.8 * turning)};
  }

  Case cruising(double turning, double dt, double seconds) {
    const auto steer = [&](std::size_t step, const Row&) {
      return cruise(static_cast<double>(step) * dt, dt, turning);
    };
    return drive(spec_, steer, static_cast<std::size_t>(std::lround(seconds / dt)), {20, 20}, heading_, dt);
  }

  // A drawn plan of five seconds.
  Case sound() {
    const double turning = uniform(0.1, 0.3) * any_side();
    return cruising(turning, 0.1 / std::uniform_int_distribution<int>(1, 5)(random_), 5);
  }

  // A rectangle in the frame of the start.
  Ring ahead(double min_x, double min_y, double max_x, double max_y) const {
    Ring ring = rectangle(min_x, min_y, max_x, max_y);
    for (Point& p : ring) {
      p = {20 + std::cos(heading_) * p.x - std::sin(heading_) * p.y,
           20 + std::sin(heading_) * p.x + std::cos(heading_) * p.y};
    }
    return ring;
  }

  static void add_wall(Case& c, const Ring& ring) { c.workspace.obstacles.push_back({"the wall", ring, {}}); }

  // Moves a stored state to the left of the start's heading.
  void move_left(Case& c, std::size_t state, double by) const {
    c.plan.states[state][0] -= static_cast<float>(by * std::sin(heading_));
    c.plan.states[state][1] += static_cast<float>(by * std::cos(heading_));
  }

  std::size_t any_state(const Case& c) {
    return std::uniform_int_distribution<std::size_t>(c.plan.states.size() / 3, c.plan.states.size() - 2)(random_);
  }

  RobotSpec spec_ = robot(GetParam().model, GetParam().links);
  std::mt19937 random_{GetParam().seed};
  double heading_ = uniform(-3, 3);
};

INSTANTIATE_TEST_SUITE_P(Draws, ForgedPlan, ::testing::ValuesIn(draws()), [](const auto& chosen) {
  return chosen.param.model + std::to_string(chosen.param.links) + "_" + std::to_string(chosen.param.seed);
});

// 1. The controls drive straight into a post; the states step aside, by less than 5 mm each, and come back behind it.
TEST_P(ForgedPlan, BySteppingAsideInEveryStep) {
  const double dt = 0.02;
  Case c = cruising(0, dt, 6);
  expect_holds(c);
  const double side = any_side();
  add_wall(c, ahead(3, -side * 0.22 - 0.01, 3.02, -side * 0.22 + 0.01));
  const auto count = static_cast<double>(c.plan.controls.size());
  for (std::size_t i = 0; i < c.plan.states.size(); ++i) {
    move_left(c, i, side * 4.5e-3 * (count / 2 - std::abs(static_cast<double>(i) - count / 2)));
  }
  expect_refused(c, AllOf(StartsWith("step "), HasSubstr(": body 0 overlaps the wall by up to 0.0")));
  expect_refused(c, AllOf(StartsWith("state 1: "), HasSubstr(" strays by "), HasSubstr("where the controls lead")));
}

// The same without a wall, in one step only.
TEST_P(ForgedPlan, BySteppingAsideOnce) {
  Case c = sound();
  expect_holds(c);
  const std::size_t state = any_state(c);
  move_left(c, state, 4e-3);
  expect_refused(c, AllOf(StartsWith("state " + std::to_string(state) + ": "), HasSubstr(" strays by 0.00"),
                          HasSubstr(" in one step from where the controls lead")));
}

// 2. A time step longer than the states were made for.
TEST_P(ForgedPlan, ByALongerTimeStep) {
  Case c = sound();
  c.asked.dt = c.plan.dt;
  expect_holds(c);
  c.plan.dt *= uniform(1.01, 2);
  expect_refused(c, StartsWith("dt: is "));
  c.asked.dt.reset();
  expect_refused(c, AllOf(StartsWith("state "), HasSubstr("from where the controls lead")));
  c.plan.dt = uniform(1.01, 100);
  expect_refused(c, HasSubstr("s, must be from 0.001 to 1 s"));
}

// States a second apart, on both sides of a thin wall.
TEST_P(ForgedPlan, ByALongTimeStepOverAWall) {
  Case c = cruising(0, 1, 6);
  expect_holds(c);
  const Case asked_for_less = [&] {
    Case other = c;
    other.asked.dt = 0.1;
    return other;
  }();
  expect_refused(asked_for_less, "dt: is 1 s, asked 0.1 s");
  const auto& at = c.plan.states[3];
  const double way = std::hypot(static_cast<double>(at[0]) - 20, static_cast<double>(at[1]) - 20);
  add_wall(c, ahead(way + 0.45, -0.3, way + 0.451, 0.3));
  expect_refused(c, AllOf(StartsWith("step 3 at 0 s: "), HasSubstr("body 0 overlaps the wall")));
}

// 3. A time step of a millisecond: 6,000 controls lead straight through a wall, 6,000 states walk round it.
TEST_P(ForgedPlan, ByAShortTimeStep) {
  const double turning = 0.5 * any_side();
  Case c = cruising(turning, 0.001, 6);
  add_wall(c, ahead(3.2, -0.4, 3.3, 0.4));
  expect_holds(c);
  c.plan.controls = cruising(0, 0.001, 6).plan.controls;
  expect_refused(c, AllOf(StartsWith("step "), HasSubstr(": body 0 overlaps the wall by up to 0.")));
  expect_refused(c, AllOf(StartsWith("state "), HasSubstr("from where the controls lead")));
}

// 4. States that drift away too slowly for any step to show it, and come back before the end.
TEST_P(ForgedPlan, ByDriftAndBack) {
  Case c = sound();
  expect_holds(c);
  const std::size_t middle = c.plan.states.size() / 2;
  const double rate = uniform(0.5, 0.9) * 1e-2 * c.plan.dt;
  for (std::size_t i = 0; i < c.plan.states.size(); ++i) {
    const std::size_t away = std::min(i, c.plan.states.size() - 1 - i);
    move_left(c, i, rate * static_cast<double>(std::min(away, middle)));
  }
  expect_refused(c, AllOf(StartsWith("state "), HasSubstr(" differs by 0.005"), HasSubstr("where the controls lead")));
  EXPECT_NEAR(c.verdict().drift, rate * static_cast<double>(middle), 0.3 * rate * static_cast<double>(middle));
}

// The drift stays within the tolerance, but a wall stands where the robot really drives.
TEST_P(ForgedPlan, ByDriftPastAWall) {
  Case c = cruising(0, 0.1, 6);
  add_wall(c, ahead(3, 0.2505, 3.2, 0.3));
  expect_holds(c);
  c.workspace.obstacles.clear();
  for (std::size_t i = 0; i < c.plan.states.size(); ++i) {
    move_left(c, i, -1e-4 * static_cast<double>(std::min(i, c.plan.states.size() - 1 - i)));
  }
  expect_holds(c);
  add_wall(c, ahead(3, 0.249, 3.2, 0.3));
  expect_refused(c, AllOf(StartsWith("step "), HasSubstr(": body 0 overlaps the wall by up to 0.00")));
}

// 5. Limits that hold in every stored state but not between them.
TEST_P(ForgedPlan, ByLimitsBrokenBetweenStates) {
  const double dt = 0.1;
  const double swing = uniform(16, 23);
  spec_.parameters["max_steering_rate"] = 24;
  spec_.parameters["max_steering"] = 1.5;
  const bool turns = spec_.model == "unicycle2";
  if (turns) spec_.parameters["max_turn_acceleration"] = 24;
  const bool folds = GetParam().links > 0 && is_car_like();
  const auto steer = [&](std::size_t step, const Row&) -> Row {
    if (is_first_order()) return {step == 10 ? 2.0 : 1.0, 0};
    if (spec_.model == "diff_drive") return step < 10 ? Row{5, 5} : step == 10 ? Row{-8, 8} : Row{0, 0};
    if (step < 10) return {2, 0};
    return step < 13 ? Row{0, 4} : step == 13 ? Row{0, -swing} : Row{0, 0};
  };
  Case c = drive(spec_, steer, 14, {20, 20}, heading_, dt);
  expect_holds(c);
  const auto lower = [&](const char* parameter, double limit) {
    c.asked.robot.parameters[parameter] = limit;
    c.plan.robot = c.asked.robot;
  };
  if (!folds) {
    // What the states cannot show at all: a control that is beyond its limit for one step.
    if (is_car_like()) lower("max_steering_rate", swing / 1.001);
    if (turns) lower("max_turn_acceleration", swing / 1.001);
    if (is_first_order()) lower("max_speed", 1.99);
    if (spec_.model == "diff_drive") lower("max_wheel_acceleration", 7.9);
    expect_refused(
        c, AllOf(StartsWith(is_car_like() || turns ? "step 13: " : "step 10: "), HasSubstr("is beyond its limit")));
    return;
  }
  const auto bend = [](const auto& state) { return static_cast<double>(state[2]) - static_cast<double>(state[5]); };
  const Row from(c.plan.states[13].begin(), c.plan.states[13].end());
  double most = 0;
  for (int i = 1; i < 20; ++i) most = std::max(most, bend(simulate(spec_, from, {0, -swing}, dt * i / 20)));
  const double ends = std::max(bend(from), bend(c.plan.states[14]));
  ASSERT_GT(most, ends + 2e-3);
  lower("max_hitch_angle", (most + ends) / 2);
  expect_refused(c, AllOf(StartsWith("step 13 at 0.0"), HasSubstr("hitch angle 1 is beyond its limit")));
}

// Stored speeds that keep just below a limit which the controls pass.
TEST_P(ForgedPlan, ByStoredSpeedsBelowALimit) {
  Case c = cruising(0, 0.1, 5);
  expect_holds(c);
  if (is_first_order()) {
    c.asked.robot.parameters["max_speed"] = c.plan.robot.parameters["max_speed"] = 0.998;
    expect_refused(c, StartsWith("step 0: speed is beyond its limit of 0.998 by up to 0.002"));
    return;
  }
  const bool car = spec_.model != "diff_drive";  // its v is limited
  const double limit = car ? 0.998 : 9.998;
  c.asked.robot.parameters[car ? "max_speed" : "max_wheel_speed"] = limit;
  c.plan.robot = c.asked.robot;
  for (auto& state : c.plan.states) {
    for (const std::size_t i : car ? std::vector<std::size_t>{3} : std::vector<std::size_t>{3, 4}) {
      state[i] *= static_cast<float>(limit / (car ? 1 : 10));
    }
  }
  expect_refused(c, AllOf(StartsWith("step 9 at 0."), HasSubstr("speed is beyond its limit of ")));
}

// 6. Only drift leads the stored states into the goal.
TEST_P(ForgedPlan, ByAGoalThatOnlyDriftTouches) {
  Case c = sound();
  const auto& end = c.plan.states.back();
  const Point at{static_cast<double>(end[0]), static_cast<double>(end[1])};
  const double beyond = uniform(5e-4, 3e-3);
  c.asked.goal = rectangle(at.x - kInside, at.y + beyond, at.x + kInside, at.y + 2 * kInside);
  c.plan.goal_polygon = c.asked.goal;
  Case inside = c;
  inside.asked.goal = inside.plan.goal_polygon =
      rectangle(at.x - kInside, at.y - 1e-4, at.x + kInside, at.y + 2 * kInside);
  expect_holds(inside);
  const auto count = static_cast<double>(c.plan.controls.size());
  for (std::size_t i = 0; i < c.plan.states.size(); ++i) {
    c.plan.states[i][1] += static_cast<float>((beyond + 1e-4) * static_cast<double>(i) / count);
  }
  const Verdict verdict = c.verdict();
  EXPECT_THAT(verdict.complaints, ::testing::ElementsAre(StartsWith("goal: the driven end lies 0.00")));
  EXPECT_NEAR(verdict.goal_depth, -beyond, 1e-5);
}

// 7. A plan of another robot, which says so or does not.
TEST_P(ForgedPlan, ByAnotherRobot) {
  const Case c = sound();
  expect_holds(c);
  const char* size = is_car_like() ? "wheelbase" : spec_.model == "diff_drive" ? "track_width" : nullptr;
  if (GetParam().links > 0 && GetParam().seed > 1) size = "hitch_length";
  if (size != nullptr) {
    Case other = c;
    other.asked.robot.parameters[size] *= uniform(1.1, 1.5);
    expect_refused(other, StartsWith(std::string("robot: ") + size + " is "));
    other.plan.robot = other.asked.robot;
    expect_refused(other, AllOf(StartsWith("state "), HasSubstr("from where the controls lead")));
  }
  Case slower = c;
  for (auto& [name, value] : slower.asked.robot.parameters) value *= name.starts_with("max_") ? 0.2 : 1;
  expect_refused(slower, HasSubstr("robot: max_"));
  slower.plan.robot = slower.asked.robot;
  expect_refused(slower, HasSubstr("is beyond its limit"));
  Case thinner = c;
  thinner.plan.robot.bodies[0] = rectangle(-0.35, -0.1, 0.35, 0.1);
  expect_refused(thinner, StartsWith("robot: body 0 differs by 0.15 m"));
}

// The plan of a thinner robot through a gap.
TEST_P(ForgedPlan, ByAThinnerRobotThroughAGap) {
  for (Ring& body : spec_.bodies) body = rectangle(-0.35, -0.1, 0.35, 0.1);
  Case c = cruising(0, 0.1, 6);
  add_wall(c, ahead(3, 0.2, 3.2, 0.4));
  expect_holds(c);
  for (Ring& body : c.asked.robot.bodies) body = rectangle(-0.35, -0.25, 0.35, 0.25);
  c.plan.robot = c.asked.robot;
  expect_refused(c, AllOf(StartsWith("step "), HasSubstr(": body 0 overlaps the wall by up to 0.05 m")));
}

// 8. A plan from another start.
TEST_P(ForgedPlan, ByAnotherStart) {
  const Case c = sound();
  expect_holds(c);
  Case moved = c;
  moved.asked.start.position.x += uniform(0.002, 5);
  expect_refused(moved, AllOf(StartsWith("start: state 0 lies "), HasSubstr(" m from the start asked for")));
  Case shifted = c;  // the states agree with the start, but only by their origin
  shifted.plan.origin = {uniform(0.1, 5), 0};
  expect_refused(shifted, StartsWith("start: state 0 lies "));
  Case turned = c;
  turned.asked.start.heading += uniform(0.001, 3);
  expect_refused(turned, AllOf(StartsWith("start: theta"), HasSubstr(" of state 0 is ")));
  Case jumped = c;  // only the first state is as asked
  jumped.asked.start.position.x -= 0.5;
  jumped.plan.states[0][0] -= 0.5F;
  expect_refused(jumped, AllOf(StartsWith("state 1: x "), HasSubstr("where the controls lead")));
}

// A plan that begins at speed, or with bent hitches.
TEST_P(ForgedPlan, ByAStartThatIsNotAtRest) {
  Case c = cruising(0.2, 0.1, 5);
  expect_holds(c);
  c.plan.states.erase(c.plan.states.begin(), c.plan.states.begin() + 15);
  c.plan.controls.erase(c.plan.controls.begin(), c.plan.controls.begin() + 15);
  const auto& first = c.plan.states[0];
  c.asked.start.position = {static_cast<double>(first[0]), static_cast<double>(first[1])};
  c.asked.start.heading = static_cast<double>(first[2]);
  if (is_first_order() && spec_.links > 0) {
    expect_refused(c, StartsWith("start: theta1 of state 0 is "));
  } else if (is_first_order()) {
    expect_holds(c);  // it is at rest wherever it is
  } else {
    expect_refused(
        c, StartsWith(spec_.model == "diff_drive" ? "start: left wheel speed of state 0" : "start: v of state 0 is 1"));
  }
}

// 9. Numbers that are none.
TEST_P(ForgedPlan, ByNotANumber) {
  const Case c = sound();
  expect_holds(c);
  for (const double none : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                            -std::numeric_limits<double>::infinity()}) {
    const auto forged = [&](const auto& forge) {
      Case other = c;
      forge(other);
      return other;
    };
    const std::size_t state = any_state(c);
    const std::string number = std::to_string(state);
    for (std::size_t i = 0; i < c.plan.states[0].size(); ++i) {
      expect_refused(forged([&](Case& o) { o.plan.states[state][i] = static_cast<float>(none); }),
                     "state " + number + " has a number that is not finite");
    }
    for (const std::size_t i : {0U, 1U}) {
      expect_refused(forged([&](Case& o) { o.plan.controls[state][i] = static_cast<float>(none); }),
                     "control " + number + " has a number that is not finite");
    }
    expect_refused(forged([&](Case& o) { o.plan.dt = none; }), StartsWith("dt: is "));
    expect_refused(forged([&](Case& o) { o.plan.origin.y = none; }), "origin: is not finite");
    expect_refused(forged([&](Case& o) { o.plan.goal_polygon[1].x = none; }), "goal: the plan states no polygon");
    expect_refused(forged([&](Case& o) { o.plan.robot.bodies[0][2].y = none; }), StartsWith("robot: body 0 differs"));
    expect_refused(forged([&](Case& o) { o.plan.robot.parameters["max_speed"] = none; }), StartsWith("robot: "));
  }
}

// 10. States that are repeated while the controls move on.
TEST_P(ForgedPlan, ByStatesThatStandStill) {
  const Case c = sound();
  expect_holds(c);
  const std::size_t state = any_state(c);
  Case once = c;
  once.plan.states[state + 1] = once.plan.states[state];
  expect_refused(
      once, AllOf(StartsWith("state " + std::to_string(state + 1) + ": "), HasSubstr("from where the controls lead")));
  Case always = c;
  for (auto& row : always.plan.states) row = always.plan.states[0];
  always.asked.goal = always.plan.goal_polygon = rectangle(19.9, 19.9, 20.1, 20.1);
  expect_refused(always, StartsWith("goal: the driven end lies "));
  expect_refused(always, AllOf(StartsWith("state "), HasSubstr("from where the controls lead")));
}

TEST_P(ForgedPlan, ByStepsThatAreRepeatedOrLeftOut) {
  const Case c = sound();
  expect_holds(c);
  const std::size_t state = any_state(c);
  const auto at = static_cast<std::ptrdiff_t>(state);
  Case twice = c;
  twice.plan.states.insert(twice.plan.states.begin() + at, c.plan.states[state]);
  twice.plan.controls.insert(twice.plan.controls.begin() + at, c.plan.controls[state]);
  expect_refused(
      twice, AllOf(StartsWith("state " + std::to_string(state + 1) + ": "), HasSubstr("from where the controls lead")));
  Case less = c;
  less.plan.states.erase(less.plan.states.begin() + at);
  less.plan.controls.erase(less.plan.controls.begin() + at);
  expect_refused(less,
                 AllOf(StartsWith("state " + std::to_string(state) + ": "), HasSubstr("from where the controls lead")));
  Case all_twice = c;
  all_twice.plan.states.insert(all_twice.plan.states.end(), c.plan.states.begin() + 1, c.plan.states.end());
  all_twice.plan.controls.insert(all_twice.plan.controls.end(), c.plan.controls.begin(), c.plan.controls.end());
  expect_refused(all_twice, AllOf(StartsWith("state " + std::to_string(c.plan.states.size()) + ": "),
                                  HasSubstr("from where the controls lead")));
}

}  // namespace
}  // namespace krait::host::testing
