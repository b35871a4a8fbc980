// SPDX-License-Identifier: Apache-2.0
// Planners in threads of one program do not touch each other. Run under ThreadSanitizer too (preset thread).
#include <thread>

#include "planner_fixture.hpp"

namespace krait::test::planner_threads_test {
namespace {

constexpr float kStart[] = {2, 6, 0};

class PlannerThreads : public ::testing::Test {
 protected:
  using TestBench = Bench<Unicycle>;

  static std::uint64_t hash_of(TestBench& bench, std::uint64_t seed) {
    (void)bench.solve({kStart, Goal::named(0), seed});
    return bench.planner.statistics().hash;
  }
};

TEST_F(PlannerThreads, PlanAsTheyDoAlone) {
  constexpr std::uint64_t kThreads = 4, kQueries = 20;
  std::uint64_t alone[kThreads][kQueries], together[kThreads][kQueries];
  std::vector<std::unique_ptr<TestBench>> benches;
  for (std::uint64_t i = 0; i < kThreads; ++i) {
    benches.push_back(std::make_unique<TestBench>(two_rooms(), small_unicycle()));
    ASSERT_TRUE(benches.back()->init().ok());
    for (std::uint64_t q = 0; q < kQueries; ++q) alone[i][q] = hash_of(*benches[i], 100 * i + q);
  }
  std::vector<std::thread> threads;
  for (std::uint64_t i = 0; i < kThreads; ++i) {
    threads.emplace_back([&, i] {
      for (std::uint64_t q = 0; q < kQueries; ++q) together[i][q] = hash_of(*benches[i], 100 * i + q);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::uint64_t i = 0; i < kThreads; ++i) {
    for (std::uint64_t q = 0; q < kQueries; ++q) EXPECT_EQ(together[i][q], alone[i][q]) << i << " " << q;
  }
}

// The scene's bytes and the robot are shared; nobody writes to them.
TEST_F(PlannerThreads, ShareASceneAndARobot) {
  const OpenScene open(two_rooms());
  const Unicycle robot = small_unicycle();
  Limits limits;
  limits.vertices = 20'000;
  std::uint64_t hashes[3] = {};
  std::vector<std::thread> threads;
  for (std::uint64_t& hash : hashes) {
    threads.emplace_back([&] {
      Scene scene;
      if (!Scene::open(open.bytes.data(), open.bytes.size(), scene).ok()) return;
      std::vector<std::uint64_t> block(Planner::bytes_required(scene, robot, limits) / 8);
      Planner planner;
      EXPECT_TRUE(planner.init({block.data(), block.size() * 8, &scene, robot}, {}, limits).ok());
      EXPECT_EQ(planner.start({kStart}), Status::searching);
      EXPECT_EQ(planner.advance(1'000'000), Status::solved);
      hash = planner.statistics().hash;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_NE(hashes[0], 0U);
  EXPECT_EQ(hashes[1], hashes[0]);
  EXPECT_EQ(hashes[2], hashes[0]);
}

}  // namespace
}  // namespace krait::test::planner_threads_test
