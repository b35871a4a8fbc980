// SPDX-License-Identifier: Apache-2.0
// What a plan is held to: what the command line asks, in terms of the map itself.
#pragma once

#include "host/input/progress.hpp"
#include "host/run/run.hpp"
#include "host/verify/verify.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

// The request's start and goal, those of the map where the request names one of them or none (then its first). Throws
// InputError where the map has none such.
Asked asked_of(const Workspace& workspace, const SearchRequest& request);

// Judges the plan by that, and shows how many of its steps are driven. Throws as verify.
Verdict judged(const Workspace& workspace, const PlanFile& plan, const Asked& asked, Progress& progress);

}  // namespace krait::host
