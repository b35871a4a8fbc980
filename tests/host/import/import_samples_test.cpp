// SPDX-License-Identifier: Apache-2.0
// Real files of others; skipped where the folder of samples is absent.
#include <gmock/gmock.h>

#include <numeric>

#include "../scratch.hpp"
#include "host/import/import.hpp"
#include "paths.hpp"

namespace krait::host::import_samples_test {
namespace {

using testing::HasSubstr;

class SamplesTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(root_)) GTEST_SKIP() << "no samples at " << root_;
  }
  Workspace read(const std::string& name, const ImportOptions& options = {}) const {
    return import_workspace(root_ + "/" + name, options);
  }
  static int occupied(const Workspace& w) {
    return std::accumulate(w.cells->occupied.begin(), w.cells->occupied.end(), 0);
  }

 private:
  std::string root_ = krait::test::source_path("../shared/samples");
};

TEST_F(SamplesTest, TurtlebotMapIsMostlyUnknown) {
  const Workspace w = read("turtlebot3/map.yaml");
  EXPECT_EQ(w.cells->columns, 384);
  EXPECT_EQ(w.min.x, -10);
  ASSERT_EQ(w.warnings.size(), 1U);
  EXPECT_THAT(w.warnings[0], HasSubstr("94.1 % of the cells are unknown and count as obstacles"));
  EXPECT_GT(occupied(w), occupied(read("turtlebot3/map.yaml", {Unknown::free})) + 100000);
}

TEST_F(SamplesTest, DepotReadsUnknownAsFreeAndSaysSo) {
  const Workspace w = read("nav2/depot.yaml");
  EXPECT_EQ(w.cells->columns, 604);
  EXPECT_EQ(w.cells->rows, 307);
  ASSERT_EQ(w.warnings.size(), 1U);
  EXPECT_THAT(w.warnings[0], HasSubstr("reads as free"));
  EXPECT_GT(occupied(read("nav2/depot.yaml", {Unknown::occupied})), occupied(w));
  EXPECT_EQ(occupied(read("nav2/depot.yaml", {Unknown::free})), occupied(w));
}

TEST_F(SamplesTest, ColouredAndTransparentPngsAreRead) {
  EXPECT_EQ(read("karlkurzer/map.yaml").cells->resolution, 1);
  EXPECT_GT(occupied(read("mir/maze.yaml")), 0);
}

TEST_F(SamplesTest, MovingAiMapsHaveTheirKnownSize) {
  EXPECT_EQ(read("movingai/arena.map").cells->columns, 49);
  EXPECT_EQ(read("movingai/den312d.map").cells->rows, 81);
}

TEST_F(SamplesTest, DynobenchProblemsHaveStartAndGoal) {
  for (const char* name : {"dynobench/bugtrap_0.yaml", "dynobench/parallelpark_0.yaml"}) {
    const Workspace w = read(name);
    EXPECT_EQ(w.starts.size(), 1U);
    EXPECT_EQ(w.goals.size(), 1U);
    EXPECT_TRUE(w.goals[0].pose);
    EXPECT_GE(w.obstacles.size(), 3U);
  }
}

TEST_F(SamplesTest, ParkingCasesHaveThreeCars) {
  for (const char* name : {"tpcap/Case1.csv", "tpcap/Case2.csv", "tpcap/Case7.csv"}) {
    const Workspace w = read(name);
    ASSERT_EQ(w.obstacles.size(), 3U);
    for (const Obstacle& obstacle : w.obstacles) EXPECT_EQ(obstacle.outer.size(), 4U);
  }
  const Workspace first = read("tpcap/Case1.csv");
  EXPECT_EQ(first.starts[0].heading, 0.200398553825878);
  ASSERT_TRUE(first.goals[0].pose);
  EXPECT_NEAR(first.goals[0].pose->facing.heading, 0.379494743668899, 1e-15);
}

// One unit is a metre there, as its query says; on paper it would be a millimetre.
TEST_F(SamplesTest, ADrawnCarParkHasItsSize) {
  const Workspace w = read("bench_mr/parking1.svg", {.unit = 1});
  EXPECT_EQ(w.obstacles.size(), 13U);
  EXPECT_NEAR(w.max.x, 18.658882, 1e-9);
  EXPECT_NEAR(w.min.y, -14.412246, 1e-9);
  EXPECT_NEAR(w.obstacles[0].outer[0].x, 168.54641 - 165.58946, 1e-9);
  EXPECT_NEAR(w.obstacles[0].outer[0].y, 46.679786 - 60.16482, 1e-9);
  EXPECT_THAT(read("bench_mr/parking1.svg").warnings, testing::ElementsAre(HasSubstr("measures 0.018658882 m")));
}

}  // namespace
}  // namespace krait::host::import_samples_test
