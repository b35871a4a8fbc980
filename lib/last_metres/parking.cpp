// SPDX-License-Identifier: Apache-2.0
#include "last_metres/parking.hpp"

#include "krait/robots/detail/functions.hpp"
#include "last_metres/last_metres.hpp"

namespace krait::detail {
namespace {

void choose_ways(LastMetres& last_metres, const Pose* poses) { last_metres.choose_ways(poses); }

bool aim(PullIn& pull_in, const Moment& now, Target& target) { return pull_in.aim(now, target); }

bool leg_over(PullIn& pull_in, std::uint32_t steps, const Moment& now) {
  return pull_in.leg_over(steps, LastMetres::kHold, now);
}

}  // namespace

const Parking kParking = {choose_ways, aim, leg_over};

}  // namespace krait::detail
