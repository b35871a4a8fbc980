// SPDX-License-Identifier: Apache-2.0
// One planner answers queries for ever: no leak, no drift, the same high-water mark. With KRAIT_LONG_TESTS=1 a hundred
// thousand of them.
#include <array>
#include <map>

#include "../long_tests.hpp"
#include "planner_fixture.hpp"

namespace krait::test::planner_endless_test {
namespace {

// Queries of every kind, bad ones among them: each is answered as it was the first time, and the memory stays as it
// was.
TEST(PlannerEndless, AnswersTheSameForEverInTheSameMemory) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  bench.limits.vertices = 400;
  bench.limits.iterations = 6;
  const std::uint64_t needed = bench.planner.bytes_required(bench.open.scene, bench.robot, bench.limits);
  constexpr std::size_t kGuard = 32;
  constexpr std::uint64_t kMark = 0x5151515151515151ULL;
  std::vector<std::uint64_t> block(needed / 8 + 2 * kGuard, kMark);
  ASSERT_TRUE(bench.planner
                  .init({block.data() + kGuard, needed, &bench.open.scene, bench.robot}, bench.parameters, bench.limits)
                  .ok());
  const std::array<std::array<float, 3>, 4> starts = {{{2, 6, 0}, {3, 2, 1.5F}, {6.1F, 1, 0}, {-1, 4, 0}}};
  const Goal goals[] = {Goal::named(2), Goal::disc({4, 4}, 0.75F), Goal::named(0), Goal::named(1), Goal::named(9)};
  struct Answer {
    Status status;
    std::uint64_t hash, vertices, bytes;
    bool operator==(const Answer&) const = default;
  };
  std::map<std::size_t, Answer> first;
  const std::size_t kinds = starts.size() * std::size(goals) * 3;
  for (std::size_t i = 0; i < by_length(2'000, 100'000); ++i) {
    const std::size_t kind = i * 7 % kinds;
    (void)bench.solve({starts[kind % starts.size()].data(), goals[kind / starts.size() % std::size(goals)],
                       kind / (starts.size() * std::size(goals))});
    const Statistics statistics = bench.planner.statistics();
    const Answer answer{bench.planner.status(), statistics.hash, statistics.vertices, statistics.bytes_used};
    ASSERT_EQ(first.try_emplace(kind, answer).first->second, answer) << i;
  }
  std::map<Status, int> seen;
  for (const auto& [kind, answer] : first) ++seen[answer.status];
  EXPECT_GT(seen[Status::solved], 3);
  EXPECT_GT(seen[Status::start_in_collision], 0);
  EXPECT_GT(seen[Status::start_outside], 0);
  EXPECT_GT(seen[Status::bad_argument], 0);
  EXPECT_GT(seen[Status::goal_in_obstacle], 0);
  EXPECT_GT(seen[Status::budget_used] + seen[Status::tree_full], 0);
  for (std::size_t i = 0; i < kGuard; ++i) {
    ASSERT_EQ(block[i], kMark);
    ASSERT_EQ(block[block.size() - 1 - i], kMark);
  }
}

}  // namespace
}  // namespace krait::test::planner_endless_test
