// SPDX-License-Identifier: Apache-2.0
#include "host/run/goal_room.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "host/run/depth.hpp"
#include "host/run/own_check.hpp"
#include "host/run/query.hpp"
#include "host/workspace/ring.hpp"

namespace krait::host {
namespace {

constexpr std::size_t kMostCells = 10'000;
constexpr std::size_t kMostBodies = 3;
constexpr double kRounding = 2e-4;   // metres: by how much float may misplace a body in a check
constexpr double kLeastArea = 1e-6;  // square metres, twice: what a body smaller than that meets says nothing
constexpr double kDiagonal = std::numbers::sqrt2;

// Without its last trailers.
RobotSpec with_bodies(RobotSpec robot, std::size_t count) {
  robot.links = static_cast<int>(count) - 1;
  robot.bodies.resize(count);
  return robot;
}

// The convex body with its border moved in; empty where nothing is left.
Ring inner_of(const Ring& body, double by) {
  Ring inner = deep_part(body, body, by);
  return twice_area(inner) < kLeastArea ? Ring{} : inner;
}

// Metres, of the body's farthest corner from the point that its pose places.
double lever_of(const Ring& body) {
  double lever = 0;
  for (const Point& corner : body) lever = std::max(lever, std::hypot(corner.x, corner.y));
  return lever;
}

// A robot at rest, and its collision check, which points to it.
class Standing {
 public:
  Standing(const RobotSpec& robot, const krait::Scene& scene, const Parameters& parameters)
      : core_(robot),
        check_(core_.view(), scene, parameters),
        angles_(static_cast<std::size_t>(robot.links)),
        state_(static_cast<std::size_t>(core_.view().state_size())) {}
  Standing(const Standing&) = delete;
  Standing& operator=(const Standing&) = delete;

  // Trailers beyond those of the robot do not count.
  Contact contact(Vec2 place, double heading, const std::vector<double>& bends) {
    double behind = heading;
    for (std::size_t i = 0; i < angles_.size(); ++i) angles_[i] = static_cast<float>(behind += bends[i]);
    const auto trailers = static_cast<std::uint32_t>(angles_.size());
    (void)core_.view().rest(place, static_cast<float>(heading), angles_.data(), trailers, state_.data());
    return check_.contact(state_.data());
  }

 private:
  CoreRobot core_;
  OwnCheck check_;
  std::vector<float> angles_;
  std::vector<float> state_;
};

// A cell's middle; all cells of one round have one size.
struct Cell {
  Vec2 place;
  double heading;
  std::vector<double> bends;  // of the hitches
};

class Bisection {
 public:
  // Of the robot's first bodies, which are so many.
  Bisection(const krait::Scene& scene, const SearchRequest& request, double by, std::size_t bodies)
      : scene_(scene),
        request_(request),
        goal_(resolve_goal(scene, request)),
        robot_(with_bodies(request.robot, bodies)),
        hitch_length_(bodies > 1 ? robot_.parameters.at("hitch_length") : 0) {
    if (by > 0) robot_ = moved_in([by](std::size_t) { return by; });
    for (const Ring& body : robot_.bodies) levers_.push_back(lever_of(body));
  }

  GoalRoom run() {
    if (robot_.bodies.empty()) return {};
    cells_ = whole_goal();
    Standing whole(robot_, scene_, request_.parameters);
    for (std::size_t looked_at = 0; looked_at + cells_.size() <= kMostCells;) {
      looked_at += cells_.size();
      look_for_room(whole);
      if (room_.found) return room_;
      leave_what_may_have_room();
      room_.none = cells_.empty();
      if (room_.none) return room_;
      divide();
    }
    return room_;
  }

 private:
  // One cell for each of the headings that are asked for, around all of the goal.
  std::vector<Cell> whole_goal() {
    const Box box = goal_.box(scene_);
    const Vec2 size = box.max - box.min, middle = 0.5F * (box.min + box.max);
    half_side_ = 0.5 * static_cast<double>(std::max(size.x, size.y));
    half_turn_ = request_.facing ? request_.facing->tolerance : std::numbers::pi;
    half_bends_.assign(trailers(), trailers() > 0 ? *request_.facing->hitches : 0);
    const double heading = request_.facing ? request_.facing->heading : 0;
    const std::vector<double> straight(trailers());
    std::vector<Cell> cells = {{middle, heading, straight}};
    if (request_.facing && request_.facing->either_way) cells.push_back({middle, heading + std::numbers::pi, straight});
    return cells;
  }

  std::size_t trailers() const { return robot_.bodies.size() - 1; }

  // With each body's border moved in by so much, as far as the first body of which nothing is left.
  template <class By>
  RobotSpec moved_in(By by) const {
    RobotSpec inner = robot_;
    std::size_t left = 0;
    for (; left < inner.bodies.size(); ++left) {
      inner.bodies[left] = inner_of(inner.bodies[left], by(left));
      if (inner.bodies[left].empty()) break;
    }
    return with_bodies(inner, left);
  }

  // Metres that a point of body k moves at most within a cell as headings and hitches turn.
  double swing(std::size_t k) const {
    double sum = 0, turn = half_turn_;
    for (std::size_t i = 0; i < k; ++i) sum += hitch_length_ * (turn += half_bends_[i]);
    return sum + levers_[k] * turn;
  }

  // Metres, of the last body's farthest point from the axle of body k.
  double lever(std::size_t k) const { return hitch_length_ * static_cast<double>(trailers() - k) + levers_.back(); }

  void look_for_room(Standing& whole) {
    for (const Cell& cell : cells_) {
      if (!goal_.near(scene_, cell.place, 0.0F)) continue;
      const Contact contact = whole.contact(cell.place, cell.heading, cell.bends);
      if (room_.poses++ == 0) room_.at_middle = contact;
      room_.found = contact.kind == ContactKind::none;
      if (room_.found) return;
    }
  }

  void leave_what_may_have_room() {
    const double radius = kDiagonal * half_side_;
    std::erase_if(cells_, [&](const Cell& cell) {
      return !goal_.near(scene_, cell.place, static_cast<float>(radius + kRounding));
    });
    const RobotSpec inner = moved_in([&](std::size_t k) { return radius + swing(k) + kRounding; });
    if (inner.bodies.empty()) return;
    Standing within(inner, scene_, request_.parameters);
    std::erase_if(cells_, [&](const Cell& cell) {
      return within.contact(cell.place, cell.heading, cell.bends).kind != ContactKind::none;
    });
  }

  // Quarters cells by place, or halves them by the heading or by the bend, whichever the robot moves most by.
  void divide() {
    const double by_place = kDiagonal * half_side_, by_turn = half_turn_ * lever(0);
    std::size_t most = 0;
    double by_bend = 0;
    for (std::size_t i = 0; i < trailers(); ++i) {
      const double moved = half_bends_[i] * lever(i + 1);
      if (moved > by_bend) most = i, by_bend = moved;
    }
    if (by_place >= std::max(by_turn, by_bend)) return quarter();
    if (by_turn >= by_bend) return halve(half_turn_, [](Cell& cell) -> double& { return cell.heading; });
    halve(half_bends_[most], [most](Cell& cell) -> double& { return cell.bends[most]; });
  }

  void quarter() {
    half_side_ /= 2;
    const auto half = static_cast<float>(half_side_);
    std::vector<Cell> parts;
    for (const Cell& cell : cells_) {
      for (const Vec2 by : {Vec2{half, half}, Vec2{-half, half}, Vec2{half, -half}, Vec2{-half, -half}})
        parts.push_back({cell.place + by, cell.heading, cell.bends});
    }
    cells_ = std::move(parts);
  }

  // Every cell by one of its angles, of which a cell has `half` radians to each side.
  template <class Angle>
  void halve(double& half, Angle angle) {
    half /= 2;
    std::vector<Cell> parts;
    for (const Cell& cell : cells_) {
      for (const double by : {half, -half}) angle(parts.emplace_back(cell)) += by;
    }
    cells_ = std::move(parts);
  }

  const krait::Scene& scene_;
  const SearchRequest& request_;
  krait::Goal goal_;
  RobotSpec robot_;                 // no bodies: nothing is left of body 0
  double hitch_length_;             // metres
  std::vector<double> levers_;      // metres, by body
  double half_side_ = 0;            // metres, of every cell
  double half_turn_ = 0;            // radians
  std::vector<double> half_bends_;  // radians, by hitch
  std::vector<Cell> cells_;
  GoalRoom room_;
};

// Trailers may stand anywhere where their hitches are not asked for.
std::size_t bodies_in_goal(const SearchRequest& request) {
  const bool straight = request.facing && request.facing->hitches;
  return straight ? std::min(request.robot.bodies.size(), kMostBodies) : 1;
}

}  // namespace

GoalRoom room_in_goal(const krait::Scene& scene, const SearchRequest& request, double moved_in) {
  GoalRoom room;
  for (std::size_t bodies = 1; bodies <= bodies_in_goal(request); ++bodies) {
    room = Bisection(scene, request, moved_in, bodies).run();
    if (room.none) break;
  }
  return room;
}

}  // namespace krait::host
