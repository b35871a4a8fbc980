// SPDX-License-Identifier: Apache-2.0
#include "krait/parameters.hpp"

#include <bit>
#include <cstddef>
#include <cstring>
#include <limits>

namespace krait {
namespace {

bool within(std::uint32_t x, std::uint32_t low, std::uint32_t high) { return x >= low && x <= high; }

// A parameter lies at `offset`, and may be from low to high, both included. Each range stands here only.
template <class Number>
struct Range {
  std::uint16_t offset;  // of the parameter
  Argument argument;
  Number low;
  Number high;
};

constexpr float kAboveZero = std::numeric_limits<float>::denorm_min();
constexpr float kBelowOne = 1.0F - 0.5F * std::numeric_limits<float>::epsilon();

constexpr Range<float> kNumbers[] = {
    {offsetof(Parameters, tuning.alpha), Argument::alpha, 1.0F, 64.0F},
    {offsetof(Parameters, tuning.beta), Argument::beta, kAboveZero, kBelowOne},
    {offsetof(Parameters, tuning.epsilon), Argument::epsilon, kAboveZero, 1.0F},
    {offsetof(Parameters, tuning.gamma), Argument::gamma, 0.0F, 1e6F},
    {offsetof(Parameters, tuning.cost_length), Argument::cost_length, 0.0F, 10.0F},
    {offsetof(Parameters, dt), Argument::dt, 0.001F, 1.0F},
    {offsetof(Parameters, tuning.path_lengths), Argument::path_lengths, 0.0F, 100.0F},
    {offsetof(Parameters, tuning.near_radius), Argument::near_radius, 0.0F, 10.0F},
    {offsetof(Parameters, tuning.goal_near_radius), Argument::goal_near_radius, 0.0F, 10.0F},
    {offsetof(Parameters, tuning.stray_share), Argument::stray_share, 0.0F, 1.0F},
    {offsetof(Parameters, tuning.gentle_share), Argument::gentle_share, 0.0F, 1.0F},
    {offsetof(Parameters, tuning.slowest), Argument::slowest, 0.05F, 1.0F},
    {offsetof(Parameters, tuning.stopping_ways), Argument::stopping_ways, 0.0F, 10.0F},
    {offsetof(Parameters, tuning.reverse_share), Argument::reverse_share, 0.0F, 1.0F},
    {offsetof(Parameters, clearance), Argument::clearance, 0.0F, 10.0F},
    {offsetof(Parameters, goal_margin), Argument::goal_margin, 0.0F, 10.0F},
    {offsetof(Parameters, end_speed), Argument::end_speed, 0.0F, kInfinity}};

constexpr Range<std::uint32_t> kCounts[] = {
    {offsetof(Parameters, tuning.group_sample), Argument::group_sample, 1, kUnboundedSample},
    {offsetof(Parameters, tuning.kappa), Argument::kappa, 1, 10000},
    {offsetof(Parameters, tuning.update_regions), Argument::update_regions, 0, 1'000'000},
    {offsetof(Parameters, tuning.max_steps), Argument::max_steps, 1, SearchTuning::kMostSteps},
    {offsetof(Parameters, tuning.open_steps), Argument::open_steps, 0, SearchTuning::kMostSteps},
    {offsetof(Parameters, tuning.path_regions), Argument::path_regions, 1, 64},
    {offsetof(Parameters, tuning.sight_tries), Argument::sight_tries, 0, 64},
    {offsetof(Parameters, tuning.candidates), Argument::candidates, 0, SearchTuning::kMostCandidates},
    {offsetof(Parameters, tuning.least_sketch), Argument::least_sketch, 0, 20},
    {offsetof(Parameters, tuning.doomed_steps), Argument::doomed_steps, 0, SearchTuning::kMostDoomedSteps},
    {offsetof(Parameters, tuning.restart_unit), Argument::restart_unit, 0, 1'000'000'000},
    {offsetof(Parameters, tuning.stuck_expansions), Argument::stuck_expansions, 0, 1'000'000'000},
    {offsetof(Parameters, tuning.max_substeps), Argument::max_substeps, 1, 64}};

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

// Leaves `range` as it is where none of the ranges is the argument's.
template <class Number, std::size_t count>
void find_range(Argument argument, const Range<Number> (&ranges)[count], ParameterRange& range) {
  for (const Range<Number>& one : ranges) {
    if (one.argument == argument) range = {static_cast<float>(one.low), static_cast<float>(one.high)};
  }
}

}  // namespace

Parameters Parameters::paper() {
  Parameters parameters;
  parameters.tuning.gamma = 50.0F;
  parameters.tuning.cost_length = 0.0F;
  parameters.tuning.kappa = 20;
  parameters.tuning.update_regions = 0;
  parameters.tuning.open_steps = 0;
  parameters.tuning.path_regions = 8;
  parameters.tuning.path_lengths = 0.0F;
  parameters.tuning.goal_near_radius = parameters.tuning.near_radius;
  parameters.tuning.stray_share = 0.0F;
  parameters.tuning.gentle_share = 0.0F;
  parameters.tuning.sight_tries = 0;
  parameters.tuning.candidates = 0;
  parameters.tuning.slowest = 0.75F;
  parameters.tuning.stopping_ways = 0.0F;
  parameters.tuning.doomed_steps = 0;
  parameters.tuning.restart_unit = 0;
  parameters.tuning.stuck_expansions = 0;
  parameters.tuning.raise_goal = true;
  parameters.tuning.group_sample = kUnboundedSample;
  parameters.tuning.continuous = false;
  parameters.tuning.prune_portals = false;
  parameters.goal_margin = 0.0F;
  parameters.end_speed = kInfinity;
  return parameters;
}

Argument Parameters::first_bad() const {
  Argument bad = first_outside(*this, kNumbers);
  if (bad == Argument::none) bad = first_outside(*this, kCounts);
  if (bad != Argument::none) return bad;
  return std::has_single_bit(tuning.max_substeps) ? Argument::none : Argument::max_substeps;
}

ParameterRange Parameters::range(Argument argument) {
  ParameterRange range;
  find_range(argument, kNumbers, range);
  find_range(argument, kCounts, range);
  return range;
}

Argument Limits::first_bad() const {
  if (vertices != 0 && !within(vertices, 2, kMost)) return Argument::vertices;
  if (expansions != 0 && !within(expansions, 2, kMost)) return Argument::expansions;
  if (when_full != WhenFull::recycle && when_full != WhenFull::stop) return Argument::when_full;
  if (way_legs != 0 && !within(way_legs, kLeastLegs, kMostLegs)) return Argument::way_legs;
  return iterations < 1 ? Argument::iterations : Argument::none;
}

}  // namespace krait
