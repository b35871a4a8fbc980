// SPDX-License-Identifier: Apache-2.0
// A robot of the user's in C has the plans of the same robot in C++, bit for bit, and one that cannot be used is
// refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "krait/krait.h"
#include "krait/robot_check.hpp"
#include "planner_fixture.hpp"

namespace krait::test::c_own_robot_test {
namespace {

// A truck with trailers as a robot of one's own has it: only what one needs.
class Bare {
 public:
  static constexpr int kMaxState = Truck::kMaxState, kMaxControl = 2, kMaxBodies = Truck::kMaxBodies;

  explicit Bare(int trailers) : truck_(parameters(trailers)) {}

  int state_size() const { return truck_.state_size(); }
  int control_size() const { return 2; }
  int body_count() const { return truck_.body_count(); }
  void derivative(StateView s, ControlView u, StateRef ds) const { truck_.derivative(s, u, ds); }
  void steer(StateView s, const Target& target, Steering&, ControlRef u) const {
    Steering fresh;  // in C it has no memory
    truck_.steer(s, target, fresh, u);
  }
  bool within_limits(StateView s) const { return truck_.within_limits(s); }
  Polygon body(int k) const { return truck_.body(k); }
  void place(StateView s, Pose* poses) const { truck_.place(s, poses); }
  bool travel(StateView s, ControlView u, float dt, StateView next, Travel* travel) const {
    return truck_.travel(s, u, dt, next, travel);
  }

 protected:
  const Truck& truck() const { return truck_; }

 private:
  static ChainParameters parameters(int trailers) {
    ChainParameters p;
    p.trailers = trailers;
    p.body_length = 0.4F;
    p.body_width = 0.3F;
    p.wheelbase = 0.4F;
    p.hitch_length = 0.5F;
    p.min_speed = -1.0F;
    return p;
  }

  Truck truck_;
};

// With what it may have besides.
class Whole : public Bare {
 public:
  using Bare::Bare;
  float speed(StateView s) const { return truck().speed(s); }
  float stopping_way(StateView s) const { return truck().stopping_way(s); }
  float turning_radius() const { return truck().turning_radius(); }
  float top_speed() const { return truck().top_speed(); }
  float fastest_rate(float dt) const { return truck().fastest_rate(dt); }
  void track(StateView s, StateView reference, float dt, ControlRef u) const { truck().track(s, reference, dt, u); }
  bool keeps_reserve(StateView s) const { return truck().keeps_reserve(s); }
  bool reversible() const { return truck().reversible(); }
  int self_collision_gap() const { return 1; }
  int backing_body() const { return truck().backing_body(); }
};

// One that states its rates: bounds for any state and control of a Bare without trailers.
constexpr BodyRates kRates{3.0F, 10.0F, 31.0F, 110.0F};
class Rated {
 public:
  static constexpr int kMaxState = Bare::kMaxState, kMaxControl = 2, kMaxBodies = 1;

  explicit Rated(int trailers) : bare_(trailers) {}

  int state_size() const { return bare_.state_size(); }
  int control_size() const { return 2; }
  int body_count() const { return 1; }
  void derivative(StateView s, ControlView u, StateRef ds) const { bare_.derivative(s, u, ds); }
  void steer(StateView s, const Target& target, Steering& steering, ControlRef u) const {
    bare_.steer(s, target, steering, u);
  }
  bool within_limits(StateView s) const { return bare_.within_limits(s); }
  Polygon body(int k) const { return bare_.body(k); }
  void place(StateView s, Pose* poses) const { bare_.place(s, poses); }
  bool rates(StateView s, ControlView u, float dt, StateView next, BodyRates* rates) const {
    Travel travel[1];
    rates[0] = kRates;
    return bare_.travel(s, u, dt, next, travel);
  }

 private:
  Bare bare_;
};

const Whole& of(const void* self) { return *static_cast<const Whole*>(self); }
StateView view(const void* self, const float* s) { return {s, of(self).state_size()}; }

// The functions of Bare, by an object of Whole.
krait_functions bare(int trailers) {
  krait_functions f{};
  f.exact = krait_exact;
  f.state_size = 5 + trailers;
  f.control_size = 2;
  f.body_count = 1 + trailers;
  f.derivative = [](const void* self, const float* s, const float* u, float* ds) {
    of(self).derivative(view(self, s), ControlView(u, 2), StateRef(ds, of(self).state_size()));
  };
  f.steer = [](const void* self, const float* s, const krait_target* target, float* u) {
    Steering none;
    of(self).steer(view(self, s), {{target->x, target->y}, target->speed, target->dt, target->turn}, none,
                   ControlRef(u, 2));
  };
  f.within_limits = [](const void* self, const float* s) { return of(self).within_limits(view(self, s)); };
  f.body = [](const void* self, int k) {
    const Polygon body = of(self).body(k);
    return krait_polygon{reinterpret_cast<const krait_point*>(body.vertices), body.count};
  };
  f.place = [](const void* self, const float* s, krait_frame* frames) {
    Pose poses[kMaxBodies];
    of(self).place(view(self, s), poses);
    for (int k = 0; k < of(self).body_count(); ++k) {
      frames[k] = {poses[k].position.x, poses[k].position.y, poses[k].heading.sin, poses[k].heading.cos};
    }
  };
  f.travel = [](const void* self, const float* s, const float* u, float dt, const float* next, krait_travel* travel) {
    Travel most[kMaxBodies];
    const bool proven = of(self).travel(view(self, s), ControlView(u, 2), dt, view(self, next), most);
    for (int k = 0; k < of(self).body_count(); ++k) {
      travel[k] = {most[k].path, most[k].turn, most[k].bend, most[k].twist};
    }
    return proven;
  };
  return f;
}

krait_functions whole(int trailers) {
  krait_functions f = bare(trailers);
  f.speed = [](const void* self, const float* s) { return of(self).speed(view(self, s)); };
  f.stopping_way = [](const void* self, const float* s) { return of(self).stopping_way(view(self, s)); };
  f.turning_radius = [](const void* self) { return of(self).turning_radius(); };
  f.top_speed = [](const void* self) { return of(self).top_speed(); };
  f.fastest_rate = [](const void* self, float dt) { return of(self).fastest_rate(dt); };
  f.track = [](const void* self, const float* s, const float* reference, float dt, float* u) {
    of(self).track(view(self, s), view(self, reference), dt, ControlRef(u, 2));
  };
  f.keeps_reserve = [](const void* self, const float* s) { return of(self).keeps_reserve(view(self, s)); };
  f.reversible = [](const void* self) { return of(self).reversible(); };
  f.self_collision_gap = [](const void* self) { return of(self).self_collision_gap(); };
  f.backing_body = [](const void* self) { return of(self).backing_body(); };
  return f;
}

constexpr krait_limits kLimits = {5000, 0, 20'000, KRAIT_RECYCLE, 0};

// A planner in C for the robot, in a block of its own.
class InC {
 public:
  explicit InC(const krait_functions& functions, int trailers)
      : whole_(trailers), functions_(functions), robot_(krait_own_robot(&functions_, &whole_)) {
    bytes_ = data_of(two_rooms()).bytes();
    EXPECT_EQ(krait_open(&scene_, bytes_.data(), bytes_.size()).status, KRAIT_OK);
    const krait_parameters parameters = krait_default_parameters();
    const krait_setup setup{block_.data(), 8 * block_.size(), &scene_, &robot_};
    failure_ = krait_init(&planner_, &setup, &parameters, &kLimits);
  }

  const krait_failure& failure() const { return failure_; }
  const krait_robot& robot() const { return robot_; }

  krait_statistics solve(std::uint64_t seed) {
    EXPECT_EQ(search(krait_pose_goal(10.5F, 6.5F, 0.4F, 0, 0.5F), seed), KRAIT_SOLVED);
    return krait_statistics_of(planner_);
  }

  krait_status search(const krait_goal& goal, std::uint64_t seed) {
    float start[KRAIT_MAX_STATE] = {2, 6, 0};
    const krait_query query = {start, goal, seed};
    EXPECT_EQ(krait_start(planner_, &query), KRAIT_SEARCHING);
    return krait_advance(planner_, 5000);
  }

 private:
  Whole whole_;
  krait_functions functions_;
  krait_robot robot_;
  SceneBytes bytes_;
  krait_scene scene_;
  std::vector<std::uint64_t> block_ = std::vector<std::uint64_t>(100'000);
  krait_planner* planner_ = nullptr;
  krait_failure failure_{};
};

template <class R>
void expect_same_plans(const krait_functions& functions, int trailers) {
  InC in_c(functions, trailers);
  ASSERT_EQ(in_c.failure().status, KRAIT_OK);
  Bench<R> bench(two_rooms(), R(trailers));
  bench.limits = {kLimits.vertices, 0, kLimits.iterations, WhenFull::recycle};
  ASSERT_TRUE(bench.init().ok());
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const std::vector<float> start = {2, 6, 0, 0, 0, 0, 0};
    const Goal goal = Goal::pose({10.5F, 6.5F}, 0.4F, 0.0F, 0.5F);
    ASSERT_EQ(bench.solve({start.data(), goal, seed}), Status::solved);
    const krait_statistics found = in_c.solve(seed);
    EXPECT_EQ(found.hash, bench.planner.statistics().hash);
    EXPECT_EQ(found.vertices, bench.planner.statistics().vertices);
    EXPECT_EQ(found.collision_checks, bench.planner.statistics().collision_checks);
    EXPECT_EQ(found.plan_end_speed, bench.planner.statistics().plan_end_speed);
  }
}

TEST(OwnRobotInC, HasThePlansOfTheSameRobotInCpp) {
  expect_same_plans<Bare>(bare(0), 0);
  expect_same_plans<Bare>(bare(2), 2);
  expect_same_plans<Whole>(whole(0), 0);
  expect_same_plans<Whole>(whole(2), 2);
}

TEST(OwnRobotInC, MayStateItsRatesInsteadOfItsTravel) {
  krait_functions f = bare(0);
  f.travel = nullptr;
  f.rates = [](const void* self, const float* s, const float* u, float dt, const float* next, krait_body_rates* rates) {
    Travel travel[1];
    rates[0] = {kRates.speed, kRates.turn, kRates.acceleration, kRates.turn_acceleration};
    return of(self).travel(view(self, s), ControlView(u, 2), dt, view(self, next), travel);
  };
  expect_same_plans<Rated>(f, 0);
}

// Each function that it may have is asked, for plans differ without it.
TEST(OwnRobotInC, EveryFunctionThatItMayHaveIsUsed) {
  const auto hash = [](const krait_functions& functions) { return InC(functions, 2).solve(1).hash; };
  const std::uint64_t all = hash(whole(2));
  krait_functions f = whole(2);
  f.speed = nullptr;
  EXPECT_NE(hash(f), all) << "speed";
  f = whole(2);
  f.track = nullptr;
  EXPECT_NE(hash(f), all) << "track";
  f = whole(2);
  f.reversible = nullptr;
  EXPECT_NE(hash(f), all) << "reversible";
  f = whole(2);
  f.fastest_rate = nullptr;
  EXPECT_NE(hash(f), all) << "fastest_rate";
}

// Nothing that is driven keeps it, so that no path becomes a plan.
TEST(OwnRobotInC, HasNoPlanWithoutItsReserve) {
  const krait_goal goal = krait_disc_goal(10.5F, 6.5F, 0.4F);
  krait_functions f = whole(2);
  EXPECT_EQ(InC(f, 2).search(goal, 1), KRAIT_SOLVED);
  f.keeps_reserve = [](const void*, const float*) { return false; };
  EXPECT_EQ(InC(f, 2).search(goal, 1), KRAIT_SEARCHING);
}

// Before the wall, heading away from it: where trailers can only be pushed to.
TEST(OwnRobotInC, LeadsItsBackingBodyBackwards) {
  krait_goal goal = krait_pose_goal(10.7F, 6.5F, 0.1F, 3.14F, 0.1F);
  goal.hitch_tolerance = 0.1F;
  int with = 0;
  int without = 0;
  krait_functions mute = whole(2);
  mute.backing_body = nullptr;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    with += InC(whole(2), 2).search(goal, seed) == KRAIT_SOLVED ? 1 : 0;
    without += InC(mute, 2).search(goal, seed) == KRAIT_SOLVED ? 1 : 0;
  }
  EXPECT_GE(with, 4);
  EXPECT_EQ(without, 0);
}

template <class Member>
void expect_refused(Member krait_functions::*member) {
  krait_functions f = whole(1);
  f.*member = nullptr;
  const InC in_c(f, 1);
  EXPECT_EQ(in_c.failure().status, KRAIT_BAD_ROBOT);
  EXPECT_STREQ(krait_argument_name(in_c.failure().element), "robot_dimensions");
}

TEST(OwnRobotInC, WithoutAFunctionThatItNeedsIsRefused) {
  expect_refused(&krait_functions::derivative);
  expect_refused(&krait_functions::steer);
  expect_refused(&krait_functions::within_limits);
  expect_refused(&krait_functions::body);
  expect_refused(&krait_functions::place);
  expect_refused(&krait_functions::travel);
}

TEST(OwnRobotInC, OfSizesOutOfRangeIsRefused) {
  const auto status = [](int krait_functions::*member, int size) {
    krait_functions f = bare(0);
    f.*member = size;
    return InC(f, 0).failure().status;
  };
  for (const int size : {-1, 0, 1, KRAIT_MAX_STATE + 1}) {
    EXPECT_EQ(status(&krait_functions::state_size, size), KRAIT_BAD_ROBOT) << size;
  }
  for (const int size : {-1, 0, KRAIT_MAX_CONTROL + 1}) {
    EXPECT_EQ(status(&krait_functions::control_size, size), KRAIT_BAD_ROBOT) << size;
  }
  for (const int size : {-1, 0, KRAIT_MAX_BODIES + 1}) {
    EXPECT_EQ(status(&krait_functions::body_count, size), KRAIT_BAD_ROBOT) << size;
  }
}

TEST(OwnRobotInC, WhoseBackingBodyIsNoneOfItsOwnIsRefused) {
  krait_functions f = whole(2);
  f.backing_body = [](const void*) { return 3; };
  EXPECT_EQ(InC(f, 2).failure().status, KRAIT_BAD_ROBOT);
  f.backing_body = [](const void*) { return -1; };
  EXPECT_EQ(InC(f, 2).failure().status, KRAIT_BAD_ROBOT);
}

TEST(OwnRobotInC, InAFileWithOtherArithmeticIsRefused) {
  krait_functions f = bare(0);
  f.exact = nullptr;
  EXPECT_EQ(InC(f, 0).failure().status, KRAIT_BAD_ARITHMETIC);
  f.exact = [] { return false; };
  EXPECT_EQ(InC(f, 0).failure().status, KRAIT_BAD_ARITHMETIC);
}

// Of the robots above with two trailers, whose headings are drawn as hitch angles.
class Checked {
 public:
  explicit Checked(const krait_functions& functions) : functions_(functions) {
    ranges_.headings = kHeadings;
    ranges_.heading_count = 3;
    ranges_.dt = kSteps;
    ranges_.dt_count = 2;
    ranges_.leaving_share = 0.5F;
    ranges_.complete_state = [](const void* self, float* state) {
      EXPECT_EQ(self, kHeadings);
      state[5] += state[2];
      state[6] += state[5];
    };
    ranges_.self = kHeadings;
  }

  krait_ranges& ranges() { return ranges_; }

  std::uint32_t run(char* text, std::size_t bytes) {
    const krait_robot robot = krait_own_robot(&functions_, &whole_);
    return krait_check_robot(&robot, &ranges_, 100, 7, text, bytes);
  }

  // The check's text, which has a line for each fault.
  std::string text() {
    char text[8192];
    const std::uint32_t faults = run(text, sizeof text);
    EXPECT_EQ(std::count(text, text + std::strlen(text), '\n'), faults);
    return text;
  }

  // The same of a robot in C++.
  static std::string text_of(const Robot& robot) {
    RobotRanges ranges;
    for (const krait_range& range : kStates) ranges.state.push_back({range.low, range.high});
    for (const krait_range& range : kControls) ranges.control.push_back({range.low, range.high});
    ranges.dt.assign(std::begin(kSteps), std::end(kSteps));
    ranges.headings.assign(std::begin(kHeadings), std::end(kHeadings));
    ranges.leaving_share = 0.5F;
    ranges.complete_state = [](std::vector<float>& state) {
      state[5] += state[2];
      state[6] += state[5];
    };
    return check_robot(robot, ranges, 100, 7).text();
  }

 private:
  static constexpr krait_range kStates[] = {{-9, 9}, {-9, 9},       {-3, 3},      {-1, 2.5F},
                                            {-1, 1}, {-1.5F, 1.5F}, {-1.5F, 1.5F}};
  static constexpr krait_range kControls[] = {{-5, 5}, {-4, 4}};
  static constexpr int kHeadings[] = {2, 5, 6};
  static constexpr float kSteps[] = {0.1F, 0.05F};

  Whole whole_{2};
  krait_functions functions_;
  krait_ranges ranges_ = krait_default_ranges(kStates, kControls);
};

// One that goes further than it says.
struct Leaper : Whole {
  using Whole::Whole;
  bool travel(StateView s, ControlView u, float dt, StateView next, Travel* travel) const {
    const bool proven = Whole::travel(s, u, dt, next, travel);
    for (int k = 0; k < body_count(); ++k) travel[k].path *= 0.5F;
    return proven;
  }
};

TEST(OwnRobotInC, IsCheckedAsInCpp) {
  const Whole sound(2);
  EXPECT_EQ(Checked::text_of(sound), "");
  EXPECT_EQ(Checked(whole(2)).text(), "");

  krait_functions f = whole(2);
  f.travel = [](const void* self, const float* s, const float* u, float dt, const float* next, krait_travel* travel) {
    Travel most[kMaxBodies];
    const Leaper leaper(2);
    const bool proven = leaper.travel(view(self, s), ControlView(u, 2), dt, view(self, next), most);
    for (int k = 0; k < 3; ++k) travel[k] = {most[k].path, most[k].turn, most[k].bend, most[k].twist};
    return proven;
  };
  const Leaper leaper(2);
  const std::string found = Checked(f).text();
  EXPECT_NE(found.find("travel (path)"), std::string::npos) << found;
  EXPECT_EQ(found, Checked::text_of(leaper));
}

TEST(OwnRobotInC, WhatKeepsTheCheckFromBeginningIsAFault) {
  const auto expect_said = [](const krait_functions& f, const char* words) {
    EXPECT_NE(Checked(f).text().find(words), std::string::npos) << words;
  };
  krait_functions f = whole(2);
  f.place = nullptr;
  expect_said(f, "robot_dimensions");
  f = whole(2);
  f.state_size = -1;
  expect_said(f, "robot_sizes");
  f = whole(2);
  f.self_collision_gap = [](const void*) { return 0; };
  expect_said(f, "robot_sizes");
  f = whole(2);
  f.exact = [] { return false; };
  expect_said(f, "exact (arithmetic)");

  Checked checked(whole(2));
  checked.ranges().state = nullptr;
  EXPECT_NE(checked.text().find("there are 0 ranges of states"), std::string::npos);
  Checked nowhere(whole(2));
  nowhere.ranges().headings = nullptr;
  EXPECT_EQ(nowhere.text(), "ranges (headings): headings is NULL, where heading_count is 3.\n");
  nowhere.ranges().heading_count = 0;
  EXPECT_EQ(nowhere.text(), "");
  Checked negative(whole(2));
  negative.ranges().leaving_share = -1;
  EXPECT_EQ(negative.text(), "ranges (leaving_share): leaving_share is -1; it must be from 0 to 1.\n");
}

TEST(OwnRobotInC, ACheckOfNoRobotIsAFault) {
  const krait_robot zeros{};
  const krait_ranges ranges{};
  for (const krait_robot* robot : {static_cast<const krait_robot*>(nullptr), &zeros}) {
    char text[512];
    EXPECT_EQ(krait_check_robot(robot, &ranges, 1, 1, text, sizeof text), 1U);
    EXPECT_NE(std::string(text).find("init refuses the robot: robot_sizes"), std::string::npos) << text;
  }
}

TEST(OwnRobotInC, ItsCheckWritesNoMoreThanThereIsRoomFor) {
  krait_functions f = whole(2);
  f.place = nullptr;
  char text[] = "0123456789";
  EXPECT_EQ(Checked(f).run(text, 5), 1U);
  EXPECT_STREQ(text, "body");
  EXPECT_STREQ(text + 5, "56789");
  EXPECT_EQ(Checked(f).run(nullptr, 0), 1U);
}

TEST(OwnRobotInC, HasItsOwnStates) {
  const InC in_c(bare(2), 2);
  EXPECT_EQ(krait_state_size(&in_c.robot()), 7U);
  EXPECT_EQ(krait_control_size(&in_c.robot()), 2U);
  float state[KRAIT_MAX_STATE];
  EXPECT_FALSE(krait_rest(&in_c.robot(), {2, 6, 0, nullptr, 0}, state));
}

TEST(OwnRobotInC, HasNoSizesWhereTheyCannotBeUsed) {
  for (const int bad : {-1, 0, 1, KRAIT_MAX_STATE + 1}) {
    krait_functions f = bare(2);
    f.state_size = bad;
    const InC in_c(f, 2);
    EXPECT_EQ(krait_state_size(&in_c.robot()), 0U) << bad;
    EXPECT_EQ(krait_control_size(&in_c.robot()), 0U) << bad;
  }
}

}  // namespace
}  // namespace krait::test::c_own_robot_test
