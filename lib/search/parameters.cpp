#include "krait/search/parameters.hpp"

#include <bit>
#include <cstddef>
#include <cstring>
#include <limits>

#include "krait/search/groups.hpp"
#include "krait/search/motion_tree.hpp"

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

#define KRAIT_PLACE(parameter) offsetof(Parameters, parameter), Argument::parameter
#define KRAIT_PLACE_OF(planner, parameter) offsetof(Parameters, planner.parameter), Argument::planner##_##parameter

constexpr float kAboveZero = std::numeric_limits<float>::denorm_min();
constexpr float kBelowOne = 1.0F - 0.5F * std::numeric_limits<float>::epsilon();

constexpr Range<float> kNumbers[] = {{KRAIT_PLACE(alpha), 1.0F, 64.0F},
                                     {KRAIT_PLACE(beta), kAboveZero, kBelowOne},
                                     {KRAIT_PLACE(epsilon), kAboveZero, 1.0F},
                                     {KRAIT_PLACE(gamma), 0.0F, 1e6F},
                                     {KRAIT_PLACE(cost_length), 0.0F, 10.0F},
                                     {KRAIT_PLACE(dt), 0.001F, 1.0F},
                                     {KRAIT_PLACE(near_radius), 0.0F, 10.0F},
                                     {KRAIT_PLACE(stray_share), 0.0F, 1.0F},
                                     {KRAIT_PLACE(gentle_share), 0.0F, 1.0F},
                                     {KRAIT_PLACE(slowest), 0.05F, 1.0F},
                                     {KRAIT_PLACE(reverse_share), 0.0F, 1.0F},
                                     {KRAIT_PLACE(clearance), 0.0F, 10.0F},
                                     {KRAIT_PLACE(goal_margin), 0.0F, 10.0F},
                                     {KRAIT_PLACE_OF(prior, epsilon), 1e-30F, 1.0F},
                                     {KRAIT_PLACE_OF(prior, path_share), 0.0F, 1.0F},
                                     {KRAIT_PLACE_OF(prior, goal_share), 0.0F, 1.0F},
                                     {KRAIT_PLACE_OF(prior, nearest_share), 0.0F, 1.0F},
                                     {KRAIT_PLACE_OF(rrt, goal_share), 0.0F, 1.0F}};

constexpr Range<std::uint32_t> kCounts[] = {{KRAIT_PLACE(group_sample), 1, kUnboundedSample},
                                            {KRAIT_PLACE(kappa), 1, 10000},
                                            {KRAIT_PLACE(max_steps), 1, 1000},
                                            {KRAIT_PLACE(path_regions), 1, 64},
                                            {KRAIT_PLACE(doomed_steps), 0, Parameters::kMostDoomedSteps},
                                            {KRAIT_PLACE(restart_unit), 0, 1'000'000'000},
                                            {KRAIT_PLACE(max_substeps), 1, 64},
                                            {KRAIT_PLACE_OF(prior, path_regions), 1, 64}};
static_assert(MotionTree::kMostSteps >= 1000);

#undef KRAIT_PLACE
#undef KRAIT_PLACE_OF

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
  parameters.path_regions = 8;
  parameters.stray_share = 0.0F;
  parameters.gentle_share = 0.0F;
  parameters.doomed_steps = 0;
  parameters.restart_unit = 0;
  parameters.raise_goal = true;
  parameters.group_sample = kUnboundedSample;
  parameters.continuous = false;
  parameters.prune_portals = false;
  parameters.goal_margin = 0.0F;
  return parameters;
}

Argument Parameters::first_bad() const {
  Argument bad = first_outside(*this, kNumbers);
  if (bad == Argument::none) bad = first_outside(*this, kCounts);
  if (bad != Argument::none) return bad;
  if (!(prior.goal_share <= 1.0F - prior.path_share)) return Argument::prior_goal_share;
  return std::has_single_bit(max_substeps) ? Argument::none : Argument::max_substeps;
}

Argument Limits::first_bad() const {
  if (!within(vertices, 2, MotionTree::kMostExpansions)) return Argument::vertices;
  if (expansions != 0 && !within(expansions, 2, MotionTree::kMostExpansions)) return Argument::expansions;
  return iterations < 1 ? Argument::iterations : Argument::none;
}

}  // namespace krait
