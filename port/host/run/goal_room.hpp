// SPDX-License-Identifier: Apache-2.0
// Whether a robot finds room in a goal as it is asked to be turned there, which a disc inside of it may although it
// does not. The first two trailers count where hitches are asked to be straight.
#pragma once

#include "host/run/run.hpp"

namespace krait::host {

struct GoalRoom {
  bool none = false;    // it is proven that no pose of the goal is free
  bool found = false;   // a free pose was found; where neither holds, the search for one ended undecided
  int poses = 0;        // that were tried, the middle of the goal first
  Contact at_middle{};  // what the robot meets there
};

// By branch and bound over places, headings and bends of the hitches, and by the request's clearance: where a body,
// with its border moved in by as much as it moves within a cell, meets something in the cell's middle, it does in every
// pose of the cell. For body 0 alone, then with each of the trailers, 10,000 cells at most. `moved_in`, metres, is how
// far the bodies' borders are moved in beforehand.
GoalRoom room_in_goal(const krait::Scene& scene, const SearchRequest& request, double moved_in = 0);

}  // namespace krait::host
