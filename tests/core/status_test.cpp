// SPDX-License-Identifier: Apache-2.0
// The names that the core's answers have in JSON.
#include "krait/status.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace krait {
namespace {

TEST(StatusNames, AreThoseOfTheEnum) {
  EXPECT_STREQ(name(Status::searching), "searching");
  EXPECT_STREQ(name(Status::solved), "solved");
  EXPECT_STREQ(name(Status::no_route), "no_route");
  EXPECT_STREQ(name(Status::budget_used), "budget_used");
  EXPECT_STREQ(name(Status::tree_full), "tree_full");
  EXPECT_STREQ(name(Status::time_used), "time_used");
  EXPECT_STREQ(name(Status::bad_scene), "bad_scene");
  EXPECT_STREQ(name(Status::bad_robot), "bad_robot");
  EXPECT_STREQ(name(Status::bad_argument), "bad_argument");
  EXPECT_STREQ(name(Status::start_outside), "start_outside");
  EXPECT_STREQ(name(Status::start_in_collision), "start_in_collision");
  EXPECT_STREQ(name(Status::goal_in_obstacle), "goal_in_obstacle");
  EXPECT_STREQ(name(Status::arena_too_small), "arena_too_small");
  EXPECT_STREQ(name(Status::bad_arithmetic), "bad_arithmetic");
  EXPECT_STREQ(name(Status::internal), "internal");
}

TEST(StatusNames, ArgumentsAreNamedLikeTheParametersThatTheyBlame) {
  EXPECT_STREQ(name(Argument::none), "none");
  EXPECT_STREQ(name(Argument::start), "start");
  EXPECT_STREQ(name(Argument::alpha), "alpha");
  EXPECT_STREQ(name(Argument::kappa), "kappa");
  EXPECT_STREQ(name(Argument::expansions), "expansions");
  EXPECT_STREQ(name(Argument::group_sample), "group_sample");
  EXPECT_STREQ(name(Argument::cost_length), "cost_length");
  EXPECT_STREQ(name(Argument::max_substeps), "max_substeps");
  EXPECT_STREQ(name(Argument::robot_sizes), "robot_sizes");
}

TEST(StatusNames, NoTwoArgumentsShareOne) {
  std::set<std::string> names;
  for (int i = 0; i <= static_cast<int>(Argument::robot_sizes); ++i) names.insert(name(static_cast<Argument>(i)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(Argument::robot_sizes) + 1);
}

}  // namespace
}  // namespace krait
