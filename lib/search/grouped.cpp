// SPDX-License-Identifier: Apache-2.0
#include "search/grouped.hpp"

namespace krait::detail {

void GroupedSearch::count(Arena& counting, const Scene& scene, const Robot& robot, const Limits& limits) {
  Search::count(counting, scene, robot, limits);
  Groups groups;
  groups.allocate(counting, scene, limits.vertices);
}

bool GroupedSearch::keep(Index region, Branch branch, const float* state) {
  const Groups::Place place = groups_.place(region, random_);
  if (!place.kept) return true;
  if (place.replaced != kNone) {
    tree_.replace(place.replaced, branch, state);
    return true;
  }
  if (tree_.vertices_full()) {
    if (limits_.when_full == WhenFull::stop) return false;
    if (!make_room_for(region)) return true;
  }
  groups_.insert(regions_, region, tree_.add(branch, state));
  return true;
}

Effort GroupedSearch::effort() const {
  Effort most;
  if (!started()) return most;
  for (Index region = 0; region < scene_->triangle_count(); ++region) {
    const std::uint32_t tries = groups_.selections(region);
    if (tries > most.tries) most = {scene_->centroid(region), tries};
  }
  return most;
}

float GroupedSearch::cost_to_go() const {
  float least = kInfinity;
  if (!started()) return least;
  for (Index region = 0; region < scene_->triangle_count(); ++region) {
    const float cost = regions_.cost(region);
    if (groups_.reached(region) > 0 && cost < least) least = cost;
  }
  return least;
}

bool GroupedSearch::room_for_expansion() {
  while (tree_.expansions_full()) {
    const Index lightest = groups_.lightest(kNone);
    if (limits_.when_full == WhenFull::stop || lightest == kNone) {
      finish(Status::tree_full);
      return false;
    }
    drop_group(lightest);
  }
  return true;
}

bool GroupedSearch::make_room_for(Index region) {
  const Index lightest = groups_.lightest(region);
  const auto weight = [this](Index of) { return groups_.log_weight(regions_, of); };
  if (lightest == kNone || !(weight(lightest) < weight(region))) return false;
  drop_group(lightest);
  return true;
}

void GroupedSearch::drop_group(Index region) {
  for (Index vertex = groups_.remove(region); vertex != kNone; vertex = groups_.remove(region)) {
    tree_.remove(vertex);
    ++statistics_.recycled;
  }
}

}  // namespace krait::detail
