// SPDX-License-Identifier: Apache-2.0
// How a planner would share out a block for a scene and a robot.
#pragma once

#include <array>
#include <cstdint>

#include "base/arena.hpp"
#include "krait/krait.hpp"

namespace krait::host {

struct Pools {
  Failure failure;  // ok, or why a planner refuses the block, the robot or the parameters: the rest is 0 then
  std::uint32_t vertices = 0;
  std::uint32_t expansions = 0;
  std::array<std::uint64_t, detail::kPoolCount> bytes{};  // by Pool
};

// The least block that a planner takes, bytes.
std::uint64_t least_block(const krait::Scene& scene, const Robot& robot);

// The block of a planner with room for `vertices` vertices, bytes.
std::uint64_t block_for(const krait::Scene& scene, const Robot& robot, std::uint32_t vertices);

// How much more each vertex takes, with the half of an expansion that goes with it, bytes.
double bytes_a_vertex(const krait::Scene& scene, const Robot& robot);

// Of a block of `bytes`.
Pools pools_of(std::uint64_t bytes, const krait::Scene& scene, const Robot& robot, const Parameters& parameters);

}  // namespace krait::host
