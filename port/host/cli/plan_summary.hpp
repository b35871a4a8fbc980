// SPDX-License-Identifier: Apache-2.0
// What krait plan prints of its answer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "host/cli/clearance.hpp"
#include "host/cli/ground.hpp"
#include "host/run/run.hpp"
#include "host/verify/verify.hpp"

namespace krait::host {

// "1 time", "3 times"
std::string times(std::uint64_t count);

// How the search ended, what was asked of it, why there is no plan, or else how long the plan is. `asks_heading`: the
// request's heading is that of the command line and not of the map's goal.
void print_summary(const SearchResult& result, const SearchRequest& request, const Ground& ground, bool asks_heading,
                   const std::optional<Clearance>& clearance);

// What improvement made of the first plan.
void print_improvement(const SearchResult& result, const SearchRequest& request);

// What the verifier measured along the plan.
void print_quality(const SearchResult& result, const SearchRequest& request, const SceneBytes& bytes,
                   const Verdict& verdict);

}  // namespace krait::host
