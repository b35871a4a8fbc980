// SPDX-License-Identifier: Apache-2.0
// The limits of a robot's states and controls, held against a motion.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host/verify/complaints.hpp"
#include "host/verify/drive.hpp"
#include "host/verify/dynamics.hpp"

namespace krait::host {

// A limit may be passed by 1e-4 of its size. Each quantity that passes its own is named once: with
// the first place where it does, and by how much it does so there and later.
class LimitCheck {
 public:
  // Keeps references.
  LimitCheck(const Dynamics& dynamics, Complaints& complaints);

  // `where` begins each complaint, as in "start".
  void check_state(const std::string& where, const State& state);
  void check_control(const std::string& where, const Control& control);

  // The states of a motion of `time` seconds, and by the parabola through each three of them what lies between.
  void check_leg(const std::string& where, const Leg& leg, double time);

 private:
  struct Place {
    const std::string& where;
    double time = 0;  // seconds; 0: there is nothing to tell apart

    std::string text() const;
  };

  struct Quantity {
    Limit limit;
    std::optional<std::size_t> complaint;  // the one that names it
  };

  void check(const Place& place, double value, Quantity& quantity);

  const Dynamics& dynamics_;
  Complaints& complaints_;
  std::vector<Quantity> of_state_;
  std::vector<Quantity> of_control_;
};

}  // namespace krait::host
