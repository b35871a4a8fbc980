// SPDX-License-Identifier: Apache-2.0
// Where a robot cannot stand.
#pragma once

#include <optional>
#include <string>

#include "host/run/run.hpp"

namespace krait::host {

// What the request's robot, at the request's start in the scene, touches or comes nearer to than the clearance: one
// line; nothing where it stands free.
std::optional<std::string> why_it_cannot_start(const krait::Scene& scene, const SearchRequest& request);

// Where the request asks for a heading at the goal, and body 0 stands free in none of some thousand poses that it
// allows, one line on that; nothing where it stands free in one, or the goal may be reached in any heading. It is no
// proof.
std::optional<std::string> why_it_hardly_ends(const krait::Scene& scene, const SearchRequest& request);

}  // namespace krait::host
