// SPDX-License-Identifier: Apache-2.0
#include "host/rivals/rrt.hpp"

#include "host/rivals/rival.hpp"

namespace krait::rivals {

std::uint64_t RrtPlanner::bytes_required(const Scene& scene, const Robot& robot, const Limits& limits) {
  Arena counting;
  count(counting, scene, robot, limits);
  NearestPoints points;
  points.allocate(counting, scene, limits.vertices);
  return counting.needed();
}

Failure RrtPlanner::init(const Setup& setup, const Parameters& parameters, const Limits& limits) {
  if (!check_setup(setup, of_rival(parameters), limits).ok()) return failure();
  const auto required = [&](const Limits& any) { return bytes_required(*setup.scene, setup.robot, any); };
  const Failure failure = take_block(setup, required);
  if (failure.ok()) points_.allocate(arena_, *scene_, limits_.vertices);
  return failure;
}

Status RrtPlanner::start(const Query& query) {
  if (!usable()) return status();
  points_.clear();
  connecting_ = kNone;
  return begin(query, Keeper(*this));
}

Status RrtPlanner::advance(std::uint64_t iterations, const Watch& watch) {
  return advance_by(iterations, [&] { iterate(watch); });
}

bool RrtPlanner::keep(Index /*region*/, Branch branch, const float* state) {
  if (tree_.vertices_full()) return false;
  newest_ = tree_.add(branch, state);
  points_.insert(position(newest_));
  return true;
}

void RrtPlanner::iterate(const Watch& watch) {
  if (tree_.expansions_full()) {
    finish(Status::tree_full);
    return;
  }
  if (connecting_ == kNone) begin_connection();
  const Vec2 from = position(connecting_);
  const Expanded expanded = expand(connecting_, kNone, target_, watch);
  const bool goes_on = expanded.outcome == Outcome::target_not_reached && comes_closer(from);
  connecting_ = goes_on ? newest_ : kNone;
}

void RrtPlanner::begin_connection() {
  const bool to_goal = random_.unit() < rrt_.goal_share;
  const Vec2 point = to_goal ? regions_.random_goal_point(random_) : random_point_in_bounds();
  target_ = any_way_to(point, kPatience);
  connecting_ = points_.nearest(point);
}

}  // namespace krait::rivals
