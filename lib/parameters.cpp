// SPDX-License-Identifier: Apache-2.0
#include "krait/parameters.hpp"

#include <bit>
#include <cstddef>
#include <cstring>
#include <limits>

namespace krait {
namespace {

bool within(std::uint32_t x, std::uint32_t low, std::uint32_t high) { return x >= low && x <= high; }

// From low to high, both included.
template <class Number>
struct Range {
  std::uint16_t offset;  // of the parameter
  Argument argument;
  Number low;
  Number high;
};

constexpr float kAboveZero = std::numeric_limits<float>::denorm_min();
constexpr float kBelowOne = 1.0F - 0.5F * std::numeric_limits<float>::epsilon();

constexpr Range<float> kNumbers[] = {{offsetof(Parameters, alpha), Argument::alpha, 1.0F, 64.0F},
                                     {offsetof(Parameters, beta), Argument::beta, kAboveZero, kBelowOne},
                                     {offsetof(Parameters, epsilon), Argument::epsilon, kAboveZero, 1.0F},
                                     {offsetof(Parameters, gamma), Argument::gamma, 0.0F, 1e6F},
                                     {offsetof(Parameters, cost_length), Argument::cost_length, 0.0F, 10.0F},
                                     {offsetof(Parameters, dt), Argument::dt, 0.001F, 1.0F},
                                     {offsetof(Parameters, near_radius), Argument::near_radius, 0.0F, 10.0F},
                                     {offsetof(Parameters, stray_share), Argument::stray_share, 0.0F, 1.0F},
                                     {offsetof(Parameters, gentle_share), Argument::gentle_share, 0.0F, 1.0F},
                                     {offsetof(Parameters, slowest), Argument::slowest, 0.05F, 1.0F},
                                     {offsetof(Parameters, reverse_share), Argument::reverse_share, 0.0F, 1.0F},
                                     {offsetof(Parameters, clearance), Argument::clearance, 0.0F, 10.0F},
                                     {offsetof(Parameters, goal_margin), Argument::goal_margin, 0.0F, 10.0F},
                                     {offsetof(Parameters, end_speed), Argument::end_speed, 0.0F, kInfinity}};

constexpr Range<std::uint32_t> kCounts[] = {
    {offsetof(Parameters, group_sample), Argument::group_sample, 1, kUnboundedSample},
    {offsetof(Parameters, kappa), Argument::kappa, 1, 10000},
    {offsetof(Parameters, update_regions), Argument::update_regions, 0, 1'000'000},
    {offsetof(Parameters, max_steps), Argument::max_steps, 1, Parameters::kMostSteps},
    {offsetof(Parameters, open_steps), Argument::open_steps, 0, Parameters::kMostSteps},
    {offsetof(Parameters, path_regions), Argument::path_regions, 1, 64},
    {offsetof(Parameters, sight_tries), Argument::sight_tries, 0, 64},
    {offsetof(Parameters, candidates), Argument::candidates, 0, Parameters::kMostCandidates},
    {offsetof(Parameters, least_sketch), Argument::least_sketch, 0, 20},
    {offsetof(Parameters, doomed_steps), Argument::doomed_steps, 0, Parameters::kMostDoomedSteps},
    {offsetof(Parameters, restart_unit), Argument::restart_unit, 0, 1'000'000'000},
    {offsetof(Parameters, max_substeps), Argument::max_substeps, 1, 64}};

// NaN is outside.
template <class Number, std::size_t count>
Argument first_outside(const Parameters& parameters, const Range<Number> (&ranges)[count]) {
  for (const Range<Number>& range : ranges) {
    Number x;
    std::memcpy(&x, reinterpret_cast<const std::byte*>(&parameters) + range.offset, sizeof x);
    if (!(x >= range.low && x <= range.high)) return range.argument;
  }
  return Argument::none;
}

}  // namespace

Parameters Parameters::paper() {
  Parameters parameters;
  parameters.gamma = 50.0F;
  parameters.cost_length = 0.0F;
  parameters.kappa = 20;
  parameters.update_regions = 0;
  parameters.open_steps = 0;
  parameters.path_regions = 8;
  parameters.stray_share = 0.0F;
  parameters.gentle_share = 0.0F;
  parameters.sight_tries = 0;
  parameters.candidates = 0;
  parameters.slowest = 0.75F;
  parameters.doomed_steps = 0;
  parameters.restart_unit = 0;
  parameters.raise_goal = true;
  parameters.group_sample = kUnboundedSample;
  parameters.continuous = false;
  parameters.prune_portals = false;
  parameters.goal_margin = 0.0F;
  parameters.end_speed = kInfinity;
  return parameters;
}

Argument Parameters::first_bad() const {
  Argument bad = first_outside(*this, kNumbers);
  if (bad == Argument::none) bad = first_outside(*this, kCounts);
  if (bad != Argument::none) return bad;
  return std::has_single_bit(max_substeps) ? Argument::none : Argument::max_substeps;
}

Argument Limits::first_bad() const {
  if (vertices != 0 && !within(vertices, 2, kMost)) return Argument::vertices;
  if (expansions != 0 && !within(expansions, 2, kMost)) return Argument::expansions;
  if (when_full != WhenFull::recycle && when_full != WhenFull::stop) return Argument::when_full;
  if (way_legs != 0 && !within(way_legs, 16, 1'000'000)) return Argument::way_legs;
  return iterations < 1 ? Argument::iterations : Argument::none;
}

}  // namespace krait
