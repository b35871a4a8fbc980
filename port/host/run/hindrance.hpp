// SPDX-License-Identifier: Apache-2.0
// What stops the robot on its ways from where a search has tried most.
#pragma once

#include "host/run/session.hpp"

namespace krait::host {

// Of some ways that are driven from states that the search has reached there, toward the regions after it, as its
// expansions are.
struct Hindrances {
  int ways = 0;     // that were driven; 0: there is no such place, or no state of it is left
  int stopped = 0;  // of those, the ways that a body ended which ended most
  Contact contact;  // of that body, on one of those ways
  int beyond = 0;   // the ways that a limit of the robot ended, of its hitch angles as a rule
};

// A hundred ways of at most 50 steps, at most.
Hindrances hindrances_of(const Session& session, const krait::Scene& scene, const Parameters& parameters);

}  // namespace krait::host
