// SPDX-License-Identifier: Apache-2.0
// What krait robot --cpp wrote of a robot is the workstation's: its class, its parameters and its bodies, bit for bit.
#include <gtest/gtest.h>

#include <cstring>

#include "host/run/robots.hpp"
#include "paths.hpp"
#include "road_train.hpp"
#include "snake.hpp"
#include "turtlebot4.hpp"
#include "unicycle.hpp"
#include "van.hpp"

namespace krait::host {
namespace {

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

// `name` as users name the robot.
template <class R>
void expect_workstations(const R& robot, const std::string& name) {
  const CoreRobot core(parse_robot(name));
  const R* const expected = core.as<R>();
  ASSERT_NE(expected, nullptr) << name;
  EXPECT_TRUE(same_bits(robot.parameters(), expected->parameters())) << name;
  ASSERT_EQ(robot.body_count(), expected->body_count()) << name;
  for (int k = 0; k < robot.body_count(); ++k) {
    const Polygon body = robot.body(k);
    ASSERT_EQ(body.count, expected->body(k).count) << name;
    for (int i = 0; i < body.count; ++i) EXPECT_TRUE(same_bits(body[i], expected->body(k)[i])) << name << k << " " << i;
  }
}

TEST(CompiledRobot, IsTheWorkstations) {
  expect_workstations(robot_van::make(), test::source_path("tests/targets/robots/van.json"));
  expect_workstations(robot_road_train::make(), test::source_path("tests/targets/robots/road_train.json"));
  expect_workstations(robot_snake::make(), "snake:3");
  expect_workstations(robot_unicycle::make(), "unicycle");
  expect_workstations(robot_turtlebot4::make(), "turtlebot4");
}

TEST(CompiledRobot, KnowsItsName) {
  EXPECT_STREQ(robot_van::kName, "van");
  EXPECT_STREQ(robot_snake::kName, "snake:3");
  EXPECT_STREQ(robot_turtlebot4::kName, "turtlebot4");
}

}  // namespace
}  // namespace krait::host
