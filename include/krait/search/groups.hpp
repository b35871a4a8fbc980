// The partition of the motion tree into groups, one a region that has been reached (Eqns 5, 6), and the choice of the
// group to expand (Eqns 7, 8).
#pragma once

#include <bit>

#include "krait/arena.hpp"
#include "krait/decomposition/regions.hpp"
#include "krait/random.hpp"

namespace krait {

// Eqn 7: w = (epsilon + 1 - h / h_max)^alpha * beta^selections, kept as its logarithm.
struct GroupWeights {
  float alpha = 8.0F;
  float beta = 0.85F;
  float epsilon = 0.01F;
};

class Groups {
 public:
  // For `regions` regions and `vertices` vertices in all; its pools cannot fill before the tree's does.
  void take(Arena& arena, Index regions, std::uint32_t vertices);

  void take(Arena& arena, const Scene& scene, std::uint32_t vertices) { take(arena, scene.triangle_count(), vertices); }

  // No groups, no selections.
  void clear(const GroupWeights& weights);

  // Puts a vertex into its region's group, which is made if there is none. O(1).
  void insert(const Regions& regions, Index region, Index vertex);

  // Weighs every group anew after h changed. O(groups).
  void weigh(const Regions& regions);

  // SELECTGROUP: the region whose group has the largest weight, the smallest number among equals; counts the
  // selection. kNone when no group has a finite cost. O(groups).
  Index select();

  // A vertex of the region's group, each as likely. O(log of the group's size), O(1) on average.
  Index random_vertex(Index region, Random& random) const;

  // Calls visit(vertex) for every vertex of the region's group. O(the group's size).
  template <class Visit>
  void for_each_vertex(Index region, Visit visit) const;

  std::uint32_t count() const { return group_count_; }
  std::uint32_t size(Index region) const { return groups_[group_of_[region]].vertices; }
  std::uint32_t selections(Index region) const;
  std::uint32_t members_used() const { return members_used_; }

  // The memory of the members, which is free once the search has ended: at least one entry a vertex.
  Index* scratch() { return members_; }

 private:
  struct Group {
    Index region;
    std::uint32_t selections;
    std::uint32_t vertices;
    Index newest_block;  // of members: an entry that names the previous block, then vertices
    float log_progress;  // alpha * log(epsilon + 1 - h / h_max)
  };

  static constexpr std::uint32_t kFirstBlock = 4;  // vertices; every further block has twice the last one's

  // Size of the block that holds a group's n-th vertex, counted from 0: 4, 8, 16, …
  static std::uint32_t block_of(std::uint32_t n) { return std::bit_floor(n / kFirstBlock + 1) * kFirstBlock; }

  float log_progress(const Regions& regions, Index region) const;
  void set_weight(std::uint32_t id);

  Index* group_of_ = nullptr;  // by region
  Group* groups_ = nullptr;
  float* log_weights_ = nullptr;
  Index* members_ = nullptr;
  Index region_count_ = 0;
  std::uint32_t group_count_ = 0;
  std::uint32_t members_used_ = 0;
  GroupWeights weights_;
  float log_beta_ = 0.0F;
};

template <class Visit>
void Groups::for_each_vertex(Index region, Visit visit) const {
  const Group& group = groups_[group_of_[region]];
  std::uint32_t block_size = block_of(group.vertices - 1);
  std::uint32_t end = group.vertices;
  for (Index block = group.newest_block; block != kNone; block = members_[block]) {
    const std::uint32_t before = block_size - kFirstBlock;  // vertices in the blocks before this one
    for (std::uint32_t i = 0; i < end - before; ++i) visit(members_[block + 1 + i]);
    end = before;
    block_size /= 2;
  }
}

}  // namespace krait
