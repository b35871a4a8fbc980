// SPDX-License-Identifier: GPL-3.0-or-later
// Whole scenes: every case runs through the brute-force checker.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "../cell_map.hpp"
#include "check_scene.hpp"
#include "host/reduce/crop.hpp"

namespace krait::host::test {
namespace {

double solid_area(const SceneView& v) {
  double sum = 0;
  for (const Ring& piece : v.pieces) sum += twice_area(piece) / 2;
  return sum;
}

std::string complaint(const Workspace& w, double tolerance = -1) {
  try {
    compile(w, {tolerance, {}});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

Workspace map_room(CellMap map, Point origin = {0, 0}, double yaw = 0) {
  Workspace w;
  w.name = "map";
  map.origin = origin;
  map.yaw = yaw;
  const double width = map.columns * map.resolution, height = map.rows * map.resolution;
  const Ring ring = rotated_box({0, 0}, width, height, yaw);
  const Point center{origin.x + std::cos(yaw) * width / 2 - std::sin(yaw) * height / 2,
                     origin.y + std::sin(yaw) * width / 2 + std::cos(yaw) * height / 2};
  w.min = w.max = center;
  for (const Point p : ring) {
    w.min = {std::min(w.min.x, center.x + p.x), std::min(w.min.y, center.y + p.y)};
    w.max = {std::max(w.max.x, center.x + p.x), std::max(w.max.y, center.y + p.y)};
  }
  w.cells = std::move(map);
  return w;
}

CellMap random_cells(std::mt19937_64& random, int columns, int rows, double share) {
  CellMap map;
  map.columns = columns;
  map.rows = rows;
  map.resolution = 0.05;
  std::bernoulli_distribution occupied(share);
  for (int i = 0; i < columns * rows; ++i) map.occupied.push_back(occupied(random));
  return map;
}

TEST(Scenes, EmptyRoom) {
  const SceneView v = checked(empty_room(50, 30));
  EXPECT_TRUE(v.pieces.empty());
  EXPECT_GT(v.triangles.size(), 50U);
}

TEST(Scenes, FullyBlockedIsRefused) {
  Workspace w = empty_room(10, 10);
  w.obstacles.push_back({"obstacles[0]", box(-1, -1, 11, 11), {}});
  EXPECT_THROW(checked(w), InputError);
}

TEST(Scenes, ABoxIsOnePiece) {
  Workspace w = empty_room(20, 20);
  w.obstacles.push_back({"obstacles[0]", box(5, 5, 9, 6), {}});
  const SceneView v = checked(w);
  EXPECT_EQ(v.pieces.size(), 1U);
  EXPECT_EQ(solid_area(v), 4);
}

TEST(Scenes, EitherOrientationAndDuplicatesGiveTheSameSolid) {
  Workspace w = empty_room(20, 20);
  Ring clockwise = box(5, 5, 9, 6);
  std::reverse(clockwise.begin(), clockwise.end());
  clockwise.insert(clockwise.begin() + 1, clockwise[1]);
  w.obstacles.push_back({"a", clockwise, {}});
  w.obstacles.push_back({"b", box(5, 5, 9, 6), {}});
  EXPECT_EQ(solid_area(checked(w)), 4);
}

TEST(Scenes, TouchingBoxesLeaveNoSlit) {
  Workspace w = empty_room(20, 20);
  w.obstacles.push_back({"a", box(0, 5, 9.3, 6), {}});
  w.obstacles.push_back({"b", box(9.3, 4, 20, 7), {}});
  const SceneView v = checked(w);
  EXPECT_NEAR(solid_area(v), 9.3 + 3 * 10.7, 1e-2);
}

TEST(Scenes, HolesAndIslandsInHoles) {
  Workspace w = empty_room(20, 20);
  w.obstacles.push_back({"ring", box(2, 2, 18, 18), {box(4, 4, 16, 16)}});
  w.obstacles.push_back({"island", box(8, 8, 12, 12), {}});
  EXPECT_NEAR(solid_area(checked(w)), 256 - 144 + 16, 1e-9);
}

TEST(Scenes, AHoleBeyondItsOutlineCutsNothingElse) {
  Workspace w = empty_room(20, 20);
  w.obstacles.push_back({"a", box(2, 2, 8, 8), {box(6, 6, 12, 12)}});
  w.obstacles.push_back({"b", box(10, 10, 14, 14), {}});
  EXPECT_NEAR(solid_area(checked(w)), 36 - 4 + 16, 1e-9);
}

TEST(Scenes, GoalsThatCrossThemselvesOrHaveOneNameAreRefused) {
  Workspace w = empty_room(20, 20);
  w.goals = {{"g", {{1, 1}, {4, 4}, {4, 1}, {1, 2}}}};
  EXPECT_THAT(complaint(w), testing::HasSubstr("do not cross or touch"));
  w.goals = {{"g", box(1, 1, 2, 2)}, {"g", box(3, 3, 4, 4)}};
  EXPECT_THAT(complaint(w), testing::HasSubstr("two goals are named 'g'"));
}

TEST(Scenes, SelfCrossingRingIsFilledAndNamed) {
  Workspace w = empty_room(20, 20);
  w.obstacles.push_back({"obstacles[0]", {{5, 5}, {15, 15}, {15, 5}, {5, 15}}, {}});
  EXPECT_NEAR(solid_area(checked(w)), 50, 0.01);
  EXPECT_THAT(compile(w, {}).warnings, testing::ElementsAre(testing::StartsWith("obstacles[0] crosses itself")));
}

TEST(Scenes, AHoleThatCrossesItsOutlineStaysOpenAsTheWarningSays) {
  Workspace w = empty_room(20, 20);
  w.obstacles.push_back({"a", box(2, 2, 8, 8), {box(6, 6, 12, 12)}});
  EXPECT_NEAR(solid_area(checked(w)), 36 - 4, 1e-9);
  EXPECT_THAT(compile(w, {}).warnings,
              testing::ElementsAre(
                  "a crosses itself: what its outline goes around counts as solid, but for what a hole goes around"));
}

TEST(Scenes, AHoleAlongItsOutlineIsNamedWithThePlace) {
  Workspace w = empty_room(20, 20);
  const auto warned = [&](const Ring& outline, const Ring& hole) {
    w.obstacles = {{"a", outline, {hole}}};
    return compile(w, {}).warnings;
  };
  const Ring outline = box(2, 2, 8, 8);
  const std::string open =
      "a has a hole along its outline, from 2,3 to 2,7: no wall is left there; move the hole "
      "inwards where there is one";
  const Ring doorway = box(2, 3, 6, 7);
  EXPECT_THAT(warned(outline, doorway), testing::ElementsAre(open));
  EXPECT_THAT(warned(outline, {doorway.rbegin(), doorway.rend()}), testing::ElementsAre(open));
  EXPECT_THAT(warned(outline, {{2, 5}, {5, 4}, {5, 6}}), testing::IsEmpty()) << "touches it in one point";
  EXPECT_THAT(warned(outline, box(3, 3, 6, 7)), testing::IsEmpty());
  EXPECT_THAT(warned(box(-5, 2, 8, 8), box(-5, 3, 6, 7)), testing::IsEmpty()) << "the bounds are a wall";
}

TEST(Scenes, AnObstacleThatIsAllHoleIsNamed) {
  Workspace w = empty_room(20, 20);
  w.obstacles.push_back({"a", box(2, 2, 8, 8), {box(2, 2, 8, 8)}});
  EXPECT_THAT(compile(w, {}).warnings, testing::ElementsAre("a is no obstacle: its holes leave nothing of it"));
}

TEST(Scenes, PartlyOutsideIsClipped) {
  Workspace w = empty_room(20, 20);
  w.obstacles.push_back({"a", rotated_box({0, 10}, 6, 6, 0.3), {}});
  w.obstacles.push_back({"b", box(-5, -5, 30, 1), {}});
  w.obstacles.push_back({"c", box(30, 30, 31, 31), {}});
  checked(w);
}

TEST(Scenes, AWallWithoutAreaStaysAWall) {
  Workspace w = empty_room(20, 20);
  w.obstacles.push_back({"obstacles[0]", {{0, 10}, {20, 10}}, {}});
  w.obstacles.push_back({"obstacles[1]", rotated_box({10, 5}, 8, 0.0001, 0.4), {}});
  w.obstacles.push_back({"obstacles[2]", {{3, 3}}, {}});
  const SceneView v = checked(w);
  EXPECT_GE(v.pieces.size(), 3U);
  EXPECT_THAT(compile(w, {}).warnings, testing::ElementsAre(testing::HasSubstr("obstacles[0] has no area"),
                                                            testing::HasSubstr("obstacles[2] has no area")));
  for (std::size_t k = 0; k < v.neighbors.size(); ++k) {
    if (v.neighbors[k] == format::kNone32) continue;
    const double y = v.triangles[k / 3][0].y + v.triangles[k / 3][1].y + v.triangles[k / 3][2].y;
    const Ring& other = v.triangles[v.neighbors[k]];
    EXPECT_EQ(y > 30, other[0].y + other[1].y + other[2].y > 30) << "a portal leads through the wall";
  }
}

// By portals wider than a centimetre.
bool connected(const SceneView& v, Point from, Point to) {
  const auto triangle_of = [&](Point p) {
    std::uint32_t t = 0;
    while (!convex_contains(v.triangles[t], p)) ++t;
    return t;
  };
  std::vector<bool> reached(v.triangles.size(), false);
  std::vector<std::uint32_t> waiting{triangle_of(from)};
  while (!waiting.empty()) {
    const std::uint32_t t = waiting.back();
    waiting.pop_back();
    if (reached[t]) continue;
    reached[t] = true;
    for (std::uint32_t i = 3 * t; i < 3 * t + 3; ++i) {
      if (v.neighbors[i] != format::kNone32 && v.widths[v.portals[i]] > 0.01F) waiting.push_back(v.neighbors[i]);
    }
  }
  return reached[triangle_of(to)];
}

// Found by fuzzing: the wall's other side lay out of bounds.
TEST(Scenes, AWallWithoutAreaGoesFromCornerToCorner) {
  for (const double height : {20.0, 30.0}) {
    for (const bool rises : {true, false}) {
      Workspace w = empty_room(20, height);
      w.obstacles.push_back({"wall", {{0, rises ? 0 : height}, {20, rises ? height : 0}}, {}});
      const SceneView v = checked(w);
      EXPECT_EQ(v.pieces.size(), 1U);
      const Point left{1, rises ? height - 1 : 1}, right{19, rises ? 1 : height - 1};
      EXPECT_TRUE(connected(v, left, {0.5, height / 2}));
      EXPECT_FALSE(connected(v, left, right)) << "a portal leads through the wall";
    }
  }
}

TEST(Scenes, ThinSpikesStay) {
  Workspace w = empty_room(20, 20);
  w.obstacles.push_back({"a", {{2, 2}, {4, 2}, {4, 4}, {3.00005, 4}, {3, 15}, {2.99995, 4}, {2, 4}}, {}});
  checked(w);
}

// Their small angles must not be refined without end (found by fuzzing: 64,196 triangles).
TEST(Scenes, OfLongEdgesThatCrossAtSmallAnglesStayCoarse) {
  Workspace w = empty_room(12, 12);
  w.obstacles.push_back({"o", {{6, -1.5}, {-1.5, 13.5}, {-1.5, -1.5}, {13.5, 13.5}, {-1.5, -1.5}}, {}});
  w.goals.push_back({"goal", box(9, 9, 11, 11)});
  EXPECT_LT(checked(w, 0.1).triangles.size(), 6000U);
}

TEST(Scenes, FarFromTheOrigin) {
  Workspace w;
  w.min = {1e6 + 0.25, -2e6};
  w.max = {1e6 + 40, -2e6 + 30};
  w.obstacles.push_back({"a", rotated_box({1e6 + 20, -2e6 + 10}, 10, 2, 1), {}});
  const SceneView v = checked(w);
  EXPECT_EQ(v.header.origin_x, 1e6 + 20);
  EXPECT_EQ(v.header.origin_y, -2e6 + 15);
}

TEST(Scenes, GoalsAreRegionsOfTheirOwn) {
  Workspace w = empty_room(50, 50);
  w.obstacles.push_back({"a", box(10, 0, 11, 20), {}});
  w.goals.push_back({"dock", rotated_box({11, 21}, 3, 3, 0.4)});
  w.goals.push_back({"corner", box(-2, -2, 3, 3)});
  const SceneView v = checked(w);
  EXPECT_EQ(v.names, (std::vector<std::string>{"room", "dock", "corner"}));
  for (std::uint16_t g = 0; g < 2; ++g) {
    double area = 0;
    for (std::size_t t = 0; t < v.triangles.size(); ++t) {
      const Point c{(v.triangles[t][0].x + v.triangles[t][1].x + v.triangles[t][2].x) / 3,
                    (v.triangles[t][0].y + v.triangles[t][1].y + v.triangles[t][2].y) / 3};
      const bool inside = winding(c, w.goals[g].polygon) != 0;
      if (distance(c, w.goals[g].polygon) > 0.001) {
        EXPECT_EQ(v.triangle_goals[t] == g, inside);
      }
      if (v.triangle_goals[t] == g) area += twice_area(v.triangles[t]) / 2;
    }
    EXPECT_GT(area, 7);
  }
}

TEST(Scenes, AGoalInsideAnObstacleIsKeptWithAWarning) {
  Workspace w = empty_room(50, 50);
  w.obstacles.push_back({"a", box(10, 10, 20, 20), {}});
  w.goals.push_back({"dock", box(12, 12, 14, 14)});
  const SceneView v = checked(w);
  EXPECT_EQ(v.goals.size(), 1U);
  EXPECT_THAT(compile(w, {}).warnings, testing::ElementsAre(testing::HasSubstr("'dock' lies wholly inside obstacles")));
}

TEST(Scenes, BadGoalsAreNamed) {
  Workspace w = empty_room(50, 50);
  w.goals = {{"a", box(1, 1, 5, 5)}, {"b", box(4, 4, 8, 8)}};
  EXPECT_THAT(complaint(w),
              testing::AllOf(testing::HasSubstr("'a'"), testing::HasSubstr("'b'"), testing::HasSubstr("overlap")));
  w.goals = {{"out", box(60, 60, 61, 61)}};
  EXPECT_THAT(complaint(w), testing::HasSubstr("'out' lies outside"));
  w.goals = {{"knot", {{5, 5}, {15, 15}, {15, 5}, {5, 15}}}};
  EXPECT_THAT(complaint(w), testing::HasSubstr("'knot'"));
  w.goals = {{"nan", {{5, 5}, {15, std::nan("")}, {15, 5}}}};
  EXPECT_THAT(complaint(w), testing::HasSubstr("'nan'"));
  w.goals = {{"touching", box(1, 1, 5, 5)}, {"neighbour", box(5, 1, 8, 5)}};
  EXPECT_EQ(complaint(w), "");
}

TEST(Scenes, BadNumbersAreRefused) {
  const double infinity = std::numeric_limits<double>::infinity();
  Workspace w = empty_room(10, 10);
  w.obstacles.push_back({"obstacles[4]", {{1, 1}, {2, infinity}, {3, 1}}, {}});
  EXPECT_THAT(complaint(w), testing::HasSubstr("obstacles[4]"));
  w.obstacles[0].outer[1].y = 1e300;
  EXPECT_THAT(complaint(w), testing::HasSubstr("obstacles[4]"));
  w.obstacles.clear();
  for (const double bad : {std::nan(""), infinity, 1e300, 0.0, -1.0}) {
    w.max.x = bad;
    EXPECT_THAT(complaint(w), testing::HasSubstr("bounds")) << bad;
  }
  w.max.x = 10;
  w.starts = {{"home", {1, std::nan("")}, 0, {}}};
  EXPECT_THAT(complaint(w), testing::HasSubstr("'home'"));
  w.starts.clear();
  EXPECT_THAT(complaint(w, std::nan("")), testing::HasSubstr("tolerance"));
  EXPECT_THAT(complaint(w, 4000.01), testing::HasSubstr("the tolerance is not a length of at most 4000 m"));
  EXPECT_EQ(complaint(w, 4000), "");
  w.starts.assign(65535, {"home", {1, 1}, 0, {}});
  EXPECT_EQ(complaint(w), "");
  w.starts.push_back(w.starts[0]);
  EXPECT_EQ(complaint(w), "more than 65535 starts: split the scene");
}

TEST(Scenes, WhatReachesTooFarIsRefused) {
  Workspace w = empty_room(4000, 100);
  EXPECT_EQ(complaint(w), "");
  w.goals = {{"far", box(5000, 1, 5001, 2)}};
  EXPECT_THAT(complaint(w), testing::HasSubstr("from the middle of the scene: move it or make it smaller"));
  w.goals.clear();
  w.min.x += 0.5;
  w.max.x += 0.5;
  EXPECT_THAT(
      complaint(w),
      testing::HasSubstr("a scene reaches at most 2000 m either way from the whole metre nearest to its middle"));
}

TEST(Scenes, SameInputSameBytes) {
  Workspace w = empty_room(50, 50);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> at(0, 50), size(0.1, 6), angle(0, 3);
  for (int i = 0; i < 30; ++i) {
    const Point center{at(random), at(random)};
    const double width = size(random), height = size(random);
    w.obstacles.push_back({"o", rotated_box(center, width, height, angle(random)), {}});
  }
  EXPECT_EQ(compile(w, {}).bytes, compile(w, {}).bytes);
}

TEST(Scenes, TrianglesStayFewWhenTheSceneGrows) {
  std::size_t counts[2];
  for (const int scale : {1, 4}) {
    const double extent = 50.0 * scale;
    Workspace w = empty_room(extent, extent);
    for (int k = 1; k <= 5; ++k) {
      const double x = extent * k / 6, low = k % 2 == 0 ? 5 : extent - 8, high = k % 2 == 0 ? extent - 6 : 8;
      const double wide = low, narrow = high;
      std::vector<std::pair<double, double>> gaps{{wide, wide + 1.4}, {narrow, narrow + 0.4}};
      std::sort(gaps.begin(), gaps.end());
      w.obstacles.push_back({"w", box(x, 0, x + 1, gaps[0].first), {}});
      w.obstacles.push_back({"w", box(x, gaps[0].second, x + 1, gaps[1].first), {}});
      w.obstacles.push_back({"w", box(x, gaps[1].second, x + 1, extent), {}});
    }
    counts[scale == 4] = checked(w, -1, 300).triangles.size();
  }
  EXPECT_GT(counts[0], 300U);
  EXPECT_LT(counts[0], 1000U);
  EXPECT_LT(counts[1], 2 * counts[0]);
}

TEST(Maps, StaircasesBecomeDiagonals) {
  std::vector<std::string> rows;
  for (int i = 0; i < 40; ++i)
    rows.push_back(std::string(static_cast<std::size_t>(i), '#') + std::string(static_cast<std::size_t>(60 - i), '.'));
  const SceneView plain = checked(map_room(cells(rows, 0.05)), 0);
  const SceneView smooth = checked(map_room(cells(rows, 0.05)));
  EXPECT_LE(smooth.pieces.size(), 3U);
  EXPECT_GE(plain.pieces.size(), 10U);
  EXPECT_LT(smooth.triangles.size(), plain.triangles.size());
}

// A slope of steps of half a metre, where growth fills the notches.
TEST(Maps, NothingGrowsAroundAStartByDefault) {
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < 40; ++i) rows.push_back(std::string(i, '#') + std::string(60 - i, '.'));
  Workspace w = map_room(cells(rows, 0.5));
  const auto in_notch = [](int i) { return Point{0.5 * (i + 0.2), 0.5 * (40 - i - 0.8)}; };
  const auto is_filled = [&](const SceneView& v, int i) {
    const auto holds = [&](const Ring& piece) { return convex_contains(piece, in_notch(i)); };
    return std::any_of(v.pieces.begin(), v.pieces.end(), holds);
  };
  EXPECT_TRUE(is_filled(checked(w), 20));
  w.starts = {{"start", in_notch(20), 0, {}}};
  const SceneView v = checked(w);
  for (int i = 2; i < 38; ++i) {
    const double away = std::sqrt(0.5) * std::abs(i - 20);
    if (away > kStartReach && away < kStartReach + 2) continue;
    EXPECT_EQ(is_filled(v, i), away > kStartReach) << i;
  }
  EXPECT_TRUE(is_filled(checked(w, 0.5), 20)) << "a tolerance that is asked for";
}

TEST(Maps, AOneCellPassageStaysOpen) {
  const SceneView v = checked(map_room(cells({"..#..", "..#..", ".....", "..#..", "..#.."}, 0.1)), 0.1);
  std::vector<bool> seen(v.triangles.size(), false);
  std::vector<std::uint32_t> waiting{0};
  seen[0] = true;
  while (!waiting.empty()) {
    const std::uint32_t t = waiting.back();
    waiting.pop_back();
    for (std::uint32_t k = 3 * t; k < 3 * t + 3; ++k) {
      const std::uint32_t other = v.neighbors[k];
      if (other == format::kNone32 || seen[other]) continue;
      seen[other] = true;
      waiting.push_back(other);
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), false), 0);
}

TEST(Maps, CellsThatTouchInACornerBlock) {
  const SceneView v = checked(map_room(cells({"#..", ".#.", "..#"}, 1)), 0.5);
  for (std::size_t k = 0; k < v.neighbors.size(); ++k) {
    if (v.neighbors[k] == format::kNone32) continue;
    const auto above = [&](const Ring& t) { return t[0].y + t[1].y + t[2].y > 9 - (t[0].x + t[1].x + t[2].x); };
    EXPECT_EQ(above(v.triangles[k / 3]), above(v.triangles[v.neighbors[k]]));
  }
}

TEST(Maps, OfNoiseWithoutEndAreRefused) {
  Workspace w = empty_room(1200, 1200);
  w.cells = CellMap{1200, 1200, 1, {0, 0}, 0, std::vector<std::uint8_t>(1200 * 1200, 0)};
  for (std::size_t i = 0; i < w.cells->occupied.size(); ++i) w.cells->occupied[i] = (i / 1200 + i) % 2;
  EXPECT_THROW(compile(w, {}), InputError);
}

TEST(Maps, EmptyAndFull) {
  EXPECT_TRUE(checked(map_room(cells({"...", "..."}, 0.5))).pieces.empty());
  EXPECT_THROW(checked(map_room(cells({"###", "###"}, 0.5))), InputError);
}

// The box cuts cells and, of a turned map, corners.
TEST(Maps, Cropped) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> share(0.1, 0.9);
  for (int round = 0; round < 12; ++round) {
    const Workspace map = map_room(random_cells(random, 40, 30, 0.2), {3, -2}, round % 3 == 0 ? 0 : 0.3 * round);
    const Point size{map.max.x - map.min.x, map.max.y - map.min.y};
    const Point middle{map.min.x + share(random) * size.x, map.min.y + share(random) * size.y};
    const double reach = 0.3 * size.x;
    const Workspace part =
        cropped(map, {middle.x - reach, middle.y - reach}, {middle.x + reach, middle.y + share(random) * reach});
    const SceneView v = checked(part, 0);
    EXPECT_NEAR(double(v.header.bounds_max_x) + v.header.origin_x, part.max.x, 3e-4);
  }
}

TEST(Maps, OfCellsOfKilometresMayBeCropped) {
  CellMap map = cells({"#.."}, 5000);
  Workspace w;
  w.max = {15000, 5000};
  w.cells = map;
  EXPECT_EQ(complaint(cropped(w, {4000, 0}, {6000, 1000})), "");
}

TEST(Maps, YawedAndFarAway) {
  std::mt19937_64 random(3);
  const SceneView v = checked(map_room(random_cells(random, 30, 20, 0.1), {1e6, 2e6}, 0.5));
  EXPECT_NE(v.header.origin_x, 0);
  EXPECT_FALSE(v.triangles.empty());
}

class RandomMaps : public testing::TestWithParam<int> {};

TEST_P(RandomMaps, Hold) {
  std::mt19937_64 random(static_cast<std::uint64_t>(GetParam()));
  const double share = std::uniform_real_distribution<double>(0.02, 0.7)(random);
  const double tolerance = GetParam() % 3 == 0 ? 0 : 0.05 * (GetParam() % 3 == 1 ? 1.0 : 2.5);
  checked(map_room(random_cells(random, 24, 18, share), {-3.3, 7.7}, GetParam() % 4 == 0 ? 0.3 : 0), tolerance, 500);
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomMaps, testing::Range(0, 24));

// Where the centre of a disc can stand in a scene and between which places it can move, by points 16 to a cell.
class Floor {
 public:
  Floor(const SceneView& v, double cell) : step_(cell / 16) {
    const auto number = [](float x) { return static_cast<double>(x); };
    const Ring bounds = box(number(v.header.bounds_min_x), number(v.header.bounds_min_y), number(v.header.bounds_max_x),
                            number(v.header.bounds_max_y));
    columns_ = static_cast<int>((bounds[2].x - bounds[0].x) / step_);
    rows_ = static_cast<int>((bounds[2].y - bounds[0].y) / step_);
    for (int i = 0; i < columns_ * rows_; ++i) {
      const Point p{bounds[0].x + step_ * (i % columns_), bounds[0].y + step_ * (i / columns_)};
      double room = distance(p, bounds);
      for (const Ring& piece : v.pieces) room = std::min(room, convex_contains(piece, p) ? 0 : distance(p, piece));
      room_.push_back(room);
    }
  }

  std::size_t size() const { return room_.size(); }
  bool stands(std::size_t i, double radius) const { return room_[i] >= radius; }

  // How far a point of a path may be from the nearest of the points.
  double coarse() const { return step_ / std::sqrt(2.0); }

  // A number for each point, the same for those between which the disc can move; -1 where it cannot stand.
  std::vector<int> parts(double radius) const {
    std::vector<int> part(room_.size(), -1);
    int count = 0;
    for (std::size_t first = 0; first < part.size(); ++first) {
      if (part[first] >= 0 || !stands(first, radius)) continue;
      std::vector<std::size_t> waiting{first};
      part[first] = count;
      while (!waiting.empty()) {
        const int at = static_cast<int>(waiting.back());
        waiting.pop_back();
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            const int x = at % columns_ + dx, y = at / columns_ + dy;
            if (x < 0 || y < 0 || x >= columns_ || y >= rows_) continue;
            const auto next = static_cast<std::size_t>(y * columns_ + x);
            if (part[next] >= 0 || !stands(next, radius)) continue;
            part[next] = count;
            waiting.push_back(next);
          }
        }
      }
      ++count;
    }
    return part;
  }

 private:
  double step_;
  int columns_ = 0, rows_ = 0;
  std::vector<double> room_;  // metres to the nearest piece or bound
};

// Points between which the disc can move on the one floor but not on the other, though it can stand at both.
std::size_t parted(const Floor& exact, const Floor& grown, double radius) {
  const std::vector<int> before = exact.parts(radius), after = grown.parts(radius - 2 * exact.coarse());
  std::vector<int> expected(before.size(), -1);
  std::size_t count = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (!exact.stands(i, radius) || !grown.stands(i, radius)) continue;
    int& part = expected[static_cast<std::size_t>(before[i])];
    if (part < 0) part = after[i];
    count += part != after[i] ? 1 : 0;
  }
  return count;
}

// Corridors of one cell, or two, in solid ground: walks that climb or descend, as staircases do.
CellMap corridors(std::mt19937_64& random, int size, double resolution) {
  CellMap map;
  map.columns = map.rows = size;
  map.resolution = resolution;
  map.occupied.assign(static_cast<std::size_t>(size * size), 1);
  const auto draw = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
  for (int walk = 0; walk < 3; ++walk) {
    const bool climbs = draw(1) == 0;
    const int width = draw(1);
    int x = 1 + draw(2), y = climbs ? 1 + draw(2) : size - 2 - draw(2);
    while (x < size - 1 && y > 0 && y < size - 1) {
      for (int i = std::max(x - width, 1); i <= x; ++i) map.occupied[static_cast<std::size_t>(y * size + i)] = 0;
      if (draw(2) > 0 ? (x + y) % 2 == 0 : draw(1) == 0) {
        ++x;
      } else {
        y += climbs ? 1 : -1;
      }
    }
  }
  return map;
}

class NarrowMaps : public testing::TestWithParam<int> {};

TEST_P(NarrowMaps, KeepWaysOfUpToTwoCellsByDefault) {
  constexpr double kCell = 0.05;
  constexpr int kSize = 12;
  std::mt19937_64 random(static_cast<std::uint64_t>(GetParam()));
  const double share = std::uniform_real_distribution<double>(0.1, 0.5)(random);
  const Workspace w =
      map_room(GetParam() % 2 == 0 ? random_cells(random, kSize, kSize, share) : corridors(random, kSize, kCell),
               {2, -3}, GetParam() % 4 < 2 ? 0 : 0.3);
  const Floor exact(checked(w, 0, 0), kCell), grown(checked(w, -1, 0), kCell);
  for (const double width : {0.98, 1.4, 1.98}) {
    EXPECT_EQ(parted(exact, grown, width / 2 * kCell), 0U) << width << " cells wide";
  }
}
INSTANTIATE_TEST_SUITE_P(Seeds, NarrowMaps, testing::Range(0, 40));

TEST(Maps, AToleranceThatIsAskedForMayNarrowACorridor) {
  constexpr double kCell = 0.05;
  std::mt19937_64 random(1);
  std::size_t narrowed = 0;
  for (int i = 0; i < 10; ++i) {
    const Workspace w = map_room(corridors(random, 12, kCell));
    narrowed += parted(Floor(checked(w, 0, 0), kCell), Floor(checked(w, kCell, 0), kCell), 0.49 * kCell);
  }
  EXPECT_GT(narrowed, 0U);
}

class RandomDrawings : public testing::TestWithParam<int> {};

TEST_P(RandomDrawings, Hold) {
  std::mt19937_64 random(static_cast<std::uint64_t>(GetParam()));
  std::uniform_real_distribution<double> at(-2, 22), angle(0, 7), size(0.0005, 3);
  Workspace w = empty_room(20, 20);
  const int count = 1 + GetParam() % 20;
  for (int i = 0; i < count; ++i) {
    const Point center{at(random), at(random)};
    Ring ring;
    if (i % 2 == 0) {
      const double width = size(random), height = size(random);
      ring = rotated_box(center, width, height, angle(random));
    } else {
      for (int k = 0; k < 3 + i % 6; ++k) {  // crosses itself as it likes
        const double radius = size(random), direction = angle(random);
        ring.push_back({center.x + radius * std::cos(direction), center.y + radius * std::sin(direction)});
      }
    }
    w.obstacles.push_back({"obstacles[" + std::to_string(i) + "]", ring, {}});
  }
  w.goals.push_back({"goal", rotated_box({10, 10}, 2, 2, angle(random))});
  checked(w, GetParam() % 3 == 0 ? 0.2 : 0, 500);
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomDrawings, testing::Range(0, 40));

TEST(Scenes, TenThousandOverlappingBoxes) {
  Workspace w = empty_room(50, 50);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> at(0, 50), size(0.05, 2), angle(0, 3);
  for (int i = 0; i < 10000; ++i) {
    const Point center{at(random), at(random)};
    const double width = size(random), height = size(random);
    w.obstacles.push_back({"o", rotated_box(center, width, height, angle(random)), {}});
  }
  const SceneView v = Reader(compile(w, {}).bytes).read();
  double area = 0;
  for (const Ring& t : v.triangles) area += twice_area(t) / 2;
  EXPECT_NEAR(area + solid_area(v), 2500, 0.1);
  EXPECT_GT(v.pieces.size(), 100U);
}

}  // namespace
}  // namespace krait::host::test
