#include "krait/search/parameters.hpp"

#include <bit>

#include "krait/search/groups.hpp"
#include "krait/search/motion_tree.hpp"

namespace krait {
namespace {

// False for NaN.
bool within(float x, float low, float high) { return x >= low && x <= high; }
bool above(float x, float low, float high) { return x > low && x <= high; }
bool within(std::uint32_t x, std::uint32_t low, std::uint32_t high) { return x >= low && x <= high; }

}  // namespace

Parameters Parameters::paper() {
  Parameters parameters;
  parameters.beta = 0.85F;
  parameters.cost_length = 0.0F;
  parameters.stray_share = 0.0F;
  parameters.gentle_share = 0.0F;
  parameters.restart_unit = 0;
  parameters.raise_goal = true;
  parameters.group_sample = kUnboundedSample;
  parameters.continuous = false;
  parameters.prune_portals = false;
  parameters.goal_margin = 0.0F;
  return parameters;
}

Argument Parameters::first_bad() const {
  if (!within(alpha, 1.0F, 64.0F)) return Argument::alpha;
  if (!(beta > 0.0F && beta < 1.0F)) return Argument::beta;
  if (!above(epsilon, 0.0F, 1.0F)) return Argument::epsilon;
  if (!within(gamma, 0.0F, 1e6F)) return Argument::gamma;
  if (!within(cost_length, 0.0F, 10.0F)) return Argument::cost_length;
  if (!within(kappa, 1, 10000)) return Argument::kappa;
  if (!within(group_sample, 1, kUnboundedSample)) return Argument::group_sample;
  if (!within(dt, 0.001F, 1.0F)) return Argument::dt;
  static_assert(MotionTree::kMostSteps >= 1000);
  if (!within(max_steps, 1, 1000)) return Argument::max_steps;
  if (!within(path_regions, 1, 64)) return Argument::path_regions;
  if (!within(near_radius, 0.0F, 10.0F)) return Argument::near_radius;
  if (!within(stray_share, 0.0F, 1.0F)) return Argument::stray_share;
  if (!within(gentle_share, 0.0F, 1.0F)) return Argument::gentle_share;
  if (!within(restart_unit, 0, 1'000'000'000)) return Argument::restart_unit;
  if (!within(slowest, 0.05F, 1.0F)) return Argument::slowest;
  if (!within(reverse_share, 0.0F, 1.0F)) return Argument::reverse_share;
  if (!within(clearance, 0.0F, 10.0F)) return Argument::clearance;
  if (!within(max_substeps, 1, 64) || !std::has_single_bit(max_substeps)) return Argument::max_substeps;
  if (!within(goal_margin, 0.0F, 10.0F)) return Argument::goal_margin;
  if (!within(prior.epsilon, 1e-30F, 1.0F)) return Argument::prior_epsilon;
  if (!within(prior.path_regions, 1, 64)) return Argument::prior_path_regions;
  if (!within(prior.path_share, 0.0F, 1.0F)) return Argument::prior_path_share;
  if (!within(prior.goal_share, 0.0F, 1.0F - prior.path_share)) return Argument::prior_goal_share;
  if (!within(prior.nearest_share, 0.0F, 1.0F)) return Argument::prior_nearest_share;
  if (!within(rrt.goal_share, 0.0F, 1.0F)) return Argument::rrt_goal_share;
  return Argument::none;
}

Argument Limits::first_bad() const {
  if (!within(vertices, 2, MotionTree::kMostExpansions)) return Argument::vertices;
  if (expansions != 0 && !within(expansions, 2, MotionTree::kMostExpansions)) return Argument::expansions;
  return iterations < 1 ? Argument::iterations : Argument::none;
}

}  // namespace krait
