// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that fit a machine: within the bytes, the finest of the steps, never freer than the map.
#include "host/compiler/fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host/reduce/cells.hpp"
#include "host/run/pools.hpp"
#include "host/run/robots.hpp"
#include "scene_view.hpp"

namespace krait::host::test {
namespace {

// Boxes of up to 24 cells, with a start and a goal in opposite corners.
Workspace clutter(int cells, int boxes, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Workspace w;
  w.name = "clutter";
  w.cells =
      CellMap{cells, cells, 0.05, {0, 0}, 0, std::vector<std::uint8_t>(std::size_t(cells) * std::size_t(cells), 0)};
  w.max = {cells * 0.05, cells * 0.05};
  const auto any = [&](int least, int most) { return std::uniform_int_distribution(least, most)(random); };
  for (int k = 0; k < boxes; ++k) {
    const int x = any(0, cells - 1), y = any(0, cells - 1), width = any(1, 24), height = any(1, 24);
    for (int row = y; row < std::min(cells, y + height); ++row) {
      for (int column = x; column < std::min(cells, x + width); ++column) {
        const bool ends = std::max(row, column) < 60 || std::min(row, column) >= cells - 60;
        if (!ends) w.cells->occupied[cell_number(*w.cells, column, row)] = 1;
      }
    }
  }
  w.starts = {{"start", {1.5, 1.5}, 0, {}}};
  const double goal = cells * 0.05 - 1.5;
  w.goals = {{"goal", {{goal, goal}, {goal + 1, goal}, {goal + 1, goal + 1}, {goal, goal + 1}}}};
  return w;
}

Budget budget(std::uint64_t flash, std::uint64_t ram, double tolerance = -1) { return {flash, ram, tolerance, false}; }

std::string refusal(const Workspace& w, const Budget& b, const char* robot) {
  try {
    fit(w, parse_robot(robot), b, {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Fit, KeepsToTheBudgetAndNothingBecomesFree) {
  const Workspace w = clutter(500, 220, 1);
  const RobotSpec robot = parse_robot("turtlebot4");
  const CoreRobot core(robot);
  std::size_t before = 0;
  for (const std::uint64_t kilobytes : {90, 160, 320, 2000}) {
    const Fitted fitted = fit(w, robot, budget(kilobytes << 10U, kilobytes << 10U), {});
    const std::vector<std::uint8_t>& bytes = fitted.scene.bytes;
    EXPECT_LE(bytes.size(), kilobytes << 10U);
    EXPECT_GE(bytes.size(), before) << "more room, less detail";
    before = bytes.size();
    krait::Scene scene;
    ASSERT_TRUE(krait::Scene::open(bytes.data(), bytes.size(), scene).ok());
    EXPECT_LE(block_for(scene, core.view(), kFitVertices), kilobytes << 10U);
    EXPECT_THAT(fitted.report.at(1), testing::StartsWith(std::to_string(bytes.size()) + " of "));
    const SceneView v = Reader(bytes).read();
    EXPECT_LT(v.header.tolerance, 0.02F) << "half of the clearance: 2 % of 0.33 m and half a cell";
    for (std::size_t i = 0; i < w.cells->occupied.size(); i += 37) {
      if (w.cells->occupied[i] == 0) continue;
      const Point p = middle(*w.cells, CellFrame(*w.cells), i);
      for (const Ring& triangle : v.triangles) ASSERT_FALSE(convex_contains(triangle, p)) << p.x << ' ' << p.y;
    }
  }
}

TEST(Fit, WhereAllFitsIsTheFinest) {
  const Workspace w = clutter(300, 60, 2);
  const Fitted fitted = fit(w, parse_robot("turtlebot4"), budget(64U << 20U, 64U << 20U), {});
  EXPECT_EQ(fitted.report.at(0), "obstacles as they are");
  EXPECT_EQ(fitted.scene.bytes, compile(w, {0, {}}).bytes);
}

TEST(Fit, ALargerErrorTakesLargerCells) {
  const Workspace w = clutter(500, 220, 3);
  const std::string fine = fit(w, parse_robot("turtlebot4"), budget(90U << 10U, 0), {}).report.at(0);
  const std::string cells = fit(w, parse_robot("turtlebot4"), budget(90U << 10U, 0, 0.6), {}).report.at(0);
  EXPECT_THAT(cells, testing::Not(testing::Eq(fine)));
  EXPECT_THAT(fine, testing::HasSubstr("shortest ways"));
  EXPECT_THAT(cells, testing::Not(testing::HasSubstr("shortest ways")));
}

// What fits into as little flash as fits anything.
Fitted smallest(const Workspace& w, const char* robot, double tolerance) {
  std::uint64_t flash = std::uint64_t{1} << 30U;
  Fitted fitted;
  while (refusal(w, budget(flash, 0, tolerance), robot).empty()) {
    fitted = fit(w, parse_robot(robot), budget(flash, 0, tolerance), {});
    flash = fitted.scene.bytes.size() - 1;
  }
  return fitted;
}

// Two rooms with clutter and a door of 0.55 m between them, without a start.
TEST(Fit, NamesThePassagesThatItsCellsCloseAndTheirErrorInTheScene) {
  Workspace w = clutter(400, 60, 6);
  w.starts.clear();
  w.goals.clear();
  for (int column = 0; column < 400; ++column) {
    for (int row = 170; row < 220; ++row) {
      const bool wall = row >= 190 && row < 200 && (column < 300 || column > 310);
      w.cells->occupied[cell_number(*w.cells, column, row)] = wall;
    }
  }
  const Fitted fitted = smallest(w, "unicycle", 2.4);
  EXPECT_THAT(fitted.report.at(0), testing::StartsWith("obstacles grown by at most 1.2 m, cells of 0.424 m"));
  EXPECT_THAT(fitted.scene.warnings,
              testing::Contains(testing::StartsWith("to fit: --cell 0.4242640687 closes a passage at 15.2")));
  EXPECT_NEAR(Reader(fitted.scene.bytes).read().header.tolerance, 1.2, 1e-6);
}

// A wall of teeth, which is straight where it may grow: with coarse regions all of the teeth take more bytes than the
// straight wall with fine ones.
Workspace teeth() {
  Workspace w;
  w.max = {60, 20};
  Ring wall{{0, 10}, {60, 10}};
  for (int i = 300; i >= 0; --i) wall.push_back({0.2 * i, i % 2 == 0 ? 10.2 : 10.4});
  w.obstacles = {{"wall", wall, {}}};
  return w;
}

TEST(Fit, TriesFineRegionsAlsoWhereFinerOutlinesDoNotFit) {
  const Workspace w = teeth();
  const std::vector<std::uint8_t> grown = compile(w, {0.5, {}}).bytes;
  ASSERT_GT(compile(w, {0, {}, true}).bytes.size(), grown.size());
  ASSERT_LT(compile(w, {0.5, {}, true}).bytes.size(), grown.size());
  EXPECT_EQ(fit(w, parse_robot("car"), budget(grown.size(), 0, 1), {}).scene.bytes, grown);
}

TEST(Fit, TriesNothingThatIsFinerThanWhatIsFarTooLarge) {
  int compiled = 0;
  const auto count = [&](const std::string& step) { compiled += step == "uniting obstacles"; };
  EXPECT_THROW(fit(teeth(), parse_robot("car"), budget(4000, 0, 1), count), InputError);
  EXPECT_EQ(compiled, 1);
}

TEST(Fit, AdvisesALargerToleranceOnlyWhereItHelps) {
  const Workspace w = teeth();
  const std::size_t grown = compile(w, {0.4, {}, true}).bytes.size();
  const std::string advice = "or allow more error: with --tolerance 0.4 it takes ";
  ASSERT_LT(grown, compile(w, {0.2, {}, true}).bytes.size() * 3 / 4);
  EXPECT_THAT(refusal(w, budget(grown, 0, 0.2), "car"), testing::HasSubstr(advice + std::to_string(grown) + " of "));
  EXPECT_THAT(refusal(w, budget(grown - 1, 0, 0.4), "car"), testing::Not(testing::HasSubstr("allow more error")));
}

TEST(Fit, KeepsToCoarseRegionsWhereTheseAreAskedFor) {
  const Workspace w = teeth();
  EXPECT_EQ(fit(w, parse_robot("car"), {0, 0, 1, true}, {}).scene.bytes, compile(w, {0, {}, true}).bytes);
}

TEST(Fit, RefusesWithTheBytes) {
  const Workspace w = clutter(300, 60, 4);
  EXPECT_THAT(refusal(w, budget(0, 20'000), "turtlebot4"),
              testing::AllOf(testing::StartsWith("does not fit: "), testing::HasSubstr(" of 20000 of RAM"),
                             testing::HasSubstr("crop the map")));
  EXPECT_THAT(refusal(w, budget(9000, 0), "turtlebot4"), testing::HasSubstr(" of 9000 bytes of flash"));
}

TEST(Fit, SaysWhereNoWayIsWideEnough) {
  Workspace w = clutter(300, 0, 5);
  for (int row = 0; row < 300; ++row) {
    if (row / 10 != 12) w.cells->occupied[cell_number(*w.cells, 150, row)] = 1;
  }
  EXPECT_EQ(refusal(w, budget(1U << 20U, 1U << 20U), "turtlebot4"), "") << "a door of 0.5 m";
  EXPECT_THAT(refusal(w, budget(1U << 20U, 1U << 20U), "husky"),
              testing::HasSubstr("no way from the start to the goal"));
}

}  // namespace
}  // namespace krait::host::test
