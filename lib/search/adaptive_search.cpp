// SPDX-License-Identifier: Apache-2.0
#include "search/adaptive_search.hpp"

#include <algorithm>

namespace krait::detail {

std::uint64_t AdaptiveSearch::bytes_required(const Scene& scene, const Robot& robot, const Limits& limits) {
  Arena counting;
  count(counting, scene, robot, limits);
  Sketcher sketcher;
  sketcher.allocate(counting, robot);
  return counting.needed();
}

Limits AdaptiveSearch::limits_for(std::uint64_t bytes, const Scene& scene, const Robot& robot, std::uint32_t way_legs) {
  return limits_within(bytes, {.way_legs = way_legs},
                       [&](const Limits& limits) { return bytes_required(scene, robot, limits); });
}

Failure AdaptiveSearch::init(const Setup& setup, const Parameters& parameters, const Limits& limits) {
  if (!check_setup(setup, parameters, limits).ok()) return failure();
  const auto required = [&](const Limits& any) { return bytes_required(*setup.scene, setup.robot, any); };
  const Failure failure = take_block(setup, required);
  if (!failure.ok()) return failure;
  allocate_groups();
  sketcher_.allocate(arena_, setup.robot);
  return failure;
}

Status AdaptiveSearch::start(const Query& query) {
  if (!usable()) return status();
  departure_.begin_query();
  reset_groups();
  return begin(query, Keeper(*this));
}

Status AdaptiveSearch::advance(std::uint64_t iterations, const Watch& watch) {
  return advance_by(iterations, [&] { iterate(watch); });
}

Status AdaptiveSearch::improve(std::uint64_t iterations) {
  return improve_by(iterations, true, [&] { iterate_restarted(); });
}

void AdaptiveSearch::iterate_restarted() {
  if (resume_restarted()) {
    (void)advance(1);
  } else {
    reset_groups();
    departure_.begin_restarted();
    begin_restarted();
  }
  pause_restarted();
}

void AdaptiveSearch::reset_groups() {
  groups_.clear({parameters_.tuning.alpha, parameters_.tuning.beta, parameters_.tuning.epsilon},
                parameters_.tuning.group_sample);
  updates_wait_ = 0;
  goes_on_ = false;
  departure_.begin_try();
  sketcher_.assign(robot_, *scene_, sketched_step(), parameters_.tuning.near_radius * robot_length_);
  sight_ = Sight::in(*scene_, kSightRoom * sketcher_.radius(), kSightStep * robot_length_);
}

float AdaptiveSearch::sketched_step() const {
  const float step = kSketchTime * parameters_.dt;
  const float longest = longest_step(robot_, parameters_.dt, kSketchRate);
  return std::min(longest, step);
}

void AdaptiveSearch::iterate(const Watch& watch) {
  if (new_try_due()) {
    reset_groups();
    new_try();
    return;
  }
  if (goes_on_) {
    learn_from(continue_expansion(watch));
  } else {
    begin_expansion(watch);
  }
  if (status() != Status::searching) return;
  if (updates_wait_ > 0) --updates_wait_;
  if (update_due()) update_costs();
}

void AdaptiveSearch::begin_expansion(const Watch& watch) {
  if (departs(watch) || !room_for_expansion()) return;
  if (!shortcuts_) (void)groups_.weigh(regions_);
  group_ = groups_.select(regions_);
  const Way way = choose_way(group_);
  if (way.promising) {
    learn_from(expand(way.vertex, group_, way.target, watch));
  } else {
    raise_costs(group_);
  }
}

bool AdaptiveSearch::departs(const Watch& watch) {
  const Departing* const departing = robot_.departing();
  const Expanded* const expanded = departing == nullptr ? nullptr : departing->iterate(departure_, expander(), watch);
  if (expanded == nullptr) return false;
  if (expanded->outcome == Outcome::goes_on) uncount_expansion();
  (void)finish_expansion(*expanded);
  return true;
}

bool AdaptiveSearch::update_due() const {
  return regions_.raised() && updates_wait_ == 0 && statistics_.iterations % parameters_.tuning.kappa == 0;
}

void AdaptiveSearch::learn_from(const Expanded& expanded) {
  goes_on_ = expanded.outcome == Outcome::goes_on;
  const bool long_way = expanded.last.step > parameters_.tuning.max_steps;
  if (long_way && expanded.outcome == Outcome::target_reached) groups_.unselect(regions_, group_);
  if (expanded.outcome == Outcome::collision) raise_costs(expanded.region);
}

AdaptiveSearch::Way AdaptiveSearch::choose_way(Index group) {
  const SearchTuning& tuning = parameters_.tuning;
  const Index ahead = regions_.regions_ahead(group, tuning.path_regions, tuning.path_lengths * robot_length_);
  const std::uint32_t count = tuning.candidates;
  if (count == 0) return any_way(group, ahead);
  for (std::uint32_t i = 0; i < count; ++i) {
    Way way = any_way(group, ahead);
    if (i == 0 && way.cost == kInfinity) way.cost = -1.0F;
    std::uint32_t at = i;
    for (; at > 0 && ways_[at - 1].cost > way.cost; --at) ways_[at] = ways_[at - 1];
    ways_[at] = way;
  }
  std::uint32_t best = 0;
  std::uint32_t longest = 0;
  for (std::uint32_t i = 0; i < count && longest < Sketcher::kSteps; ++i) {
    const std::uint32_t steps = sketcher_.free_steps(tree_.state(ways_[i].vertex), ways_[i].target);
    if (steps <= longest) continue;
    longest = steps;
    best = i;
  }
  ways_[best].promising = longest >= tuning.least_sketch;
  return ways_[best];
}

AdaptiveSearch::Way AdaptiveSearch::any_way(Index group, Index ahead) {
  Way way;
  way.vertex = groups_.random_vertex(group, random_);
  const float stray = parameters_.tuning.stray_share;
  const bool strays = stray > 0.0F && random_.unit() < stray;
  way.cost = kInfinity;
  const Vec2 point = strays ? random_point_in_bounds() : point_ahead(group, ahead, position(way.vertex), way.cost);
  way.target = any_way_to(point, groups_.selections(group));
  slow_for(way.target, way.vertex, way.cost == 0.0F);
  return way;
}

Vec2 AdaptiveSearch::point_ahead(Index group, Index ahead, Vec2 from, float& cost) {
  for (std::uint32_t tries = 1;; ++tries) {
    const Index region = regions_.random_ahead(group, ahead, random_);
    const Vec2 point = regions_.random_point(region, random_);
    cost = regions_.cost(region);
    if (tries >= parameters_.tuning.sight_tries || sight_.line_free(from, point)) return point;
  }
}

void AdaptiveSearch::raise_costs(Index last_region) {
  const Index next = regions_.next(last_region);
  if (next == kNone || (regions_.is_goal(next) && !parameters_.tuning.raise_goal)) return;
  regions_.raise_edges(next, {parameters_.tuning.gamma, parameters_.tuning.cost_length * robot_length_});
}

void AdaptiveSearch::update_costs() {
  const Index repaired = regions_.repair(!shortcuts_);
  if (shortcuts_) {
    statistics_.regions_repaired += repaired;
  } else {
    ++statistics_.dijkstra_runs;
  }
  const Index weighed = groups_.weigh(regions_);
  if (parameters_.tuning.update_regions == 0) return;
  const Index most = std::max(weighed, repaired);
  updates_wait_ = most / parameters_.tuning.update_regions;
}

}  // namespace krait::detail
