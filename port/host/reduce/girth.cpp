// SPDX-License-Identifier: Apache-2.0
#include "host/reduce/girth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/workspace/ring.hpp"

namespace krait::host {
namespace {

struct Disc {
  Point center;
  double radius = 0;
};

// The centres of the discs of this radius in a convex ring, counter-clockwise.
Ring centers(const Ring& body, double radius) {
  Ring ring = body;
  for (std::size_t i = 0; i < body.size() && !ring.empty(); ++i) {
    const Point a = body[i], b = body[(i + 1) % body.size()];
    const double edge = std::hypot(b.x - a.x, b.y - a.y);
    ring = clip(ring, [&](Point p) { return cross(a, b, p) / edge - radius; });
  }
  return ring;
}

Point middle(const Ring& ring) {
  Point sum;
  for (const Point p : ring) sum = {sum.x + p.x, sum.y + p.y};
  return {sum.x / double(ring.size()), sum.y / double(ring.size())};
}

// By bisection, a millionth of the body smaller than the largest at most.
Disc largest_disc(const Ring& body) {
  double fits = 0, most = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < body.size(); ++i) {
    const Point a = body[i], b = body[(i + 1) % body.size()];
    double height = 0;
    for (const Point p : body) height = std::max(height, cross(a, b, p) / std::hypot(b.x - a.x, b.y - a.y));
    most = std::min(most, height / 2);
  }
  Disc best{middle(body), 0};
  for (int step = 0; step < 20; ++step) {
    const double radius = (fits + most) / 2;
    const Ring at = centers(body, radius);
    (at.empty() ? most : fits) = radius;
    if (!at.empty()) best = {middle(at), radius};
  }
  return best;
}

}  // namespace

Girth girth_of(const RobotSpec& robot) {
  Girth girth{std::numeric_limits<double>::infinity(), 0, 0};
  const double hitch = robot.links > 0 ? robot.parameters.at("hitch_length") : 0;
  for (std::size_t k = 0; k < robot.bodies.size(); ++k) {
    const Disc disc = largest_disc(robot.bodies[k]);
    girth.inner = std::min(girth.inner, disc.radius);
    for (const Point p : robot.bodies[k])
      girth.outer = std::max(girth.outer, std::hypot(p.x - disc.center.x, p.y - disc.center.y));
    girth.spread = std::max(girth.spread, double(k) * hitch + std::hypot(disc.center.x, disc.center.y));
  }
  return girth;
}

}  // namespace krait::host
