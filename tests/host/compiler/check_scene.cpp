// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_scene.hpp"

#include <gtest/gtest.h>

#include <random>

#include "krait/scene.hpp"

namespace krait::host::test {
namespace {

constexpr double kStep = 1.0 / 4096;

class Checker {
 public:
  Checker(const Workspace& workspace, const SceneView& view, int samples)
      : w_(workspace), v_(view), samples_(samples) {}

  void run() {
    adjacency();
    areas();
    for (int i = 0; i < samples_; ++i) point(random_point());
    for (const Ring& piece : v_.pieces) {  // the hard places: corners and edges
      for (const Point p : piece) {
        if (inside_bounds(p)) point({p.x + jitter(), p.y + jitter()});
      }
    }
    portals();
  }

 private:
  Point random_point() {
    const auto uniform = [this](float low, float high) {
      return std::uniform_real_distribution<double>(double(low), double(high))(random_);
    };
    const double x = uniform(v_.header.bounds_min_x, v_.header.bounds_max_x);
    return {x, uniform(v_.header.bounds_min_y, v_.header.bounds_max_y)};
  }
  double jitter() { return std::uniform_real_distribution<double>(-0.02, 0.02)(random_); }

  bool inside_bounds(Point p) const {
    return p.x > double(v_.header.bounds_min_x) && p.x < double(v_.header.bounds_max_x) &&
           p.y > double(v_.header.bounds_min_y) && p.y < double(v_.header.bounds_max_y);
  }

  double bounds_distance(Point p) const {
    return std::min({p.x - double(v_.header.bounds_min_x), double(v_.header.bounds_max_x) - p.x,
                     p.y - double(v_.header.bounds_min_y), double(v_.header.bounds_max_y) - p.y});
  }

  // To the nearest piece or bound; 0 inside a piece.
  double true_clearance(Point p) const {
    double nearest = std::max(0.0, bounds_distance(p));
    for (const Ring& piece : v_.pieces) nearest = std::min(nearest, convex_contains(piece, p) ? 0 : distance(p, piece));
    return nearest;
  }

  void adjacency() {
    for (std::uint32_t t = 0; t < v_.triangles.size(); ++t) {
      EXPECT_GT(twice_area(v_.triangles[t]), 0);
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t other = v_.neighbors[3 * t + i];
        EXPECT_EQ(other == format::kNone32, v_.portals[3 * t + i] == format::kNone32);
        if (other == format::kNone32) continue;
        const auto back =
            std::find(v_.neighbors.begin() + 3 * other, v_.neighbors.begin() + 3 * other + 3, t) - v_.neighbors.begin();
        ASSERT_LT(back, 3 * other + 3);
        EXPECT_EQ(v_.portals[static_cast<std::size_t>(back)], v_.portals[3 * t + i]);
      }
    }
  }

  // Bent edges may overlap or gape by less than a grid step along the boundary.
  void areas() {
    double sum = 0, border = 0;
    for (const Ring& ring : v_.triangles) sum += twice_area(ring) / 2;
    for (const Ring& ring : v_.pieces) sum += twice_area(ring) / 2;
    for (std::uint32_t k = 0; k < v_.neighbors.size(); ++k) {
      if (v_.neighbors[k] != format::kNone32) continue;
      const Ring& t = v_.triangles[k / 3];
      border += std::hypot(t[(k + 1) % 3].x - t[k % 3].x, t[(k + 1) % 3].y - t[k % 3].y);
    }
    const double width = double(v_.header.bounds_max_x) - double(v_.header.bounds_min_x);
    const double height = double(v_.header.bounds_max_y) - double(v_.header.bounds_min_y);
    EXPECT_NEAR(sum, width * height, 1e-9 * width * height + border * kStep);
  }

  void point(Point p) {
    if (!inside_bounds(p)) return;
    const auto in = [&](const std::vector<Ring>& rings) {
      return std::count_if(rings.begin(), rings.end(), [&](const Ring& r) { return convex_contains(r, p); });
    };
    const auto pieces = in(v_.pieces), triangles = in(v_.triangles);
    const bool near_edge =
        std::any_of(v_.pieces.begin(), v_.pieces.end(), [&](const Ring& r) { return distance(p, r) < 2 * kStep; }) ||
        std::any_of(v_.triangles.begin(), v_.triangles.end(),
                    [&](const Ring& r) { return distance(p, r) < 2 * kStep; });
    if (!near_edge) {
      EXPECT_EQ(pieces + triangles, 1) << p.x << ' ' << p.y;
    }
    against_input(p, pieces > 0);
    buckets(p);
    clearance(p);
  }

  // The obstacles as the user gave them: how deep inside (positive) or far outside (negative) the point lies.
  double input_depth(Point local) const {
    const Point p{local.x + v_.header.origin_x, local.y + v_.header.origin_y};
    double depth = -std::numeric_limits<double>::infinity();
    for (const Obstacle& o : w_.obstacles) {
      double to_edge = distance(p, o.outer);
      bool inside = winding(p, o.outer) != 0;
      for (const Ring& hole : o.holes) {
        to_edge = std::min(to_edge, distance(p, hole));
        inside = inside && winding(p, hole) == 0;
      }
      depth = std::max(depth, inside ? to_edge : -to_edge);
    }
    return w_.cells ? std::max(depth, cell_depth(p)) : depth;
  }

  // For a map: inside counts as infinitely deep, as touching cells add up; outside the map is inside.
  double cell_depth(Point p) const {
    const CellMap& m = *w_.cells;
    const double dx = p.x - m.origin.x, dy = p.y - m.origin.y, cos = std::cos(m.yaw), sin = std::sin(m.yaw);
    const double x = (cos * dx + sin * dy) / m.resolution, y = (-sin * dx + cos * dy) / m.resolution;
    double nearest = std::numeric_limits<double>::infinity();
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    for (int j = row - 3; j <= row + 3; ++j) {
      for (int i = column - 3; i <= column + 3; ++i) {
        const bool outside = i < 0 || j < 0 || i >= m.columns || j >= m.rows;
        if (!outside && !m.at(i, j)) continue;
        const double gap_x = std::max({i - x, x - i - 1, 0.0}), gap_y = std::max({j - y, y - j - 1, 0.0});
        nearest = std::min(nearest, std::hypot(gap_x, gap_y));
      }
    }
    if (nearest > 0) return -nearest * m.resolution;
    return solid_depth(x, y) * m.resolution;
  }

  // Distance in cells to the nearest free cell, up to 1.
  double solid_depth(double x, double y) const {
    const CellMap& m = *w_.cells;
    double nearest = 1;
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    for (int j = row - 1; j <= row + 1; ++j) {
      for (int i = column - 1; i <= column + 1; ++i) {
        if (i < 0 || j < 0 || i >= m.columns || j >= m.rows || m.at(i, j)) continue;
        const double gap_x = std::max({i - x, x - i - 1, 0.0}), gap_y = std::max({j - y, y - j - 1, 0.0});
        nearest = std::min(nearest, std::hypot(gap_x, gap_y));
      }
    }
    return nearest;
  }

  void against_input(Point p, bool in_piece) {
    const double depth = input_depth(p), error = double(v_.header.obstacle_error);
    if (!in_piece) {
      EXPECT_LE(depth, error + 1e-9) << "an obstacle was lost at " << p.x << ' ' << p.y;
    }
    if (in_piece) {
      EXPECT_GE(depth, -1.001 * double(v_.header.tolerance) - error - 2 * kStep)
          << "an obstacle grew too much at " << p.x << ' ' << p.y;
    }
  }

  void buckets(Point p) {
    const double size = double(v_.header.bucket_size);
    const auto column = static_cast<std::size_t>((p.x - double(v_.header.bounds_min_x)) / size);
    const auto row = static_cast<std::size_t>((p.y - double(v_.header.bounds_min_y)) / size);
    const std::size_t bucket = row * v_.header.bucket_columns + column;
    ASSERT_LT(bucket, v_.bucket_triangles.size());
    const auto listed = [&](const std::vector<std::uint32_t>& list, const std::vector<Ring>& rings) {
      for (std::uint32_t i = 0; i < rings.size(); ++i) {
        if (convex_contains(rings[i], p)) {
          EXPECT_TRUE(std::binary_search(list.begin(), list.end(), i)) << i;
        }
      }
    };
    listed(v_.bucket_triangles[bucket], v_.triangles);
    listed(v_.bucket_pieces[bucket], v_.pieces);
  }

  void clearance(Point p) {
    const double size = double(v_.header.clearance_cell);
    const auto column = static_cast<std::size_t>((p.x - double(v_.header.bounds_min_x)) / size);
    const auto row = static_cast<std::size_t>((p.y - double(v_.header.bounds_min_y)) / size);
    const std::uint8_t byte = v_.clearance.at(row * v_.header.clearance_columns + column);
    const double bound = byte * double(v_.header.clearance_unit), truth = true_clearance(p);
    EXPECT_LE(bound, truth) << p.x << ' ' << p.y;
    if (byte < format::kMaxClearance) {
      // On a diagonal the bytes rise by a cell where distances rise by its diagonal.
      EXPECT_GE(bound, truth / std::sqrt(2.0) - 1.5 * size - double(v_.header.clearance_unit) - 8 * kStep);
    }
  }

  void portals() {
    std::vector<bool> seen(v_.widths.size(), false);
    for (std::uint32_t k = 0; k < v_.portals.size(); ++k) {
      const std::uint32_t portal = v_.portals[k];
      if (portal == format::kNone32 || seen.at(portal)) continue;
      seen[portal] = true;
      const Point a = v_.triangles[k / 3][k % 3], b = v_.triangles[k / 3][(k + 1) % 3];
      double largest = 0;
      constexpr int kSteps = 20;
      for (int i = 0; i <= kSteps; ++i) {
        const double t = double(i) / kSteps;
        largest = std::max(largest, true_clearance({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}));
      }
      const double width = double(v_.widths[portal]), spacing = std::hypot(b.x - a.x, b.y - a.y) / kSteps;
      EXPECT_GE(width, 2 * largest);
      EXPECT_LE(width, 2.02 * (largest + spacing) + 0.01);
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), false), 0);
  }

  const Workspace& w_;
  const SceneView& v_;
  int samples_;
  std::mt19937_64 random_{7};
};

}  // namespace

SceneView checked(const Workspace& workspace, double tolerance, int samples) {
  const CompiledScene scene = compile(workspace, {tolerance, {}});
  Scene opened;
  const Failure failure = Scene::open(scene.bytes.data(), scene.bytes.size(), opened);
  EXPECT_TRUE(failure.ok()) << "section " << int{failure.section} << " element " << failure.element;
  const SceneView view = Reader(scene.bytes).read();
  Checker(workspace, view, samples).run();
  return view;
}

Ring box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

Ring rotated_box(Point center, double width, double height, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Ring ring;
  for (const Point p : box(-width / 2, -height / 2, width / 2, height / 2)) {
    ring.push_back({center.x + c * p.x - s * p.y, center.y + s * p.x + c * p.y});
  }
  return ring;
}

Workspace empty_room(double width, double height) {
  Workspace w;
  w.name = "room";
  w.max = {width, height};
  return w;
}

}  // namespace krait::host::test
