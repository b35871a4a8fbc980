// SPDX-License-Identifier: Apache-2.0
// The clearance that krait plan keeps where none is asked for: what a robot that tracks the plan can be off by.
#pragma once

#include <optional>
#include <string>

#include "host/run/run.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

// Metres.
struct Clearance {
  float kept = 0;      // from Parameters{}.clearance, a millimetre, to `usual`
  float usual = 0;     // 2 % of the robot's width and, on a map of cells, half a cell
  std::string narrow;  // what has too little room for the usual one, "the start has"; empty where that is kept
};

// The usual clearance, halved until start and widest way to the goal have room for twice as much, so that a search has
// room to move; at least a millimetre. A few set-ups of the request's search. Throws InputError as those do, but not
// for obstacles in the way.
Clearance usual_clearance(const krait::Scene& scene, const SearchRequest& request, const std::optional<Workspace>& map);

// "clearance 0.0175 m: …": what is kept and why.
std::string text(const Clearance& clearance, const std::optional<Workspace>& map);

}  // namespace krait::host
