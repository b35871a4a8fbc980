// SPDX-License-Identifier: Apache-2.0
// The planners that the adaptive one is compared with, which share its memory, expansions and plans.
#pragma once

#include "host/rivals/plain.hpp"
#include "host/rivals/prior.hpp"
#include "host/rivals/rival.hpp"
#include "host/rivals/rrt.hpp"
#include "planner_fixture.hpp"

namespace krait::test {

using rivals::PlainPlanner;
using rivals::PriorPlanner;
using rivals::RrtPlanner;

}  // namespace krait::test
