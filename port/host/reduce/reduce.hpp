// SPDX-License-Identifier: Apache-2.0
// Makes a map smaller before it is compiled: what is left out, how coarse its cells are, what a robot cannot touch. No
// place becomes free that was not.
#pragma once

#include <optional>

#include "host/reduce/girth.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

struct Box {
  Point min;
  Point max;
};

// In the order in which they act; metres.
struct Reduction {
  std::optional<Box> crop;         // crop.hpp
  std::optional<double> cell;      // resample.hpp
  std::optional<Girth> fill;       // fill.hpp
  std::optional<double> corridor;  // corridor.hpp
  Girth disc;                      // whose ways a corridor is around
};

// Warnings, among them those that name passages that larger cells close and goals that a disc cannot get to, go to the
// workspace's. Throws InputError where an operation does, where a drawing has no cells for one, where larger cells
// close every way from the starts to the goals that there was, and where a disc can get to no goal.
Workspace reduced(Workspace workspace, const Reduction& reduction);

}  // namespace krait::host
