// SPDX-License-Identifier: Apache-2.0
// Polyanya (Cui, Harabor and Grastien: Compromise-free Pathfinding on a Navigation Mesh, IJCAI 2017): A* over intervals
// of portals, each of which is seen whole from its root, the place where the ways through it have bent last.
#include "host/run/shortest_way.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "decomposition/locate.hpp"
#include "host/run/local_point.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {
namespace {

double distance(const Point& a, const Point& b) { return std::hypot(b.x - a.x, b.y - a.y); }

// Positive where c lies to the left of the line from a to b: twice the area of the triangle.
double area(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Point between(const Point& a, const Point& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

// Up to what share of the line from a to b a linear function is positive that does not grow from 0 and has these values
// at its ends.
double positive_share(double at_a, double at_b) {
  if (at_b > 0) return 1;
  return at_a > 0 ? at_a / (at_a - at_b) : 0;
}

class Polyanya {
 public:
  Polyanya(const krait::Scene& scene, float least_width) : scene_(scene), least_width_(least_width) { find_corners(); }

  double length(Index begin, const Point& from, Index end, const Point& to) {
    if (begin == end) return distance(from, to);
    to_ = to;
    for (int edge = 0; edge < 3; ++edge) {
      const auto [left, right] = ends(begin, edge);
      push({begin, edge, right, left, from, 0, 0});
    }
    while (!queue_.empty()) {
      const Node node = queue_.top();
      queue_.pop();
      if (node.triangle == end) return node.bound;
      if (!outdated(node.root, node.length)) expand(node);
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

 private:
  static constexpr double kRounding = 1e-9;  // metres, or square metres of an area

  // Ways that go on into a triangle through an interval of its edge, seen from the root between left and right.
  struct Node {
    Index triangle;
    int edge;
    Point left, right;
    Point root;
    double length;  // metres to the root
    double bound;   // metres of the shortest way through the interval, if nothing were in its way afterwards

    bool operator<(const Node& other) const { return bound > other.bound; }
  };

  // A part of an edge of a triangle, from left to right as one sees it from inside.
  struct Side {
    int edge;
    Point left, right;
  };

  static std::uint64_t key(const Point& p) {
    const auto bits = [](double x) { return std::bit_cast<std::uint32_t>(static_cast<float>(x)); };
    return std::uint64_t{bits(p.x)} << 32U | bits(p.y);
  }

  bool open(Index triangle, int edge) const {
    return scene_.neighbor(triangle, edge) != kNone &&
           scene_.portal_width(scene_.portal(triangle, edge)) >= least_width_;
  }

  // As one sees them who looks into the triangle.
  std::pair<Point, Point> ends(Index triangle, int edge) const {
    return {local_point(scene_.corner(triangle, edge)), local_point(scene_.corner(triangle, (edge + 1) % 3))};
  }

  // Shortest ways bend at vertices of closed edges only.
  void find_corners() {
    for (Index triangle = 0; triangle < scene_.triangle_count(); ++triangle) {
      for (int edge = 0; edge < 3; ++edge) {
        if (open(triangle, edge)) continue;
        const auto [left, right] = ends(triangle, edge);
        for (const Point& end : {left, right}) corners_.emplace(key(end), std::numeric_limits<double>::infinity());
      }
    }
  }

  bool is_corner(const Point& p) const { return corners_.contains(key(p)); }

  // Whether a shorter way to the root is known.
  bool outdated(const Point& root, double length) const {
    const auto corner = corners_.find(key(root));
    return corner != corners_.end() && length > corner->second + kRounding;
  }

  // Of a way from a through the interval to b, which may be on the same side: as in a mirror then.
  static double through(const Point& a, const Point& left, const Point& right, const Point& b) {
    const double width = distance(left, right);
    if (!(width > 0)) return distance(a, left) + distance(left, b);
    const auto along = [&](const Point& p) {
      return ((p.x - left.x) * (right.x - left.x) + (p.y - left.y) * (right.y - left.y)) / width;
    };
    const double off_a = std::abs(area(left, right, a)) / width;
    const double off_b = std::abs(area(left, right, b)) / width;
    const double share = off_a + off_b > 0 ? off_a / (off_a + off_b) : 0;
    const double at = std::clamp(along(a) + share * (along(b) - along(a)), 0.0, width);
    const Point crossing = between(left, right, at / width);
    return distance(a, crossing) + distance(crossing, b);
  }

  // The ways that leave the triangle of `node` through its edge, between left and right.
  void push(const Node& node) {
    if (!open(node.triangle, node.edge)) return;
    Node next = node;
    next.triangle = scene_.neighbor(node.triangle, node.edge);
    next.edge = 0;
    while (scene_.neighbor(next.triangle, next.edge) != node.triangle) ++next.edge;
    next.bound = next.length + through(next.root, next.left, next.right, to_);
    queue_.push(next);
  }

  // Ways that bend at an end of the interval, where that is a corner.
  void push_bent(const Node& node, const Point& end, const Side& side) {
    if (!is_corner(end) || !(distance(side.left, side.right) > kRounding)) return;
    const double length = node.length + distance(node.root, end);
    if (outdated(end, length)) return;
    double& least = corners_[key(end)];
    least = std::min(least, length);
    push({node.triangle, side.edge, side.left, side.right, end, length, 0});
  }

  // Whether the triangle is entered for the first time beside this root, or on a shorter way: around a vertex that is
  // no corner ways would go for ever.
  bool first_around(const Node& node) {
    const auto [before, first] = around_.emplace(std::tuple(key(node.root), node.triangle, node.edge), node.length);
    if (!first && !(node.length < before->second)) return false;
    before->second = node.length;
    return true;
  }

  // The other two edges of the node's triangle, in the order in which one sees them who comes in.
  std::array<Side, 2> sides(const Node& node) const {
    const auto [first, last] = ends(node.triangle, node.edge);
    const Point top = local_point(scene_.corner(node.triangle, (node.edge + 2) % 3));
    return {Side{(node.edge + 2) % 3, first, top}, Side{(node.edge + 1) % 3, top, last}};
  }

  void expand(const Node& node) {
    const double twice = area(node.left, node.right, node.root);
    if (std::abs(twice) <= kRounding * (1 + distance(node.left, node.right))) return expand_along(node);
    for (const Side& side : sides(node)) expand_side(node, side);
  }

  // The root lies on the line of the interval: from its nearest place all of the triangle is seen.
  void expand_along(const Node& node) {
    const bool left = distance(node.root, node.left) < distance(node.root, node.right);
    const double apart = through(node.root, node.left, node.right, node.root) / 2;
    if (apart <= kRounding && !first_around(node)) return;
    for (const Side& side : sides(node)) {
      if (apart <= kRounding) {
        push({node.triangle, side.edge, side.left, side.right, node.root, node.length, 0});
      } else {
        push_bent(node, left ? node.left : node.right, side);
      }
    }
  }

  // What lies to the left of what the root sees through the interval, that itself, and what lies to its right.
  void expand_side(const Node& node, const Side& side) {
    const auto& [edge, a, b] = side;
    const auto beside = [&](const Point& end, const Point& p) { return area(node.root, end, p); };
    const double begin = positive_share(beside(node.left, a), beside(node.left, b));
    const double end = std::max(begin, positive_share(beside(node.right, a), beside(node.right, b)));
    const Point left = begin <= 0 ? a : begin >= 1 ? b : between(a, b, begin);
    const Point right = end <= 0 ? a : end >= 1 ? b : between(a, b, end);
    if (begin > 0) push_bent(node, node.left, {edge, a, left});
    if (begin < end && distance(left, right) > kRounding) {
      push({node.triangle, edge, left, right, node.root, node.length, 0});
    }
    if (end < 1) push_bent(node, node.right, {edge, right, b});
  }

  const krait::Scene& scene_;
  float least_width_;
  Point to_;
  std::unordered_map<std::uint64_t, double> corners_;               // and the shortest known way to each
  std::map<std::tuple<std::uint64_t, Index, int>, double> around_;  // lengths to roots beside entered edges
  std::priority_queue<Node> queue_;
};

}  // namespace

double shortest_way(const krait::Scene& scene, float least_width, Vec2 from, Vec2 to) {
  const Index begin = detail::locate(scene, from);
  const Index end = detail::locate(scene, to);
  if (begin == kNone || end == kNone) return std::numeric_limits<double>::quiet_NaN();
  return Polyanya(scene, least_width).length(begin, local_point(from), end, local_point(to));
}

}  // namespace krait::host
