// SPDX-License-Identifier: GPL-3.0-or-later
// Single steps of the compiler, where whole scenes would hit the hard case too rarely.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>

#include "host/compiler/rings.hpp"
#include "host/compiler/simplify.hpp"
#include "host/compiler/snap.hpp"
#include "host/compiler/triangulation.hpp"
#include "host/compiler/unite.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host::compiler {
namespace {

bool meet_inside(const Edge& a, const Edge& b) {
  const auto on = [](const Edge& e, GridPoint p) {
    return p != e.from && p != e.to && cross(e.from, e.to, p) == 0 && dot(p, e.from, e.to) <= 0;
  };
  const auto side = [](const Edge& e, GridPoint p) {
    return (cross(e.from, e.to, p) > 0) - (cross(e.from, e.to, p) < 0);
  };
  return on(a, b.from) || on(a, b.to) || on(b, a.from) || on(b, a.to) ||
         (side(a, b.from) * side(a, b.to) < 0 && side(b, a.from) * side(b, a.to) < 0);
}

void expect_sound(const Edges& edges) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) EXPECT_FALSE(meet_inside(edges[i], edges[j]));
  }
}

TEST(Snap, CrossedDiagonalsOfOneGridCellComeToRest) {
  Edges edges{{{0, 0}, {1, 1}}, {{1, 0}, {0, 1}}};
  expect_sound(snap(edges).edges);
}

TEST(Snap, DenseRandomEdgesEndSound) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<std::int32_t> at(0, seed % 2 == 0 ? 12 : 300);
    Edges edges;
    for (int i = 0; i < 30; ++i) {
      const GridPoint a{at(random), at(random)}, b{at(random), at(random)};
      edges.push_back({a, b});
    }
    expect_sound(snap(edges).edges);
  }
}

TEST(Snap, OverlappingEdgesAddTheirWindings) {
  const Edges edges = snap({{{0, 0}, {10, 0}, {1, 0}}, {{15, 0}, {5, 0}, {1, 0}}}).edges;
  ASSERT_EQ(edges.size(), 3U);
  EXPECT_EQ(edges[0].winding[0], 1);
  EXPECT_EQ(edges[1].winding[0], 0);
  EXPECT_EQ(edges[2].winding[0], -1);
}

TEST(Snap, LeadsEdgesThroughPointsNearby) {
  const Edges edges = snap({{{0, 0}, {1000, 3}}}, {{500, 1}, {500, 4}}).edges;
  ASSERT_EQ(edges.size(), 2U);
  EXPECT_EQ(edges[0].to, (GridPoint{500, 1}));
}

TEST(Snap, TooManyCrossingsAreRefused) {
  Edges edges;
  for (std::int32_t i = 0; i < 1100; ++i) {
    edges.push_back({{0, 10 * i}, {20000, 10 * i + 1}});
    edges.push_back({{10 * i, -5}, {10 * i + 1, 20000}});
  }
  EXPECT_THROW(snap(edges), InputError);
}

// Each of 19,900 pairs crosses once, but shares a hundred cells of the index.
TEST(Snap, CountsACrossingOnce) {
  Edges edges;
  for (std::int32_t i = 0; i < 200; ++i) edges.push_back({{0, 10 * i}, {200000, 1990 - 10 * i + 37 * i % 101}});
  EXPECT_LT(snap(edges).crossings, 40'000U);  // in all passes
}

// Free space on the left: a room, counter-clockwise, whose walls do the case at hand.
TEST(Simplify, TakesOnlyStraightVerticesAtGrowthZero) {
  const GridRing room{{0, 0}, {500, 0}, {1000, 0}, {1000, 1000}, {500, 1001}, {0, 1000}};
  const auto simple = simplify({room}, 0);
  ASSERT_EQ(simple.size(), 1U);
  EXPECT_THAT(simple[0], testing::ElementsAre(GridPoint{0, 0}, GridPoint{1000, 0}, GridPoint{1000, 1000},
                                              GridPoint{500, 1001}, GridPoint{0, 1000}));
}

TEST(Simplify, ShrinksObstaclesByOneGridStepAtMost) {
  for (const std::int32_t bump : {1, 3}) {  // the wall y = 0 bulges up into the room
    const GridRing room{{0, 0}, {500, bump}, {1000, 0}, {1000, 1000}, {0, 1000}};
    EXPECT_EQ(simplify({room}, 10)[0].size(), bump == 1 ? 4U : 5U) << bump;
  }
}

TEST(Simplify, ObstaclesThatTouchInAVertexStayTouching) {
  // The wall y = 0 bulges by one step, and there an obstacle's lowest corner touches it.
  const GridRing room{{0, 0}, {500, 1}, {1000, 0}, {1000, 1000}, {0, 1000}};
  const GridRing island{{500, 1}, {400, 400}, {500, 800}, {600, 400}};
  const auto simple = simplify({room, island}, 10);
  EXPECT_THAT(simple[0], testing::Contains(GridPoint{500, 1}));
}

TEST(Simplify, KeepsWhatStandsInTheWay) {
  // A notch in the floor, too small to matter, but a post stands in it.
  const GridRing room{{0, 0}, {490, 0}, {500, -10}, {510, 0}, {1000, 0}, {1000, 1000}, {0, 1000}};
  const GridRing post{{500, -3}, {499, -2}, {500, -1}, {501, -2}};
  EXPECT_THAT(simplify({room, post}, 50)[0], testing::Contains(GridPoint{500, -10}));
  EXPECT_THAT(simplify({room}, 50)[0], testing::Not(testing::Contains(GridPoint{500, -10})));
}

// A wall of 2 km with a vertex in its middle, and one with a shallow notch all along, as deep as the wall may grow:
// samples as dense as the growth, or a thousandth of it, would take a minute.
TEST(Simplify, EndsSoonHoweverLittleItMayGrow) {
  const GridRing straight{{0, 0}, {4000000, 0}, {8000000, 0}, {8000000, 1000}, {0, 1000}};
  const GridRing notched{{0, 0},       {10, 0},      {10, -2},        {7999990, -2},
                         {7999990, 0}, {8000000, 0}, {8000000, 1000}, {0, 1000}};
  const std::clock_t begin = std::clock();
  EXPECT_EQ(simplify({straight}, 0.002)[0].size(), 4U);
  EXPECT_EQ(simplify({notched}, 2)[0].size(), 4U);
  EXPECT_LT(double(std::clock() - begin) / CLOCKS_PER_SEC, 5);
}

TEST(Simplify, KeepsASpikeThatLeansAlongItsBase) {
  // Its tip is one step from the line through its neighbours, but 1,500 steps past the nearer of them.
  const GridPoint tip{5001, 3000};
  const GridRing room{{0, 0}, {5000, 0}, tip, {5001, 1500}, {5004, 0}, {10000, 0}, {10000, 10000}, {0, 10000}};
  EXPECT_THAT(simplify({room}, 100)[0], testing::Contains(tip));
}

TEST(Simplify, GrowsNoObstacleWhereThatLeavesAPassageNarrow) {
  // A notch in the floor, and a ceiling across from it.
  const GridRing room{{0, 0}, {400, 0}, {500, -100}, {600, 0}, {1000, 0}, {1000, 300}, {0, 300}};
  EXPECT_THAT(simplify({room}, 100, 150)[0], testing::Not(testing::Contains(GridPoint{500, -100})));
  EXPECT_THAT(simplify({room}, 100, 250)[0], testing::Contains(GridPoint{500, -100}));
}

TEST(Simplify, ObstaclesOnBothSidesOfAPassageLeaveItItsWidth) {
  // Each of two notches could be filled if the other were not: 340 steps from floor to ceiling, 380 at a notch.
  const GridRing room{{0, 0},      {400, 0},   {500, -40}, {600, 0},   {1000, 0},
                      {1000, 340}, {600, 340}, {500, 380}, {400, 340}, {0, 340}};
  EXPECT_EQ(simplify({room}, 50, 280)[0].size(), 4U);
  EXPECT_EQ(simplify({room}, 50, 340)[0].size(), room.size());
}

TEST(Simplify, WhatIsBehindAWallLeavesNoPassageNarrow) {
  // A notch in the top of a thin wall: across from it, only the floor below the wall is near, and behind it.
  const GridRing room{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}};
  const GridRing wall{{100, 400}, {100, 450}, {400, 450}, {500, 420}, {600, 450}, {900, 450}, {900, 400}};
  EXPECT_THAT(simplify({room, wall}, 100, 150)[1], testing::Not(testing::Contains(GridPoint{500, 420})));
}

TEST(Simplify, KeepsOutlinesAroundAPlace) {
  // Two notches in the floor, and a vertex in the line between them.
  const GridRing room{{0, 0},    {400, 0},    {500, -40}, {600, 0},     {1300, 0},
                      {1900, 0}, {2000, -40}, {2100, 0},  {3000, 1000}, {0, 1000}};
  const GridRing simple = simplify({room}, 100, 0, {{{500, 100}, {2900, 900}}, 300})[0];
  EXPECT_THAT(simple, testing::IsSupersetOf({GridPoint{400, 0}, GridPoint{500, -40}, GridPoint{600, 0}}));
  EXPECT_THAT(simple, testing::Not(testing::Contains(GridPoint{2000, -40})));
  EXPECT_THAT(simple, testing::Not(testing::Contains(GridPoint{1300, 0})));
  // A hollow all along the floor, whose deepest point is far from the place.
  const GridRing hollow{{0, 0}, {1500, -60}, {3000, 0}, {3000, 1000}, {0, 1000}};
  EXPECT_EQ(simplify({hollow}, 100, 0, {{{200, 50}}, 100})[0].size(), 5U);
  EXPECT_EQ(simplify({hollow}, 100, 0, {{{200, 900}}, 100})[0].size(), 4U);
}

// The sine of a triangle's smallest angle: over the shortest edge, between the two longer ones.
double sine_of_smallest_angle(const Triangulation& t, const Face& face) {
  double edges[3];
  for (int i = 0; i < 3; ++i) {
    const GridPoint a = t.corner(face, i), b = t.corner(face, i + 1);
    edges[i] = std::hypot(a.x - b.x, a.y - b.y);
  }
  std::sort(edges, edges + 3);
  return static_cast<double>(t.twice_area(face)) / (edges[1] * edges[2]);
}

TEST(Refinement, LeavesNoSlenderTriangleInAHallWithAPillar) {
  Edges edges;
  const auto add_box = [&](int x, int y, int width, int height, int winding) {
    const GridPoint corners[] = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    for (int i = 0; i < 4; ++i) edges.push_back({corners[i], corners[(i + 1) % 4], {winding, 0}});
  };
  add_box(0, 0, 40'000, 5'000, 1);
  add_box(9'000, 2'000, 400, 300, -1);
  const Edges snapped = snap(edges).edges;
  const std::vector<GridPoint> added = refinement(snapped, {10'000, 100, 10'000});
  const Triangulation t = triangulate(snap(snapped, added).edges, added);
  ASSERT_GT(t.faces.size(), 10U);
  for (const Face& face : t.faces) {
    if (face.winding[0] == 0) continue;
    EXPECT_GT(sine_of_smallest_angle(t, face), 0.32);  // 19.4 degrees, and rounding
  }
}

TEST(Rings, ThatTouchInAPointStayApart) {
  const GridPoint middle{0, 0};
  Edges edges;
  append_ring(edges, {{0, -10}, middle, {-10, -5}}, {1, 0});
  append_ring(edges, {middle, {-2, 10}, {-10, 8}}, {1, 0});
  const std::vector<GridRing> rings = rings_of(edges);
  ASSERT_EQ(rings.size(), 2U);
  for (const GridRing& ring : rings) EXPECT_THAT(ring, testing::AllOf(testing::SizeIs(3), testing::Contains(middle)));
}

// Triangles thinner than the grid, of lengths over two decades; every eighth along a diagonal.
std::vector<Edges> needles(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto place = [](double x, double y) {
    return GridPoint{static_cast<std::int32_t>(std::lround(x)), static_cast<std::int32_t>(std::lround(y))};
  };
  std::vector<Edges> result;
  for (int i = 0; i < 40; ++i) {
    const double x = between(-20000, 20000), y = between(-20000, 20000);
    const double angle = i % 8 == 0 ? 0.785398 : between(0, 6.2832);
    const double length = 200 * std::pow(100, between(0, 1)), along = between(0, length), width = between(-2, 2);
    const double cos = std::cos(angle), sin = std::sin(angle);
    const GridRing ring{place(x, y), place(x + along * cos - width * sin, y + along * sin + width * cos),
                        place(x + length * cos, y + length * sin)};
    result.emplace_back();
    append_ring(result.back(), ring, {1, 0});
  }
  return result;
}

double distance(const Edges& edges, double x, double y) {
  double least = 1e18;
  for (const Edge& e : edges) {
    const double dx = e.to.x - e.from.x, dy = e.to.y - e.from.y;
    const double along = std::clamp(((x - e.from.x) * dx + (y - e.from.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    least = std::min(least, std::hypot(e.from.x + along * dx - x, e.from.y + along * dy - y));
  }
  return least;
}

TEST(Unite, LosesNoPartOfANeedle) {
  const GridBox bounds{{-41000, -41000}, {41000, 41000}};
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    std::vector<Edges> parts;
    for (const Edges& needle : needles(seed)) parts.push_back(unite({needle}, bounds).boundary);
    const United united = unite(parts, bounds);
    for (const Edges& needle : needles(seed)) {
      for (const Edge& e : needle) {
        for (int i = 0; i <= 50; ++i) {
          const double x = e.from.x + 0.02 * i * (e.to.x - e.from.x), y = e.from.y + 0.02 * i * (e.to.y - e.from.y);
          ASSERT_LT(distance(united.boundary, x, y), 6) << "seed " << seed << ", at " << x << ", " << y;
        }
      }
    }
  }
}

TEST(Unite, FitsAWallIntoBoundsOfTwoSteps) {
  const GridBox bounds{{0, 0}, {1000, 2}};
  Edges line;
  append_ring(line, {{10, 1}, {900, 1}}, {1, 0});
  EXPECT_FALSE(unite({line}, bounds).boundary.empty());
}

}  // namespace
}  // namespace krait::host::compiler
