// SPDX-License-Identifier: Apache-2.0
#include "search/groups.hpp"

#include <algorithm>

#include "krait/status.hpp"

namespace krait::detail {
namespace {

constexpr std::uint8_t kLeastBlockBits = 5;  // blocks of fewer regions than 32 would use memory for no gain

// The logarithm to base 2 of how many regions a block has: the least with which there are not more blocks than regions
// in one, so that a choice looks at the fewest numbers.
std::uint8_t block_bits_for(Index regions) {
  std::uint8_t bits = kLeastBlockBits;
  while ((regions >> bits) > (Index{1} << bits)) ++bits;
  return bits;
}

}  // namespace

void Groups::allocate(Arena& arena, const Scene& scene, std::uint32_t vertices) {
  region_count_ = scene.triangle_count();
  log_weights_ = arena.allocate<float>(Pool::groups, region_count_);
  block_bits_ = block_bits_for(region_count_);
  block_count_ = (region_count_ + (1U << block_bits_) - 1) >> block_bits_;
  block_weights_ = arena.allocate<float>(Pool::groups, block_count_);
  reached_ = arena.allocate<std::uint32_t>(Pool::groups, region_count_);
  selections_ = arena.allocate<std::uint32_t>(Pool::groups, region_count_);
  sizes_ = arena.allocate<std::uint16_t>(Pool::groups, region_count_);
  newest_.allocate(arena, Pool::groups, region_count_, vertices);
  links_.allocate(arena, Pool::members, vertices, vertices);
}

void Groups::clear(const GroupWeights& weights, std::uint32_t sample) {
  weights_ = weights;
  log_beta_ = math::log(weights.beta);
  sample_ = sample;
  for (Index r = 0; r < region_count_; ++r) {
    log_weights_[r] = -kInfinity;
    reached_[r] = 0;
    selections_[r] = 0;
    sizes_[r] = 0;
    newest_.set(r, kNone);
  }
  for (Index block = 0; block < block_count_; ++block) block_weights_[block] = -kInfinity;
}

// Sampling with a reservoir (Vitter's algorithm R).
Groups::Place Groups::place(Index region, Random& random) {
  KRAIT_ASSERT(region < region_count_);
  const std::uint32_t before = reached_[region];
  if (before != 0xFFFFFFFF) ++reached_[region];
  if (sizes_[region] < sample_) return {true, kNone};
  std::uint32_t place = random.below(reached_[region]);
  if (place >= sample_) return {false, kNone};
  Index vertex = newest_[region];
  for (; place > 0; --place) vertex = links_[vertex];
  return {vertex != kRoot, vertex};
}

void Groups::insert(const Regions& regions, Index region, Index vertex) {
  KRAIT_ASSERT(region < region_count_);
  links_.set(vertex, newest_[region]);
  newest_.set(region, vertex);
  if (sizes_[region]++ == 0) set_weight(regions, region);
}

Index Groups::remove(Index region) {
  const Index vertex = newest_[region];
  if (vertex == kRoot || vertex == kNone) return kNone;
  newest_.set(region, links_[vertex]);
  if (--sizes_[region] == 0) change_weight(region, -kInfinity);
  return vertex;
}

// The weight is computed from the integer count and never accumulated, so it does not depend on how it came about.
float Groups::log_weight(const Regions& regions, Index region) const {
  const float h = regions.cost(region);
  if (h == kInfinity) return -kInfinity;
  const float most = regions.largest_cost();
  const float progress = most > 0.0F ? weights_.epsilon + (1.0F - h / most) : weights_.epsilon + 1.0F;
  return weights_.alpha * math::log(progress) + log_beta_ * static_cast<float>(selections_[region]);
}

void Groups::set_weight(const Regions& regions, Index region) { change_weight(region, log_weight(regions, region)); }

Index Groups::block_end(Index block) const {
  const Index end = block_begin(block + 1);
  return std::min(region_count_, end);
}

float Groups::largest_in_block(Index block) const {
  float most = -kInfinity;
  for (Index r = block_begin(block); r < block_end(block); ++r) {
    if (log_weights_[r] > most) most = log_weights_[r];
  }
  return most;
}

void Groups::change_weight(Index region, float weight) {
  const Index block = region >> block_bits_;
  const float before = log_weights_[region];
  log_weights_[region] = weight;
  if (weight >= block_weights_[block]) {
    block_weights_[block] = weight;
  } else if (before == block_weights_[block]) {
    block_weights_[block] = largest_in_block(block);
  }
}

Index Groups::weigh(const Regions& regions) {
  Index weighed = 0;
  for (Index block = 0; block < block_count_; ++block) {
    if (block_weights_[block] == -kInfinity) continue;
    for (Index r = block_begin(block); r < block_end(block); ++r) {
      if (log_weights_[r] == -kInfinity) continue;
      log_weights_[r] = log_weight(regions, r);
      ++weighed;
    }
    block_weights_[block] = largest_in_block(block);
  }
  return weighed;
}

Index Groups::select(const Regions& regions) {
  Index best = 0;
  for (Index block = 1; block < block_count_; ++block) {
    if (block_weights_[block] > block_weights_[best]) best = block;
  }
  const float most = block_weights_[best];
  if (most == -kInfinity) return kNone;
  Index region = block_begin(best);
  while (log_weights_[region] != most) ++region;
  ++selections_[region];
  set_weight(regions, region);
  return region;
}

void Groups::unselect(const Regions& regions, Index region) {
  --selections_[region];
  if (sizes_[region] > 0) set_weight(regions, region);
}

Index Groups::lightest(Index besides) const {
  Index best = kNone;
  for (Index r = 0; r < region_count_; ++r) {
    if (sizes_[r] == 0 || newest_[r] == kRoot || r == besides) continue;
    if (best == kNone || log_weights_[r] <= log_weights_[best]) best = r;
  }
  return best;
}

Index Groups::random_vertex(Index region, Random& random) const {
  KRAIT_ASSERT(region < region_count_ && sizes_[region] > 0);
  Index vertex = newest_[region];
  for (std::uint32_t place = random.below(sizes_[region]); place > 0; --place) vertex = links_[vertex];
  return vertex;
}

}  // namespace krait::detail
