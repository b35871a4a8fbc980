// SPDX-License-Identifier: Apache-2.0
// What planners that grow the tree by groups share: which states are kept, and what goes when the memory is full.
#pragma once

#include "krait/search/groups.hpp"
#include "krait/search/search.hpp"

namespace krait {

// The place where a search has tried most, as a rule in vain.
struct Effort {
  Vec2 at{};                // the middle of a region, local coordinates
  std::uint32_t tries = 0;  // expansions from there since the search last began anew; 0: none
};

template <class Derived>
class GroupedSearch : public Search<Derived, Groups> {
  using Base = Search<Derived, Groups>;

 public:
  // Puts the state into its region's group, if the group's sample has a place for it and there is room. False when the
  // search has to stop for want of memory.
  bool keep(Index region, Branch branch, const float* state) {
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

  // Where a search that has started has made most of its expansions, the first among equals. O(R).
  Effort effort() const {
    Effort most;
    for (Index region = 0; region < this->scene_->triangle_count(); ++region) {
      const std::uint32_t tries = this->guide_.selections(region);
      if (tries > most.tries) most = {this->scene_->centroid(region), tries};
    }
    return most;
  }

  // The least cost h of the regions that a search has reached since it last began anew, metres; infinite where it has
  // not started. O(R).
  float cost_to_go() const {
    float least = kInfinity;
    for (Index region = 0; region < this->scene_->triangle_count(); ++region) {
      const float cost = this->regions_.cost(region);
      if (this->guide_.reached(region) > 0 && cost < least) least = cost;
    }
    return least;
  }

 protected:
  // Makes sure that the tree has room for an expansion. False, and the search has ended, when it has not.
  bool room_for_expansion() {
    while (this->tree_.expansions_full()) {
      const Index lightest = this->guide_.lightest(kNone);
      if (this->limits_.when_full == WhenFull::stop || lightest == kNone) {
        this->finish(Status::tree_full);
        return false;
      }
      empty(lightest);
    }
    return true;
  }

 private:
  // Empties the group that helps least if it helps less than the region's. False when there is none such.
  bool make_room_for(Index region) {
    const Index lightest = this->guide_.lightest(region);
    const auto weight = [this](Index of) { return this->guide_.log_weight(this->regions_, of); };
    if (lightest == kNone || !(weight(lightest) < weight(region))) return false;
    empty(lightest);
    return true;
  }

  // Frees the group's vertices, but for the root.
  void empty(Index region) {
    for (Index vertex = this->guide_.remove(region); vertex != kNone; vertex = this->guide_.remove(region)) {
      this->tree_.remove(vertex);
      ++this->statistics_.recycled;
    }
  }
};

}  // namespace krait
