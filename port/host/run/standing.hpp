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

// Where it is proven that body 0 has no room in the goal, turned as the request asks for, one line on that.
std::optional<std::string> why_it_never_ends(const krait::Scene& scene, const SearchRequest& request);

// The same where it stands free in none of the poses that were tried, which is no proof.
std::optional<std::string> why_it_hardly_ends(const krait::Scene& scene, const SearchRequest& request);

}  // namespace krait::host
