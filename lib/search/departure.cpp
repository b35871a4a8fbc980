// SPDX-License-Identifier: Apache-2.0
#include "search/departure.hpp"

namespace krait::detail {
namespace {

// Measured: bench/ABLATIONS.md, "Cars leave narrow places".
constexpr float kAway = 2.0F;  // lengths of body 0

const Expanded* iterate(Departure& departure, Expander& expander, const Watch& watch) {
  return departure.iterate(expander, watch);
}

}  // namespace

const Departing kDeparting = {iterate};

const Expanded* Departure::iterate(Expander& expander, const Watch& watch) {
  begin();
  if (skips_ || (!driving_ && (!due(expander) || !begin_way(expander)))) return nullptr;
  const Outcome outcome = drive(expander, watch);
  driving_ = outcome == Outcome::goes_on;
  // One that failed before its last move has kept no state, so that the tree has not come away by it.
  const bool failed = outcome == Outcome::collision || outcome == Outcome::target_not_reached;
  const bool kept = expander.last_metres().manoeuvre().on_last_move();
  if (failed && !kept) expander.place(expander.tools().tree->state(kRoot));
  return &expander.end_legs(outcome);
}

void Departure::begin() {
  if (query_begins_) {
    far_out_ = hopeless_ = false;
    ways_ = next_ = 0;
  }
  if (try_begins_) {
    away_ = driving_ = false;
    waited_ = 0;
  }
  query_begins_ = try_begins_ = false;
}

bool Departure::due(const Expander& expander) {
  const ExpanderTools& tools = expander.tools();
  const std::uint32_t patience = tools.parameters->tuning.stuck_expansions;
  if (away_ || hopeless_ || patience == 0) return false;
  const float* const start = tools.tree->state(kRoot);
  const float* const last = expander.state();
  away_ = length(Vec2{last[0] - start[0], last[1] - start[1]}) > kAway * tools.robot_length;
  if (away_ || ++waited_ <= patience) return false;
  waited_ = 0;
  return true;
}

bool Departure::begin_way(Expander& expander) {
  LastMetres& last_metres = expander.last_metres();
  hopeless_ = !last_metres.parks();
  if (hopeless_) return false;
  expander.begin_legs();
  const bool all_driven = next_ == ways_;
  if (all_driven) {
    far_out_ = !far_out_;
    next_ = 0;
  }
  if (all_driven || !last_metres.ways_lead_from_start()) {
    ways_ = last_metres.find_ways_from(expander.now().at(), far_out_);
    hopeless_ = ways_ == 0;
  }
  if (hopeless_) return false;
  last_metres.manoeuvre().begin_outward(static_cast<std::uint8_t>(next_++));
  leg_steps_ = 0;
  return true;
}

Outcome Departure::drive(Expander& expander, const Watch& watch) {
  const Manoeuvre& manoeuvre = expander.last_metres().manoeuvre();
  for (std::uint32_t remaining = expander.tools().parameters->tuning.max_steps; remaining > 0; --remaining) {
    if (!leg_goes_on(expander)) {
      return manoeuvre.arrived(expander.now()) ? Outcome::target_reached : Outcome::target_not_reached;
    }
    const Outcome outcome = expander.take_leg_step(manoeuvre.on_last_move(), watch);
    if (outcome != Outcome::target_not_reached) return outcome;
    ++leg_steps_;
  }
  return Outcome::goes_on;
}

bool Departure::leg_goes_on(Expander& expander) {
  Manoeuvre& manoeuvre = expander.last_metres().manoeuvre();
  const Moment now = expander.now();
  if (leg_steps_ > 0 && !manoeuvre.leg_over(leg_steps_, 1, now)) return true;
  leg_steps_ = 0;
  Target target;
  return !manoeuvre.arrived(now) && manoeuvre.aim(now, target) && expander.begin_leg(target);
}

}  // namespace krait::detail
