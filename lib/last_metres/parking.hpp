// SPDX-License-Identifier: Apache-2.0
// How robots drive into narrow places in reverse. The functions are called by their addresses, which the tables of the
// models hold that do so (krait/robots/detail/functions.hpp): a program of other models does not contain them.
#pragma once

#include "last_metres/manoeuvre.hpp"

namespace krait::detail {

class LastMetres;

// Each does what the member of its name does.
struct Parking {
  void (*choose)(LastMetres& last_metres, const Pose* poses);  // choose_ways
  bool (*aim)(Manoeuvre& manoeuvre, const Moment& now, Target& target);
  bool (*leg_over)(Manoeuvre& manoeuvre, std::uint32_t steps, const Moment& now);
};

}  // namespace krait::detail
