// SPDX-License-Identifier: Apache-2.0
// From a shipped scene to a verified plan, over many seeds: every robot, every scene, several scales.
#include "host/cli/campaign.hpp"
#include "host/cli/program.hpp"
#include "host/scenes/scenes.hpp"

namespace krait::host {
namespace {

class ShippedScene : public ScratchTest, public testing::WithParamInterface<const char*> {
 protected:
  void expect_solved(const char* robot, double scale, std::uint64_t count) {
    const std::string name = GetParam();
    Query query;
    query.input = write("scene.json", scene_json(name, scale));
    query.compiled = path("scene.krait");
    query.robot = parse_robot(robot);
    ASSERT_NO_FATAL_FAILURE(compile_input(query, directory()));
    expect_all_solved(name + " x" + std::to_string(scale).substr(0, 4) + " " + robot, query, count);
  }
};

TEST_P(ShippedScene, SnakeOf15) { expect_solved("snake:15", 1, seeds(10, 60)); }
TEST_P(ShippedScene, TruckOf2) { expect_solved("truck:2", 1, seeds(10, 60)); }
TEST_P(ShippedScene, Car) { expect_solved("car", 1, seeds(5, 20)); }
TEST_P(ShippedScene, Unicycle) { expect_solved("unicycle", 1, seeds(5, 20)); }
TEST_P(ShippedScene, DifferentialDrive) { expect_solved("diff_drive", 1, seeds(5, 20)); }

TEST_P(ShippedScene, SnakeOf15Smaller) { expect_solved("snake:15", 0.75, seeds(2, 20)); }
TEST_P(ShippedScene, SnakeOf15TwiceAsLarge) { expect_solved("snake:15", 2, seeds(2, 20)); }
TEST_P(ShippedScene, SnakeOf15FourTimesAsLarge) { expect_solved("snake:15", 4, seeds(2, 20)); }

using LongChain = ShippedScene;
TEST_P(LongChain, SnakeOf25) { expect_solved("snake:25", 1, seeds(10, 100)); }
TEST_P(LongChain, SnakeOf25TwiceAsLarge) { expect_solved("snake:25", 2, seeds(5, 100)); }

INSTANTIATE_TEST_SUITE_P(All, ShippedScene,
                         testing::Values("openings", "gates", "rooms", "comb", "corridors", "streets"),
                         [](const auto& scene) { return std::string(scene.param); });

INSTANTIATE_TEST_SUITE_P(Streets, LongChain, testing::Values("streets"),
                         [](const auto& scene) { return std::string(scene.param); });

}  // namespace
}  // namespace krait::host
