// SPDX-License-Identifier: Apache-2.0
// The decomposition's heuristic costs against Boost's Dijkstra on the same graph, built here in double precision.
#include "decomposition/regions.hpp"

#include <gtest/gtest.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <cmath>
#include <set>
#include <vector>

#include "decomposition/locate.hpp"
#include "regions_around.hpp"
#include "scene_builder.hpp"

namespace krait::test::regions_test {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// Regions in the caller's memory.
struct Decomposition {
  explicit Decomposition(const Scene& scene) {
    detail::Arena counting;
    regions.allocate(counting, scene);
    block.resize(counting.needed() / 8);
    detail::Arena arena(block.data(), block.size() * 8);
    regions.allocate(arena, scene);
  }
  std::vector<std::uint64_t> block;
  detail::Regions regions;
};

// The graph (R, E, C) by its definition: centroids, the goal's triangles as one vertex (a disc's: one more vertex at
// distance zero from all that it meets).
class Graph {
 public:
  Graph(const Scene& scene, const Goal& goal, double least_width, double least_cost) : scene_(scene), goal_(goal) {
    const auto [x, y] = goal_center();
    for (Index t = 0; t < scene.triangle_count(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const Index n = scene.neighbor(t, i);
        if (n == kNone || n < t || vertex(n) == vertex(t)) continue;
        const Point a = vertex(t) == 0 && !goal.is_disc() ? Point{x, y} : center(t);
        const Point b = vertex(n) == 0 && !goal.is_disc() ? Point{x, y} : center(n);
        const bool open = static_cast<double>(scene.portal_width(scene.portal(t, i))) >= least_width;
        const double apart = std::max(least_cost, std::hypot(a.x - b.x, a.y - b.y));
        edges_.push_back({t, n, open ? apart : kInfinite, apart});
      }
    }
  }

  void raise(Index triangle, double gamma, double length) {
    const auto joins = [this](Index a, Index b) { return !goal(b) && joined(a, b); };
    const auto apart = [this](Index a, Index b) {
      return std::hypot(center(a).x - center(b).x, center(a).y - center(b).y);
    };
    const double reach = goal(triangle) ? 0 : 0.35 * length;
    std::set<std::size_t> raised;
    for (const Index t : regions_around(scene_, triangle, reach, joins, apart)) raised.insert(vertex(t));
    for (Edge& e : edges_) {
      if (raised.count(vertex(e.a)) + raised.count(vertex(e.b)) == 0 || e.cost == kInfinite) continue;
      const double scale = length > 0 ? length * std::min(e.base, length) : 1;
      e.cost += gamma * scale / std::max(e.cost, length);
    }
  }

  // Distances of all triangles from the goal.
  std::vector<double> distances() const {
    using Boost = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                        boost::property<boost::edge_weight_t, double>>;
    Boost boost_graph(scene_.triangle_count() + 1);
    for (const Edge& e : edges_) {
      if (e.cost < kInfinite) boost::add_edge(vertex(e.a), vertex(e.b), e.cost, boost_graph);
    }
    if (goal_.is_disc()) {
      for (Index t = 0; t < scene_.triangle_count(); ++t) {
        if (goal_.covers(scene_, t)) boost::add_edge(0, vertex(t), 0.0, boost_graph);
      }
    }
    std::vector<double> by_vertex(scene_.triangle_count() + 1);
    boost::dijkstra_shortest_paths(boost_graph, 0, boost::distance_map(by_vertex.data()));
    std::vector<double> result;
    for (Index t = 0; t < scene_.triangle_count(); ++t) {
      const double d = by_vertex[vertex(t)];
      result.push_back(d < 1e300 ? d : kInfinite);
    }
    return result;
  }

  // Least h + C over the neighbours of a triangle's region, and the neighbours that have it within `tolerance`.
  std::vector<Index> best_neighbors(Index t, const std::vector<double>& h, double tolerance) const {
    double least = kInfinite;
    for (const Edge& e : edges_) {
      if (e.a == t) least = std::min(least, h[e.b] + e.cost);
      if (e.b == t) least = std::min(least, h[e.a] + e.cost);
    }
    std::vector<Index> best;
    for (const Edge& e : edges_) {
      if (e.a == t && h[e.b] + e.cost <= least * (1 + tolerance)) best.push_back(e.b);
      if (e.b == t && h[e.a] + e.cost <= least * (1 + tolerance)) best.push_back(e.a);
    }
    return best;
  }

 private:
  struct Edge {
    Index a, b;
    double cost, base;  // base: before the first raise
  };

  bool goal(Index t) const { return goal_.covers(scene_, t); }
  bool joined(Index a, Index b) const {
    return std::any_of(edges_.begin(), edges_.end(),
                       [&](const Edge& e) { return std::minmax(a, b) == std::minmax(e.a, e.b) && e.cost < kInfinite; });
  }

  std::size_t vertex(Index t) const {
    const bool merged = !goal_.is_disc() && scene_.goal_of(t) == goal_.index();
    return merged ? 0 : std::size_t{t} + 1;
  }
  Point center(Index t) const {
    double x = 0, y = 0;
    for (int i = 0; i < 3; ++i) {
      x += static_cast<double>(scene_.corner(t, i).x) / 3;
      y += static_cast<double>(scene_.corner(t, i).y) / 3;
    }
    return {x, y};
  }
  // Centroid of the area of all the goal's triangles.
  Point goal_center() const {
    double x = 0, y = 0, total = 0;
    for (Index t = 0; t < scene_.triangle_count(); ++t) {
      if (goal_.is_disc() || scene_.goal_of(t) != goal_.index()) continue;
      const double area = side(point(scene_.corner(t, 0)), point(scene_.corner(t, 1)), point(scene_.corner(t, 2)));
      x += area * center(t).x;
      y += area * center(t).y;
      total += area;
    }
    return {x / total, y / total};
  }

  const Scene& scene_;
  Goal goal_;
  std::vector<Edge> edges_;
};

// The widest way by its definition: the largest width at which a flood from `from` through portals of at least that
// width meets the goal; 0 where none does.
double widest_way(const Scene& scene, const Goal& goal, Index from) {
  const auto connected = [&](float width) {
    std::vector<Index> found = {from};
    std::set<Index> seen = {from};
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (goal.covers(scene, found[i])) return true;
      for (int edge = 0; edge < 3; ++edge) {
        const Index n = scene.neighbor(found[i], edge);
        if (n == kNone || scene.portal_width(scene.portal(found[i], edge)) < width || !seen.insert(n).second) continue;
        found.push_back(n);
      }
    }
    return false;
  };
  float widest = 0;
  for (Index p = 0; p < scene.portal_count(); ++p) {
    const float width = scene.portal_width(p);
    if (width > widest && connected(width)) widest = width;
  }
  return static_cast<double>(widest);
}

TEST(Regions, TheWidestWayIsThatOfAFloodAtEveryWidth) {
  int ways = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const OpenScene open(random_room(seed, 8, 8));
    Decomposition d(open.scene);
    for (const Goal& goal : {Goal::named(0), Goal::disc({4, 4}, 0.3F)}) {
      if (!d.regions.reset(goal, 0.6F, 0.01F)) continue;
      for (Index from = 0; from < open.scene.triangle_count(); from += 17) {
        if (goal.covers(open.scene, from)) continue;
        const float before = d.regions.cost(d.regions.region(from));
        const Bottleneck bottleneck = d.regions.widest_way(from, 0.0F);
        EXPECT_EQ(static_cast<double>(bottleneck.width), widest_way(open.scene, goal, from)) << seed << " " << from;
        EXPECT_EQ(d.regions.cost(d.regions.region(from)), before);
        ways += bottleneck.width > 0.0F ? 1 : 0;
      }
    }
  }
  EXPECT_GT(ways, 50);
}

void expect_costs(const detail::Regions& regions, const Graph& graph) {
  const Scene& scene = regions.scene();
  const auto expected = graph.distances();
  double largest = 0;
  for (Index t = 0; t < scene.triangle_count(); ++t) {
    const double h = static_cast<double>(regions.cost(regions.region(t)));
    if (expected[t] == kInfinite) {
      ASSERT_EQ(h, kInfinite) << t;
    } else {
      ASSERT_NEAR(h, expected[t], 1e-5 * (1 + expected[t])) << t;
      largest = std::max(largest, expected[t]);
    }
  }
  ASSERT_NEAR(static_cast<double>(regions.largest_cost()), largest, 1e-5 * (1 + largest));
}

void expect_next(const detail::Regions& regions, const Graph& graph) {
  const Scene& scene = regions.scene();
  std::vector<double> h;
  for (Index t = 0; t < scene.triangle_count(); ++t) h.push_back(static_cast<double>(regions.cost(regions.region(t))));
  for (Index t = 0; t < scene.triangle_count(); ++t) {
    const Index r = regions.region(t);
    const Index next = regions.next(r);
    if (h[t] == 0 || h[t] == kInfinite) {
      ASSERT_EQ(next, kNone) << t;
      continue;
    }
    ASSERT_NE(next, kNone) << t;
    ASSERT_LT(regions.cost(next), regions.cost(r)) << t;
    bool best = false;
    for (const Index n : graph.best_neighbors(t, h, 1e-5)) best = best || regions.region(n) == next;
    ASSERT_TRUE(best) << t;
  }
}

TEST(Regions, CostsAreBoostsOnRandomScenes) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const OpenScene open(random_room(seed));
    Decomposition d(open.scene);
    const Goal goal = Goal::named(0);
    const bool found = d.regions.reset(goal, 0.0F, 0.05F);
    if (!found) continue;
    const Graph graph(open.scene, goal, 0, 0.05);
    expect_costs(d.regions, graph);
    expect_next(d.regions, graph);
  }
}

// With 3 and 12 m a raise reaches some of the cells of 1 m around, and more than it may raise.
TEST(Regions, CostsAreBoostsAfterRandomRaisesInBothForms) {
  for (const float length : {0.0F, 0.7F, 3.0F, 12.0F}) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
      const OpenScene open(random_room(seed));
      Decomposition d(open.scene);
      const Goal goal = Goal::named(0);
      if (!d.regions.reset(goal, 0.0F, 0.05F)) continue;
      Graph graph(open.scene, goal, 0, 0.05);
      std::mt19937 random(seed);
      for (int round = 0; round < 10; ++round) {
        for (unsigned i = 0; i < 1 + random() % 20; ++i) {
          const Index t = below(random, open.scene.triangle_count());
          d.regions.raise_edges(d.regions.region(t), {50.0F, length});
          graph.raise(t, 50, static_cast<double>(length));
        }
        d.regions.update();
        expect_costs(d.regions, graph);
        expect_next(d.regions, graph);
      }
    }
  }
}

// How much longer the way from one side of a room with narrow walls becomes by a failure in its middle.
double raise_in_the_middle(double cell) {
  Room room;
  room.bounds = {0, 0, 8, 1};
  room.spacing = cell;
  room.goals = {{7, 0, 8, 1}};
  const OpenScene open(room);
  Decomposition d(open.scene);
  EXPECT_TRUE(d.regions.reset(Goal::named(0), 0.0F, 0.001F));
  const Index start = detail::locate(open.scene, {0.55F, 0.45F});
  const float before = d.regions.cost(start);
  for (int failures = 0; failures < 20; ++failures) {
    Index ahead = start;
    while (open.scene.centroid(ahead).x < 3.8F) ahead = d.regions.next(ahead);
    d.regions.raise_edges(ahead, {1.0F, 3.0F});
    d.regions.update();
  }
  return static_cast<double>(d.regions.cost(start) - before);
}

// A way could else evade a raised region through the small ones beside it.
TEST(Regions, AFailureWeighsAsMuchAmongSmallRegions) {
  const double coarse = raise_in_the_middle(1.0), fine = raise_in_the_middle(0.25);
  EXPECT_GT(fine, coarse / 3);
  EXPECT_LT(fine, coarse * 3);
}

// The same decomposition twice: one repaired, one computed anew after the same raises.
class Twins {
 public:
  Twins(const Scene& scene, const Goal& goal, float least_width = 0.0F)
      : triangles_(scene.triangle_count()), repaired_(scene), updated_(scene) {
    found_ = repaired_.regions.reset(goal, least_width, 0.05F) && updated_.regions.reset(goal, least_width, 0.05F);
  }

  bool found() const { return found_; }
  const detail::Regions& regions() const { return repaired_.regions; }

  void raise(Index region, const detail::CostRaise& raise) {
    repaired_.regions.raise_edges(region, raise);
    updated_.regions.raise_edges(region, raise);
  }

  // Returns how many regions' paths were found anew.
  Index repair() {
    updated_.regions.update();
    return repaired_.regions.repair();
  }

  void expect_equal() const {
    const detail::Regions &a = repaired_.regions, &b = updated_.regions;
    ASSERT_EQ(a.largest_cost(), b.largest_cost());
    for (Index t = 0; t < triangles_; ++t) {
      ASSERT_EQ(a.cost(a.region(t)), b.cost(b.region(t))) << t;
      ASSERT_EQ(a.next(a.region(t)), b.next(b.region(t))) << t;
    }
  }

 private:
  Index triangles_;
  Decomposition repaired_, updated_;
  bool found_ = false;
};

// Raises some regions, mostly ones that paths go through, now and then the goal itself or a source.
void raise_some(Twins& twins, std::mt19937& random, const detail::CostRaise& raise) {
  const detail::Regions& regions = twins.regions();
  for (unsigned i = 0; i < 1 + random() % 12; ++i) {
    Index region = regions.region(below(random, regions.scene().triangle_count()));
    for (unsigned steps = static_cast<unsigned>(random() % 6); steps > 0; --steps) {
      if (regions.next(region) != kNone) region = regions.next(region);
    }
    twins.raise(region, raise);
  }
}

void expect_repairs(const Scene& scene, const Goal& goal, float least_width, const detail::CostRaise& raise,
                    unsigned seed) {
  Twins twins(scene, goal, least_width);
  if (!twins.found()) return;
  std::mt19937 random(seed);
  Index repaired = 0, rounds = 0;
  for (; rounds < 60; ++rounds) {
    raise_some(twins, random, raise);
    const Index count = twins.repair();
    ASSERT_LE(count, scene.triangle_count());
    repaired += count;
    twins.expect_equal();
    if (testing::Test::HasFatalFailure()) FAIL() << "seed " << seed << " round " << rounds;
  }
  EXPECT_GT(repaired, 0U);
}

TEST(RegionsRepair, IsAnUpdateBitForBitForNamedGoals) {
  for (unsigned seed = 1; seed <= 25; ++seed) {
    const OpenScene open(random_room(seed));
    for (const detail::CostRaise& raise : {detail::CostRaise{50.0F, 0.7F}, detail::CostRaise{50.0F, 0.0F},
                                           detail::CostRaise{0.01F, 0.7F}, detail::CostRaise{50.0F, 3.0F}}) {
      expect_repairs(open.scene, Goal::named(0), seed % 3 == 0 ? 0.9F : 0.0F, raise, seed);
    }
  }
}

TEST(RegionsRepair, IsAnUpdateBitForBitForDiscGoals) {
  for (unsigned seed = 1; seed <= 25; ++seed) {
    const OpenScene open(random_room(seed));
    std::mt19937 random(seed + 50);
    const Goal goal =
        Goal::disc({uniform_float(random, 1, 11), uniform_float(random, 1, 11)}, uniform_float(random, 0.05, 3));
    expect_repairs(open.scene, goal, 0.0F, {50.0F, seed % 2 == 0 ? 0.7F : 4.0F}, seed);
  }
}

// Rooms of equal cells have many paths of equal cost: ties must fall alike.
TEST(RegionsRepair, IsAnUpdateBitForBitAmongTies) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Room room;
    room.goals = {{4, 4, 6, 6}, {0, 0, 1, 1}};
    room.diagonals = seed;
    const OpenScene open(room);
    expect_repairs(open.scene, Goal::named(seed % 2), 0.0F, {1.0F, 1.0F}, seed);
  }
}

// Paths so long that float loses edges on them, whose order then decides.
TEST(RegionsRepair, IsAnUpdateBitForBitAfterTheSteepestRaises) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const OpenScene open(random_room(seed));
    expect_repairs(open.scene, Goal::named(0), 0.0F, {1e6F, 10.0F}, seed);
    expect_repairs(open.scene, Goal::named(0), 0.0F, {1e6F, 0.0F}, seed);
  }
}

TEST(RegionsRepair, OfTheWholeGoalRaisesEveryPath) {
  const OpenScene open(random_room(1));
  Twins twins(open.scene, Goal::named(0));
  ASSERT_TRUE(twins.found());
  for (int i = 0; i < 5; ++i) {
    twins.raise(twins.regions().goal_region(), {50.0F, 0.7F});
    const Index count = twins.repair();
    Index reachable = 0;
    for (Index t = 0; t < open.scene.triangle_count(); ++t) {
      const float h = twins.regions().cost(twins.regions().region(t));
      reachable += h < kInfinity ? 1 : 0;
    }
    EXPECT_EQ(count, reachable);
    twins.expect_equal();
  }
}

TEST(RegionsRepair, OfARegionThatNoPathCrossesTouchesOnlyItself) {
  const OpenScene open(random_room(1));
  Twins twins(open.scene, Goal::named(0));
  ASSERT_TRUE(twins.found());
  const detail::Regions& regions = twins.regions();
  std::set<Index> crossed;
  for (Index t = 0; t < open.scene.triangle_count(); ++t) crossed.insert(regions.next(regions.region(t)));
  Index leaf = 0;
  while (crossed.count(leaf) != 0 || regions.is_goal(regions.region(leaf)) || regions.cost(leaf) == kInfinity) ++leaf;
  twins.raise(leaf, {50.0F, 0.7F});
  EXPECT_EQ(twins.repair(), 1U);
  twins.expect_equal();
  EXPECT_EQ(twins.repair(), 0U);  // nothing was raised since
  twins.expect_equal();
}

TEST(RegionsRepair, AfterAResetStartsAnew) {
  const OpenScene open(random_room(2));
  Decomposition d(open.scene), fresh(open.scene);
  ASSERT_TRUE(d.regions.reset(Goal::named(0), 0.0F, 0.05F));
  for (Index t = 0; t < open.scene.triangle_count(); t += 3) d.regions.raise_edges(d.regions.region(t), {50.0F, 0.7F});
  const Goal disc = Goal::disc({3, 3}, 1);
  ASSERT_TRUE(d.regions.reset(disc, 0.0F, 0.05F));
  ASSERT_TRUE(fresh.regions.reset(disc, 0.0F, 0.05F));
  EXPECT_EQ(d.regions.repair(), 0U);
  for (Index t = 0; t < open.scene.triangle_count(); ++t) {
    ASSERT_EQ(d.regions.cost(t), fresh.regions.cost(t));
    ASSERT_EQ(d.regions.next(t), fresh.regions.next(t));
  }
}

TEST(Regions, DiscGoalsMakeEveryTriangleThatTheyMeetASource) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const OpenScene open(random_room(seed));
    std::mt19937 random(seed);
    Decomposition d(open.scene);
    const Vec2 center{uniform_float(random, 0, 12), uniform_float(random, 0, 12)};
    const float radius = uniform_float(random, 0.05, 2);
    const Goal goal = Goal::disc(center, radius);
    if (!d.regions.reset(goal, 0.0F, 0.05F)) continue;
    Graph graph(open.scene, goal, 0, 0.05);
    expect_costs(d.regions, graph);
    for (int i = 0; i < 30; ++i) {
      const Index t = below(random, open.scene.triangle_count());
      d.regions.raise_edges(t, {20.0F, 1.0F});
      graph.raise(t, 20, 1);
    }
    d.regions.update();
    expect_costs(d.regions, graph);
    expect_next(d.regions, graph);
  }
}

TEST(Regions, DiscMeetsExactlyTheTrianglesWithinItsRadius) {
  const OpenScene open(random_room(3));
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i) {
    const Vec2 center{uniform_float(random, 0, 12), uniform_float(random, 0, 12)};
    const float radius = uniform_float(random, 0.01, 2);
    for (Index t = 0; t < open.scene.triangle_count(); ++t) {
      Ring triangle;
      for (int k = 0; k < 3; ++k) triangle.push_back(point(open.scene.corner(t, k)));
      const double distance = distance_to_convex(point(center), triangle) - static_cast<double>(radius);
      if (std::abs(distance) > 1e-5) {
        ASSERT_EQ(Goal::disc(center, radius).covers(open.scene, t), distance < 0);
      }
    }
  }
}

TEST(Regions, PortalsNarrowerThanTheRobotAreNoEdges) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const OpenScene open(random_room(seed));
    Decomposition d(open.scene);
    const Goal goal = Goal::named(0);
    if (!d.regions.reset(goal, 0.9F, 0.05F)) continue;
    const Graph graph(open.scene, goal, static_cast<double>(0.9F), 0.05);
    expect_costs(d.regions, graph);
    expect_next(d.regions, graph);
  }
}

// Two rooms and a door of 0.5 m between them.
Room with_door() {
  Room room;
  room.bounds = {0, 0, 10, 4};
  room.boxes = {{5, 0, 5.25, 1.5}, {5, 2, 5.25, 4}};
  room.goals = {{8, 0, 10, 4}};
  return room;
}

TEST(Regions, BeyondAClosedDoorAllIsInfinite) {
  const OpenScene open(with_door());
  Decomposition d(open.scene);
  ASSERT_TRUE(d.regions.reset(Goal::named(0), 0.45F, 0.05F));
  const Index left = detail::locate(open.scene, {1, 1});
  EXPECT_LT(d.regions.cost(left), 20.0F);
  ASSERT_TRUE(d.regions.reset(Goal::named(0), 0.6F, 0.05F));
  EXPECT_EQ(d.regions.cost(left), kInfinity);
  EXPECT_EQ(d.regions.next(left), kNone);
  EXPECT_LT(d.regions.largest_cost(), 20.0F);  // of what can be reached
}

// Where every edge costs the same, ways of the same length abound: the smaller region is the next one.
TEST(Regions, OfEquallyShortWaysTheOneOverTheSmallerRegionIsTaken) {
  const OpenScene open(random_room(3));
  const Scene& scene = open.scene;
  Decomposition d(scene);
  constexpr float kCost = 64.0F;
  ASSERT_TRUE(d.regions.reset(Goal::named(0), 0, kCost));
  int ties = 0;
  for (Index t = 0; t < scene.triangle_count(); ++t) {
    if (d.regions.is_goal(d.regions.region(t)) || d.regions.cost(t) == kInfinity) continue;
    Index smallest = kNone;
    int shortest = 0;
    for (int i = 0; i < 3; ++i) {
      if (scene.neighbor(t, i) == kNone) continue;
      const Index n = d.regions.region(scene.neighbor(t, i));
      if (d.regions.cost(n) + kCost != d.regions.cost(t)) continue;
      ++shortest;
      smallest = std::min(smallest, n);
    }
    ties += shortest > 1 ? 1 : 0;
    ASSERT_EQ(d.regions.next(t), smallest) << t;
  }
  EXPECT_GT(ties, 10);
}

// Two aisles of 4 km, one after the other, with cells of a grid step in the furthest corner: h + C is h there.
TEST(Regions, EveryPathEndsInTheGoalWhereFloatsAddNoEdge) {
  constexpr double kStep = 1.0 / 4096;
  Room room;
  room.bounds = {-1990, -10, 1990, 10};
  room.boxes = {{-1990, -1, 1980, 1}};
  for (int i = 0; i < 6; ++i) {
    room.boxes.push_back({-1980 + 2 * i * kStep, 9, -1980 + (2 * i + 1) * kStep, 9.5});
    room.boxes.push_back({1985, 5 + 2 * i * kStep, 1985.5, 5 + (2 * i + 1) * kStep});
  }
  room.goals = {{-1985, -5, -1980, -2}};
  room.spacing = 40;
  room.clearance_cell = room.bucket_size = 2;
  for (unsigned diagonals = 1; diagonals <= 4; ++diagonals) {
    room.diagonals = diagonals;
    const OpenScene open(room);
    Decomposition decomposition(open.scene);
    const detail::Regions& regions = decomposition.regions;
    ASSERT_TRUE(decomposition.regions.reset(Goal::named(0), 0.0F, 1e-5F));
    Index as_far = 0;
    for (Index t = 0; t < open.scene.triangle_count(); ++t) {
      const Index first = regions.next(regions.region(t));
      as_far += first != kNone && regions.cost(first) == regions.cost(regions.region(t)) ? 1 : 0;
      Index region = regions.region(t);
      Index steps = 0;
      while (region != kNone && !regions.is_goal(region) && steps <= open.scene.triangle_count()) {
        region = regions.next(region);
        ++steps;
      }
      ASSERT_LE(steps, open.scene.triangle_count()) << "from triangle " << t;
    }
    EXPECT_GT(as_far, 10U);  // else the scene tests nothing
  }
}

TEST(Regions, TrianglesOfAGoalAreOneRegion) {
  const OpenScene open(with_door());
  Decomposition d(open.scene);
  ASSERT_TRUE(d.regions.reset(Goal::named(0), 0.0F, 0.05F));
  const Index goal_region = d.regions.goal_region();
  int merged = 0;
  for (Index t = 0; t < open.scene.triangle_count(); ++t) {
    if (open.scene.goal_of(t) == 0) {
      EXPECT_EQ(d.regions.region(t), goal_region);
      EXPECT_TRUE(d.regions.is_goal(d.regions.region(t)));
      ++merged;
    } else {
      EXPECT_EQ(d.regions.region(t), t);
    }
  }
  EXPECT_EQ(merged, 20);  // two columns and five rows of cells
  EXPECT_EQ(d.regions.next(goal_region), kNone);
}

TEST(Regions, GoalWithoutTrianglesIsSaid) {
  Room room;
  room.boxes = {{2, 2, 6, 6}};
  room.goals = {{3, 3, 4, 4}};
  const OpenScene open(room);
  Decomposition d(open.scene);
  EXPECT_FALSE(d.regions.reset(Goal::named(0), 0.0F, 0.05F));
  EXPECT_FALSE(d.regions.reset(Goal::disc({4, 4}, 0.5F), 0.0F, 0.05F));
  EXPECT_TRUE(d.regions.reset(Goal::disc({4, 4}, 2.5F), 0.0F, 0.05F));
}

// Worked by hand: one cell of one metre beside the goal's; the portal's cost is the distance of (2/3, 1/3) or, by the
// other diagonal, (2/3, 2/3), and (3/2, 1/2).
class RegionsEqn9 : public ::testing::Test {
 protected:
  static Room room() {
    Room result;
    result.bounds = {0, 0, 2, 1};
    result.goals = {{1, 0, 2, 1}};
    return result;
  }
  float nearest() const {
    float least = kInfinity;
    for (Index t = 0; t < open.scene.triangle_count(); ++t) {
      const float h = d.regions.cost(d.regions.region(t));
      if (h > 0.0F && h < least) least = h;
    }
    return least;
  }
  OpenScene open{room()};
  Decomposition d{open.scene};
  const double c = std::hypot(5.0 / 6, 1.0 / 6);
};

TEST_F(RegionsEqn9, PaperFormAddsGammaOverC) {
  ASSERT_TRUE(d.regions.reset(Goal::named(0), 0.0F, 0.01F));
  EXPECT_NEAR(static_cast<double>(nearest()), c, 1e-6);
  d.regions.raise_edges(d.regions.goal_region(), {50.0F, 0.0F});
  d.regions.update();
  EXPECT_NEAR(static_cast<double>(nearest()), c + 50 / c, 1e-4);
  d.regions.raise_edges(d.regions.goal_region(), {50.0F, 0.0F});
  d.regions.update();
  EXPECT_NEAR(static_cast<double>(nearest()), c + 50 / c + 50 / (c + 50 / c), 1e-4);
}

TEST_F(RegionsEqn9, LengthFormAddsGammaTimesLengthAndTheSmallerOverTheLarger) {
  ASSERT_TRUE(d.regions.reset(Goal::named(0), 0.0F, 0.01F));
  d.regions.raise_edges(d.regions.goal_region(), {50.0F, 2.0F});
  d.regions.update();
  EXPECT_NEAR(static_cast<double>(nearest()), c + 50 * 2 * c / 2, 1e-4);
  d.regions.raise_edges(d.regions.goal_region(), {50.0F, 2.0F});
  d.regions.update();
  EXPECT_NEAR(static_cast<double>(nearest()), 51 * c + 50 * 2 * c / (51 * c), 1e-4);
}

TEST_F(RegionsEqn9, NoCostIsBelowTheLeast) {
  ASSERT_TRUE(d.regions.reset(Goal::named(0), 0.0F, 3.0F));
  EXPECT_EQ(nearest(), 3.0F);
}

TEST_F(RegionsEqn9, ResetForgetsAllRaises) {
  ASSERT_TRUE(d.regions.reset(Goal::named(0), 0.0F, 0.01F));
  const float before = nearest();
  for (int i = 0; i < 10; ++i) d.regions.raise_edges(d.regions.goal_region(), {50.0F, 0.0F});
  ASSERT_TRUE(d.regions.reset(Goal::named(0), 0.0F, 0.01F));
  EXPECT_EQ(nearest(), before);
}

// Distances of centroids as a walk along the path finds them.
TEST(RegionsAhead, AreTheFirstOfThePathAndFurtherOnesThatAreNear) {
  Room fine = with_door();
  fine.spacing = 0.25;
  const OpenScene open(fine);
  Decomposition d(open.scene);
  ASSERT_TRUE(d.regions.reset(Goal::named(0), 0.0F, 0.05F));
  Index longest = 0;
  for (Index t = 0; t < open.scene.triangle_count(); ++t) {
    if (d.regions.is_goal(d.regions.region(t))) continue;
    const Index all = d.regions.regions_ahead(t, 1000);
    for (const Index least : {1U, 6U, 40U}) EXPECT_EQ(d.regions.regions_ahead(t, least), std::min(all, least));
    EXPECT_EQ(d.regions.regions_ahead(t, 3, kInfinity), std::min(all, 32U));
    const Index near = d.regions.regions_ahead(t, 3, 1.0F);
    longest = std::max(longest, near);
    Index r = t;
    for (Index i = 1; i <= std::min({near + 1, all, 32U}); ++i) {
      r = d.regions.next(r);
      if (i <= 3 || d.regions.is_goal(r)) continue;
      EXPECT_EQ(length(open.scene.centroid(r) - open.scene.centroid(t)) < 1.0F, i <= near) << t << " " << i;
    }
  }
  EXPECT_GT(longest, 6U);
}

TEST(RegionsPoints, LieInTheirRegionAndFillItsHalvesEqually) {
  const OpenScene open(with_door());
  Decomposition d(open.scene);
  ASSERT_TRUE(d.regions.reset(Goal::named(0), 0.0F, 0.05F));
  detail::Random random(1);
  const Index t = detail::locate(open.scene, {1.2F, 1.4F});
  Ring triangle;
  for (int k = 0; k < 3; ++k) triangle.push_back(point(open.scene.corner(t, k)));
  // The medians cut a triangle into halves of equal area.
  int left[3] = {0, 0, 0};
  constexpr int kDraws = 30'000;
  for (int i = 0; i < kDraws; ++i) {
    const Point p = point(d.regions.random_point(t, random));
    ASSERT_LT(distance_to_convex(p, triangle), 1e-6);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point a = triangle[k], b = triangle[(k + 1) % 3], c = triangle[(k + 2) % 3];
      left[k] += side(a, {(b.x + c.x) / 2, (b.y + c.y) / 2}, p) > 0 ? 1 : 0;
    }
  }
  for (const int count : left) EXPECT_NEAR(count, kDraws / 2, 5 * std::sqrt(kDraws) / 2);
}

TEST(RegionsPoints, OfTheGoalFillAllOfIt) {
  const OpenScene open(with_door());
  Decomposition d(open.scene);
  ASSERT_TRUE(d.regions.reset(Goal::named(0), 0.0F, 0.05F));
  detail::Random random(2);
  int counts[8] = {};
  constexpr int kDraws = 40'000;
  for (int i = 0; i < kDraws; ++i) {
    const Vec2 p = d.regions.random_point(d.regions.goal_region(), random);
    ASSERT_GE(p.x, 8.0F);
    ASSERT_LE(p.x, 10.0F);
    const int column = std::min(1, static_cast<int>(p.x - 8.0F)), row = std::min(3, static_cast<int>(p.y));
    ++counts[row * 2 + column];
  }
  for (const int count : counts) EXPECT_NEAR(count, kDraws / 8, 5 * std::sqrt(kDraws / 8));
}

TEST(RegionsPoints, OfADiscLieInIt) {
  const OpenScene open(with_door());
  Decomposition d(open.scene);
  const Goal goal = Goal::disc({2, 2}, 0.75F);
  ASSERT_TRUE(d.regions.reset(goal, 0.0F, 0.05F));
  detail::Random random(3);
  int inner = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vec2 p = d.regions.random_point(detail::locate(open.scene, {2, 2}), random);
    ASSERT_LE(length(p - Vec2{2, 2}), 0.750001F);
    inner += length(p - Vec2{2, 2}) < 0.75F * 0.70710678F ? 1 : 0;
  }
  EXPECT_NEAR(inner, 10'000, 5 * 71);
}

}  // namespace
}  // namespace krait::test::regions_test
