// SPDX-License-Identifier: Apache-2.0
// Polygon distances, point location, and shortest paths after raised costs.
#include "base/arena.hpp"
#include "base/random.hpp"
#include "collision/distance.hpp"
#include "decomposition/locate.hpp"
#include "decomposition/regions.hpp"
#include "stages.hpp"

namespace krait::stages {
namespace {

constexpr int kPairs = 1500;
constexpr int kPoints = 3000;
constexpr int kUpdates = 12;
constexpr int kRaises = 5;  // between updates

// Corners on a circle: convex and counter-clockwise.
struct RandomPolygon {
  Vec2 corners[format::kMaxPieceVertices];
  int count;

  RandomPolygon(detail::Random& random, Vec2 center) : count(3 + static_cast<int>(random.below(6))) {
    const float radius = 0.1F + 2.0F * random.unit();
    const float sector = 2.0F * kPi / static_cast<float>(count);
    for (int i = 0; i < count; ++i) {
      const SinCos angle = math::sin_cos(sector * (static_cast<float>(i) + 0.8F * random.unit()));
      corners[i] = center + radius * Vec2{angle.cos, angle.sin};
    }
  }

  Polygon polygon() const { return {corners, count}; }
};

void locations(const firmware::Board& board, const Scene& scene) {
  Hash hash;
  detail::Random random(22);
  Index near = kNone;
  for (int i = 0; i < kPoints; ++i) {
    const Vec2 p = random_in(scene.bounds(), random);
    const Index triangle = detail::locate(scene, p);
    hash.add(triangle);
    hash.add(detail::locate(scene, p, near));
    hash.add(scene.clearance().at(p));
    near = triangle;
  }
  report(board, {scene.name(), "locate"}, hash);
}

void add_paths(const detail::Regions& regions, detail::Random& random, Hash& hash) {
  for (Index t = 0; t < regions.scene().triangle_count(); ++t) {
    hash.add(regions.cost(t));
    hash.add(regions.next(t));
  }
  const Index from = random.below(regions.scene().triangle_count());
  hash.add(regions.random_point(regions.random_ahead(from, regions.regions_ahead(from, 8), random), random));
}

void shortest_paths(const firmware::Board& board, const Scene& scene) {
  Hash hash;
  detail::Random random(23);
  detail::Arena arena(board.arena, board.arena_room);
  detail::Regions regions;
  regions.allocate(arena, scene);
  regions.reset(Goal::named(0), 0.5F, 0.035F);
  add_paths(regions, random, hash);
  for (int update = 0; update < kUpdates; ++update) {
    for (int i = 0; i < kRaises; ++i) regions.raise_edges(random.below(scene.triangle_count()), {50.0F, 0.7F});
    regions.update();
    add_paths(regions, random, hash);
  }
  report(board, {scene.name(), "shortest_paths"}, hash);
}

}  // namespace

void distances(const firmware::Board& board) {
  Hash hash;
  detail::Random random(21);
  for (int i = 0; i < kPairs; ++i) {
    const RandomPolygon a(random, {});
    const float x = spread(random, 4.0F);
    const float y = spread(random, 4.0F);
    const RandomPolygon b(random, {x, y});
    hash.add(detail::polygon_distance(a.polygon(), b.polygon()));
  }
  report(board, {"distance"}, hash);
}

void decomposition(const firmware::Board& board, const Scene& scene) {
  locations(board, scene);
  shortest_paths(board, scene);
}

}  // namespace krait::stages
