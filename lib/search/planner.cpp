// SPDX-License-Identifier: Apache-2.0
#include "krait/planner.hpp"

#include <new>
#include <type_traits>

#include "search/adaptive_search.hpp"

namespace krait {

using detail::AdaptiveSearch;
using detail::opened;

AdaptiveSearch& detail::opened(Planner& planner) {
  return *std::launder(reinterpret_cast<AdaptiveSearch*>(planner.search_));
}

const AdaptiveSearch& detail::opened(const Planner& planner) {
  return *std::launder(reinterpret_cast<const AdaptiveSearch*>(planner.search_));
}

Planner::Planner() {
  static_assert(sizeof(AdaptiveSearch) <= kSearchBytes && alignof(AdaptiveSearch) <= alignof(std::uint64_t));
  static_assert(std::is_trivially_destructible_v<AdaptiveSearch>);
  ::new (search_) AdaptiveSearch;
}

std::uint64_t Planner::bytes_required(const Scene& scene, const Robot& robot, const Limits& limits) {
  return AdaptiveSearch::bytes_required(scene, robot, limits);
}

Limits Planner::limits_for(std::uint64_t bytes, const Scene& scene, const Robot& robot, std::uint32_t way_legs) {
  return AdaptiveSearch::limits_for(bytes, scene, robot, way_legs);
}

Failure Planner::init(const Setup& setup, const Parameters& parameters, const Limits& limits) {
  ::new (search_) AdaptiveSearch;  // also where start-up code ran no constructors
  return opened(*this).init(setup, parameters, limits);
}

Status Planner::start(const Query& query) { return opened(*this).start(query); }

Status Planner::advance(std::uint64_t iterations) { return opened(*this).advance(iterations, Watch()); }

Status Planner::advance(std::uint64_t iterations, const Watch& watch) {
  return opened(*this).advance(iterations, watch);
}

Status Planner::improve(std::uint64_t iterations) { return opened(*this).improve(iterations); }

void Planner::stop_for_time() { opened(*this).stop_for_time(); }

Status Planner::status() const { return opened(*this).status(); }

const Failure& Planner::failure() const { return opened(*this).failure(); }

Plan Planner::plan() const { return opened(*this).plan(); }

Statistics Planner::statistics() const { return opened(*this).statistics(); }

Contact Planner::contact() { return opened(*this).contact(); }

Bottleneck Planner::bottleneck() { return opened(*this).bottleneck(); }

Effort Planner::effort() const { return opened(*this).effort(); }

float Planner::cost_to_go() const { return opened(*this).cost_to_go(); }

}  // namespace krait
