// SPDX-License-Identifier: Apache-2.0
// Why a search ended without a plan, in words and as JSON.
#pragma once

#include "firmware/line.hpp"
#include "krait/planner.hpp"
#include "krait/scene.hpp"
#include "krait/status.hpp"

namespace krait::firmware {

#ifdef KRAIT_NO_REASONS
inline constexpr bool kGivesReasons = false;
#else
inline constexpr bool kGivesReasons = true;
#endif

// What the planner says of a search without a plan. Places in it are in the scene's local coordinates.
struct Why {
  Contact contact;        // after start_in_collision
  Bottleneck bottleneck;  // after a search without a plan
  Effort effort;          // after a search that did not end by itself
  double origin_x = 0.0;  // metres, of the scene in the world
  double origin_y = 0.0;
  float tolerance = 0.0F;  // metres, the scene's: how far its obstacles may have grown when it was compiled
};

// Asks a planner whose search has ended. O(R log R) after a search, in R regions of the scene.
Why ask_why(Planner& planner, const Scene& scene);

// Whether there is more to say of a search that ended so.
bool explains(Status status);

// The reason, as ": body 0 overlaps an obstacle at (1.000, 2.000)", of a status that explains().
void put_why(Line& line, Status status, const Why& why);

// The fields `contact_…` of start_in_collision, and `bottleneck_…` and `effort_…` of a search without a plan;
// `tolerance_m` with either.
void add_why(JsonLine& line, Status status, const Why& why);

}  // namespace krait::firmware
