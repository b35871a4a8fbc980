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
    bool room = !this->tree_.expansions_full();
    while (!room && this->limits_.when_full == WhenFull::recycle && empty_lightest(kNone)) {
      room = !this->tree_.expansions_full();
    }
    if (!room) this->finish(Status::tree_full);
    return room;
  }

 private:
  // Whether a group other than the region's helps less and was emptied for it.
  bool make_room_for(Index region) {
    const Index lightest = this->guide_.lightest(region);
    if (lightest == kNone) return false;
    const bool lighter =
        this->guide_.log_weight(this->regions_, lightest) < this->guide_.log_weight(this->regions_, region);
    return lighter && empty_lightest(region) && !this->tree_.vertices_full();
  }

  // Frees the vertices of the group that helps least, but for the root. False when there is none.
  bool empty_lightest(Index besides) {
    const Index region = this->guide_.lightest(besides);
    if (region == kNone) return false;
    for (Index vertex = this->guide_.remove(region); vertex != kNone; vertex = this->guide_.remove(region)) {
      this->tree_.remove(vertex);
      ++this->statistics_.recycled;
    }
    return true;
  }
};

}  // namespace krait
