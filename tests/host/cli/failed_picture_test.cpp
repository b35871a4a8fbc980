// SPDX-License-Identifier: Apache-2.0
// The picture of a search that found nothing: the robot at its start, and branches as they grew.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

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
    vertices_ = result.plan.statistics->at("vertices").get<std::uint64_t>();
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

// Past the door it cannot turn before the bounds. The last try has lasted long.
TEST_F(FailedPicture, MarksWhereItTriedMostAndWhatStoppedIt) {
  const std::vector<Mark> marks = picture(12'000).marks;
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

// A trailer that is pushed for 14 hitch lengths makes ways that do not hold as driven. Driving them again takes calls
// that are no iterations of the search.
TEST_F(FailedPicture, HasAllThatGrewAlsoWhereWaysWereRefused) {
  write("lane.json", R"({"bounds": {"min": [0, 0], "max": [14, 1.2]}, "obstacles": [],
      "goals": [{"name": "west", "box": {"center": [1.1, 0.6], "size": [0.6, 1], "angle": 0}}],
      "starts": [{"name": "east", "position": [7, 0.6], "heading": 0, "angles": [0]}]})");
  expect_done({"compile", "lane.json", "-o", "lane.krait"});
  SearchRequest request;
  request.robot = parse_robot("truck:1");
  request.robot.parameters.at("hitch_length") = 0.4;
  request.robot.parameters.at("min_speed") = -request.robot.parameters.at("max_speed");
  request.parameters.tuning.reverse_share = 0.5F;
  request.iterations = 2000;
  const SceneBytes bytes = SceneBytes::read(path("lane.krait"));
  std::uint64_t refused = 0;
  for (request.seed = 1; request.seed <= 10; ++request.seed) {
    const SearchResult result = run_search("lane.krait", bytes, request, {});
    refused += result.plan.statistics->at("plans_refused").get<std::uint64_t>();
    const auto vertices = result.plan.statistics->at("vertices").get<std::uint64_t>();
    const Picture picture = watch_search("lane.krait", bytes, request, result.plan);
    ASSERT_LE(vertices, 20'000U);
    EXPECT_EQ(picture.tree.size(), vertices) << request.seed;
    EXPECT_EQ(picture.frames.back().iteration, result.plan.statistics->at("iterations").get<std::uint64_t>());
  }
  EXPECT_GT(refused, 0U);
}

// The door is 0.6 m wide, the car and its clearance 0.602 m.
TEST_F(FailedPicture, CutsOffTheRegionsBeyondANarrowDoor) {
  write("narrow.json", R"({"bounds": {"min": [0, 0], "max": [20, 10]},
      "obstacles": [{"box": {"center": [10, 2.35], "size": [1, 4.7], "angle": 0}},
                    {"box": {"center": [10, 7.65], "size": [1, 4.7], "angle": 0}}],
      "goals": [{"name": "east", "box": {"center": [17, 5], "size": [2, 2], "angle": 0}}],
      "starts": [{"name": "west", "position": [3, 5], "heading": 0}]})");
  expect_done({"compile", "narrow.json", "-o", "narrow.krait"});
  SearchRequest request;
  request.robot = parse_robot("car");
  const SceneBytes bytes = SceneBytes::read(path("narrow.krait"));
  const SearchResult result = run_search("narrow.krait", bytes, request, {});
  ASSERT_EQ(result.plan.status, "no_route");
  const Picture picture = watch_search("narrow.krait", bytes, request, result.plan);
  for (std::size_t t = 0; t < picture.triangles.size(); ++t) {
    const auto& corners = picture.triangles[t].corners;
    const bool west = std::max({corners[0].x, corners[1].x, corners[2].x}) <= 9.5 + picture.min.x;
    const bool east = std::min({corners[0].x, corners[1].x, corners[2].x}) >= 10.5 + picture.min.x;
    const float cost = picture.frames.front().costs[t];
    EXPECT_TRUE(!west || std::isinf(cost));
    EXPECT_TRUE(!east || std::isfinite(cost));
  }
}

// Where no search begins, there is no tree and no cost.
TEST_F(FailedPicture, HasTheRobotInTheObstacleThatItsStartLiesIn) {
  SearchRequest request;
  request.robot = parse_robot("car");
  request.start = StartPose{{9.5, 1}, 0};
  const SceneBytes bytes = SceneBytes::read(path("room.krait"));
  try {
    run_search("room.krait", bytes, request, {});
    FAIL() << "it stands in the wall";
  } catch (const InObstacle& refusal) {
    const Picture picture = picture_of_refusal("room.krait", bytes, request, refusal);
    EXPECT_EQ(picture.plan.status, "start_in_collision");
    EXPECT_EQ(picture.start.size(), 5U);
    EXPECT_TRUE(picture.tree.empty());
    ASSERT_EQ(picture.marks.size(), 1U);
    EXPECT_EQ(picture.marks[0].text, "in the way");
    EXPECT_NEAR(picture.marks[0].at.x + picture.plan.origin.x, 10, 0.5);
    EXPECT_NEAR(picture.marks[0].at.y + picture.plan.origin.y, 1, 0.3);
  }
}

}  // namespace
}  // namespace krait::host
