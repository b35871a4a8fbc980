// SPDX-License-Identifier: Apache-2.0
// Memory is known beforehand: a block of bytes_required works, one byte less says how many are needed.
#include "planner_fixture.hpp"
#include "search/adaptive_search.hpp"

namespace krait::test::planner_memory_test {
namespace {

constexpr float kStart[] = {2, 6, 0};

TEST(PlannerMemory, BlockOfExactlyTheBytesRequiredSolves) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  const auto needed = bench.planner.bytes_required(bench.open.scene, bench.robot, bench.limits);
  ASSERT_TRUE(bench.init(needed).ok());
  ASSERT_EQ(bench.solve({kStart}), Status::solved);
  const Statistics statistics = bench.planner.statistics();
  EXPECT_EQ(statistics.bytes_given, needed);
  EXPECT_LE(statistics.bytes_used, needed);
}

TEST(PlannerMemory, PoolsAddUpToTheBytesUsed) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  const auto needed = bench.planner.bytes_required(bench.open.scene, bench.robot, bench.limits);
  ASSERT_TRUE(bench.init(needed).ok());
  std::uint64_t sum = 0;
  for (std::size_t pool = 0; pool < detail::kPoolCount; ++pool)
    sum += detail::opened(bench.planner).arena().needed(static_cast<detail::Pool>(pool));
  EXPECT_EQ(sum, needed);
  EXPECT_GE(detail::opened(bench.planner).arena().needed(detail::Pool::states),
            bench.limits.vertices * 3 * sizeof(float));
}

// The same as with limits_for.
TEST(PlannerMemory, WithoutAStatedNumberOfVerticesTheBlockIsSpent) {
  constexpr std::uint64_t kBytes = 100'000;
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  for (const std::uint32_t way_legs : {0U, 64U}) {
    bench.limits = bench.planner.limits_for(kBytes, bench.open.scene, bench.robot, way_legs);
    ASSERT_TRUE(bench.init(kBytes).ok());
    const std::uint64_t spent = detail::opened(bench.planner).arena().needed();
    bench.limits.vertices = 0;
    ASSERT_TRUE(bench.init(kBytes).ok());
    EXPECT_EQ(detail::opened(bench.planner).arena().needed(), spent);
    EXPECT_EQ(bench.solve({kStart}), Status::solved);
    const Failure failure = bench.init(1000);
    EXPECT_EQ(failure.status, Status::arena_too_small);
    Limits least = bench.limits;
    least.vertices = 2;
    EXPECT_EQ(failure.bytes_needed, bench.planner.bytes_required(bench.open.scene, bench.robot, least));
  }
}

TEST(PlannerMemory, OneByteLessIsTooSmallAndSaysHowManyAreNeeded) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  const auto needed = bench.planner.bytes_required(bench.open.scene, bench.robot, bench.limits);
  for (const std::uint64_t bytes : {needed - 1, needed / 2, std::uint64_t{1}, std::uint64_t{0}}) {
    const Failure failure = bench.init(bytes);
    EXPECT_EQ(failure.status, Status::arena_too_small) << bytes;
    EXPECT_EQ(failure.bytes_needed, needed) << bytes;
  }
}

TEST(PlannerMemory, NothingOutsideTheBlockIsWritten) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  bench.limits.vertices = 300;
  expect_nothing_written_outside(bench, kStart);
}

TEST(PlannerMemory, LimitsForFitAndAreTheMost) {
  const OpenScene open(two_rooms());
  const Unicycle robot = small_unicycle();
  for (const std::uint64_t bytes : {20'000U, 65'536U, 131'072U, 1'000'003U, 67'108'864U}) {
    Limits limits = Planner::limits_for(bytes, open.scene, robot);
    EXPECT_LE(Planner::bytes_required(open.scene, robot, limits), bytes);
    limits.vertices += 1;
    EXPECT_GT(Planner::bytes_required(open.scene, robot, limits), bytes);
  }
}

TEST(PlannerMemory, MoreBytesNeverMeanFewerVertices) {
  const OpenScene open(two_rooms());
  const Unicycle robot = small_unicycle();
  std::uint32_t before = 2;
  for (std::uint64_t bytes = 0; bytes < 8'000'000; bytes += 1 + bytes / 97) {
    const std::uint32_t vertices = Planner::limits_for(bytes, open.scene, robot).vertices;
    ASSERT_GE(vertices, before) << bytes;
    before = vertices;
  }
  EXPECT_GT(before, 100'000U);  // with indices of both widths
}

TEST(PlannerMemory, MoreOfAnythingNeverNeedsFewerBytes) {
  const OpenScene open(two_rooms());
  const Unicycle robot = small_unicycle();
  std::uint64_t before = 0;
  for (std::uint32_t vertices = 2; vertices < 200'000; vertices += 1 + vertices / 50) {
    Limits limits;
    limits.vertices = vertices;
    const std::uint64_t bytes = Planner::bytes_required(open.scene, robot, limits);
    ASSERT_GE(bytes, before) << vertices;
    ASSERT_EQ(bytes % 8, 0U);
    limits.expansions = limits.kept_expansions();
    ASSERT_EQ(Planner::bytes_required(open.scene, robot, limits), bytes);
    limits.expansions += 100;
    ASSERT_GE(Planner::bytes_required(open.scene, robot, limits), bytes + 1600);
    before = bytes;
  }
}

TEST(PlannerMemory, LimitsForAHugeBlockAreTheMostThatAPlannerTakes) {
  Planner planner;
  const OpenScene open(two_rooms());
  const Unicycle robot = small_unicycle();
  for (const std::uint64_t bytes : {std::uint64_t{1} << 34U, ~std::uint64_t{0}}) {
    const Limits limits = planner.limits_for(bytes, open.scene, robot);
    EXPECT_EQ(limits.vertices, detail::MotionTree::kMostExpansions);
    EXPECT_EQ(limits.first_bad(), Argument::none);
  }
}

// From the tables alone to all of the block, as the tree grows.
TEST(PlannerMemory, BytesUsedGrowWithTheTreeUpToAllOfThem) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  bench.limits.vertices = 300;
  bench.limits.expansions = 100;
  bench.limits.when_full = WhenFull::stop;
  bench.parameters.tuning.group_sample = kUnboundedSample;
  bench.parameters.tuning.max_steps = 5;
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.planner.start({kStart, Goal::disc({11, 1}, 1e-3F)}), Status::searching);
  const detail::Arena& arena = detail::opened(bench.planner).arena();
  const std::uint64_t tree_bytes = arena.needed(detail::Pool::vertices) + arena.needed(detail::Pool::states) +
                                   arena.needed(detail::Pool::expansions);
  std::uint64_t before = bench.planner.statistics().bytes_used;
  EXPECT_NEAR(static_cast<double>(before), static_cast<double>(arena.needed() - tree_bytes), 32);
  while (bench.planner.advance(1) == Status::searching) {
    const std::uint64_t used = bench.planner.statistics().bytes_used;
    ASSERT_GE(used, before);
    before = used;
  }
  ASSERT_EQ(bench.planner.status(), Status::tree_full);
  EXPECT_LE(before, arena.needed());
  EXPECT_GT(before, arena.needed() - tree_bytes / 2);
}

TEST(PlannerMemory, LimitsForABlockThatIsTooSmallAreTheLeast) {
  const OpenScene open(two_rooms());
  const Unicycle robot = small_unicycle();
  for (const std::uint64_t bytes : {0U, 1U, 100U}) {
    const Limits limits = Planner::limits_for(bytes, open.scene, robot);
    EXPECT_EQ(limits.vertices, 2U);
    EXPECT_GT(Planner::bytes_required(open.scene, robot, limits), bytes);
  }
}

TEST(PlannerMemory, BytesGrowWithVerticesAndWithTheRunTimeState) {
  const OpenScene open(two_rooms());
  ChainParameters small, large;
  small.trailers = 1;
  large.trailers = 15;
  Limits few, many;
  few.vertices = 1000;
  many.vertices = 2000;
  const auto bytes = [&](const ChainParameters& p, const Limits& limits) {
    const Snake snake(p);
    return Planner::bytes_required(open.scene, snake, limits);
  };
  EXPECT_GE(bytes(small, many) - bytes(small, few), 1000U * 4 * 6);
  EXPECT_GE(bytes(large, few) - bytes(small, few), 1000U * 4 * 14);  // 14 floats a vertex more
  // And its work arrays: at most 200 bytes a body and 32 a component of the state.
  EXPECT_LE(bytes(large, few) - bytes(small, few), 1000U * 4 * 14 + 14U * (200 + 32) + 64);
}

TEST(PlannerMemory, NullAndMisalignedBlocksAreBadArguments) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  const auto needed = bench.planner.bytes_required(bench.open.scene, bench.robot, bench.limits);
  std::vector<std::uint64_t> block(needed / 8 + 2);
  auto* bytes = reinterpret_cast<unsigned char*>(block.data());
  const auto init = [&](void* at) {
    return bench.planner.init({at, needed, &bench.open.scene, bench.robot}, bench.parameters, bench.limits);
  };
  const auto blames_block = [](const Failure& failure) {
    return failure.status == Status::bad_argument && failure.element == static_cast<std::uint32_t>(Argument::block);
  };
  EXPECT_TRUE(blames_block(init(nullptr)));
  for (std::size_t shift = 1; shift < 8; ++shift) EXPECT_TRUE(blames_block(init(bytes + shift))) << shift;
  EXPECT_TRUE(init(bytes + 8).ok());
}

}  // namespace
}  // namespace krait::test::planner_memory_test
