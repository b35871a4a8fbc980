// SPDX-License-Identifier: Apache-2.0
#include "host/run/shortest_way.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <vector>

#include "decomposition/locate.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {
namespace {

Point point(Vec2 p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

double distance(const Point& a, const Point& b) { return std::hypot(b.x - a.x, b.y - a.y); }

// Dijkstra over points on the portals, the ends among them: those of a triangle's portals see each other.
class PortalPoints {
 public:
  PortalPoints(const krait::Scene& scene, const krait::Goal& goal, float least_width)
      : scene_(scene), goal_(goal), least_width_(least_width), nodes_(std::size_t{scene.portal_count()} * kPoints) {}

  // From `from` in `triangle` to `to` in the goal; empty where there is none.
  std::vector<Point> way(Index triangle, const Point& from, const Point& to) {
    if (goal_.covers(scene_, triangle)) return {from, to};
    reach(triangle, from, 0, kFirst);
    while (!queue_.empty()) {
      const auto [length, node] = queue_.top();
      queue_.pop();
      if (node == kLast) return way_to_last(from, to);
      if (length > nodes_[node].length) continue;
      for (const Index next : nodes_[node].triangles) {
        if (goal_.covers(scene_, next)) {
          reach_last(length + distance(nodes_[node].at, to), node);
        } else {
          reach(next, nodes_[node].at, length, node);
        }
      }
    }
    return {};
  }

 private:
  static constexpr std::size_t kPoints = 7;  // on a portal
  static constexpr std::size_t kFirst = SIZE_MAX;
  static constexpr std::size_t kLast = SIZE_MAX - 1;

  struct Node {
    double length = std::numeric_limits<double>::infinity();  // from the start
    std::size_t before = kFirst;
    Point at;
    Index triangles[2] = {kNone, kNone};  // that meet there
  };

  // All points of the triangle's portals, from one that is `length` from the start.
  void reach(Index triangle, const Point& from, double length, std::size_t before) {
    for (int edge = 0; edge < 3; ++edge) {
      const Index other = scene_.neighbor(triangle, edge);
      if (other == kNone || scene_.portal_width(scene_.portal(triangle, edge)) < least_width_) continue;
      const Point a = point(scene_.corner(triangle, edge));
      const Point b = point(scene_.corner(triangle, (edge + 1) % 3));
      for (std::size_t i = 0; i < kPoints; ++i) {
        // Counted from the same end by both triangles.
        const double share = static_cast<double>(triangle < other ? i : kPoints - 1 - i) / (kPoints - 1);
        const Point at{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
        const std::size_t number = std::size_t{scene_.portal(triangle, edge)} * kPoints + i;
        const double through = length + distance(from, at);
        if (!(through < nodes_[number].length)) continue;
        nodes_[number] = {through, before, at, {triangle, other}};
        queue_.emplace(through, number);
      }
    }
  }

  void reach_last(double length, std::size_t before) {
    if (!(length < last_)) return;
    last_ = length;
    before_last_ = before;
    queue_.emplace(length, kLast);
  }

  std::vector<Point> way_to_last(const Point& from, const Point& to) const {
    std::vector<Point> way = {to};
    for (std::size_t node = before_last_; node != kFirst; node = nodes_[node].before) way.push_back(nodes_[node].at);
    way.push_back(from);
    return way;
  }

  const krait::Scene& scene_;
  const krait::Goal& goal_;
  float least_width_;
  std::vector<Node> nodes_;
  double last_ = std::numeric_limits<double>::infinity();
  std::size_t before_last_ = kFirst;
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

// False where the triangles share a portal that is narrower.
bool wide_enough(const krait::Scene& scene, Index from, Index to, float least_width) {
  for (int edge = 0; from != kNone && edge < 3; ++edge) {
    if (scene.neighbor(from, edge) == to) return scene.portal_width(scene.portal(from, edge)) >= least_width;
  }
  return true;
}

// Whether the line lies in triangles and passes through wide portals, as far as points every 2 cm tell.
bool sees(const krait::Scene& scene, float least_width, const Point& a, const Point& b) {
  constexpr double kStep = 0.02;
  const int steps = static_cast<int>(distance(a, b) / kStep) + 1;
  Index before = kNone;
  for (int i = 1; i < steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const Vec2 at{static_cast<float>(a.x + share * (b.x - a.x)), static_cast<float>(a.y + share * (b.y - a.y))};
    const Index triangle = detail::locate(scene, at, before);
    if (triangle == kNone || !wide_enough(scene, before, triangle, least_width)) return false;
    before = triangle;
  }
  return true;
}

// Leaves out points whose neighbours see each other.
void straighten(const krait::Scene& scene, float least_width, std::vector<Point>& way) {
  for (std::size_t i = 1; i + 1 < way.size();) {
    if (!sees(scene, least_width, way[i - 1], way[i + 1])) {
      ++i;
      continue;
    }
    way.erase(way.begin() + static_cast<std::ptrdiff_t>(i));
    if (i > 1) --i;
  }
}

double length_of(const std::vector<Point>& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += distance(way[i - 1], way[i]);
  return length;
}

}  // namespace

double shortest_way(const krait::Scene& scene, const krait::Goal& goal, float least_width, Vec2 from, Vec2 to) {
  constexpr double kNoWay = std::numeric_limits<double>::quiet_NaN();
  const Index triangle = detail::locate(scene, from);
  if (triangle == kNone) return kNoWay;
  std::vector<Point> way = PortalPoints(scene, goal, least_width).way(triangle, point(from), point(to));
  if (way.empty()) return kNoWay;
  straighten(scene, least_width, way);
  return length_of(way);
}

}  // namespace krait::host
