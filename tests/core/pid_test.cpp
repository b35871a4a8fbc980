// SPDX-License-Identifier: Apache-2.0
// The controller against its definition, step by step.
#include <gtest/gtest.h>

#include "krait/robots/model.hpp"

namespace krait::test::pid_test {
namespace {

constexpr PidGains kGains{2.0F, 0.5F, 0.25F};

TEST(Pid, AddsProportionSumAndSlope) {
  Pid pid;
  EXPECT_FLOAT_EQ(pid(kGains, 1.0F, 0.5F), 2.0F + 0.5F * 0.5F);  // no slope yet
  EXPECT_FLOAT_EQ(pid(kGains, 3.0F, 0.5F), 6.0F + 0.5F * 2.0F + 0.25F * 4.0F);
  EXPECT_FLOAT_EQ(pid(kGains, -1.0F, 0.25F), -2.0F + 0.5F * 1.75F - 0.25F * 16.0F);
}

TEST(Pid, AnotherOneBeginsAnew) {
  Pid used;
  used(kGains, 5.0F, 1.0F);
  used = {};
  Pid fresh;
  EXPECT_EQ(used(kGains, 1.0F, 0.5F), fresh(kGains, 1.0F, 0.5F));
}

}  // namespace
}  // namespace krait::test::pid_test
