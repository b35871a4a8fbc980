// SPDX-License-Identifier: Apache-2.0
// What planners that grow the tree by groups share: which states are kept, and what goes when the memory is full.
#pragma once

#include "search/groups.hpp"
#include "search/search.hpp"

namespace krait::detail {

class GroupedSearch : public Search {
 public:
  const Groups& groups() const { return groups_; }

  // These do what the members of Planner do.
  Effort effort() const;
  float cost_to_go() const;

 protected:
  GroupedSearch() = default;
  ~GroupedSearch() = default;

  // Search::count, and counts the groups.
  static void count(Arena& counting, const Scene& scene, const Robot& robot, const Limits& limits);

  // After Search::take_block.
  void allocate_groups() { groups_.allocate(arena_, *scene_, limits_.vertices); }

  // Implements Keeper: puts the state into its region's group, if the group's sample has a place for it and there is
  // room. False when the search has to stop for want of memory.
  bool keep(Index region, Branch branch, const float* state);

  // Makes sure that the tree has room for an expansion. False, and the search has ended, when it has not.
  bool room_for_expansion();

  Groups groups_;

 private:
  friend class Keeper;

  // Empties the group that helps least if it helps less than the region's. False when there is none such.
  bool make_room_for(Index region);

  // Frees the group's vertices, but for the root.
  void drop_group(Index region);
};

}  // namespace krait::detail
