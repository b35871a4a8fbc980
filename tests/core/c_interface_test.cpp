// SPDX-License-Identifier: Apache-2.0
// The C interface answers as the C++ one does: the same plans to the bit, the same refusals, every number in its
// place.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "c_program.h"
#include "planner_fixture.hpp"

namespace krait::test::c_interface_test {
namespace {

constexpr krait_pose kPose = {2, 6, 0, nullptr, 0};
constexpr krait_limits kLimits = {5000, 0, 20'000, KRAIT_RECYCLE, 0};

c_answer plan(const krait_robot& robot, std::uint64_t expansions = 1000, krait_pose pose = kPose) {
  const SceneBytes bytes = data_of(two_rooms()).bytes();
  return plan_in_c(&robot, bytes.data(), bytes.size(), pose, &kLimits, expansions);
}

template <class R>
Statistics plan_in_cpp(const R& robot) {
  Bench<R> bench(two_rooms(), robot);
  bench.limits = {kLimits.vertices, 0, kLimits.iterations, WhenFull::recycle};
  EXPECT_TRUE(bench.init().ok());
  float start[R::kMaxState];
  if constexpr (R::kMaxBodies > 1) {
    robot.rest({kPose.x, kPose.y}, kPose.heading, nullptr, start);
  } else {
    robot.rest({kPose.x, kPose.y}, kPose.heading, start);
  }
  EXPECT_EQ(bench.solve({start}), Status::solved);
  return bench.planner.statistics();
}

void expect_same_plan(const krait_robot& robot, const Statistics& expected) {
  for (const std::uint64_t expansions : {1, 7, 20'000}) {
    const c_answer answer = plan(robot, expansions);
    ASSERT_EQ(answer.failure.status, KRAIT_SOLVED);
    EXPECT_EQ(answer.statistics.hash, expected.hash);
    EXPECT_EQ(answer.statistics.vertices, expected.vertices);
    EXPECT_EQ(answer.statistics.iterations, expected.iterations);
    EXPECT_EQ(answer.statistics.bytes_used, expected.bytes_used);
    EXPECT_EQ(answer.statistics.plan_steps, expected.plan_steps);
    EXPECT_EQ(answer.statistics.plan_length, expected.plan_length);
    EXPECT_EQ(answer.states, expected.plan_steps + 1);
    EXPECT_TRUE(answer.starts_at_start);
    EXPECT_TRUE(answer.ends_at_rest);
    EXPECT_TRUE(answer.begins_again);
  }
}

template <class P>
P small(P parameters) {
  parameters.body_length = 0.4F;
  parameters.body_width = 0.3F;
  parameters.wheelbase = 0.4F;
  parameters.hitch_length = 0.45F;
  return parameters;
}

ChainParameters chain(int trailers) {
  ChainParameters parameters;
  parameters.trailers = trailers;
  return small(parameters);
}

TEST(CInterface, SnakePlansAsInCpp) {
  krait_robot robot = krait_snake(3);
  robot.parameters.chain = small(robot.parameters.chain);
  expect_same_plan(robot, plan_in_cpp(Snake(chain(3))));
}

TEST(CInterface, TruckPlansAsInCpp) {
  krait_robot robot = krait_truck(1);
  robot.parameters.chain = small(robot.parameters.chain);
  expect_same_plan(robot, plan_in_cpp(Truck(chain(1))));
}

TEST(CInterface, KinematicTruckPlansAsInCpp) {
  krait_robot robot = krait_kinematic_truck(1);
  robot.parameters.kinematic_truck = small(robot.parameters.kinematic_truck);
  KinematicTruckParameters parameters;
  parameters.trailers = 1;
  expect_same_plan(robot, plan_in_cpp(KinematicTruck(small(parameters))));
}

TEST(CInterface, CarPlansAsInCpp) { expect_same_plan(krait_car(), plan_in_cpp(Car(Car::defaults()))); }

TEST(CInterface, UnicyclePlansAsInCpp) {
  expect_same_plan(krait_unicycle(), plan_in_cpp(Unicycle(UnicycleParameters())));
}

TEST(CInterface, Unicycle2PlansAsInCpp) {
  expect_same_plan(krait_unicycle2(), plan_in_cpp(Unicycle2(Unicycle2Parameters())));
}

TEST(CInterface, DifferentialDrivePlansAsInCpp) {
  expect_same_plan(krait_diff_drive(), plan_in_cpp(DifferentialDrive(DifferentialDriveParameters())));
}

TEST(CInterface, OwnBodiesAreUsed) {
  const krait_point corners[] = {{-0.2F, -0.2F}, {0.5F, 0}, {-0.2F, 0.2F}};
  const krait_polygon triangle = {corners, 3};
  krait_robot robot = krait_unicycle();
  robot.bodies = &triangle;
  Unicycle expected{UnicycleParameters()};
  const Vec2 same[] = {{-0.2F, -0.2F}, {0.5F, 0}, {-0.2F, 0.2F}};
  expected.set_body(0, {same, 3});
  expect_same_plan(robot, plan_in_cpp(expected));
  EXPECT_NE(plan(robot).statistics.hash, plan(krait_unicycle()).statistics.hash);
}

TEST(CInterface, BodiesThatAreNoneAreRefused) {
  krait_point corners[9] = {};
  for (const int count : {-1, 0, 2, 9, 1'000'000}) {
    const krait_polygon body = {corners, count};
    krait_robot robot = krait_unicycle();
    robot.bodies = &body;
    const krait_failure failure = plan(robot).failure;
    EXPECT_EQ(failure.status, KRAIT_BAD_ROBOT) << count;
    EXPECT_STREQ(krait_argument_name(failure.element), "robot_polygon");
  }
}

TEST(CInterface, TrailersThatAreNoneAreRefused) {
  const krait_point corners[] = {{-0.2F, -0.2F}, {0.2F, 0}, {-0.2F, 0.2F}};
  const std::vector<krait_polygon> bodies(KRAIT_MAX_TRAILERS + 1, {corners, 3});
  for (const int trailers : {std::numeric_limits<int>::min(), -1, 26, 1'000'000, std::numeric_limits<int>::max()}) {
    for (krait_robot robot : {krait_snake(trailers), krait_truck(trailers), krait_kinematic_truck(trailers)}) {
      for (const krait_polygon* shapes : {static_cast<const krait_polygon*>(nullptr), bodies.data()}) {
        robot.bodies = shapes;
        float state[KRAIT_MAX_STATE];
        EXPECT_EQ(krait_state_size(&robot), 0U);
        EXPECT_EQ(krait_control_size(&robot), 0U);
        EXPECT_FALSE(krait_rest(&robot, kPose, state));
        EXPECT_EQ(plan(robot).failure.status, KRAIT_BAD_ROBOT) << trailers;
      }
    }
  }
}

// As many bytes as a car needs, so that no limits are spent on what cannot be planned for.
TEST(CInterface, TrailersThatAreNoneNeedNoMoreThanACar) {
  const SceneBytes bytes = data_of(two_rooms()).bytes();
  krait_scene scene;
  ASSERT_EQ(krait_open(&scene, bytes.data(), bytes.size()).status, KRAIT_OK);
  const krait_robot none = krait_snake(0);
  for (const int trailers : {std::numeric_limits<int>::min(), -1, 26, std::numeric_limits<int>::max()}) {
    const krait_robot robot = krait_snake(trailers);
    EXPECT_LE(krait_bytes_required(&scene, &robot, &kLimits), krait_bytes_required(&scene, &none, &kLimits));
    EXPECT_GE(krait_limits_for(100'000, &scene, &robot).vertices, 2U);
  }
}

TEST(CInterface, WhatToDoWhenFullIsOneOfTwo) {
  const SceneBytes bytes = data_of(two_rooms()).bytes();
  krait_scene scene;
  ASSERT_EQ(krait_open(&scene, bytes.data(), bytes.size()).status, KRAIT_OK);
  const krait_robot robot = krait_unicycle();
  std::vector<std::uint64_t> block(50'000);
  for (int when_full = 0; when_full <= 255; ++when_full) {
    const krait_limits limits = {100, 0, 10, static_cast<std::uint8_t>(when_full), 0};
    krait_planner* planner = nullptr;
    const krait_setup setup{block.data(), block.size() * 8, &scene, &robot};
    const krait_failure failure = krait_init(&planner, &setup, nullptr, &limits);
    if (when_full <= KRAIT_STOP) {
      EXPECT_EQ(failure.status, KRAIT_OK) << when_full;
    } else {
      EXPECT_EQ(failure.status, KRAIT_BAD_ARGUMENT) << when_full;
      EXPECT_STREQ(krait_argument_name(failure.element), "when_full");
      EXPECT_EQ(planner, nullptr);
    }
  }
}

TEST(CInterface, RestTakesAnglesOfEveryTrailerOrOfNone) {
  const krait_robot robot = krait_snake(2);
  const float angles[] = {0.5F, 0.25F, 0.125F};
  float state[KRAIT_MAX_STATE];
  EXPECT_FALSE(krait_rest(&robot, {1, 2, 3, angles, 3}, state));
  ASSERT_TRUE(krait_rest(&robot, {1, 2, 3, angles, 2}, state));
  const float bent[] = {1, 2, 3, 0, 0, 0.5F, 0.25F};
  EXPECT_EQ(std::memcmp(state, bent, sizeof bent), 0);
  ASSERT_TRUE(krait_rest(&robot, {1, 2, 3, nullptr, 0}, state));
  const float straight[] = {1, 2, 3, 0, 0, 3, 3};
  EXPECT_EQ(std::memcmp(state, straight, sizeof straight), 0);
}

TEST(CInterface, EveryRobotOfTheLibraryHasTwoControls) {
  for (const krait_robot& robot : {krait_snake(3), krait_truck(2), krait_kinematic_truck(1), krait_car(),
                                   krait_unicycle(), krait_unicycle2(), krait_diff_drive()}) {
    EXPECT_EQ(krait_control_size(&robot), static_cast<std::uint32_t>(KRAIT_CONTROL));
  }
}

TEST(CInterface, ACarHasNoTrailerToTakeAnAngle) {
  const krait_robot robot = krait_car();
  const float angles[] = {0.5F, 0.25F};
  float state[KRAIT_MAX_STATE];
  ASSERT_TRUE(krait_rest(&robot, {1, 2, 3, angles, 2}, state));
  const float rest[] = {1, 2, 3, 0, 0};
  EXPECT_EQ(krait_state_size(&robot), 5U);
  EXPECT_EQ(std::memcmp(state, rest, sizeof rest), 0);
}

// A sanitizer sees it.
TEST(CInterface, OfTooManyTrailersNoBodyIsReadBeyondTheMost) {
  const krait_point corners[] = {{-0.2F, -0.2F}, {0.2F, 0}, {-0.2F, 0.2F}};
  const std::vector<krait_polygon> bodies(KRAIT_MAX_TRAILERS + 1, {corners, 3});
  krait_robot robot = krait_snake(1'000'000);
  robot.bodies = bodies.data();
  EXPECT_EQ(krait_state_size(&robot), 0U);
  robot.parameters.chain.trailers = KRAIT_MAX_TRAILERS;
  EXPECT_EQ(krait_state_size(&robot), 5U + KRAIT_MAX_TRAILERS);
}

TEST(CInterface, StartPosesAreTheScenes) {
  Room room = two_rooms();
  room.starts = {{2, 6, 0.5F, 0, 2}, {3, 1, -0.5F, 2, 1}};
  room.start_angles = {0.25F, 0.125F, 1.0F};
  const SceneBytes bytes = data_of(room).bytes();
  krait_scene scene;
  ASSERT_EQ(krait_open(&scene, bytes.data(), bytes.size()).status, KRAIT_OK);
  const krait_pose first = krait_start_pose(&scene, 0), second = krait_start_pose(&scene, 1);
  EXPECT_EQ(first.x, 2.0F);
  EXPECT_EQ(first.y, 6.0F);
  EXPECT_EQ(first.heading, 0.5F);
  ASSERT_EQ(first.angle_count, 2U);
  EXPECT_EQ(first.angles[1], 0.125F);
  EXPECT_EQ(second.heading, -0.5F);
  ASSERT_EQ(second.angle_count, 1U);
  EXPECT_EQ(second.angles[0], 1.0F);
}

TEST(CInterface, BadScenesAreRefused) {
  SceneBytes bytes = data_of(two_rooms()).bytes();
  krait_scene scene;
  EXPECT_EQ(krait_open(&scene, bytes.data(), bytes.size()).status, KRAIT_OK);
  const krait_failure failure = krait_open(&scene, bytes.data(), bytes.size() - 4);
  EXPECT_EQ(failure.status, KRAIT_BAD_SCENE);
  EXPECT_EQ(failure.section, Scene::kHeaderSection);
}

// A scene, a robot and a block of exactly the bytes that its limits need.
struct Given {
  SceneBytes bytes = data_of(two_rooms()).bytes();
  krait_scene scene;
  krait_robot robot = krait_unicycle();
  krait_parameters parameters = krait_default_parameters();
  krait_limits limits = {100, 0, 10, KRAIT_STOP, 0};
  std::uint64_t needed = 0;
  std::vector<std::uint64_t> block;
  krait_planner* planner = nullptr;

  Given() {
    EXPECT_EQ(krait_open(&scene, bytes.data(), bytes.size()).status, KRAIT_OK);
    needed = krait_bytes_required(&scene, &robot, &limits);
    block.resize(needed / 8 + 2, 0xA5A5A5A5A5A5A5A5ULL);
  }
  krait_failure init(std::uint64_t size) { return init(block.data(), size); }
  krait_failure init(void* at, std::uint64_t size) {
    const krait_setup setup{at, size, &scene, &robot};
    return krait_init(&planner, &setup, &parameters, &limits);
  }
};

TEST(CInterface, TheBlockIsAsLargeAsAsked) {
  Given given;
  for (const std::uint64_t too_few : {std::uint64_t{0}, std::uint64_t{8}, given.needed / 2, given.needed - 1}) {
    const krait_failure failure = given.init(too_few);
    EXPECT_EQ(failure.status, KRAIT_ARENA_TOO_SMALL);
    EXPECT_EQ(failure.bytes_needed, given.needed);
    EXPECT_EQ(given.planner, nullptr);
  }
  EXPECT_EQ(given.init(given.needed).status, KRAIT_OK);
  EXPECT_NE(given.planner, nullptr);
  const float start[] = {2, 6, 0};
  const krait_query query = {start, krait_named_goal(0), 1};
  EXPECT_EQ(krait_start(given.planner, &query), KRAIT_SEARCHING);
  (void)krait_advance(given.planner, 1000);
  for (std::size_t i = given.needed / 8; i < given.block.size(); ++i) EXPECT_EQ(given.block[i], 0xA5A5A5A5A5A5A5A5ULL);
}

TEST(CInterface, BlocksThatAreNoneAreRefused) {
  Given given;
  for (void* block :
       {static_cast<void*>(nullptr), static_cast<void*>(reinterpret_cast<char*>(given.block.data()) + 4)}) {
    const krait_failure failure = given.init(block, given.needed);
    EXPECT_EQ(failure.status, KRAIT_BAD_ARGUMENT);
    EXPECT_STREQ(krait_argument_name(failure.element), "block");
  }
}

TEST(CInterface, ARobotThatIsNoneIsRefusedInABlockOfAnySize) {
  Given given;
  const krait_robot zeros{};
  const krait_robot no_functions = krait_own_robot(nullptr, nullptr);
  for (const krait_robot* robot : {static_cast<const krait_robot*>(nullptr), &zeros, &no_functions}) {
    float state[KRAIT_MAX_STATE];
    EXPECT_EQ(krait_state_size(robot), 0U);
    EXPECT_EQ(krait_control_size(robot), 0U);
    EXPECT_FALSE(krait_rest(robot, kPose, state));
    EXPECT_EQ(krait_bytes_required(&given.scene, robot, &given.limits), 0U);
    EXPECT_EQ(krait_limits_for(given.needed, &given.scene, robot).vertices, 0U);
    for (const std::uint64_t size : {std::uint64_t{0}, given.needed}) {
      const krait_setup setup{given.block.data(), size, &given.scene, robot};
      const krait_failure failure = krait_init(&given.planner, &setup, nullptr, nullptr);
      EXPECT_EQ(failure.status, KRAIT_BAD_ROBOT);
      EXPECT_STREQ(krait_argument_name(failure.element), "robot_sizes");
      EXPECT_EQ(failure.bytes_needed, 0U);
      EXPECT_EQ(given.planner, nullptr);
    }
  }
}

TEST(CInterface, ASceneThatIsNoneIsRefusedInABlockOfAnySize) {
  Given given;
  krait_scene closed;
  EXPECT_EQ(krait_open(&closed, given.bytes.data(), 4).status, KRAIT_BAD_SCENE);
  for (const krait_scene* scene : {static_cast<const krait_scene*>(nullptr), &std::as_const(closed)}) {
    for (const std::uint64_t size : {std::uint64_t{100}, given.needed}) {
      const krait_setup setup{given.block.data(), size, scene, &given.robot};
      const krait_failure failure = krait_init(&given.planner, &setup, &given.parameters, &given.limits);
      EXPECT_EQ(failure.status, KRAIT_BAD_ARGUMENT);
      EXPECT_STREQ(krait_argument_name(failure.element), "scene");
    }
  }
}

// Without limits as many vertices are kept as fit, and the plan is that of these limits.
TEST(CInterface, WithoutLimitsTheBlockIsSpent) {
  Given spent;
  spent.limits = krait_limits_for(100'000, &spent.scene, &spent.robot);
  Given defaults;
  for (Given* each : {&spent, &defaults}) each->block.assign(100'000 / 8, 0);
  ASSERT_EQ(spent.init(100'000).status, KRAIT_OK);
  const krait_setup setup{defaults.block.data(), 100'000, &defaults.scene, &defaults.robot};
  ASSERT_EQ(krait_init(&defaults.planner, &setup, nullptr, nullptr).status, KRAIT_OK);
  const krait_setup small{defaults.block.data(), 1000, &defaults.scene, &defaults.robot};
  krait_planner* none = nullptr;
  const krait_failure failure = krait_init(&none, &small, nullptr, nullptr);
  EXPECT_EQ(failure.status, KRAIT_ARENA_TOO_SMALL);
  krait_limits least = krait_limits_for(0, &defaults.scene, &defaults.robot);
  EXPECT_EQ(failure.bytes_needed, krait_bytes_required(&defaults.scene, &defaults.robot, &least));
  least.vertices = 0xFFFFFFFF;  // how large a block must be for these cannot be said
  const krait_failure limits = krait_init(&none, &small, nullptr, &least);
  EXPECT_EQ(limits.status, KRAIT_BAD_ARGUMENT);
  EXPECT_STREQ(krait_argument_name(limits.element), "vertices");
}

TEST(CInterface, LimitsSpendTheBlock) {
  Given given;
  for (const std::uint64_t bytes :
       {std::uint64_t{0}, std::uint64_t{100}, std::uint64_t{20'000}, std::uint64_t{200'000}}) {
    given.limits = krait_limits_for(bytes, &given.scene, &given.robot);
    EXPECT_GE(given.limits.vertices, 2U);
    const std::uint64_t needed = krait_bytes_required(&given.scene, &given.robot, &given.limits);
    EXPECT_TRUE(needed <= bytes || given.limits.vertices == 2) << bytes;
    ++given.limits.vertices;
    EXPECT_GT(krait_bytes_required(&given.scene, &given.robot, &given.limits), bytes);
  }
}

TEST(CInterface, ImprovesAPlanAsTheCppPlannerDoes) {
  Given given;
  given.limits = krait_limits_to_improve(200'000, &given.scene, &given.robot, 64);
  given.needed = krait_bytes_required(&given.scene, &given.robot, &given.limits);
  ASSERT_LE(given.needed, 200'000U);
  given.block.assign(given.needed / 8, 0);
  ASSERT_EQ(given.init(given.needed).status, KRAIT_OK);
  EXPECT_EQ(krait_improve(given.planner, 10), KRAIT_READY);  // before the first start
  const float start[] = {2, 6, 0};
  const krait_query query = {start, krait_named_goal(0), 1};
  ASSERT_EQ(krait_start(given.planner, &query), KRAIT_SEARCHING);
  ASSERT_EQ(krait_advance(given.planner, 100'000), KRAIT_SOLVED);
  float state[3];
  float control[2];
  ASSERT_TRUE(krait_next(given.planner, state, control));
  ASSERT_TRUE(krait_next(given.planner, state, control));
  EXPECT_EQ(krait_improve(given.planner, 500), KRAIT_SOLVED);
  ASSERT_TRUE(krait_next(given.planner, state, control));
  EXPECT_EQ(std::memcmp(state, start, sizeof start), 0);  // begins again
  std::uint32_t steps = 0;
  while (krait_next(given.planner, state, control)) ++steps;

  Bench<Unicycle> bench(two_rooms(), Unicycle(UnicycleParameters()));
  bench.limits = {given.limits.vertices, 0, given.limits.iterations, WhenFull::recycle, 64};
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.solve({start}), Status::solved);
  ASSERT_EQ(bench.planner.improve(500), Status::solved);
  const krait_statistics statistics = krait_statistics_of(given.planner);
  EXPECT_GT(statistics.improvements, 0U);
  EXPECT_EQ(statistics.improvements, bench.planner.statistics().improvements);
  EXPECT_EQ(statistics.hash, bench.planner.statistics().hash);
  EXPECT_EQ(statistics.plan_steps, steps);
}

TEST(CInterface, ImprovingNeedsRoomInTheLimits) {
  Given given;
  given.limits = krait_limits_for(200'000, &given.scene, &given.robot);
  EXPECT_EQ(given.limits.way_legs, 0U);
  given.block.assign(25'000, 0);
  ASSERT_EQ(given.init(200'000).status, KRAIT_OK);
  const float start[] = {2, 6, 0};
  const krait_query query = {start, krait_named_goal(0), 1};
  ASSERT_EQ(krait_start(given.planner, &query), KRAIT_SEARCHING);
  ASSERT_EQ(krait_advance(given.planner, 100'000), KRAIT_SOLVED);
  EXPECT_EQ(krait_improve(given.planner, 10), KRAIT_BAD_ARGUMENT);
  EXPECT_EQ(krait_last_failure(given.planner).status, KRAIT_SOLVED);
}

TEST(CInterface, TheSceneTellsWhatIsInIt) {
  const Given given;
  const OpenScene expected(two_rooms());
  const krait_scene_facts facts = krait_facts(&given.scene);
  EXPECT_STREQ(facts.name, expected.scene.name());
  EXPECT_EQ(facts.goals, 3U);
  EXPECT_EQ(facts.starts, expected.scene.start_count());
  EXPECT_EQ(facts.max_x, 12.0F);
  EXPECT_EQ(facts.max_y, 8.0F);
  EXPECT_STREQ(krait_goal_name(&given.scene, 1), expected.scene.goal_name(1));
  EXPECT_EQ(krait_find_goal(&given.scene, krait_goal_name(&given.scene, 2)), 2U);
  EXPECT_EQ(krait_find_goal(&given.scene, "nowhere"), KRAIT_NONE);
}

TEST(CInterface, DiscsAndQueriesAreTheCpps) {
  Given given;
  ASSERT_EQ(given.init(given.needed).status, KRAIT_OK);
  const float start[] = {2, 6, 0};
  const auto ask = [&](const float* from, krait_goal goal) {
    const krait_query query = {from, goal, 1};
    const krait_status status = krait_start(given.planner, &query);
    EXPECT_EQ(krait_last_failure(given.planner).status, status);
    return status;
  };
  EXPECT_EQ(ask(start, krait_disc_goal(2, 6, 0.5F)), KRAIT_SOLVED);
  EXPECT_EQ(ask(start, krait_disc_goal(6.125F, 1, 0.1F)), KRAIT_GOAL_IN_OBSTACLE);
  EXPECT_EQ(ask(start, krait_named_goal(7)), KRAIT_BAD_ARGUMENT);
  EXPECT_EQ(ask(nullptr, krait_named_goal(0)), KRAIT_BAD_ARGUMENT);
  EXPECT_EQ(ask(start, krait_named_goal(0)), KRAIT_SEARCHING);
  krait_stop_for_time(given.planner);
  EXPECT_EQ(krait_advance(given.planner, 1), KRAIT_TIME_USED);
  float state[KRAIT_MAX_STATE], control[KRAIT_CONTROL];
  EXPECT_FALSE(krait_next(given.planner, state, control));
}

TEST(CInterface, PosesAreTheCpps) {
  Given given;
  given.limits = kLimits;
  given.needed = krait_bytes_required(&given.scene, &given.robot, &given.limits);
  given.block.resize(given.needed / 8 + 2);
  ASSERT_EQ(given.init(given.needed).status, KRAIT_OK);
  const float start[] = {2, 6, 0};
  const auto ask = [&](krait_goal goal) {
    const krait_query query = {start, goal, 1};
    krait_status status = krait_start(given.planner, &query);
    while (status == KRAIT_SEARCHING) status = krait_advance(given.planner, 10);
    return status;
  };
  const auto last_heading = [&] {
    float state[KRAIT_MAX_STATE], control[KRAIT_CONTROL];
    while (krait_next(given.planner, state, control)) continue;
    return static_cast<double>(state[2]);
  };
  krait_goal pose = krait_pose_goal(10.5F, 6.5F, 0.2F, 2, 0.1F);
  EXPECT_EQ(ask(pose), KRAIT_SOLVED);
  EXPECT_NEAR(std::remainder(last_heading() - 2, 6.283185307), 0, 0.1);
  pose.either_way = true;
  pose.hitch_tolerance = 0.3F;
  EXPECT_EQ(ask(pose), KRAIT_SOLVED);
  EXPECT_NEAR(std::remainder(last_heading() - 2, 3.141592654), 0, 0.1);
  EXPECT_EQ(ask(krait_pose_goal(2, 6, 0.2F, 0, 0.1F)), KRAIT_SOLVED);
  pose.heading_tolerance = 0;
  EXPECT_EQ(ask(pose), KRAIT_BAD_ARGUMENT) << "the two fields below must be zero";
  EXPECT_EQ(ask(krait_pose_goal(2, 6, 0.2F, 0, -1)), KRAIT_BAD_ARGUMENT);
  EXPECT_EQ(ask(krait_pose_goal(2, 6, 0.2F, 1, 0)), KRAIT_BAD_ARGUMENT) << "a heading is not dropped silently";
  krait_goal named = krait_named_goal(0);
  named.heading_tolerance = 0.1F;
  EXPECT_EQ(ask(named), KRAIT_BAD_ARGUMENT) << "a heading is for the disc only";
  krait_goal turned = krait_disc_goal(2, 6, 0.5F);
  turned.heading = 3;
  EXPECT_EQ(ask(turned), KRAIT_SOLVED) << "without a tolerance the heading is free";
}

TEST(CInterface, SaysWhyThereIsNoPlan) {
  Given given;
  ASSERT_EQ(given.init(given.needed).status, KRAIT_OK);
  const float start[] = {2, 6, 0};
  const float at_wall[] = {5.9F, 1, 0};
  const krait_query cramped = {start, krait_disc_goal(0.1F, 0.1F, 0.05F), 1};
  EXPECT_EQ(krait_start(given.planner, &cramped), KRAIT_NO_ROUTE);
  const krait_bottleneck bottleneck = krait_bottleneck_of(given.planner);
  EXPECT_TRUE(bottleneck.at_goal);
  EXPECT_GT(bottleneck.needed, bottleneck.width);
  EXPECT_GT(bottleneck.width, 0.0F);
  EXPECT_NEAR(static_cast<double>(bottleneck.x), 0.13, 0.03);
  EXPECT_EQ(krait_start_contact(given.planner).kind, KRAIT_NO_CONTACT);
  const krait_query blocked = {at_wall, krait_named_goal(0), 1};
  EXPECT_EQ(krait_start(given.planner, &blocked), KRAIT_START_IN_COLLISION);
  const krait_contact contact = krait_start_contact(given.planner);
  EXPECT_EQ(contact.kind, KRAIT_WITH_OBSTACLE);
  EXPECT_EQ(contact.other, 0U);
  EXPECT_GT(contact.needed, contact.distance);
  EXPECT_NEAR(static_cast<double>(contact.x), 6.1, 0.1);
  EXPECT_EQ(krait_bottleneck_of(given.planner).needed, 0.0F);
  const krait_query query = {start, krait_named_goal(0), 1};
  EXPECT_EQ(krait_start(given.planner, &query), KRAIT_SEARCHING);
  EXPECT_EQ(krait_effort_of(given.planner).tries, 0U);
  EXPECT_EQ(krait_advance(given.planner, 3), KRAIT_SEARCHING);
  EXPECT_GT(krait_effort_of(given.planner).tries, 0U);
}

TEST(CInterface, SinesAndAnglesAreTheCpps) {
  for (float x = -9; x < 9; x += 0.37F) {
    float sine = 0, cosine = 0;
    krait_sin_cos(x, &sine, &cosine);
    EXPECT_EQ(sine, math::sin_cos(x).sin);
    EXPECT_EQ(cosine, math::sin_cos(x).cos);
    EXPECT_EQ(krait_atan2(x, 1.5F), math::atan2(x, 1.5F));
  }
}

TEST(CInterface, NamesAreTheCpps) {
  for (std::uint32_t i = 0; i <= KRAIT_INTERNAL; ++i) {
    EXPECT_STREQ(krait_status_name(static_cast<krait_status>(i)), to_string(static_cast<Status>(i)));
  }
  EXPECT_STREQ(krait_status_name(KRAIT_START_IN_COLLISION), "start_in_collision");
  EXPECT_STREQ(krait_status_name(KRAIT_ARENA_TOO_SMALL), "arena_too_small");
  EXPECT_STREQ(krait_status_name(255), "unknown");
  EXPECT_STREQ(krait_argument_name(0xFFFFFFFF), "unknown");
}

#define EXPECT_SAME_PLACE(C, Cpp, field) EXPECT_EQ(offsetof(C, field), offsetof(Cpp, field)) << #field

TEST(CInterface, EveryParameterIsInItsPlace) {
  EXPECT_SAME_PLACE(krait_parameters, Parameters, tuning);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, group_sample);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, alpha);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, beta);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, epsilon);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, gamma);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, cost_length);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, kappa);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, update_regions);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, raise_goal);
  EXPECT_SAME_PLACE(krait_parameters, Parameters, dt);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, max_steps);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, open_steps);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, path_regions);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, path_lengths);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, near_radius);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, goal_near_radius);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, stray_share);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, gentle_share);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, sight_tries);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, candidates);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, least_sketch);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, doomed_steps);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, restart_unit);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, stuck_expansions);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, slowest);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, stopping_ways);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, reverse_share);
  EXPECT_SAME_PLACE(krait_parameters, Parameters, clearance);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, continuous);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, max_substeps);
  EXPECT_SAME_PLACE(krait_search_tuning, SearchTuning, prune_portals);
  EXPECT_SAME_PLACE(krait_parameters, Parameters, goal_margin);
  EXPECT_SAME_PLACE(krait_parameters, Parameters, end_speed);
  EXPECT_SAME_PLACE(krait_limits, Limits, vertices);
  EXPECT_SAME_PLACE(krait_limits, Limits, expansions);
  EXPECT_SAME_PLACE(krait_limits, Limits, iterations);
  EXPECT_SAME_PLACE(krait_limits, Limits, when_full);
  EXPECT_SAME_PLACE(krait_limits, Limits, way_legs);
  EXPECT_EQ(static_cast<WhenFull>(KRAIT_RECYCLE), WhenFull::recycle);
  EXPECT_EQ(static_cast<WhenFull>(KRAIT_STOP), WhenFull::stop);
}

TEST(CInterface, EveryParameterOfARobotIsInItsPlace) {
  EXPECT_SAME_PLACE(krait_chain_parameters, ChainParameters, trailers);
  EXPECT_SAME_PLACE(krait_chain_parameters, ChainParameters, body_length);
  EXPECT_SAME_PLACE(krait_chain_parameters, ChainParameters, body_width);
  EXPECT_SAME_PLACE(krait_chain_parameters, ChainParameters, body_offset);
  EXPECT_SAME_PLACE(krait_chain_parameters, ChainParameters, wheelbase);
  EXPECT_SAME_PLACE(krait_chain_parameters, ChainParameters, hitch_length);
  EXPECT_SAME_PLACE(krait_chain_parameters, ChainParameters, max_speed);
  EXPECT_SAME_PLACE(krait_chain_parameters, ChainParameters, min_speed);
  EXPECT_SAME_PLACE(krait_chain_parameters, ChainParameters, max_steering);
  EXPECT_SAME_PLACE(krait_chain_parameters, ChainParameters, max_acceleration);
  EXPECT_SAME_PLACE(krait_chain_parameters, ChainParameters, max_steering_rate);
  EXPECT_SAME_PLACE(krait_chain_parameters, ChainParameters, self_collision_gap);
  EXPECT_SAME_PLACE(krait_chain_parameters, ChainParameters, max_hitch_angle);
  EXPECT_SAME_PLACE(krait_kinematic_truck_parameters, KinematicTruckParameters, trailers);
  EXPECT_SAME_PLACE(krait_kinematic_truck_parameters, KinematicTruckParameters, body_length);
  EXPECT_SAME_PLACE(krait_kinematic_truck_parameters, KinematicTruckParameters, body_width);
  EXPECT_SAME_PLACE(krait_kinematic_truck_parameters, KinematicTruckParameters, body_offset);
  EXPECT_SAME_PLACE(krait_kinematic_truck_parameters, KinematicTruckParameters, wheelbase);
  EXPECT_SAME_PLACE(krait_kinematic_truck_parameters, KinematicTruckParameters, hitch_length);
  EXPECT_SAME_PLACE(krait_kinematic_truck_parameters, KinematicTruckParameters, max_speed);
  EXPECT_SAME_PLACE(krait_kinematic_truck_parameters, KinematicTruckParameters, min_speed);
  EXPECT_SAME_PLACE(krait_kinematic_truck_parameters, KinematicTruckParameters, max_steering);
  EXPECT_SAME_PLACE(krait_kinematic_truck_parameters, KinematicTruckParameters, self_collision_gap);
  EXPECT_SAME_PLACE(krait_kinematic_truck_parameters, KinematicTruckParameters, max_hitch_angle);
  EXPECT_SAME_PLACE(krait_unicycle_parameters, UnicycleParameters, body_length);
  EXPECT_SAME_PLACE(krait_unicycle_parameters, UnicycleParameters, body_width);
  EXPECT_SAME_PLACE(krait_unicycle_parameters, UnicycleParameters, max_speed);
  EXPECT_SAME_PLACE(krait_unicycle_parameters, UnicycleParameters, min_speed);
  EXPECT_SAME_PLACE(krait_unicycle_parameters, UnicycleParameters, max_turn_rate);
  EXPECT_SAME_PLACE(krait_unicycle2_parameters, Unicycle2Parameters, body_length);
  EXPECT_SAME_PLACE(krait_unicycle2_parameters, Unicycle2Parameters, body_width);
  EXPECT_SAME_PLACE(krait_unicycle2_parameters, Unicycle2Parameters, max_speed);
  EXPECT_SAME_PLACE(krait_unicycle2_parameters, Unicycle2Parameters, min_speed);
  EXPECT_SAME_PLACE(krait_unicycle2_parameters, Unicycle2Parameters, max_turn_rate);
  EXPECT_SAME_PLACE(krait_unicycle2_parameters, Unicycle2Parameters, max_acceleration);
  EXPECT_SAME_PLACE(krait_unicycle2_parameters, Unicycle2Parameters, max_turn_acceleration);
  EXPECT_SAME_PLACE(krait_diff_drive_parameters, DifferentialDriveParameters, body_length);
  EXPECT_SAME_PLACE(krait_diff_drive_parameters, DifferentialDriveParameters, body_width);
  EXPECT_SAME_PLACE(krait_diff_drive_parameters, DifferentialDriveParameters, wheel_radius);
  EXPECT_SAME_PLACE(krait_diff_drive_parameters, DifferentialDriveParameters, track_width);
  EXPECT_SAME_PLACE(krait_diff_drive_parameters, DifferentialDriveParameters, max_wheel_speed);
  EXPECT_SAME_PLACE(krait_diff_drive_parameters, DifferentialDriveParameters, max_wheel_acceleration);
}

TEST(CInterface, EveryAnswerIsInItsPlace) {
  EXPECT_SAME_PLACE(krait_failure, Failure, status);
  EXPECT_SAME_PLACE(krait_failure, Failure, section);
  EXPECT_SAME_PLACE(krait_failure, Failure, element);
  EXPECT_SAME_PLACE(krait_failure, Failure, bytes_needed);
  EXPECT_SAME_PLACE(krait_contact, Contact, kind);
  EXPECT_SAME_PLACE(krait_contact, Contact, body);
  EXPECT_SAME_PLACE(krait_contact, Contact, other);
  EXPECT_SAME_PLACE(krait_contact, Contact, distance);
  EXPECT_SAME_PLACE(krait_contact, Contact, needed);
  EXPECT_EQ(offsetof(krait_contact, x), offsetof(Contact, at));
  EXPECT_SAME_PLACE(krait_bottleneck, Bottleneck, width);
  EXPECT_SAME_PLACE(krait_bottleneck, Bottleneck, needed);
  EXPECT_EQ(offsetof(krait_bottleneck, x), offsetof(Bottleneck, at));
  EXPECT_SAME_PLACE(krait_bottleneck, Bottleneck, at_goal);
  EXPECT_EQ(offsetof(krait_effort, x), offsetof(Effort, at));
  EXPECT_SAME_PLACE(krait_effort, Effort, tries);
  EXPECT_SAME_PLACE(krait_statistics, Statistics, iterations);
  EXPECT_SAME_PLACE(krait_statistics, Statistics, vertices);
  EXPECT_SAME_PLACE(krait_statistics, Statistics, recycled);
  EXPECT_SAME_PLACE(krait_statistics, Statistics, collision_checks);
  EXPECT_SAME_PLACE(krait_statistics, Statistics, restarts);
  EXPECT_SAME_PLACE(krait_statistics, Statistics, dijkstra_runs);
  EXPECT_SAME_PLACE(krait_statistics, Statistics, regions_repaired);
  EXPECT_SAME_PLACE(krait_statistics, Statistics, bytes_used);
  EXPECT_SAME_PLACE(krait_statistics, Statistics, bytes_given);
  EXPECT_SAME_PLACE(krait_statistics, Statistics, plan_steps);
  EXPECT_SAME_PLACE(krait_statistics, Statistics, plan_length);
  EXPECT_SAME_PLACE(krait_statistics, Statistics, plan_duration);
  EXPECT_SAME_PLACE(krait_statistics, Statistics, plan_end_speed);
  EXPECT_SAME_PLACE(krait_statistics, Statistics, hash);
  EXPECT_SAME_PLACE(krait_statistics, Statistics, improvements);
}

}  // namespace
}  // namespace krait::test::c_interface_test
