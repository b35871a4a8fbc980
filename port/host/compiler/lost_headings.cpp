// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/lost_headings.hpp"

#include <cmath>
#include <numbers>

#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

constexpr std::size_t kMostNamed = 3;

std::string options_for(const GoalPose& pose) {
  const GoalFacing usual;
  const GoalFacing& facing = pose.facing;
  const double heading = std::remainder(facing.heading, 2 * std::numbers::pi);
  std::string text =
      printed("--goal %.10g,%.10g,%.10g --heading %.8g", pose.position.x, pose.position.y, pose.radius, heading);
  if (facing.tolerance != usual.tolerance) text += printed(" --heading-tolerance %.8g", facing.tolerance);
  if (facing.either_way) text += " --either-way";
  if (facing.hitches) text += printed(" --hitch-tolerance %.8g", *facing.hitches);
  return text;
}

}  // namespace

std::string lost_headings(const std::vector<Goal>& goals) {
  std::string named;
  std::size_t count = 0;
  for (const Goal& goal : goals) {
    if (!goal.pose || ++count > kMostNamed) continue;
    named += (count > 1 ? "; " : "") + options_for(*goal.pose) + " for goal '" + goal.name + "'";
  }
  if (count == 0) return {};
  if (count > kMostNamed) named += "; so for " + std::to_string(count - kMostNamed) + " more";
  return "a scene file holds no headings of goals: plan in it with " + named +
         " (--any-heading leaves this warning out)";
}

}  // namespace krait::host
