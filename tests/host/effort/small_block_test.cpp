// SPDX-License-Identifier: GPL-3.0-or-later
// README's claim: snakes of 5 and of 15 links plan in 32 KB, in every shipped scene, with every seed of a hundred.
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "host/compiler/compiler.hpp"
#include "host/scenes/scenes.hpp"
#include "krait/krait.hpp"

namespace krait::host {
namespace {

constexpr std::uint64_t kBlock = 32 * 1024;    // bytes
constexpr std::uint64_t kIterations = 20'000;  // of a search, as in lib/MEMORY.md
constexpr std::uint64_t kSeeds = 100;

class SmallBlock : public ::testing::TestWithParam<std::string> {};

TEST_P(SmallBlock, HoldsEverySearch) {
  const CompiledScene compiled = compile(make_scene(GetParam(), 1).workspace, {});
  std::vector<std::uint32_t> file(compiled.bytes.size() / 4 + 1);
  std::memcpy(file.data(), compiled.bytes.data(), compiled.bytes.size());
  krait::Scene scene;
  ASSERT_TRUE(krait::Scene::open(file.data(), compiled.bytes.size(), scene).ok());
  std::vector<std::uint64_t> block(kBlock / 8);
  for (const int links : {5, 15}) {
    ChainParameters parameters;
    parameters.trailers = links;
    const Snake snake(parameters);
    Planner planner;
    Limits limits = Planner::limits_for(kBlock, scene, snake);
    limits.iterations = kIterations;
    ASSERT_TRUE(planner.init({block.data(), kBlock, &scene, snake}, Parameters(), limits).ok());
    std::vector<float> start(static_cast<std::size_t>(snake.state_size()));
    const ScenePose pose = scene.start(0);
    snake.rest(pose.position, pose.heading, nullptr, start.data());
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      ASSERT_EQ(planner.start({start.data(), krait::Goal::named(0), seed}), Status::searching);
      EXPECT_EQ(planner.advance(kIterations), Status::solved) << "snake:" << links << ", seed " << seed;
      EXPECT_LE(planner.statistics().bytes_used, kBlock);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SmallBlock,
                         ::testing::Values("openings", "gates", "rooms", "comb", "corridors", "streets"),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace krait::host
