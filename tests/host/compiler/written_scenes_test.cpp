// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene file says beside its mesh: starts, names, how much obstacles grew, how fine its grids are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "check_scene.hpp"
#include "krait/scene.hpp"

namespace krait::host::test {
namespace {

TEST(WrittenScenes, EveryStartKeepsItsPoseAndItsAngles) {
  Workspace w;
  w.min = {2000, 5000};  // so far from 0 that the file has an origin
  w.max = {2010, 5010};
  w.starts = {{"a", {2001, 5002}, 0.5, {0.25, -0.5}}, {"b", {2003, 5004}, 1, {}}, {"c", {2005, 5006}, -1, {0.75}}};
  const CompiledScene compiled = compile(w, {});
  Scene scene;
  ASSERT_TRUE(Scene::open(compiled.bytes.data(), compiled.bytes.size(), scene).ok());
  ASSERT_EQ(scene.start_count(), w.starts.size());
  for (Index i = 0; i < scene.start_count(); ++i) {
    const ScenePose pose = scene.start(i);
    EXPECT_EQ(double(pose.position.x) + scene.header().origin_x, w.starts[i].position.x);
    EXPECT_EQ(double(pose.position.y) + scene.header().origin_y, w.starts[i].position.y);
    EXPECT_EQ(double(pose.heading), w.starts[i].heading);
    EXPECT_THAT(std::vector<double>(pose.angles, pose.angles + pose.angle_count),
                testing::ElementsAreArray(w.starts[i].angles));
  }
}

TEST(WrittenScenes, ANameLosesWhatEndsNames) {
  Workspace w = empty_room(10, 10);
  w.name = std::string("ro\0om", 5);
  w.goals = {{std::string("\0dock", 5), box(1, 1, 3, 3)}};
  EXPECT_EQ(checked(w).names, (std::vector<std::string>{"room", "dock"}));
}

TEST(WrittenScenes, HowMuchObstaclesGrewIsNotRoundedDown) {
  Workspace w = empty_room(10, 10);
  w.obstacles.push_back({"a", box(4, 4, 6, 6), {}});
  for (const double growth : {0.1, 0.3, 0.5, 0.6, 0.7}) {  // singles nearest to them lie on either side
    const double said = double(checked(w, 2 * growth).header.tolerance);
    EXPECT_GE(said, growth);
    EXPECT_LE(said, growth + 1e-7);
  }
}

TEST(WrittenScenes, ClearanceCellsAreSmallInSmallScenesAndLargeInLargeOnes) {
  const auto cell = [](double side) { return double(checked(empty_room(side, side)).header.clearance_cell); };
  EXPECT_NEAR(cell(100), 0.39, 0.01);
  EXPECT_NEAR(cell(40), 0.25, 0.01);
  EXPECT_NEAR(cell(8), 0.125, 0.01);
  EXPECT_NEAR(cell(2), 0.03125, 0.01);
}

}  // namespace
}  // namespace krait::host::test
