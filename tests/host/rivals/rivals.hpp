// SPDX-License-Identifier: Apache-2.0
// The rivals, which share the planner's memory, expansions and plans.
#pragma once

#include "host/rivals/prior.hpp"
#include "host/rivals/rival.hpp"
#include "host/rivals/rrt.hpp"
#include "planner_fixture.hpp"

namespace krait::test {

using rivals::PriorPlanner;
using rivals::RrtPlanner;

}  // namespace krait::test
