// SPDX-License-Identifier: Apache-2.0
#include "host/run/pools.hpp"

#include <memory>
#include <vector>

#include "base/arena.hpp"
#include "search/adaptive_search.hpp"

namespace krait::host {

std::uint64_t block_for(const krait::Scene& scene, const Robot& robot, std::uint32_t vertices) {
  return Planner::bytes_required(scene, robot, {.vertices = vertices});
}

std::uint64_t least_block(const krait::Scene& scene, const Robot& robot) { return block_for(scene, robot, 2); }

double bytes_a_vertex(const krait::Scene& scene, const Robot& robot) {
  constexpr std::uint32_t kMany = 10'000;
  const std::uint64_t many = block_for(scene, robot, 2 + kMany);
  return static_cast<double>(many - least_block(scene, robot)) / kMany;
}

Pools pools_of(std::uint64_t bytes, const krait::Scene& scene, const Robot& robot, const Parameters& parameters) {
  Pools pools;
  const std::uint64_t least = least_block(scene, robot);
  if (bytes < least) {
    pools.failure = {Status::arena_too_small, 0, 0, least};
    return pools;
  }
  const Limits limits = Planner::limits_for(bytes, scene, robot);
  std::vector<std::uint64_t> block((Planner::bytes_required(scene, robot, limits) + 7) / 8);
  const auto planner = std::make_unique<Planner>();
  pools.failure = planner->init({block.data(), 8 * block.size(), &scene, robot}, parameters, limits);
  if (!pools.failure.ok()) return pools;
  pools.vertices = limits.vertices;
  pools.expansions = limits.kept_expansions();
  for (std::size_t i = 0; i < detail::kPoolCount; ++i)
    pools.bytes[i] = detail::opened(*planner).arena().needed(static_cast<detail::Pool>(i));
  return pools;
}

}  // namespace krait::host
