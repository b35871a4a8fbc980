// SPDX-License-Identifier: Apache-2.0
#include "host/verify/drive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/verify/bodies.hpp"

namespace krait::host {
namespace {

constexpr std::size_t kFewestSubSteps = 4;
constexpr std::size_t kMostSubSteps = 16384;
constexpr double kStray = 2e-5;      // m, well below the clearance that a planner keeps
constexpr double kMostTurn = 0.5;    // rad between two poses: more could hide whole turns
constexpr double kAgreement = 1e-9;  // m, rad, m/s, rad/s

bool all_finite(const State& state) {
  return std::all_of(state.begin(), state.end(), [](double value) { return std::isfinite(value); });
}

// How far the middle of a path lies from that of its chord.
double bend(const Point& a, const Point& middle, const Point& b) {
  return distance(middle, {(a.x + b.x) / 2, (a.y + b.y) / 2});
}

// Up to the rounding of `count` sums of eight terms, half a unit in the last place each.
bool agree(const State& a, const State& b, std::size_t count) {
  const double rounding = 4 * static_cast<double>(count) * std::numeric_limits<double>::epsilon();
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(std::abs(a[i] - b[i]) <= kAgreement + rounding * std::abs(a[i]))) return false;
  }
  return true;
}

}  // namespace

Drive::Drive(const RobotSpec& robot, const Dynamics& dynamics)
    : robot_(robot), dynamics_(dynamics), radii_(radii_of(robot)) {}

std::optional<Leg> Drive::leg(const State& from, const Control& control, double time) const {
  State coarse = dynamics_.integrate(from, control, time, kFewestSubSteps / 2).back();
  for (std::size_t count = kFewestSubSteps; count <= kMostSubSteps; count *= 2) {
    Leg leg = cut(from, control, time, count);
    if (leg.stray <= kStray && agree(leg.states.back(), coarse, count)) return leg;
    coarse = std::move(leg.states.back());
  }
  return {};
}

// Without poses, and infinitely far astray, where the states are too far apart to be looked at.
Leg Drive::cut(const State& from, const Control& control, double time, std::size_t count) const {
  Leg leg;
  leg.states = dynamics_.integrate(from, control, time, count);
  leg.stray = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < leg.states.size(); ++i) {
    if (!all_finite(leg.states[i])) return leg;
    if (i > 0 && most_turn(leg.states[i - 1], leg.states[i]) > kMostTurn) return leg;
  }
  for (const State& state : leg.states) leg.poses.push_back(dynamics_.frames(state));
  leg.stray = stray(leg.poses);
  return leg;
}

double Drive::most_turn(const State& from, const State& to) const {
  double most = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (dynamics_.is_angle(i)) most = std::max(most, std::abs(to[i] - from[i]));
  }
  return most;
}

// A smooth path strays from its chord by a quarter when the chord is halved; over the double chord it is seen at the
// pose in the middle. The distance is convex in the point of the body, so that its corners suffice. A quarter more is
// kept in reserve, since the acceleration at the ends of the path is not quite that around the next pose.
double Drive::stray(const std::vector<Pose>& poses) const {
  double worst = 0;
  for (std::size_t i = 1; i + 1 < poses.size(); ++i) {
    for (std::size_t body = 0; body < robot_.bodies.size(); ++body) {
      for (const Point& corner : robot_.bodies[body]) {
        worst = std::max(worst, bend(poses[i - 1][body].place(corner), poses[i][body].place(corner),
                                     poses[i + 1][body].place(corner)));
      }
    }
    worst = std::max(worst, relative_bend(poses[i - 1], poses[i], poses[i + 1]));
  }
  return 1.25 * worst / 4;
}

// The same for bodies as others see them that may come to meet them.
double Drive::relative_bend(const Pose& before, const Pose& middle, const Pose& after) const {
  double worst = 0;
  for_each_pair(dynamics_, [&](std::size_t first, std::size_t second) {
    const double moved = gap(before[first], after[first]) + gap(before[second], after[second]);
    if (gap(middle[first], middle[second]) - moved > radii_[first] + radii_[second]) return;
    for (const Point& corner : robot_.bodies[second]) {
      worst = std::max(worst, bend(before[first].inverse(before[second].place(corner)),
                                   middle[first].inverse(middle[second].place(corner)),
                                   after[first].inverse(after[second].place(corner))));
    }
  });
  return worst;
}

}  // namespace krait::host
