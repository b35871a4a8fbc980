// SPDX-License-Identifier: Apache-2.0
#include "robot_check/invariance.hpp"

#include <cmath>

#include "robot_check/answers.hpp"

namespace krait::detail::checking {
namespace {

// The plane turned about the origin, then shifted.
struct Move {
  const char* promise;
  double angle = 0;
  double dx = 0;
  double dy = 0;

  Point direction(double x, double y) const {
    return {std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y};
  }
  Point point(double x, double y) const {
    const Point turned = direction(x, y);
    return {turned.x + dx, turned.y + dy};
  }
};

std::vector<float> moved(const std::vector<float>& state, const Move& move, const std::vector<int>& headings) {
  std::vector<float> result = state;
  const Point at = move.point(static_cast<double>(state[0]), static_cast<double>(state[1]));
  result[0] = static_cast<float>(at.x);
  result[1] = static_cast<float>(at.y);
  for (const int i : headings) result[static_cast<std::size_t>(i)] += static_cast<float>(move.angle);
  return result;
}

constexpr const char* kAlike =
    "The robot must move alike there; if it need not, change `translation_invariant` and `headings` of the ranges.";

void check_derivative_moved(const Case& c, const Move& move, const std::vector<float>& there) {
  const std::vector<float> here = derivative_of(c.robot, c.sample.state, c.sample.control);
  const std::vector<float> got = derivative_of(c.robot, there, c.sample.control);
  Numbers expected(here.begin(), here.end());
  const Point velocity = move.direction(expected[0], expected[1]);
  expected[0] = velocity.x;
  expected[1] = velocity.y;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double off = std::abs(static_cast<double>(got[i]) - expected[i]);
    if (off <= 3e-5 * (1 + std::hypot(velocity.x, velocity.y) + std::abs(expected[i]))) continue;
    c.fault("derivative", move.promise, off,
            "at " + list(there) + " the rate of component " + std::to_string(i) + " is " +
                number(static_cast<double>(got[i])) + " and not " + number(expected[i]),
            kAlike);
  }
}

void check_place_moved(const Case& c, const Move& move, const std::vector<float>& there) {
  const std::vector<Frame> here = c.frames[0];
  const std::vector<Frame> got = frames_of(c.robot, there);
  for (std::size_t k = 0; k < here.size(); ++k) {
    const Point at = move.point(here[k].x, here[k].y);
    const Point along = move.direction(here[k].cos, here[k].sin);
    const double off = distance(at, origin(got[k])) + distance(along, {got[k].cos, got[k].sin});
    const double size = 1 + std::abs(at.x) + std::abs(at.y) + std::abs(here[k].x) + std::abs(here[k].y);
    if (off <= 1e-5 * size) continue;
    c.fault(
        "place", move.promise, off,
        "at " + list(there) + " the frame of " + body_number(k) + " is off by " + number(off) + " (metres and radians)",
        kAlike);
  }
}

void check_travel_moved(const Case& c, const Move& move, const std::vector<float>& there) {
  const Sample sample{there, c.sample.control, c.sample.dt};
  const std::vector<float> next = moved(c.next, move, move.angle != 0 ? c.ranges.headings : std::vector<int>{});
  const TravelAnswer here = travel_of(c.robot, c.sample, c.next, 0.0F);
  const TravelAnswer got = travel_of(c.robot, sample, next, 0.0F);
  for (std::size_t k = 0; k < got.bodies.size(); ++k) {
    const std::vector<float> a = numbers_of(here.bodies[k]);
    const std::vector<float> b = numbers_of(got.bodies[k]);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double off = std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
      if (!(off > 1e-4 * (1 + std::abs(static_cast<double>(a[i]))))) continue;
      c.fault("travel", move.promise, off,
              "at " + list(there) + " the bound of " + body_number(k) + " is " + list(b) + " and not " + list(a),
              kAlike);
    }
  }
}

void check_moved(const Case& c, const Move& move) {
  const std::vector<float> there =
      moved(c.sample.state, move, move.angle != 0 ? c.ranges.headings : std::vector<int>{});
  if (!nearly_within_limits(c.robot, there)) {
    c.fault("within_limits", move.promise, kInfinite, "the state " + list(there) + " is not within the limits", kAlike);
    return;
  }
  check_derivative_moved(c, move, there);
  check_place_moved(c, move, there);
  if (!c.next.empty()) check_travel_moved(c, move, there);
}

}  // namespace

void check_invariance(const Case& c, double angle) {
  if (c.ranges.translation_invariant) check_moved(c, Move{"anywhere", 0, 3.5, -2.25});
  if (!c.ranges.headings.empty()) check_moved(c, Move{"direction", angle});
}

}  // namespace krait::detail::checking
