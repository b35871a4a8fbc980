#include "host/verify/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/verify/verify.hpp"

namespace krait::host {
namespace {

constexpr std::size_t kSubSteps = 8;
constexpr std::size_t kMostSubSteps = 512;
constexpr double kSweepError = 2e-5;  // m, well below the clearance that a planner keeps
constexpr double kMostTurn = 0.5;     // rad between two poses: more could hide whole turns
constexpr double kTouch = 1e-9;       // m

bool all_finite(const State& state) {
  return std::all_of(state.begin(), state.end(), [](double value) { return std::isfinite(value); });
}

double radius_of(const Ring& body) {
  double radius = 0;
  for (const Point& point : body) radius = std::max(radius, std::hypot(point.x, point.y));
  return radius;
}

double gap(const Frame& a, const Frame& b) { return std::hypot(a.origin.x - b.origin.x, a.origin.y - b.origin.y); }

// How far the middle of a path lies from that of its chord.
double bend(const Point& a, const Point& middle, const Point& b) {
  return std::hypot(middle.x - (a.x + b.x) / 2, middle.y - (a.y + b.y) / 2);
}

// How far two bodies' frames have come.
double travel(const std::vector<Frame>& from, const std::vector<Frame>& to, std::size_t first, std::size_t second) {
  return gap(from[first], to[first]) + gap(from[second], to[second]);
}

// The convex hull of a body in two poses.
Convex swept(const Ring& body, const Frame& from, const Frame& to) {
  Ring points;
  for (const Point& point : body) {
    points.push_back(from.place(point));
    points.push_back(to.place(point));
  }
  return hull_of(points);
}

// The same, seen from another body that moves too.
Convex swept_relative(const Ring& body, const Frame& from, const Frame& to, const Frame& seen_from,
                      const Frame& seen_to) {
  Ring points;
  for (const Point& point : body) {
    points.push_back(seen_from.inverse(from.place(point)));
    points.push_back(seen_to.inverse(to.place(point)));
  }
  return hull_of(points);
}

}  // namespace

Sweep::Sweep(const RobotSpec& robot, const Dynamics& dynamics, const Obstacles& obstacles, Complaints& complaints)
    : robot_(robot),
      dynamics_(dynamics),
      obstacles_(obstacles),
      complaints_(complaints),
      clearance_(kLargestClearance),
      self_clearance_(std::numeric_limits<double>::infinity()) {
  for (const Ring& body : robot.bodies) {
    shapes_.push_back(hull_of(body));
    radii_.push_back(radius_of(body));
  }
}

// Pairs of bodies that must not meet.
template <typename Visit>
void Sweep::for_each_pair(const Visit& visit) const {
  const std::size_t apart = dynamics_.self_collision_gap();
  for (std::size_t first = 0; apart > 0 && first < robot_.bodies.size(); ++first) {
    for (std::size_t second = first + apart; second < robot_.bodies.size(); ++second) visit(first, second);
  }
}

void Sweep::check_pose(const State& state) {
  const Pose pose = dynamics_.frames(state);
  check_hulls("start", {pose, pose}, 0);
}

void Sweep::check_step(std::size_t index, const State& from, const Control& control, double time, const State& to) {
  const std::string step = "step " + text(index);
  std::size_t count = kSubSteps;
  Path cut = path(from, control, time, count);
  while (!(cut.error <= kSweepError) && count < kMostSubSteps) {
    count *= 2;
    cut = path(from, control, time, count);
  }
  if (!(cut.error <= kSweepError)) {
    complaints_.add(step + ": moves too far to be checked between its poses");
    check_hulls(step, {dynamics_.frames(to), dynamics_.frames(to)}, 0);
    return;
  }
  sweep_error_ = std::max(sweep_error_, cut.error);
  cut.poses.push_back(dynamics_.frames(to));
  check_hulls(step, cut.poses, time / static_cast<double>(count));
}

Sweep::Path Sweep::path(const State& from, const Control& control, double time, std::size_t count) const {
  const std::vector<State> states = dynamics_.integrate(from, control, time, count);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const bool usable = all_finite(states[i]) && (i == 0 || most_turn(states[i - 1], states[i]) <= kMostTurn);
    if (!usable) return {{}, std::numeric_limits<double>::infinity()};
    poses.push_back(dynamics_.frames(states[i]));
  }
  const double error = chord_error(poses);
  return {std::move(poses), error};
}

double Sweep::most_turn(const State& from, const State& to) const {
  double most = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (dynamics_.is_heading(i)) most = std::max(most, std::abs(to[i] - from[i]));
  }
  return most;
}

// A smooth path strays from its chord by a quarter when the chord is halved; over the double chord it is seen at the
// pose in the middle. The distance is convex in the point of the body, so that its corners suffice.
double Sweep::chord_error(const std::vector<Pose>& poses) const {
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
  return worst / 4;
}

// The same for bodies as others see them that may come to meet them.
double Sweep::relative_bend(const Pose& before, const Pose& middle, const Pose& after) const {
  double worst = 0;
  for_each_pair([&](std::size_t first, std::size_t second) {
    if (gap(middle[first], middle[second]) - travel(before, after, first, second) > radii_[first] + radii_[second]) {
      return;
    }
    for (const Point& corner : robot_.bodies[second]) {
      worst = std::max(worst, bend(before[first].inverse(before[second].place(corner)),
                                   middle[first].inverse(middle[second].place(corner)),
                                   after[first].inverse(after[second].place(corner))));
    }
  });
  return worst;
}

void Sweep::check_hulls(const std::string& step, const std::vector<Pose>& poses, double time) {
  std::vector<bool> failed(robot_.bodies.size(), false);
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const std::string where =
        time > 0 ? step + " at " + text(static_cast<double>(i) * time) + " s: body " : step + ": body ";
    for (std::size_t body = 0; body < failed.size(); ++body) {
      if (!failed[body]) failed[body] = !check_obstacles(where, body, poses[i], poses[i + 1]);
    }
    for_each_pair([&](std::size_t first, std::size_t second) {
      if (failed[first] || failed[second]) return;
      failed[first] = !check_self(where, first, second, poses[i], poses[i + 1]);
    });
  }
}

bool Sweep::check_obstacles(const std::string& where, std::size_t body, const Pose& from, const Pose& to) {
  const Convex hull = swept(robot_.bodies[body], from[body], to[body]);
  const double room = obstacles_.room(hull);
  clearance_ = std::min(clearance_, room);
  if (room < 0) {
    complaints_.add(where + text(body) + " is " + text(-room) + " m outside the bounds");
    return false;
  }
  const Contact contact = obstacles_.nearest(hull, std::max(clearance_, kTouch));
  clearance_ = std::min(clearance_, contact.distance);
  if (contact.distance > 0) return true;
  complaints_.add(where + text(body) + " overlaps " + contact.obstacle + " by " + text(contact.overlap) + " m");
  return false;
}

bool Sweep::check_self(const std::string& where, std::size_t first, std::size_t second, const Pose& from,
                       const Pose& to) {
  const double reach = radii_[first] + radii_[second] + std::max(self_clearance_, kTouch);
  if (gap(from[first], from[second]) - travel(from, to, first, second) > reach) return true;
  const Convex hull = swept_relative(robot_.bodies[second], from[second], to[second], from[first], to[first]);
  const double distance = boost::geometry::distance(shapes_[first], hull);
  self_clearance_ = std::min(self_clearance_, distance);
  if (distance > 0) return true;
  complaints_.add(where + text(first) + " meets body " + text(second));
  return false;
}

}  // namespace krait::host
