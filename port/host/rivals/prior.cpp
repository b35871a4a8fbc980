// SPDX-License-Identifier: Apache-2.0
#include "host/rivals/prior.hpp"

#include "decomposition/locate.hpp"
#include "host/rivals/rival.hpp"

namespace krait::rivals {

std::uint64_t PriorPlanner::bytes_required(const Scene& scene, const Robot& robot, const Limits& limits) {
  Arena counting;
  count(counting, scene, robot, limits);
  return counting.needed();
}

Failure PriorPlanner::init(const Setup& setup, const Parameters& parameters, const Limits& limits) {
  if (!check_setup(setup, of_rival(parameters), limits).ok()) return failure();
  const auto required = [&](const Limits& any) { return bytes_required(*setup.scene, setup.robot, any); };
  const Failure failure = take_block(setup, required);
  if (failure.ok()) allocate_groups();
  return failure;
}

Status PriorPlanner::start(const Query& query) {
  if (!usable()) return status();
  groups_.clear({parameters_.tuning.alpha, parameters_.tuning.beta, prior_.epsilon}, kUnboundedSample);
  return begin(query, Keeper(*this));
}

Status PriorPlanner::advance(std::uint64_t iterations, const Watch& watch) {
  return advance_by(iterations, [&] { iterate(watch); });
}

void PriorPlanner::iterate(const Watch& watch) {
  if (!room_for_expansion()) return;
  const Index group = groups_.select(regions_);
  const Vec2 point = choose_point(group);
  const Index vertex = choose_vertex(group, point);
  expand(vertex, group, any_way_to(point, groups_.selections(group)), watch);
}

Vec2 PriorPlanner::choose_point(Index group) {
  const float choice = random_.unit();
  if (choice < prior_.path_share) {
    const Index count = regions_.regions_ahead(group, prior_.path_regions);
    return regions_.random_point(regions_.random_ahead(group, count, random_), random_);
  }
  if (choice < prior_.path_share + prior_.goal_share) return regions_.random_goal_point(random_);
  return random_free_point();
}

Vec2 PriorPlanner::random_free_point() {
  Vec2 point = random_point_in_bounds();
  for (int tries = 1; tries < kMaxTries && locate(*scene_, point) == kNone; ++tries) point = random_point_in_bounds();
  return point;
}

Index PriorPlanner::choose_vertex(Index group, Vec2 point) {
  const bool nearest = random_.unit() < prior_.nearest_share;
  return nearest ? nearest_vertex(group, point) : groups_.random_vertex(group, random_);
}

Index PriorPlanner::nearest_vertex(Index group, Vec2 point) const {
  Index best = kNone;
  float least = kInfinity;
  groups_.for_each_vertex(group, [&](Index vertex) {
    const Vec2 apart = point - position(vertex);
    const float squared = dot(apart, apart);
    if (squared > least || (squared == least && vertex > best)) return;
    least = squared;
    best = vertex;
  });
  return best;
}

}  // namespace krait::rivals
