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
constexpr double kRounding = 2e-4;   // metres: by how much float may misplace a body in a check
constexpr double kLeastArea = 1e-6;  // square metres, twice: what a body smaller than that meets says nothing
constexpr double kDiagonal = std::numbers::sqrt2;

// Of body 0 alone, which needs no trailers.
RobotSpec lead_of(RobotSpec robot) {
  robot.links = 0;
  robot.bodies.resize(1);
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

// A robot and its collision check, which points to it.
class Body {
 public:
  Body(const RobotSpec& lead, const krait::Scene& scene, const Parameters& parameters)
      : core_(lead),
        check_(core_.view(), scene, parameters),
        state_(static_cast<std::size_t>(core_.view().state_size())) {}
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  Contact contact(Vec2 place, double heading) {
    (void)core_.view().rest(place, static_cast<float>(heading), nullptr, 0, state_.data());
    return check_.contact(state_.data());
  }
  bool meets(Vec2 place, double heading) { return contact(place, heading).kind != ContactKind::none; }

 private:
  CoreRobot core_;
  OwnCheck check_;
  std::vector<float> state_;
};

// A cell's middle; all cells of one round have one size.
struct Cell {
  Vec2 place;
  double heading;
};

class Bisection {
 public:
  Bisection(const krait::Scene& scene, const SearchRequest& request, double by)
      : scene_(scene), request_(request), goal_(resolve_goal(scene, request)), lead_(lead_of(request.robot)) {
    if (by > 0) lead_.bodies[0] = inner_of(lead_.bodies[0], by);
  }

  GoalRoom run() {
    if (lead_.bodies[0].empty()) return {};
    cells_ = whole_goal();
    Body whole(lead_, scene_, request_.parameters);
    lever_ = lever_of(lead_.bodies[0]);
    for (std::size_t looked_at = 0; looked_at + cells_.size() <= kMostCells;) {
      looked_at += cells_.size();
      look_for_room(whole);
      if (room_.found) return room_;
      leave_what_may_have_room();
      room_.none = cells_.empty();
      if (room_.none) return room_;
      quarter();
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
    const double heading = request_.facing ? request_.facing->heading : 0;
    std::vector<Cell> cells = {{middle, heading}};
    if (request_.facing && request_.facing->either_way) cells.push_back({middle, heading + std::numbers::pi});
    return cells;
  }

  void look_for_room(Body& whole) {
    for (const Cell& cell : cells_) {
      if (!goal_.near(scene_, cell.place, 0.0F)) continue;
      const Contact contact = whole.contact(cell.place, cell.heading);
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
    RobotSpec inner = lead_;
    inner.bodies[0] = inner_of(lead_.bodies[0], radius + half_turn_ * lever_ + kRounding);
    if (inner.bodies[0].empty()) return;
    Body body(inner, scene_, request_.parameters);
    std::erase_if(cells_, [&](const Cell& cell) { return body.meets(cell.place, cell.heading); });
  }

  // Quarters cells by place or halves them by heading, whichever a body moves more by.
  void quarter() {
    const bool turns = half_turn_ * lever_ > kDiagonal * half_side_;
    (turns ? half_turn_ : half_side_) /= 2;
    std::vector<Cell> parts;
    for (const Cell& cell : cells_) {
      for (int i = 0; i < (turns ? 2 : 4); ++i) parts.push_back(part(cell, turns, i));
    }
    cells_ = std::move(parts);
  }

  Cell part(const Cell& cell, bool turns, int i) const {
    const double aside = (i & 1) == 0 ? 1 : -1, up = (i & 2) == 0 ? 1 : -1;
    if (turns) return {cell.place, cell.heading + aside * half_turn_};
    const Vec2 by{static_cast<float>(aside * half_side_), static_cast<float>(up * half_side_)};
    return {cell.place + by, cell.heading};
  }

  const krait::Scene& scene_;
  const SearchRequest& request_;
  krait::Goal goal_;
  RobotSpec lead_;
  double lever_ = 0;
  double half_side_ = 0;  // metres, of every cell
  double half_turn_ = 0;  // radians
  std::vector<Cell> cells_;
  GoalRoom room_;
};

}  // namespace

GoalRoom room_in_goal(const krait::Scene& scene, const SearchRequest& request, double moved_in) {
  return Bisection(scene, request, moved_in).run();
}

}  // namespace krait::host
