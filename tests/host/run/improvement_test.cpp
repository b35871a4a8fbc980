// SPDX-License-Identifier: Apache-2.0
// By how many multiples of the first plan's collision checks a plan is improved.
#include <gtest/gtest.h>

#include "host/run/run.hpp"

namespace krait::host {
namespace {

TEST(Improvement, IsByTheMultiplesThatAreAsked) {
  SearchRequest request;
  request.improve = 0.5;
  for (const std::uint64_t checks : {0U, 1U, 543U, 1'000'000U}) EXPECT_EQ(request.multiples_of(checks), 0.5) << checks;
}

TEST(Improvement, IsByTheLeastWholeMultipleOfACheapPlanThatMakesEnoughChecks) {
  SearchRequest request;
  request.improve = 10;
  request.improve_least = 300'000;
  EXPECT_EQ(request.multiples_of(543), 553);
  EXPECT_EQ(request.multiples_of(29'999), 11);
  EXPECT_EQ(request.multiples_of(30'000), 10);
  EXPECT_EQ(request.multiples_of(1'000'000), 10);
  EXPECT_EQ(request.multiples_of(0), 300'000);
}

}  // namespace
}  // namespace krait::host
