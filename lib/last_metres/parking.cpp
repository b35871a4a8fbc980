// SPDX-License-Identifier: Apache-2.0
#include "last_metres/parking.hpp"

#include "krait/robots/detail/functions.hpp"
#include "last_metres/last_metres.hpp"

namespace krait::detail {
namespace {

void choose_ways(LastMetres& last_metres, const Pose* poses) { last_metres.choose_ways(poses); }

bool aim(Manoeuvre& manoeuvre, const Moment& now, Target& target) { return manoeuvre.aim(now, target); }

bool leg_over(Manoeuvre& manoeuvre, std::uint32_t steps, const Moment& now) {
  return manoeuvre.leg_over(steps, LastMetres::kHold, now);
}

}  // namespace

const Parking kParking = {choose_ways, aim, leg_over};

}  // namespace krait::detail
