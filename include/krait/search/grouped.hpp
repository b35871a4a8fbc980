// SPDX-License-Identifier: Apache-2.0
// What planners that grow the tree by groups share: which states are kept, and what goes when the memory is full.
#pragma once

#include "krait/search/groups.hpp"
#include "krait/search/search.hpp"

namespace krait {

template <class Derived, Robot R>
class GroupedSearch : public Search<Derived, R, Groups> {
  using Base = Search<Derived, R, Groups>;

 public:
  // Puts the state into its region's group, if the group's sample takes it and there is room. False when the search has
  // to stop for want of memory.
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
