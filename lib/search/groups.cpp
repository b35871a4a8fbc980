#include "krait/search/groups.hpp"

namespace krait {
namespace {

// A group of n vertices holds blocks of 4, 8, 16, … vertices and a link each: never more than 2n + n/8 + 5 entries.
std::uint64_t members_needed(Index regions, std::uint32_t vertices) {
  const std::uint64_t groups = regions < vertices ? regions : vertices;
  return 2 * std::uint64_t{vertices} + vertices / 8 + 5 * groups;
}

}  // namespace

void Groups::take(Arena& arena, Index regions, std::uint32_t vertices) {
  region_count_ = regions;
  group_of_ = arena.take<Index>(Pool::groups, regions);
  groups_ = arena.take<Group>(Pool::groups, regions);
  log_weights_ = arena.take<float>(Pool::groups, regions);
  members_ = arena.take<Index>(Pool::members, members_needed(regions, vertices));
}

void Groups::clear(const GroupWeights& weights) {
  weights_ = weights;
  log_beta_ = log(weights.beta);
  group_count_ = 0;
  members_used_ = 0;
  for (Index r = 0; r < region_count_; ++r) group_of_[r] = kNone;
}

std::uint32_t Groups::selections(Index region) const {
  return group_of_[region] == kNone ? 0 : groups_[group_of_[region]].selections;
}

float Groups::log_progress(const Regions& regions, Index region) const {
  const float h = regions.cost(region);
  if (h == kInfinity) return -kInfinity;
  const float most = regions.largest_cost();
  const float progress = most > 0.0F ? weights_.epsilon + (1.0F - h / most) : weights_.epsilon + 1.0F;
  return weights_.alpha * log(progress);
}

// From the integer count, never by accumulation: the same weight however it came about.
void Groups::set_weight(std::uint32_t id) {
  log_weights_[id] = groups_[id].log_progress + log_beta_ * static_cast<float>(groups_[id].selections);
}

void Groups::insert(const Regions& regions, Index region, Index vertex) {
  Index id = group_of_[region];
  if (id == kNone) {
    id = group_count_++;
    group_of_[region] = id;
    groups_[id] = {region, 0, 0, kNone, log_progress(regions, region)};
    set_weight(id);
  }
  Group& group = groups_[id];
  // The blocks before one of b vertices hold b - kFirstBlock; a new one is due when all are full.
  const std::uint32_t filled = group.vertices / kFirstBlock + 1;
  const bool all_full = group.vertices % kFirstBlock == 0 && (filled & (filled - 1)) == 0;
  if (all_full) {
    members_[members_used_] = group.newest_block;
    group.newest_block = members_used_;
    members_used_ += 1 + kFirstBlock * filled;
  }
  const std::uint32_t block_size = block_of(group.vertices);
  members_[group.newest_block + 1 + (group.vertices - (block_size - kFirstBlock))] = vertex;
  ++group.vertices;
}

void Groups::weigh(const Regions& regions) {
  for (std::uint32_t id = 0; id < group_count_; ++id) {
    groups_[id].log_progress = log_progress(regions, groups_[id].region);
    set_weight(id);
  }
}

Index Groups::select() {
  std::uint32_t best = kNone;
  float most = -kInfinity;
  for (std::uint32_t id = 0; id < group_count_; ++id) {
    const bool larger = log_weights_[id] > most;
    const bool tie = best != kNone && log_weights_[id] == most && groups_[id].region < groups_[best].region;
    if (!larger && !tie) continue;
    most = log_weights_[id];
    best = id;
  }
  if (best == kNone) return kNone;
  ++groups_[best].selections;
  set_weight(best);
  return groups_[best].region;
}

Index Groups::random_vertex(Index region, Random& random) const {
  const Group& group = groups_[group_of_[region]];
  const std::uint32_t chosen = random.below(group.vertices);
  std::uint32_t block_size = block_of(group.vertices - 1);
  Index block = group.newest_block;
  while (chosen < block_size - kFirstBlock) {
    block = members_[block];
    block_size /= 2;
  }
  return members_[block + 1 + (chosen - (block_size - kFirstBlock))];
}

}  // namespace krait
