// SPDX-License-Identifier: Apache-2.0
#include "host/verify/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/verify/bodies.hpp"
#include "host/verify/verify.hpp"

namespace krait::host {
namespace {

constexpr double kTouch = 1e-9;  // m

// The convex hull of a body in the poses from `first` to `last`.
Convex swept(const Ring& shape, const std::vector<Pose>& poses, std::size_t body, std::size_t first, std::size_t last) {
  Ring points;
  for (std::size_t i = first; i <= last; ++i) {
    for (const Point& point : shape) points.push_back(poses[i][body].place(point));
  }
  return hull_of(points);
}

// The hull of a body in two poses, seen from another body that moves too.
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
      radii_(radii_of(robot)),
      failed_(robot.bodies.size()),
      clearance_(kLargestClearance),
      self_clearance_(std::numeric_limits<double>::infinity()) {
  for (const Ring& body : robot.bodies) shapes_.push_back(hull_of(body));
}

void Sweep::check_pose(const std::string& where, const State& state) { check_between(where, state, state); }

void Sweep::check_between(const std::string& where, const State& from, const State& to) {
  const std::vector<Pose> poses{dynamics_.frames(from), dynamics_.frames(to)};
  check_way({where, poses, 0});
}

void Sweep::check_leg(const std::string& where, const Leg& leg, double time) {
  stray_ = std::max(stray_, leg.stray);
  check_way({where, leg.poses, time / static_cast<double>(leg.poses.size() - 1)});
}

std::string Sweep::Way::body(std::size_t index, std::size_t body) const {
  const std::string at = sub_step > 0 ? " at " + text(static_cast<double>(index) * sub_step) + " s" : "";
  return where + at + ": body " + text(body);
}

void Sweep::check_way(const Way& way) {
  for (std::size_t body = 0; body < robot_.bodies.size(); ++body) {
    check_obstacles(way, body, 0, way.poses.size() - 1);
  }
  for_each_pair(dynamics_, [&](std::size_t first, std::size_t second) { check_pair(way, first, second); });
}

// The hull of many poses covers those of any two of them: where it is no nearer to anything than the least clearance
// so far, none of them has to be looked at.
void Sweep::check_obstacles(const Way& way, std::size_t body, std::size_t first, std::size_t last) {
  const Convex hull = swept(robot_.bodies[body], way.poses, body, first, last);
  if (last - first == 1) {
    measure(way, body, first, hull);
  } else if (!is_clear(hull)) {
    const std::size_t middle = first + (last - first) / 2;
    check_obstacles(way, body, first, middle);
    check_obstacles(way, body, middle, last);
  }
}

bool Sweep::is_clear(const Convex& hull) const {
  if (obstacles_.room(hull) < std::max(clearance_, 0.0)) return false;
  const double reach = std::max(clearance_, kTouch);
  return obstacles_.nearest(hull, reach).distance >= reach;
}

void Sweep::measure(const Way& way, std::size_t body, std::size_t index, const Convex& hull) {
  const double room = obstacles_.room(hull);
  clearance_ = std::min(clearance_, room);
  if (room < 0) return fail(way, body, index, {" is up to ", -room, " m outside the bounds"});
  const Contact contact = obstacles_.nearest(hull, std::max(clearance_, kTouch));
  clearance_ = std::min(clearance_, contact.distance);
  if (contact.distance > 0) return;
  fail(way, body, index, {" overlaps " + contact.obstacle + " by up to ", contact.overlap, " m"});
}

void Sweep::check_pair(const Way& way, std::size_t first, std::size_t second) {
  if (are_apart(way, first, second)) return;
  for (std::size_t i = 0; i + 1 < way.poses.size(); ++i) measure_pair(way, first, second, i);
}

// Whether two bodies stay further apart than any distance that counts, by the way that their frames go.
bool Sweep::are_apart(const Way& way, std::size_t first, std::size_t second) const {
  double moved = 0;
  for (std::size_t i = 0; i + 1 < way.poses.size(); ++i) {
    moved += gap(way.poses[i][first], way.poses[i + 1][first]) + gap(way.poses[i][second], way.poses[i + 1][second]);
  }
  return gap(way.poses[0][first], way.poses[0][second]) - moved > pair_reach(first, second);
}

void Sweep::measure_pair(const Way& way, std::size_t first, std::size_t second, std::size_t index) {
  const Pose& from = way.poses[index];
  const Pose& to = way.poses[index + 1];
  const double moved = gap(from[first], to[first]) + gap(from[second], to[second]);
  if (gap(from[first], from[second]) - moved > pair_reach(first, second)) return;
  const Convex hull = swept_relative(robot_.bodies[second], from[second], to[second], from[first], to[first]);
  const double distance = boost::geometry::distance(shapes_[first], hull);
  self_clearance_ = std::min(self_clearance_, distance);
  if (distance > 0) return;
  fail(way, first, index, {" meets body " + text(second), {}, {}});
}

double Sweep::pair_reach(std::size_t first, std::size_t second) const {
  return radii_[first] + radii_[second] + std::max(self_clearance_, kTouch);
}

void Sweep::fail(const Way& way, std::size_t body, std::size_t index, const Failure& failure) {
  std::optional<Failed>& failed = failed_[body];
  if (!failed) {
    const std::string line = way.body(index, body) + failure.before;
    failed = {failure.before, complaints_.add_lasting({line, failure.amount, failure.after})};
  } else if (failed->before == failure.before) {
    complaints_.raise(failed->complaint, failure.amount.value_or(0));
  }
}

}  // namespace krait::host
