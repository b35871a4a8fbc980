// SPDX-License-Identifier: Apache-2.0
// The names that the core's answers have in JSON.
#include "krait/status.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace krait::test::status_test {
namespace {

TEST(StatusNames, AreThoseOfTheEnum) {
  EXPECT_STREQ(to_string(Status::searching), "searching");
  EXPECT_STREQ(to_string(Status::solved), "solved");
  EXPECT_STREQ(to_string(Status::no_route), "no_route");
  EXPECT_STREQ(to_string(Status::budget_used), "budget_used");
  EXPECT_STREQ(to_string(Status::tree_full), "tree_full");
  EXPECT_STREQ(to_string(Status::time_used), "time_used");
  EXPECT_STREQ(to_string(Status::bad_scene), "bad_scene");
  EXPECT_STREQ(to_string(Status::bad_robot), "bad_robot");
  EXPECT_STREQ(to_string(Status::bad_argument), "bad_argument");
  EXPECT_STREQ(to_string(Status::start_outside), "start_outside");
  EXPECT_STREQ(to_string(Status::start_in_collision), "start_in_collision");
  EXPECT_STREQ(to_string(Status::goal_in_obstacle), "goal_in_obstacle");
  EXPECT_STREQ(to_string(Status::arena_too_small), "arena_too_small");
  EXPECT_STREQ(to_string(Status::bad_arithmetic), "bad_arithmetic");
  EXPECT_STREQ(to_string(Status::internal), "internal");
}

TEST(StatusNames, ArgumentsAreNamedLikeTheParametersThatTheyBlame) {
  EXPECT_STREQ(to_string(Argument::none), "none");
  EXPECT_STREQ(to_string(Argument::start), "start");
  EXPECT_STREQ(to_string(Argument::alpha), "alpha");
  EXPECT_STREQ(to_string(Argument::kappa), "kappa");
  EXPECT_STREQ(to_string(Argument::expansions), "expansions");
  EXPECT_STREQ(to_string(Argument::group_sample), "group_sample");
  EXPECT_STREQ(to_string(Argument::cost_length), "cost_length");
  EXPECT_STREQ(to_string(Argument::max_substeps), "max_substeps");
  EXPECT_STREQ(to_string(Argument::robot_sizes), "robot_sizes");
}

TEST(StatusNames, OfNoEnumeratorAreUnknown) {
  for (const int number : {static_cast<int>(Status::internal) + 1, 99, 255})
    EXPECT_STREQ(to_string(static_cast<Status>(number)), "unknown");
  for (const int number : {static_cast<int>(Argument::robot_sizes) + 1, 200, 255})
    EXPECT_STREQ(to_string(static_cast<Argument>(number)), "unknown");
}

TEST(StatusNames, NoTwoArgumentsShareOne) {
  std::set<std::string> names;
  for (int i = 0; i <= static_cast<int>(Argument::robot_sizes); ++i) names.insert(to_string(static_cast<Argument>(i)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(Argument::robot_sizes) + 1);
}

}  // namespace
}  // namespace krait::test::status_test
