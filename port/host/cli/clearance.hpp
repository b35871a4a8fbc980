// SPDX-License-Identifier: Apache-2.0
// The clearance that krait plan keeps where none is asked for: what a robot that tracks the plan can be off by.
#pragma once

#include <optional>
#include <string>

#include "host/run/session.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

constexpr float kLeastClearance = Parameters{}.clearance;  // a millimetre

// Metres.
struct Clearance {
  float kept = 0;        // from kLeastClearance to `usual`
  float usual = 0;       // 2 % of the robot's width and, on a map of cells, half a cell
  std::string narrow;    // what has too little room for twice the usual, "the start has"; empty where there is room
  float in_vain = 0;     // what was kept by a search before this one; 0: by none
  bool no_room = false;  // that one left the robot no room in the goal; else it used up its iterations
};

// The usual clearance, halved until start and widest way to the goal have room for twice as much, so that a search has
// room to move; at least kLeastClearance. A few set-ups of the request's search, in its block. Throws InputError as
// those do, but not for obstacles in the way.
Clearance usual_clearance(const krait::Scene& scene, const SearchRequest& request, const std::optional<Workspace>& map,
                          Block& block);

// "clearance 0.0175 m: …": what is kept and why.
std::string text(const Clearance& clearance, const std::optional<Workspace>& map);

}  // namespace krait::host
