// SPDX-License-Identifier: Apache-2.0
#include "host/input/facing.hpp"

#include <nlohmann/json.hpp>
#include <numbers>

#include "host/workspace/heading.hpp"

namespace krait::host {
namespace {

double tolerance(const Field& field) { return field.number(kLeastTolerance, std::numbers::pi, "radians"); }

}  // namespace

GoalFacing read_facing(const Field& goal) {
  GoalFacing facing;
  facing.heading = goal.at("heading").number(-kMaxAngle, kMaxAngle, "radians");
  if (goal.has("heading_tolerance")) facing.tolerance = tolerance(goal.at("heading_tolerance"));
  if (goal.has("either_way")) facing.either_way = goal.at("either_way").boolean();
  if (goal.has("hitch_tolerance")) facing.hitches = tolerance(goal.at("hitch_tolerance"));
  return facing;
}

void require_no_tolerance(const Field& goal) {
  for (const char* key : {"heading_tolerance", "either_way", "hitch_tolerance"}) {
    if (goal.has(key)) goal.at(key).fail("needs a heading beside it: give the goal \"heading\": RADIANS");
  }
}

void add_facing(const GoalFacing& facing, Json& goal) {
  goal["heading"] = facing.heading;
  goal["heading_tolerance"] = facing.tolerance;
  goal["either_way"] = facing.either_way;
  if (facing.hitches) goal["hitch_tolerance"] = *facing.hitches;
}

}  // namespace krait::host
