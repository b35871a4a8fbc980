// SPDX-License-Identifier: Apache-2.0
// How a robot leaves a narrow place, such as a parking space: where the tree stays near the start, the robot is driven
// along ways out of it that body 0 could go (PullOuts), and the tree grows on from their last moves.
#pragma once

#include "search/expander.hpp"

namespace krait::detail {

class Departure {
 public:
  // Before the first iteration.
  void begin_query() {
    query_begins_ = true;
    skipped_ = false;
  }
  // And whenever the tree begins anew. Ways that were not driven in the try before come first then.
  void begin_try() {
    try_begins_ = true;
    skips_ = false;
  }
  // And then, where the try is the first of a search that improves a plan: of these every other one does without.
  void begin_restarted() {
    skipped_ = !skipped_;
    skips_ = skipped_;
  }

  // Drives the next way, or the next max_steps steps of one. Returns what became of it, of which the outcome is goes_on
  // where it has not ended; or null, since the tree has come away from the start, or has not made stuck_expansions
  // expansions since the last way, or there is no way. Now and then it first finds the ways, by at most nine times
  // PullOuts::kMostLooks placements of body 0.
  const Expanded* iterate(Expander& expander, const Watch& watch);

 private:
  // Resets what a query or a try begins with: here, since every program contains begin_query and begin_try.
  void begin();

  // Whether a way is to be driven now.
  bool due(const Expander& expander);

  // Begins the next way. False where there is none.
  bool begin_way(Expander& expander);

  // Drives on for at most max_steps steps.
  Outcome drive(Expander& expander, const Watch& watch);

  // Whether the leg goes on, or another has begun.
  bool leg_goes_on(Expander& expander);

  // What follows has values since begin_query and begin_try, or begin.
  bool query_begins_;
  bool try_begins_;
  bool skipped_;             // whether the last search that improves a plan has begun without
  bool skips_;               // whether this try does
  bool away_;                // whether the tree has come away from the start in this try
  bool driving_;             // whether a way is driven
  bool far_out_;             // whether the ways are those that end with a long arc, rather
  bool hopeless_;            // whether there is no way out
  int ways_;                 // that were found
  int next_;                 // the way that is driven next
  std::uint32_t waited_;     // expansions since the last way
  std::uint32_t leg_steps_;  // of the leg that is driven
};

// Reached through the table of a model that parks: a program of other models does not contain it.
struct Departing {
  const Expanded* (*iterate)(Departure& departure, Expander& expander, const Watch& watch);
};

}  // namespace krait::detail
