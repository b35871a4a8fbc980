// SPDX-License-Identifier: Apache-2.0
// The part of a map around the ways from its starts to its goals.
#pragma once

#include "host/reduce/girth.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

// Free cells stay free within `width` metres of a way of the girth's inner disc from a start to a goal, and those in
// one block of half that width with such a cell, so that the border has few corners; all others become occupied. A way
// is the shortest over the cells around whose middles the disc surely fits, or, where there is none, over those in
// which it may fit (disc.hpp), straightened where its points see each other over such cells; from every start to every
// goal. It begins at the nearest such cell that the disc can get to from where the start stands, within `width`, and
// so never behind a wall. A goal in which the disc fits nowhere is reached within girth.outer of it, on the same side
// of walls. Throws InputError where there is no start or no goal, where a start has no way to any goal, and for a width
// below girth.outer; a goal that no way leads to is warned of.
CellMap within_corridor(const CellMap& map, double width, const Girth& girth, const std::vector<Start>& starts,
                        const std::vector<Goal>& goals, std::vector<std::string>& warnings);

}  // namespace krait::host
