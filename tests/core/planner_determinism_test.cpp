// SPDX-License-Identifier: Apache-2.0
// The same query has the same answer, bit for bit: again, in pieces, in another block, beside another planner.
#include <set>

#include "planner_fixture.hpp"

namespace krait::test::planner_determinism_test {
namespace {

constexpr float kStart[] = {2, 6, 0};

class PlannerDeterminism : public ::testing::Test {
 protected:
  using TestBench = Bench<Unicycle>;

  static std::uint64_t hash_of(std::uint64_t seed, std::uint64_t piece) {
    TestBench bench(two_rooms(), small_unicycle());
    EXPECT_TRUE(bench.init().ok());
    EXPECT_EQ(bench.planner.start({kStart, Goal::named(0), seed}), Status::searching);
    while (bench.planner.advance(piece) == Status::searching) continue;
    EXPECT_EQ(bench.planner.status(), Status::solved);
    return bench.planner.statistics().hash;
  }
};

TEST_F(PlannerDeterminism, ResultDoesNotDependOnHowTheSearchIsCut) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const std::uint64_t all = hash_of(seed, 1'000'000'000);
    EXPECT_EQ(hash_of(seed, 1), all);
    EXPECT_EQ(hash_of(seed, 7), all);
  }
}

TEST_F(PlannerDeterminism, DifferentSeedsGiveDifferentPlans) {
  std::set<std::uint64_t> hashes;
  for (std::uint64_t seed = 0; seed < 10; ++seed) hashes.insert(hash_of(seed, 1000));
  EXPECT_EQ(hashes.size(), 10U);
}

TEST_F(PlannerDeterminism, AThousandQueriesOnOnePlannerGiveTheSameHashEach) {
  TestBench bench(two_rooms(), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  const float other_start[] = {3, 2, 1.5F};
  const Query queries[] = {
      {kStart, Goal::named(0), 1}, {other_start, Goal::disc({10, 2}, 0.75F), 2}, {kStart, Goal::named(2), 3}};
  std::uint64_t expected[3] = {};
  for (std::size_t i = 0; i < 1000; ++i) {
    const std::size_t which = i % 3;
    ASSERT_EQ(bench.solve(queries[which]), Status::solved) << i;
    const std::uint64_t hash = bench.planner.statistics().hash;
    if (i < 3) expected[which] = hash;
    ASSERT_EQ(hash, expected[which]) << i;
  }
  EXPECT_NE(expected[0], expected[1]);
}

TEST_F(PlannerDeterminism, WhatTheBlockHeldDoesNotMatter) {
  std::set<std::uint64_t> hashes;
  for (const std::uint64_t filling : {0ULL, 0xFFFFFFFFFFFFFFFFULL, 0x7FC000007FC00000ULL}) {
    TestBench bench(two_rooms(), small_unicycle());
    const auto needed = bench.planner.bytes_required(bench.open.scene, bench.robot, bench.limits);
    bench.block.assign(needed / 8, filling);
    ASSERT_TRUE(
        bench.planner.init({bench.block.data(), needed, &bench.open.scene, bench.robot}, bench.parameters, bench.limits)
            .ok());
    ASSERT_EQ(bench.solve({kStart}), Status::solved);
    hashes.insert(bench.planner.statistics().hash);
  }
  EXPECT_EQ(hashes.size(), 1U);
}

TEST_F(PlannerDeterminism, MoreMemoryThanNeededDoesNotMatter) {
  TestBench tight(two_rooms(), small_unicycle()), wide(two_rooms(), small_unicycle());
  ASSERT_TRUE(tight.init().ok());
  ASSERT_EQ(tight.solve({kStart}), Status::solved);
  wide.limits.vertices *= 3;
  ASSERT_TRUE(wide.init().ok());
  ASSERT_EQ(wide.solve({kStart}), Status::solved);
  EXPECT_EQ(tight.planner.statistics().hash, wide.planner.statistics().hash);
}

TEST_F(PlannerDeterminism, TwoPlannersSideBySideDoNotDisturbEachOther) {
  TestBench a(two_rooms(), small_unicycle()), b(two_rooms(), small_unicycle());
  ASSERT_TRUE(a.init().ok());
  ASSERT_TRUE(b.init().ok());
  EXPECT_EQ(a.planner.start({kStart, Goal::named(0), 1}), Status::searching);
  EXPECT_EQ(b.planner.start({kStart, Goal::named(0), 2}), Status::searching);
  bool searching = true;
  while (searching) {
    const bool first = a.planner.advance(1) == Status::searching;
    searching = b.planner.advance(1) == Status::searching || first;
  }
  EXPECT_EQ(a.planner.statistics().hash, hash_of(1, 1000));
  EXPECT_EQ(b.planner.statistics().hash, hash_of(2, 1000));
}

TEST_F(PlannerDeterminism, SceneAtAnotherAddressGivesTheSameHash) {
  TestBench bench(two_rooms(), small_unicycle());
  SceneBytes moved(bench.open.bytes.size() + 4);
  std::memcpy(moved.data() + 4, bench.open.bytes.data(), bench.open.bytes.size());
  Scene scene;
  ASSERT_TRUE(Scene::open(moved.data() + 4, bench.open.bytes.size(), scene).ok());
  const auto needed = bench.planner.bytes_required(scene, bench.robot, bench.limits);
  bench.block.resize(needed / 8);
  ASSERT_TRUE(
      bench.planner.init({bench.block.data(), needed, &scene, bench.robot}, bench.parameters, bench.limits).ok());
  ASSERT_EQ(bench.solve({kStart}), Status::solved);
  EXPECT_EQ(bench.planner.statistics().hash, hash_of(1, 1000));
}

}  // namespace
}  // namespace krait::test::planner_determinism_test
