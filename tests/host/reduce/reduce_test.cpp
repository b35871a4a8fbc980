// SPDX-License-Identifier: Apache-2.0
// What is done to maps before they are compiled, against brute force on random maps: nothing becomes free, and what a
// robot can touch stays free.
#include "host/reduce/reduce.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "../cell_map.hpp"
#include "../ring_oracle.hpp"
#include "host/reduce/cell_distances.hpp"
#include "host/reduce/cell_ways.hpp"
#include "host/reduce/cells.hpp"
#include "host/reduce/closed.hpp"
#include "host/reduce/disc.hpp"
#include "host/reduce/fill.hpp"
#include "host/reduce/goal_cells.hpp"
#include "host/reduce/resample.hpp"

namespace krait::host::test {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double least, double most) {
  return std::uniform_real_distribution(least, most)(random);
}

Workspace room(CellMap map) {
  Workspace w;
  w.name = "room";
  w.max = {map.columns * map.resolution, map.rows * map.resolution};
  w.cells = std::move(map);
  return w;
}

// Boxes and single cells, turned and moved.
CellMap random_map(Random& random) {
  CellMap map;
  map.columns = std::uniform_int_distribution(20, 70)(random);
  map.rows = std::uniform_int_distribution(20, 70)(random);
  map.resolution = uniform(random, 0.02, 0.3);
  map.origin = {uniform(random, -50, 50), uniform(random, -50, 50)};
  map.yaw = uniform(random, -3, 3);
  map.occupied.assign(std::size_t(map.columns) * std::size_t(map.rows), 0);
  for (int k = std::uniform_int_distribution(0, 50)(random); k > 0; --k) {
    const int x = std::uniform_int_distribution(0, map.columns - 1)(random);
    const int y = std::uniform_int_distribution(0, map.rows - 1)(random);
    const int w = std::uniform_int_distribution(1, 9)(random), h = std::uniform_int_distribution(1, 9)(random);
    for (int j = y; j < std::min(map.rows, y + h); ++j) {
      for (int i = x; i < std::min(map.columns, x + w); ++i) map.occupied[cell_number(map, i, j)] = 1;
    }
  }
  return map;
}

double gap(double at, double low, double high) { return std::max({0.0, low - at, at - high}); }

// From a place in cells to the nearest occupied cell or the border, in cells; brute force.
double room_at(const CellMap& map, Point p) {
  double nearest = std::min({p.x, p.y, map.columns - p.x, map.rows - p.y});
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      if (map.at(column, row))
        nearest = std::min(nearest, std::hypot(gap(p.x, column, column + 1), gap(p.y, row, row + 1)));
    }
  }
  return nearest;
}

bool free_at(const CellMap& map, Point p) {
  return p.x >= 0 && p.y >= 0 && p.x < map.columns && p.y < map.rows && !map.at(int(p.x), int(p.y));
}

Point random_place(const CellMap& map, Random& random) {
  return {uniform(random, 0, map.columns), uniform(random, 0, map.rows)};
}

std::string complaint(const Workspace& w, const Reduction& reduction) {
  try {
    reduced(w, reduction);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CellDistances, AreThoseOfBruteForce) {
  Random random(1);
  for (int round = 0; round < 40; ++round) {
    const CellMap map = random_map(random);
    for (const Beyond beyond : {Beyond::unmarked, Beyond::marked}) {
      const std::vector<std::uint32_t> found = squared_distances(map.occupied, map.columns, beyond);
      for (int k = 0; k < 50; ++k) {
        const Point p = random_place(map, random);
        const int x = int(p.x), y = int(p.y);
        std::int64_t nearest = kFarSquared;
        const int border = std::min({x + 1, y + 1, map.columns - x, map.rows - y});
        if (beyond == Beyond::marked) nearest = std::int64_t{border} * border;
        for (int row = 0; row < map.rows; ++row) {
          for (int column = 0; column < map.columns; ++column) {
            const std::int64_t dx = column - x, dy = row - y;
            if (map.at(column, row)) nearest = std::min(nearest, dx * dx + dy * dy);
          }
        }
        ASSERT_EQ(found[cell_number(map, x, y)], nearest) << round;
      }
    }
  }
}

// A place in cells, in world coordinates.
Point in_world(const CellMap& map, Point cells) {
  const double x = cells.x * map.resolution, y = cells.y * map.resolution;
  return {map.origin.x + std::cos(map.yaw) * x - std::sin(map.yaw) * y,
          map.origin.y + std::sin(map.yaw) * x + std::cos(map.yaw) * y};
}

// Triangles, some of them smaller than a cell and some of them partly off the map.
TEST(GoalCells, AreThoseWithTheirMiddlesInItAndThoseOfItsCorners) {
  Random random(7);
  for (int round = 0; round < 60; ++round) {
    const CellMap map = random_map(random);
    const Point at = random_place(map, random);
    const double size = round % 3 == 0 ? 0.4 : uniform(random, 1, 40);
    Ring triangle;
    for (int i = 0; i < 3; ++i) triangle.push_back({at.x + uniform(random, 0, size), at.y + uniform(random, 0, size)});
    std::set<std::size_t> expected;
    for (int row = 0; row < map.rows; ++row) {
      for (int column = 0; column < map.columns; ++column) {
        const bool middle = winding({column + 0.5, row + 0.5}, triangle) != 0;
        const bool corner = std::any_of(triangle.begin(), triangle.end(),
                                        [&](Point p) { return std::floor(p.x) == column && std::floor(p.y) == row; });
        if (middle || corner) expected.insert(cell_number(map, column, row));
      }
    }
    Goal goal{"goal", {}};
    for (const Point p : triangle) goal.polygon.push_back(in_world(map, p));
    const std::vector<std::size_t> found = cells_of(map, goal);
    EXPECT_EQ(std::set<std::size_t>(found.begin(), found.end()), expected) << round;
  }
}

TEST(Disc, CentersLeaveOutNoneAndSureOnesFit) {
  Random random(2);
  for (int round = 0; round < 40; ++round) {
    const CellMap map = random_map(random);
    const double radius = uniform(random, 0, 6);
    const CellMask possible = disc_centers(map, radius * map.resolution, Fit::possible);
    const CellMask sure = disc_centers(map, radius * map.resolution, Fit::sure);
    for (int k = 0; k < 60; ++k) {
      const Point p = random_place(map, random);
      const std::size_t cell = cell_number(map, int(p.x), int(p.y));
      const double room = room_at(map, p), middle = room_at(map, {int(p.x) + 0.5, int(p.y) + 0.5});
      if (room >= radius && free_at(map, p)) {
        EXPECT_TRUE(possible[cell]) << round;
      }
      if (possible[cell]) {
        EXPECT_GE(middle, radius - 0.93) << round;
      }
      if (sure[cell]) {
        EXPECT_GE(middle, radius - 1e-6) << round;
      }
      if (middle >= radius + 0.21 && free_at(map, p)) {
        EXPECT_TRUE(sure[cell]) << round;
      }
    }
  }
}

TEST(Disc, ReachesTheCellsWithinItsReachAndNoOthers) {
  Random random(8);
  for (int round = 0; round < 40; ++round) {
    const CellMap map = random_map(random);
    const double reach = uniform(random, 0, 8);
    const CellMask near = within_reach(map, map.occupied, reach * map.resolution);
    for (int k = 0; k < 50; ++k) {
      const Point p = random_place(map, random);
      double nearest = std::numeric_limits<double>::infinity();
      for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
          const double dx = std::max(0, std::abs(column - int(p.x)) - 1),
                       dy = std::max(0, std::abs(row - int(p.y)) - 1);
          if (map.at(column, row)) nearest = std::min(nearest, std::hypot(dx, dy));
        }
      }
      EXPECT_EQ(near[cell_number(map, int(p.x), int(p.y))] != 0, nearest <= reach) << round;
    }
  }
}

// A box whose points are all in free space, by samples as dense as the cells.
std::vector<Point> box_points(Point center, double length, double width, double heading) {
  std::vector<Point> points;
  const double c = std::cos(heading), s = std::sin(heading);
  for (double x = -1; x <= 1; x += 1.0 / 12) {
    for (double y = -1; y <= 1; y += 1.0 / 12)
      points.push_back(
          {center.x + c * x * length / 2 - s * y * width / 2, center.y + s * x * length / 2 + c * y * width / 2});
  }
  return points;
}

bool all_free(const CellMap& map, const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(), [&](Point p) { return free_at(map, p); });
}

TEST(Fill, NoPlacementOfTheRobotIsLostAndNothingBecomesFree) {
  Random random(3);
  int placements = 0, closed = 0;
  for (int round = 0; round < 400; ++round) {
    const CellMap map = random_map(random);
    const double width = uniform(random, 0.5, 8), length = width * uniform(random, 1, 3);  // cells
    const Girth girth{width / 2 * map.resolution, std::hypot(width, length) / 2 * map.resolution, 0};
    const CellMap result = filled(map, girth, {});
    for (std::size_t i = 0; i < map.occupied.size(); ++i) {
      ASSERT_GE(result.occupied[i], map.occupied[i]);
      closed += result.occupied[i] - map.occupied[i];
    }
    for (int k = 0; k < 120; ++k) {
      const std::vector<Point> body = box_points(random_place(map, random), length, width, uniform(random, -3, 3));
      if (!all_free(map, body)) continue;
      ++placements;
      ASSERT_TRUE(all_free(result, body)) << round;
    }
  }
  EXPECT_GT(placements, 1000);
  EXPECT_GT(closed, 1000);
}

TEST(Fill, OfADiscClosesWhatIsNarrowerThanItLessTwoCells) {
  CellMap map = cells(std::vector<std::string>(40, std::string(60, '.')), 0.1);
  for (int row = 0; row < 40; ++row) {
    for (const int column : {20, 27, 45}) map.occupied[cell_number(map, column, row)] = 1;  // gaps of 6 and 17 cells
  }
  const CellMap result = *reduced(room(map), {{}, {}, Girth{0.401, 0.401, 0}, {}, {}}).cells;
  for (int row = 0; row < 40; ++row) {
    for (int column = 20; column <= 27; ++column) EXPECT_TRUE(result.at(column, row));
  }
  EXPECT_FALSE(result.at(35, 20));
  const CellMap kept = *reduced(room(map), {{}, {}, Girth{0.3, 0.3, 0}, {}, {}}).cells;
  EXPECT_FALSE(kept.at(23, 20)) << "a disc of that radius passes";
}

TEST(Fill, ClosesWhatNoStartLeadsTo) {
  CellMap map = cells(std::vector<std::string>(20, "..........#........."));
  map.occupied[cell_number(map, 10, 9)] = 0;  // a door of one cell
  map.yaw = 0.5;
  map.origin = {7, -3};
  Workspace w = room(map);
  const CellMap open = *reduced(w, {{}, {}, Girth{2, 2, 0}, {}, {}}).cells;
  EXPECT_FALSE(open.at(15, 9));
  w.starts = {{"left", middle(map, CellFrame(map), cell_number(map, 4, 4)), 0, {}}};
  const CellMap left = *reduced(w, {{}, {}, Girth{2, 2, 0}, {}, {}}).cells;
  EXPECT_FALSE(left.at(5, 9));
  EXPECT_TRUE(left.at(15, 9));
  const CellMap narrow = *reduced(w, {{}, {}, Girth{0.4, 0.4, 0}, {}, {}}).cells;
  EXPECT_FALSE(narrow.at(15, 9)) << "a disc of that radius passes the door";
}

// Corners of the outline: of each two by two cells, one for an odd number of occupied ones, two for a diagonal pair.
int corner_count(const CellMap& map) {
  int count = 0;
  for (int row = 0; row <= map.rows; ++row) {
    for (int column = 0; column <= map.columns; ++column) {
      const auto at = [&](int x, int y) {
        return x < 0 || y < 0 || x >= map.columns || y >= map.rows || map.at(x, y) ? 1 : 0;
      };
      const int a = at(column - 1, row - 1), b = at(column, row - 1), c = at(column - 1, row), d = at(column, row);
      count += (a + b + c + d) % 2 + (a == d && b == c && a != b ? 2 : 0);
    }
  }
  return count;
}

TEST(Fill, NamesTheGoalsThatItCloses) {
  std::vector<std::string> rows(30, "..........#.........#.........");
  rows[14][10] = rows[15][10] = rows[16][10] = '.';        // a door of 3 cells
  for (std::size_t i = 3; i < 15; ++i) rows[i][20] = '.';  // and one of 12
  Workspace w = room(cells(rows, 0.1));
  w.starts = {{"a", {2.5, 1.5}, 0, {}}};
  w.goals = {{"near", {{1.3, 1.3}, {1.7, 1.3}, {1.7, 1.7}}}, {"far", {{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}}}};
  const Reduction narrow{{}, {}, Girth{0.1, 0.1, 0}, {}, {}}, wide{{}, {}, Girth{0.4, 0.4, 0}, {}, {}};
  EXPECT_TRUE(reduced(w, narrow).warnings.empty());
  EXPECT_THAT(
      reduced(w, wide).warnings,
      testing::ElementsAre("goal 'far' is closed: no way from the starts to it is wide enough for a disc of "
                           "radius 0.4 m, the robot's or that of --fill: give a narrower one, or another goal"));
  w.goals.erase(w.goals.begin());
  EXPECT_THAT(complaint(w, wide), testing::StartsWith("goal 'far' is closed: no way from the starts to it is wide"));
}

TEST(Fill, NamesTheStartThatLiesInAnObstacle) {
  Workspace w = room(cells(std::vector<std::string>(20, "....................##########"), 0.1));
  const auto said = [&](Point start, std::optional<double> cell = {}, double radius = 0.3) {
    w.starts = {{"home", start, 0, {}}};
    return complaint(w, {{}, cell, Girth{radius, radius, 0}, {}, {}});
  };
  const std::string another = ": give another --start X,Y,HEADING";
  EXPECT_EQ(said({1, 1}), "");
  EXPECT_EQ(said({2.5, 1}), "start 'home' at 2.5,1 lies in an obstacle" + another);
  EXPECT_EQ(said({2.5, 1}, 0.3),
            "start 'home' at 2.5,1 lies in an obstacle" + another + ", or smaller cells to --cell");
  EXPECT_EQ(said({-1, 1}), "start 'home' at -1,1 lies outside of the map" + another);
  EXPECT_EQ(said({1, 1}, {}, 2),
            "a disc of radius 2 m, the robot's or that of --fill, has room nowhere that a start leads to: give a "
            "narrower one, or another start");
}

TEST(Fill, NamesTheGoalsThatHaveNoRoomWhereThereAreNoStarts) {
  Workspace w = room(cells(std::vector<std::string>(30, "..........#..#................"), 0.1));
  w.starts.clear();
  w.goals = {{"wide", {{2, 1}, {2.5, 1}, {2.5, 2}}}, {"slot", {{1.12, 1}, {1.28, 1}, {1.28, 2}}}};
  const Reduction reduction{{}, {}, Girth{0.4, 0.4, 0}, {}, {}};
  EXPECT_THAT(reduced(w, reduction).warnings,
              testing::ElementsAre("goal 'slot' is closed: it has no room for a disc of radius 0.4 m, the robot's or "
                                   "that of --fill: give a narrower one, or another goal"));
  w.goals.erase(w.goals.begin());
  EXPECT_THAT(complaint(w, reduction), testing::StartsWith("goal 'slot' is closed: it has no room for a disc"));
}

TEST(Fill, LessensTheCornersOfOutlines) {
  Random random(9);
  int before = 0, after = 0;
  for (int round = 0; round < 60; ++round) {
    const CellMap map = random_map(random);
    const double radius = uniform(random, 0.5, 4) * map.resolution;
    const CellMap result = filled(map, Girth{radius, 1.5 * radius, 0}, {});
    EXPECT_LE(corner_count(result), corner_count(map)) << round;
    before += corner_count(map);
    after += corner_count(result);
  }
  EXPECT_LT(after, 0.95 * before);
}

TEST(Resample, NothingOccupiedBecomesFreeAndNothingGrowsByMoreThanACell) {
  Random random(4);
  for (int round = 0; round < 60; ++round) {
    const CellMap map = random_map(random);
    const double factor = uniform(random, 1, 6);
    const CellMap result = resampled(map, factor * map.resolution);
    EXPECT_EQ(result.yaw, map.yaw);
    EXPECT_EQ(result.columns, int(map.columns / factor));
    for (int k = 0; k < 200; ++k) {
      const Point p = random_place(map, random), q{p.x / factor, p.y / factor};
      if (!free_at(map, p)) {
        EXPECT_FALSE(free_at(result, q)) << round;
      }
      if (room_at(map, p) > factor * std::sqrt(2)) {
        EXPECT_TRUE(free_at(result, q)) << round;
      }
    }
  }
}

TEST(Resample, AMultipleOfTheCellsFitsThem) {
  const CellMap map = cells({"....#.", "......", "......", "......", "......", "#....."}, 0.05);
  const CellMap result = resampled(map, 0.1);
  EXPECT_THAT(result.occupied, testing::ElementsAre(1, 0, 0, 0, 0, 0, 0, 0, 1));
  EXPECT_EQ(resampled(map, 0.05).occupied, map.occupied);
}

TEST(Resample, NamesThePassagesThatClose) {
  std::vector<std::string> rows(30, "..........#.........#.........");
  rows[14][10] = rows[15][10] = rows[16][10] = '.';       // a door of 3 cells
  for (std::size_t i = 3; i < 9; ++i) rows[i][20] = '.';  // and one of 6
  Workspace w = room(cells(rows, 0.1));
  const Workspace closed = reduced(w, {{}, 0.3, {}, {}, {}});
  EXPECT_THAT(closed.warnings, testing::ElementsAre("--cell 0.3 closes a passage at 1.05,1.45, at least 0.3 m wide"));
  w.starts = {{"a", {0.5, 0.5}, 0, {}}};
  w.goals = {{"b", {{2.5, 2.5}, {2.7, 2.5}, {2.7, 2.7}}}};
  EXPECT_THAT(complaint(w, {{}, 0.3, {}, {}, {}}), testing::HasSubstr("closes every way from the start to the goal"));
  EXPECT_TRUE(reduced(w, {{}, 0.1, {}, {}, {}}).warnings.empty());
}

TEST(Resample, NamesThePassagesOfADrawingThatClose) {
  Workspace w;
  w.max = {20, 10};
  w.obstacles = {{"low", {{9.9, 0}, {10.1, 0}, {10.1, 4.6}, {9.9, 4.6}}, {}},
                 {"high", {{9.9, 5.5}, {10.1, 5.5}, {10.1, 10}, {9.9, 10}}, {}}};
  EXPECT_THAT(reduced(w, {{}, 1.0, {}, {}, {}}).warnings,
              testing::ElementsAre("--cell 1 closes a passage at 10.0625,4.9375, at least 0.625 m wide"));
  EXPECT_TRUE(reduced(w, {{}, 0.2, {}, {}, {}}).warnings.empty());
  w.starts = {{"a", {2, 5}, 0, {}}};
  w.goals = {{"b", {{17, 4}, {18, 4}, {18, 6}, {17, 6}}}};
  EXPECT_THAT(complaint(w, {{}, 1.0, {}, {}, {}}), testing::HasSubstr("closes every way from the start to the goal"));
}

// Of 100 m by 100 m a million cells are as large as these.
TEST(Resample, SaysWhereADrawingIsTooLargeToLookForPassages) {
  Workspace w;
  w.max = {100, 100};
  w.obstacles = {{"box", {{50, 50}, {51, 50}, {51, 51}, {50, 51}}, {}}};
  EXPECT_THAT(reduced(w, {{}, 0.1, {}, {}, {}}).warnings,
              testing::ElementsAre("--cell 0.1: the drawing is too large to look for passages that this closes"));
  EXPECT_TRUE(reduced(w, {{}, 0.25, {}, {}, {}}).warnings.empty());
}

TEST(Resample, RefusesFinerCellsAndOnesLargerThanTheMap) {
  const Workspace w = room(cells({"....", "...."}, 0.5));
  EXPECT_THAT(complaint(w, {{}, 0.4, {}, {}, {}}), testing::HasSubstr("finer than the map, whose cells are 0.5 m"));
  EXPECT_THAT(complaint(w, {{}, 1.5, {}, {}, {}}), testing::HasSubstr("the map is only 2 m by 1 m"));
}

TEST(Resample, RefusesCellsThatLeaveNoneFree) {
  const std::string complaint_of_cells = "--cell 0.2: leaves no cell free: take smaller cells";
  EXPECT_EQ(complaint(room(cells({"#.", ".#"}, 0.1)), {{}, 0.2, {}, {}, {}}), complaint_of_cells);
  EXPECT_EQ(complaint(room(cells({"##", "##"}, 0.1)), {{}, 0.2, {}, {}, {}}), "") << "the compiler says what covers it";
  Workspace drawing;
  drawing.max = {0.2, 0.2};
  drawing.obstacles = {{"post", {{0.1, 0.1}, {0.12, 0.1}, {0.12, 0.12}}, {}}};
  EXPECT_EQ(complaint(drawing, {{}, 0.2, {}, {}, {}}), complaint_of_cells);
}

Ring random_ring(Random& random, Point middle, double reach) {
  Ring ring;
  for (int i = std::uniform_int_distribution(1, 7)(random); i > 0; --i)
    ring.push_back({middle.x + uniform(random, -reach, reach), middle.y + uniform(random, -reach, reach)});
  return ring;
}

TEST(Resample, ADrawingIsOccupiedWhereAnObstacleMeetsACellAndNowhereElse) {
  Random random(5);
  for (int round = 0; round < 60; ++round) {
    Workspace w;
    w.max = {30, 20};
    for (int k = 0; k < 4; ++k) {
      const Point middle{uniform(random, -5, 35), uniform(random, -5, 25)};
      w.obstacles.push_back({"o", random_ring(random, middle, 8), {}});
      if (k % 2 == 0) w.obstacles.back().holes.push_back(random_ring(random, middle, 4));
    }
    const double size = uniform(random, 0.1, 2);
    const Workspace drawn = reduced(w, {{}, size, {}, {}, {}});
    EXPECT_TRUE(drawn.obstacles.empty());
    for (int k = 0; k < 300; ++k) {
      const Point p{uniform(random, 0, 30), uniform(random, 0, 20)};
      const auto cell = cell_at(*drawn.cells, CellFrame(*drawn.cells), p);
      if (!cell) continue;
      bool inside = false;
      double nearest = std::numeric_limits<double>::infinity();
      for (const Obstacle& o : w.obstacles) {
        inside = inside || (winding(p, o.outer) != 0 && (o.holes.empty() || winding(p, o.holes[0]) == 0));
        nearest = std::min(nearest, distance(p, o.outer));
        if (!o.holes.empty()) nearest = std::min(nearest, distance(p, o.holes[0]));
      }
      if (inside) {
        EXPECT_TRUE(drawn.cells->occupied[*cell]) << round;
      }
      if (!inside && nearest > size * std::sqrt(2)) {
        EXPECT_FALSE(drawn.cells->occupied[*cell]) << round;
      }
    }
  }
}

TEST(Crop, KeepsTheCellsThatTheBoxMeets) {
  Random random(6);
  for (int round = 0; round < 60; ++round) {
    const CellMap map = random_map(random);
    Workspace w = room(map);
    const Point a = CellFrame(map).world(map.columns / 2.0, map.rows / 2.0);
    w.min = {a.x - 100, a.y - 100};
    w.max = {a.x + 100, a.y + 100};
    const double reach = uniform(random, 1, 40) * map.resolution;
    const Workspace part = reduced(w, {Box{{a.x - reach, a.y - reach}, {a.x + reach, a.y + 3}}, {}, {}, {}, {}});
    EXPECT_EQ(part.max.y, a.y + 3);
    EXPECT_LE(part.cells->occupied.size(), map.occupied.size());
    for (int k = 0; k < 100; ++k) {
      const Point p{uniform(random, part.min.x, part.max.x), uniform(random, part.min.y, part.max.y)};
      const auto before = cell_at(map, CellFrame(map), p);
      const auto after = cell_at(*part.cells, CellFrame(*part.cells), p);
      ASSERT_EQ(before.has_value(), after.has_value()) << round;
      if (before) {
        EXPECT_EQ(map.occupied[*before], part.cells->occupied[*after]) << round;
      }
    }
  }
}

TEST(Crop, RefusesWhatHoldsNothingAndStartsAndGoalsOutside) {
  Workspace w = room(cells(std::vector<std::string>(20, std::string(20, '.'))));
  EXPECT_THAT(complaint(w, {Box{{20, 0}, {30, 5}}, {}, {}, {}, {}}), testing::HasSubstr("holds nothing of the map"));
  w.starts = {{"s", {5, 5}, 0, {}}};
  w.goals = {{"g", {{10, 10}, {12, 10}, {12, 12}}}};
  EXPECT_EQ(complaint(w, {Box{{4, 4}, {11, 11}}, {}, {}, {}, {}}), "");
  EXPECT_THAT(complaint(w, {Box{{6, 4}, {11, 11}}, {}, {}, {}, {}}), testing::HasSubstr("start 's' lies outside"));
  EXPECT_THAT(complaint(w, {Box{{4, 4}, {10, 11}}, {}, {}, {}, {}}), testing::HasSubstr("goal 'g' lies outside"));
}

TEST(CellWays, CutNoCorners) {
  const CellMap map = cells({"...", "..."}, 0.1);
  const CellMask room{1, 0, 1, 1, 1, 1};  // the way from one end of the first row to the other is by the second row
  EXPECT_THAT(CellWays(map, room, 0).way_to(2), testing::ElementsAre(0U, 3U, 2U));
  const CellMask corners{1, 0, 0, 0, 1, 0};
  EXPECT_THAT(CellWays(map, corners, 0).way_to(4), testing::IsEmpty());
}

TEST(Corridor, KeepsWhatIsNearTheWayOnly) {
  CellMap map = cells(std::vector<std::string>(100, std::string(100, '.')), 0.1);
  for (int row = 0; row < 90; ++row) map.occupied[cell_number(map, 50, row)] = 1;  // the way leads around its end
  Workspace w = room(map);
  w.starts = {{"s", {2.05, 1.05}, 0, {}}};
  w.goals = {{"g", {{7.9, 0.9}, {8.1, 0.9}, {8.1, 1.1}, {7.9, 1.1}}}};
  const Girth disc{0.2, 0.2, 0};
  const CellMap result = *reduced(w, {{}, {}, {}, 0.5, disc}).cells;
  // From (2, 1) around (4.8, 9.2) and (5.3, 9.2), the corners of the wall's end at the disc's distance, to (8, 1).
  const Ring way{{2.05, 1.05}, {4.82, 9.1}, {5.05, 9.25}, {5.28, 9.1}, {8, 1}};
  for (int row = 0; row < 100; ++row) {
    for (int column = 0; column < 100; ++column) {
      const Point p = middle(map, CellFrame(map), cell_number(map, column, row));
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t i = 1; i < way.size(); ++i) nearest = std::min(nearest, distance(p, way[i - 1], way[i]));
      if (nearest < 0.3 && !map.at(column, row)) {
        EXPECT_FALSE(result.at(column, row)) << p.x << ' ' << p.y;
      }
      if (nearest > 0.5 + 0.36 + 0.25) {
        EXPECT_TRUE(result.at(column, row)) << p.x << ' ' << p.y;
      }
    }
  }
}

TEST(Corridor, PassesNoGapThatTheDiscDoesNot) {
  CellMap map = cells(std::vector<std::string>(60, std::string(60, '.')), 0.1);
  for (int row = 0; row < 60; ++row) {
    const bool narrow = row >= 10 && row < 14, wide = row >= 45 && row < 58;
    if (!narrow && !wide) map.occupied[cell_number(map, 30, row)] = 1;
  }
  Workspace w = room(map);
  w.starts = {{"s", {1, 1.2}, 0, {}}};
  w.goals = {{"g", {{5, 1}, {5.2, 1}, {5.2, 1.4}}}};
  const CellMap wide = *reduced(w, {{}, {}, {}, 0.6, Girth{0.4, 0.4, 0}}).cells;
  EXPECT_TRUE(wide.at(30, 12));
  EXPECT_FALSE(wide.at(30, 46));
  const CellMap unsure = *reduced(w, {{}, {}, {}, 0.6, Girth{0.22, 0.22, 0}}).cells;
  EXPECT_TRUE(unsure.at(30, 12)) << "the gap is 0.04 m narrower than the disc";
  const CellMap narrow = *reduced(w, {{}, {}, {}, 0.6, Girth{0.1, 0.1, 0}}).cells;
  EXPECT_FALSE(narrow.at(30, 12));
  EXPECT_TRUE(narrow.at(30, 46));
}

// In cells of 0.5 m: an aisle of 1 m, a wall, and a room, which the aisle's left end leads to.
CellMap aisle_beside_room() {
  std::vector<std::string> rows(12, std::string(40, '.'));
  for (std::size_t i = 2; i < 40; ++i) rows[9][i] = '#';  // rows 10 and 11 are the aisle
  return cells(rows, 0.5);
}

bool joined(const CellMap& map, Point from, Point to) {
  const CellFrame frame(map);
  return connected(map, free_cells(map), {*cell_at(map, frame, from)})[*cell_at(map, frame, to)] != 0;
}

const Ring kInTheRoom{{16, 3}, {17, 3}, {17, 4}}, kInTheAisle{{16, 0.3}, {17, 0.3}, {17, 0.7}};

Workspace aisle_query(Point start, const std::vector<Goal>& goals) {
  Workspace w = room(aisle_beside_room());
  w.starts = {{"s", start, 0, {}}};
  w.goals = goals;
  return w;
}

// The disc is unsure in the aisle and sure in the room, 1 m from the start and behind the wall.
TEST(Corridor, BeginsOnTheStartsSideOfAWall) {
  Workspace w = aisle_query({15, 0.5}, {{"g", kInTheRoom}});
  const CellMap result = *reduced(w, {{}, {}, {}, 2.0, Girth{0.2, 0.3, 0}}).cells;
  EXPECT_TRUE(joined(result, {15, 0.5}, {16.9, 3.2}));
  w.cells->occupied[cell_number(*w.cells, 3, 0)] = w.cells->occupied[cell_number(*w.cells, 3, 1)] = 1;
  EXPECT_THAT(complaint(w, {{}, {}, {}, 2.0, Girth{0.2, 0.3, 0}}), testing::HasSubstr("no way from start 's'"));
}

// The middle of the disc cannot be in the start's own cell, which is at the border, but in one below it.
TEST(Corridor, BeginsWhereTheDiscHasRoomNearTheStart) {
  Workspace w = aisle_query({5, 5.95}, {{"g", kInTheRoom}});
  EXPECT_TRUE(joined(*reduced(w, {{}, {}, {}, 2.0, Girth{0.9, 0.9, 0.9}}).cells, {5, 5.95}, {16.9, 3.2}));
  w.starts = {{"s", {5, 1.25}, 0, {}}};  // in the wall
  EXPECT_THAT(complaint(w, {{}, {}, {}, 2.0, Girth{0.2, 0.3, 0}}), testing::HasSubstr("no way from start 's'"));
}

TEST(Corridor, LeadsToAGoalInItsOwnAisleAndNotBehindTheWall) {
  Workspace w = aisle_query({15, 3.5}, {{"g", kInTheAisle}});
  EXPECT_TRUE(joined(*reduced(w, {{}, {}, {}, 2.0, Girth{0.2, 1.5, 0}}).cells, {15, 3.5}, {16.9, 0.5}));
}

TEST(Corridor, LeadsToEveryGoalAlsoWhereOnlySomeAreSurelyReached) {
  Workspace w = aisle_query({15, 3.5}, {{"a", kInTheRoom}, {"b", kInTheAisle}});
  const Workspace result = reduced(w, {{}, {}, {}, 2.0, Girth{0.2, 0.3, 0}});
  EXPECT_TRUE(joined(*result.cells, {15, 3.5}, {16.9, 0.5}));
  EXPECT_TRUE(joined(*result.cells, {15, 3.5}, {16.9, 3.2}));
  EXPECT_THAT(result.warnings, testing::IsEmpty());
}

TEST(Corridor, IsRefusedWithoutAWay) {
  std::vector<std::string> rows(20, "..........#.........");
  Workspace w = room(cells(rows));
  EXPECT_THAT(complaint(w, {{}, {}, {}, 3.0, Girth{1, 1, 0}}), testing::HasSubstr("no start"));
  w.starts = {{"s", {5, 5}, 0, {}}};
  EXPECT_THAT(complaint(w, {{}, {}, {}, 3.0, Girth{1, 1, 0}}), testing::HasSubstr("no goal"));
  w.goals = {{"g", {{15, 5}, {17, 5}, {17, 7}}}};
  EXPECT_THAT(complaint(w, {{}, {}, {}, 0.5, Girth{1, 1, 0}}), testing::HasSubstr("narrower than the robot"));
  EXPECT_THAT(complaint(w, {{}, {}, {}, 3.0, Girth{1, 1, 0}}),
              testing::HasSubstr("a disc of radius 1 m has no way from start 's' to goal 'g'"));
  w.goals.push_back({"h", {{5, 15}, {7, 15}, {7, 17}}});
  EXPECT_THAT(reduced(w, {{}, {}, {}, 3.0, Girth{1, 1, 0}}).warnings,
              testing::ElementsAre(testing::HasSubstr("no way leads to goal 'g'")));
}

TEST(Reduced, ADrawingHasNoCells) {
  Workspace w;
  w.max = {10, 10};
  EXPECT_THAT(complaint(w, {{}, {}, Girth{1, 1, 0}, {}, {}}), testing::HasSubstr("give --cell METRES"));
  EXPECT_THAT(complaint(w, {{}, {}, {}, 3.0, {}}), testing::HasSubstr("give --cell METRES"));
}

TEST(Girth, IsThatOfTheThinnestAndOfTheLargestBody) {
  RobotSpec train = parse_robot("truck:2");
  train.bodies = {{{-1, -0.2}, {1, -0.2}, {1, 0.2}, {-1, 0.2}},
                  {{-1, -0.1}, {1, -0.1}, {1, 0.1}, {-1, 0.1}},
                  {{-2, -0.3}, {2, -0.3}, {2, 0.3}, {-2, 0.3}}};
  EXPECT_NEAR(girth_of(train).inner, 0.1, 1e-5);
  EXPECT_GE(girth_of(train).outer, std::hypot(2, 0.3) - 1e-3);
  std::swap(train.bodies[1], train.bodies[2]);
  EXPECT_NEAR(girth_of(train).inner, 0.1, 1e-5);
  EXPECT_GE(girth_of(train).outer, std::hypot(2, 0.3) - 1e-3);
}

TEST(Girth, IsThatOfTheBodies) {
  const Girth box = girth_of(parse_robot("car"));
  EXPECT_NEAR(box.inner, 0.3, 1e-5);
  EXPECT_NEAR(box.outer, std::hypot(0.6, 0.3), 1e-3);
  EXPECT_NEAR(box.spread, 0.4, 1e-3);
  for (const char* name : {"snake:5", "semitrailer", "turtlebot4", "fork_lift", "unicycle"}) {
    const RobotSpec robot = parse_robot(name);
    const Girth girth = girth_of(robot);
    for (const Ring& body : robot.bodies) {
      double widest = 0;  // the room around the best of many places in the body
      Random random(7);
      for (int k = 0; k < 4000; ++k) {
        const Point p{uniform(random, -20, 20) * 0.5, uniform(random, -3, 3) * 0.5};
        if (winding(p, body) != 0) widest = std::max(widest, distance(p, body));
      }
      EXPECT_GE(girth.outer, widest) << name;
    }
    EXPECT_GT(girth.inner, 0) << name;
    EXPECT_LE(girth.inner, girth.outer) << name;
  }
}

}  // namespace
}  // namespace krait::host::test
