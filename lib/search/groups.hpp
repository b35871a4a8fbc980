// SPDX-License-Identifier: Apache-2.0
// The partition of the motion tree into groups, one a region that has been reached (Eqns 5, 6), and the choice of the
// group to expand (Eqns 7, 8).
#pragma once

#include "base/arena.hpp"
#include "base/random.hpp"
#include "decomposition/regions.hpp"
#include "krait/parameters.hpp"
#include "plan/motion_tree.hpp"

namespace krait::detail {

// Eqn 7: w = (epsilon + 1 - h / h_max)^alpha * beta^selections, kept as its logarithm.
struct GroupWeights {
  float alpha;
  float beta;
  float epsilon;
};

class Groups {
 public:
  // Allocates room for `vertices` vertices in all: 16 to 18 bytes a region, 2 to 4 a vertex.
  void allocate(Arena& arena, const Scene& scene, std::uint32_t vertices);

  // Removes all members and forgets all selections. A group keeps at most `sample` members, 1 … kUnboundedSample. O(R).
  void clear(const GroupWeights& weights, std::uint32_t sample);

  // What becomes of a state that reached the region: it joins the group, or takes the place of a member other than the
  // root, or is not kept. Counts it. Each with the probability that keeps the sample uniform. O(sample).
  struct Place {
    bool kept = false;
    Index replaced = kNone;
  };
  Place place(Index region, Random& random);

  // Makes a vertex a member; with the first one its group has a weight. O(1).
  void insert(const Regions& regions, Index region, Index vertex);

  // Removes the newest member but the root from the group and returns it, or kNone. The count of selections stays.
  Index remove(Index region);

  // Recomputes every group's weight after h changed and returns how many groups have one. O(R).
  Index weigh(const Regions& regions);

  // SELECTGROUP: the region whose group has the largest weight, the smallest number among equals; counts the
  // selection. kNone when no group with members has a finite cost. O(sqrt(R)).
  Index select(const Regions& regions);

  // Reverts a selection of the region's group: it does not lower its weight. O(1).
  void unselect(const Regions& regions, Index region);

  // The region whose group has the smallest weight of those with members besides the root, the largest number among
  // equals, `besides` excluded; kNone when there is no other. O(R).
  Index lightest(Index besides) const;

  // The logarithm of the weight that the region's group has, or would have with a member.
  float log_weight(const Regions& regions, Index region) const;

  // A member of the region's group, each as likely. O(sample).
  Index random_vertex(Index region, Random& random) const;

  // Calls visit(vertex) for every member of the region's group, newest first.
  template <class Visit>
  void for_each_vertex(Index region, Visit visit) const {
    for (Index vertex = newest_[region]; vertex != kNone; vertex = links_[vertex]) visit(vertex);
  }

  std::uint32_t size(Index region) const { return sizes_[region]; }
  std::uint32_t reached(Index region) const { return reached_[region]; }
  std::uint32_t selections(Index region) const { return selections_[region]; }

 private:
  void set_weight(const Regions& regions, Index region);
  void change_weight(Index region, float weight);
  float largest_in_block(Index block) const;
  Index block_begin(Index block) const { return block << block_bits_; }
  Index block_end(Index block) const;

  // Arrays and counts have values since allocate, what weighs the groups since clear.
  float* log_weights_;      // by region: minus infinity without members
  float* block_weights_;    // by block of regions: the largest of them
  std::uint32_t* reached_;  // how many states ever
  std::uint32_t* selections_;
  std::uint16_t* sizes_;
  PackedIndices newest_;  // by region: its newest member
  PackedIndices links_;   // by vertex: the member before it
  Index region_count_;
  Index block_count_;
  std::uint8_t block_bits_;
  std::uint32_t sample_;
  GroupWeights weights_;
  float log_beta_;
};

}  // namespace krait::detail
