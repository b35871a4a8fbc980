// SPDX-License-Identifier: Apache-2.0
// The picture of a search that found nothing: the robot at its start, and branches as they grew.
#include <cmath>

#include "host/cli/program.hpp"
#include "host/run/run.hpp"

namespace krait::host {
namespace {

class FailedPicture : public CliTest {
 protected:
  // A car that cannot turn to the door.
  Picture picture(std::uint64_t iterations) {
    SearchRequest request;
    request.robot = parse_robot("car");
    request.robot.parameters.at("max_steering") = 0.01;
    request.start_name = "north";
    request.iterations = iterations;
    const SceneBytes bytes = SceneBytes::read(path("room.krait"));
    const SearchResult result = run_search("room.krait", bytes, request, {});
    EXPECT_EQ(result.plan.status, "budget_used");
    vertices_ = result.plan.statistics.at("vertices").get<std::uint64_t>();
    return watch_search("room.krait", bytes, request, result.plan);
  }

  std::uint64_t vertices_ = 0;
};

TEST_F(FailedPicture, HasTheRobotAtItsStart) {
  const Picture small = picture(100);
  ASSERT_EQ(small.start.size(), 5U);
  EXPECT_NEAR(static_cast<double>(small.start[2]), -0.5, 1e-6);
  EXPECT_EQ(small.start[0], small.tree.front().x);
}

// Past the door it cannot turn before the bounds.
TEST_F(FailedPicture, MarksWhereItTriedMostAndWhatStoppedIt) {
  const std::vector<Mark> marks = picture(20'000).marks;
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_EQ(marks[0].text, "tried most");
  EXPECT_GT(marks[0].at.x, 10);
  EXPECT_EQ(marks[1].text, "stops it");
  EXPECT_NEAR(marks[1].at.x, 20, 0.1);
}

// A chord across a bend could lead through an obstacle: every line is a step, at most 2.5 m/s for 0.1 s.
TEST_F(FailedPicture, ThinnedBranchesKeepTheirBends) {
  const Picture large = picture(20'000);
  ASSERT_GT(vertices_, 40'000U);
  EXPECT_LE(large.tree.size(), 20'000U);
  EXPECT_GT(large.tree.size(), 2'000U);
  for (const TreeVertex& vertex : large.tree) {
    const TreeVertex& parent = large.tree[vertex.parent];
    EXPECT_LE(std::hypot(static_cast<double>(vertex.x - parent.x), static_cast<double>(vertex.y - parent.y)), 0.2501);
  }
}

}  // namespace
}  // namespace krait::host
