// SPDX-License-Identifier: Apache-2.0
// Judges the shipped scenes as a user reads them (JSON, importer), by flooding a fine grid of points with a disc.
#include "host/scenes/scenes.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "../scratch.hpp"
#include "host/import/import.hpp"

namespace krait::host {
namespace {

struct Box {
  Point min, max;
};

Box box_of(const Ring& ring) {
  Box box{ring[0], ring[0]};
  for (const Point& p : ring) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
  }
  return box;
}

double distance(const Box& box, const Point& p) {
  return std::hypot(std::max({box.min.x - p.x, 0.0, p.x - box.max.x}),
                    std::max({box.min.y - p.y, 0.0, p.y - box.max.y}));
}

// The points of a grid where a disc neither meets a box nor leaves the bounds, and how far it moves to each of them,
// along x and y only.
class Flood {
 public:
  Flood(double side, const std::vector<Box>& boxes, double radius, double step)
      : step_(step), count_(static_cast<std::size_t>(side / step)), steps_(count_ * count_, kFree) {
    block_bounds(side, radius);
    for (const Box& box : boxes) block(box, radius);
  }

  void fill_from(const Point& start) {
    if (steps_[index(start)] != kFree) return;
    std::vector<std::size_t> queue = {index(start)};
    steps_[queue[0]] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const std::size_t at = queue[i];
      const auto visit = [&](std::size_t next) {
        if (steps_[next] != kFree) return;
        steps_[next] = steps_[at] + 1;
        queue.push_back(next);
      };
      if (at % count_ > 0) visit(at - 1);
      if (at % count_ + 1 < count_) visit(at + 1);
      if (at >= count_) visit(at - count_);
      if (at + count_ < steps_.size()) visit(at + count_);
    }
  }

  // Metres; infinite where it is not reached.
  double length_to(const Point& p) const {
    const int steps = steps_[index(p)];
    return steps >= 0 ? steps * step_ : std::numeric_limits<double>::infinity();
  }

 private:
  static constexpr int kFree = -1;
  static constexpr int kBlocked = -2;

  double coordinate(std::size_t i) const { return (static_cast<double>(i) + 0.5) * step_; }
  std::size_t cell(double x) const {
    return static_cast<std::size_t>(std::clamp(x / step_, 0.0, static_cast<double>(count_ - 1)));
  }
  std::size_t index(const Point& p) const { return cell(p.y) * count_ + cell(p.x); }

  void block(const Box& box, double radius) {
    for (std::size_t j = cell(box.min.y - radius); j <= cell(box.max.y + radius); ++j) {
      for (std::size_t i = cell(box.min.x - radius); i <= cell(box.max.x + radius); ++i) {
        if (distance(box, {coordinate(i), coordinate(j)}) < radius) steps_[j * count_ + i] = kBlocked;
      }
    }
  }

  void block_bounds(double side, double radius) {
    for (const Box& edge :
         {Box{{0, 0}, {side, 0}}, Box{{0, side}, {side, side}}, Box{{0, 0}, {0, side}}, Box{{side, 0}, {side, side}}}) {
      block(edge, radius);
    }
  }

  double step_;
  std::size_t count_;
  std::vector<int> steps_;
};

constexpr double kInradius = 0.25;  // of the default robots

class SceneTest : public testing::TestWithParam<std::tuple<std::string, double>> {
 protected:
  SceneTest() : scene_(make_scene(name(), scale())), boxes_(boxes(scene_.workspace)) {}

  static std::string name() { return std::get<0>(GetParam()); }
  static double scale() { return std::get<1>(GetParam()); }
  static double side() { return 50 * scale(); }

  static std::vector<Box> boxes(const Workspace& workspace) {
    std::vector<Box> list;
    for (const Obstacle& obstacle : workspace.obstacles) list.push_back(box_of(obstacle.outer));
    return list;
  }

  Point goal_center() const {
    const Box box = box_of(scene_.workspace.goals[0].polygon);
    return {(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2};
  }

  double length(double radius, const std::vector<Box>& more = {}) const {
    std::vector<Box> all = boxes_;
    all.insert(all.end(), more.begin(), more.end());
    Flood flood(side(), all, radius, scale() < 2 ? 0.05 : 0.1);
    flood.fill_from(scene_.workspace.starts[0].position);
    return flood.length_to(goal_center());
  }
  bool reachable(double radius, const std::vector<Box>& more = {}) const { return std::isfinite(length(radius, more)); }

  std::vector<Box> passages(bool passable) const {
    std::vector<Box> list;
    for (const Passage& p : scene_.passages) {
      if (p.passable == passable) list.push_back({p.min, p.max});
    }
    return list;
  }

  bool free(const Box& box) const {
    return std::none_of(boxes_.begin(), boxes_.end(), [&](const Box& b) {
      return b.min.x < box.max.x && box.min.x < b.max.x && b.min.y < box.max.y && box.min.y < b.max.y;
    });
  }

  Scene scene_;
  std::vector<Box> boxes_;
};

TEST_P(SceneTest, EveryObstacleIsARectangleOfPositiveArea) {
  for (const Obstacle& obstacle : scene_.workspace.obstacles) {
    ASSERT_EQ(obstacle.outer.size(), 4U);
    const Box box = box_of(obstacle.outer);
    double area = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point& a = obstacle.outer[i];
      const Point& b = obstacle.outer[(i + 1) % 4];
      area += (a.x * b.y - b.x * a.y) / 2;
    }
    EXPECT_NEAR(area, (box.max.x - box.min.x) * (box.max.y - box.min.y), 1e-6);
    EXPECT_GT(std::min(box.max.x - box.min.x, box.max.y - box.min.y), 0.1) << obstacle.label;
  }
}

TEST_P(SceneTest, TheGoalIsReachedByADiscOfTheRobotsInradius) { EXPECT_TRUE(reachable(kInradius)); }

TEST_P(SceneTest, WithoutItsPassablePassagesTheGoalIsOutOfReach) {
  if (scene_.passages.empty()) {
    EXPECT_TRUE(reachable(name() == "streets" ? 1.6 : 0.85));  // nothing narrower than 3.5 m, or 1.9 m, is needed
  } else {
    EXPECT_FALSE(reachable(kInradius, passages(true)));
    EXPECT_TRUE(reachable(0.6, passages(false)));
  }
}

TEST_P(SceneTest, TheShortestWayLeadsThroughTooNarrowPassagesIfThereAreAny) {
  if (scene_.passages.empty()) {
    EXPECT_GT(length(0.1) + 5 * scale(), length(kInradius));
  } else {
    EXPECT_GE(passages(false).size(), 2U);
    EXPECT_LT(length(0.1) + 5 * scale(), length(kInradius));
  }
}

// Independent of the list of passages: the free width is measured from the obstacles.
TEST_P(SceneTest, EveryPassageHasItsWidthAndTurningRoomOnBothSides) {
  for (const Passage& p : scene_.passages) {
    const bool across_x = p.max.y - p.min.y == 1;  // a gap in a wall along x
    EXPECT_NEAR(across_x ? p.max.x - p.min.x : p.max.y - p.min.y, p.passable ? 1.4 : 0.4, 1e-9);
    EXPECT_TRUE(free({p.min, p.max}));
    const Point middle = {(p.min.x + p.max.x) / 2, (p.min.y + p.max.y) / 2};
    double clearance = 1e9;
    for (const Box& box : boxes_) {
      clearance = std::min(clearance, distance(box, middle));
    }
    EXPECT_NEAR(2 * clearance, p.width, 1e-9);
    if (!p.passable || scale() < 0.75) continue;
    const double deep = 0.5 + 3;
    const double half = 1.5;
    const Box room = across_x ? Box{{middle.x - half, p.min.y - 3}, {middle.x + half, p.min.y}}
                              : Box{{p.min.x - 3, middle.y - half}, {p.min.x, middle.y + half}};
    const Box other = across_x ? Box{{middle.x - half, p.max.y}, {middle.x + half, middle.y + deep}}
                               : Box{{p.max.x, middle.y - half}, {middle.x + deep, middle.y + half}};
    EXPECT_TRUE(free(room)) << middle.x << " " << middle.y;
    EXPECT_TRUE(free(other)) << middle.x << " " << middle.y;
  }
}

TEST_P(SceneTest, TheStartHasRoomForTwentyFiveTrailersBehindAndATurnAhead) {
  const Point start = scene_.workspace.starts[0].position;
  const Box strip = {{start.x - 20.5, start.y - 0.5}, {start.x + 2.9, start.y + 0.5}};
  EXPECT_EQ(scene_.workspace.starts[0].heading, 0);
  EXPECT_GE(strip.min.x, 0.5);
  EXPECT_LE(strip.max.x, side());
  EXPECT_TRUE(free(strip));
}

TEST_P(SceneTest, TheGoalIsThreeMetresWideFreeAndInside) {
  const Box goal = box_of(scene_.workspace.goals[0].polygon);
  EXPECT_NEAR(goal.max.x - goal.min.x, 3, 1e-9);
  EXPECT_NEAR(goal.max.y - goal.min.y, 3, 1e-9);
  EXPECT_TRUE(free(goal));
  EXPECT_GT(std::min(goal.min.x, goal.min.y), 0);
  EXPECT_LT(std::max(goal.max.x, goal.max.y), side());
}

INSTANTIATE_TEST_SUITE_P(Shipped, SceneTest,
                         testing::Combine(testing::Values("openings", "gates", "rooms", "comb", "corridors", "streets"),
                                          testing::Values(0.5, 0.75, 1.0, 2.0, 4.0)),
                         [](const auto& test) {
                           return std::get<0>(test.param) + "_" +
                                  std::to_string(static_cast<int>(100 * std::get<1>(test.param)));
                         });

TEST(Scenes, AreSixByName) {
  std::vector<std::string> names;
  for (const SceneName& name : scene_names()) names.emplace_back(name.name);
  EXPECT_THAT(names, testing::ElementsAre("openings", "gates", "rooms", "comb", "corridors", "streets"));
}

// A disc of the robots' inradius that drives along y through one row of blocks meets the next.
TEST(Scenes, HaveStreetsThatDoNotGoOnBehindTheNextRow) {
  for (const double scale : {1.0, 2.0, 4.0}) {
    std::map<double, std::vector<Box>> rows;  // by their lower edges
    for (const Obstacle& obstacle : make_scene("streets", scale).workspace.obstacles) {
      const Box box = box_of(obstacle.outer);
      rows[box.min.y].push_back(box);
    }
    ASSERT_EQ(rows.size(), 3U);
    for (double x = kInradius; x < 50 * scale; x += kInradius) {
      bool before = false;
      for (const auto& [bottom, blocks] : rows) {
        const bool open = std::none_of(blocks.begin(), blocks.end(), [&](const Box& block) {
          return block.min.x < x + kInradius && x - kInradius < block.max.x;
        });
        EXPECT_FALSE(before && open) << x << " " << bottom;
        before = open;
      }
    }
  }
}

TEST(Scenes, RefuseUnknownNamesAndScales) {
  EXPECT_THAT(error_of([] { make_scene("nave", 1); }), testing::HasSubstr("known are openings, gates"));
  for (const double scale : {0.49, 8.01, -1.0, 0.0, std::nan("")}) {
    EXPECT_THAT(error_of([&] { make_scene("gates", scale); }), testing::HasSubstr("from 0.5 to 8")) << scale;
  }
}

using SceneJson = ScratchTest;

TEST_F(SceneJson, ReadsBackTheSameWorkspace) {
  for (const SceneName& name : scene_names()) {
    const Workspace scene = make_scene(name.name, 1.5).workspace;
    const Workspace copy = import_workspace(write("s.json", scene_json(name.name, 1.5)), {});
    EXPECT_EQ(copy.name, name.name);
    EXPECT_EQ(copy.max.x, 75);
    ASSERT_EQ(copy.obstacles.size(), scene.obstacles.size());
    for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(copy.obstacles[i].outer[k].x, scene.obstacles[i].outer[k].x);
        EXPECT_EQ(copy.obstacles[i].outer[k].y, scene.obstacles[i].outer[k].y);
      }
    }
    EXPECT_EQ(copy.goals.at(0).name, "goal");
    EXPECT_EQ(copy.starts.at(0).name, "start");
  }
}

}  // namespace
}  // namespace krait::host
