// SPDX-License-Identifier: Apache-2.0
#include "sweep.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "judge.hpp"

namespace krait::campaign {
namespace {

constexpr std::size_t kMostHalvings = 40;
constexpr double kFinestTurn = 1e-5;  // of the limit: how far a hitch angle goes unseen

}  // namespace

Sweep::Sweep(const Equations& equations, std::vector<Convex> bodies, const Field& field)
    : equations_(equations), bodies_(std::move(bodies)), field_(field), left_(kMostHalvings + 1) {
  const int count = equations.bodies();
  for (int k = 0; k < count; ++k) {
    const Convex& body = bodies_[static_cast<std::size_t>(k)];
    const Placed at = placed(body, {0, 0, 1, 0});
    const double x = (at.box.left + at.box.right) / 2, y = (at.box.bottom + at.box.top) / 2;
    double radius = 0, farthest = 0;
    for (int i = 0; i < body.count; ++i) {
      radius = std::max(radius, std::hypot(body.x[i] - x, body.y[i] - y));
      farthest = std::max(farthest, std::hypot(body.x[i], body.y[i]));
    }
    middles_.push_back({x, y, 1, 0});
    radii_.push_back(radius);
    farthest_.push_back(farthest);
    all_.bodies.push_back(k);
    if (k > 0) all_.hitches.push_back(k);
    for (int j = k + equations.self_collision_gap(); j < count; ++j) all_.pairs.push_back({k, j});
  }
}

void Sweep::set(Pose& pose, const State& state) const {
  pose.state = state;
  equations_.place(state, pose.frames);
  pose.looked.fill(0);
}

void Sweep::begin(const State& state) {
  set(here_, state);
  for (int k = 0; k < equations_.bodies(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (field_.inside(placed(bodies_[i], here_.frames[i]))) meet(k, -1, 0);
    body_free(here_, here_, k, 0);
  }
  for (const Pair& pair : all_.pairs) pair_free(here_, here_, pair, 0);
  for (const int k : all_.hitches) hitch_within(here_, here_, k, 0);
}

void Sweep::go(const State& to, const double* u, double time, double step) {
  step_ = step;
  set(next_, to);
  prove(here_, next_, u, time, all_, 0);
  std::swap(here_, next_);
}

void Sweep::prove(Pose& a, Pose& b, const double* u, double time, const Open& open, std::size_t depth) {
  Reaches reaches;
  equations_.reach(a.state, a.frames, b.state, b.frames, u, time, reaches);
  const auto way = [&](int k) {
    const auto i = static_cast<std::size_t>(k);
    return reaches[i].path + farthest_[i] * reaches[i].turn;
  };
  Open& left = left_[depth];
  left.bodies.clear();
  left.pairs.clear();
  left.hitches.clear();
  for (const int k : open.bodies) {
    if (!body_free(a, b, k, way(k))) left.bodies.push_back(k);
  }
  for (const Pair& pair : open.pairs) {
    if (!pair_free(a, b, pair, way(pair.first) + way(pair.second))) left.pairs.push_back(pair);
  }
  for (const int k : open.hitches) {
    const auto i = static_cast<std::size_t>(k);
    if (!hitch_within(a, b, k, reaches[i - 1].turn + reaches[i].turn)) left.hitches.push_back(k);
  }
  if (left.none() || depth == kMostHalvings) return;
  Pose middle;
  set(middle, advanced(equations_, a.state, u, time / 2));
  prove(a, middle, u, time / 2, left, depth + 1);
  prove(middle, b, u, time / 2, left, depth + 1);
}

double Sweep::room(Pose& pose, int k, double reach) {
  const auto i = static_cast<std::size_t>(k);
  if (pose.looked[i] < reach && !(pose.looked[i] > 0 && pose.room[i] < pose.looked[i])) {
    pose.looked[i] = reach;
    pose.room[i] = field_.room(placed(bodies_[i], pose.frames[i]), reach);
    clearance_ = std::min(clearance_, pose.room[i]);
  }
  return pose.room[i];
}

// Whether the body, no point of which goes further than `way` from a to b, is proven free, or has been seen often
// enough.
bool Sweep::body_free(Pose& a, Pose& b, int k, double way) {
  const auto i = static_cast<std::size_t>(k);
  const Frame& f = a.frames[i];
  const double x = f.x + f.cos * middles_[i].x - f.sin * middles_[i].y;
  const double y = f.y + f.sin * middles_[i].x + f.cos * middles_[i].y;
  const double around = radii_[i] + way + kCare;
  if (field_.clear({x - around, y - around, x + around, y + around})) return true;
  const double needed = way + 2 * kCare;
  const double before = room(a, k, needed);
  if (before >= needed) return true;
  const double after = room(b, k, needed);
  if (before <= 0 || after <= 0) meet(k, -1, std::min(before, after));
  return before <= 0 || after <= 0 || before + after >= needed || way <= kCoarsest;
}

double Sweep::pair_room(const Pose& pose, const Pair& pair) const {
  const auto i = static_cast<std::size_t>(pair.first), j = static_cast<std::size_t>(pair.second);
  return apart(placed(bodies_[i], pose.frames[i]).shape, placed(bodies_[j], pose.frames[j]).shape);
}

// The same for two bodies that go no further than `way` together.
bool Sweep::pair_free(const Pose& a, const Pose& b, const Pair& pair, double way) {
  const auto i = static_cast<std::size_t>(pair.first), j = static_cast<std::size_t>(pair.second);
  const double dx = a.frames[i].x - a.frames[j].x, dy = a.frames[i].y - a.frames[j].y;
  const double far = farthest_[i] + farthest_[j] + way + kCare;
  if (dx * dx + dy * dy > far * far) return true;
  const double needed = way + 2 * kCare;
  const double before = pair_room(a, pair);
  clearance_ = std::min(clearance_, before);
  if (before >= needed) return true;
  const double after = pair_room(b, pair);
  clearance_ = std::min(clearance_, after);
  if (before <= 0 || after <= 0) meet(pair.first, pair.second, std::min(before, after));
  return before <= 0 || after <= 0 || before + after >= needed || way <= kCoarsest;
}

// Whether the angle before body k, which goes no further than `turn` from a to b, stays within its limit, or has been
// seen often enough.
bool Sweep::hitch_within(const Pose& a, const Pose& b, int k, double turn) {
  const double limit = equations_.max_hitch_angle();
  const double before = std::abs(equations_.hitch(a.state, k)), after = std::abs(equations_.hitch(b.state, k));
  hitch_excess_ = std::max(hitch_excess_, std::max(before, after) / limit - 1);
  return (before + after + turn) / 2 <= limit || turn <= kFinestTurn * limit || hitch_excess_ > kLimitShare;
}

void Sweep::meet(int body, int other, double room) {
  for (Contact& contact : contacts_) {
    if (contact.body != body || contact.other != other) continue;
    contact.depth = std::max(contact.depth, -room);
    return;
  }
  contacts_.push_back({body, other, step_, -room});
}

}  // namespace krait::campaign
