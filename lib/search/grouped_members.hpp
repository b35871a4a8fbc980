// SPDX-License-Identifier: Apache-2.0
// The members of GroupedSearch, which the files of planners with groups instantiate.
#pragma once

#include "krait/search/grouped.hpp"
#include "search/search_members.hpp"

namespace krait {

template <class Derived, class Guide>
bool GroupedSearch<Derived, Guide>::keep(Index region, Branch branch, const float* state) {
  const Groups::Place place = this->guide_.place(region, this->random_);
  if (!place.kept) return true;
  if (place.replaced != kNone) {
    this->tree_.replace(place.replaced, branch, state);
    return true;
  }
  if (this->tree_.vertices_full()) {
    if (this->limits_.when_full == WhenFull::stop) return false;
    if (!make_room_for(region)) return true;
  }
  this->guide_.insert(this->regions_, region, this->tree_.add(branch, state));
  return true;
}

template <class Derived, class Guide>
Effort GroupedSearch<Derived, Guide>::effort() const {
  Effort most;
  for (Index region = 0; region < this->scene_->triangle_count(); ++region) {
    const std::uint32_t tries = this->guide_.selections(region);
    if (tries > most.tries) most = {this->scene_->centroid(region), tries};
  }
  return most;
}

template <class Derived, class Guide>
float GroupedSearch<Derived, Guide>::cost_to_go() const {
  float least = kInfinity;
  for (Index region = 0; region < this->scene_->triangle_count(); ++region) {
    const float cost = this->regions_.cost(region);
    if (this->guide_.reached(region) > 0 && cost < least) least = cost;
  }
  return least;
}

template <class Derived, class Guide>
bool GroupedSearch<Derived, Guide>::room_for_expansion() {
  while (this->tree_.expansions_full()) {
    const Index lightest = this->guide_.lightest(kNone);
    if (this->limits_.when_full == WhenFull::stop || lightest == kNone) {
      this->finish(Status::tree_full);
      return false;
    }
    drop_group(lightest);
  }
  return true;
}

template <class Derived, class Guide>
bool GroupedSearch<Derived, Guide>::make_room_for(Index region) {
  const Index lightest = this->guide_.lightest(region);
  const auto weight = [this](Index of) { return this->guide_.log_weight(this->regions_, of); };
  if (lightest == kNone || !(weight(lightest) < weight(region))) return false;
  drop_group(lightest);
  return true;
}

template <class Derived, class Guide>
void GroupedSearch<Derived, Guide>::drop_group(Index region) {
  for (Index vertex = this->guide_.remove(region); vertex != kNone; vertex = this->guide_.remove(region)) {
    this->tree_.remove(vertex);
    ++this->statistics_.recycled;
  }
}

}  // namespace krait
