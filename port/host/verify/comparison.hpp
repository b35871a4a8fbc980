// SPDX-License-Identifier: Apache-2.0
// A plan's stored states, held against those that its controls lead to.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/verify/complaints.hpp"
#include "host/verify/dynamics.hpp"

namespace krait::host {

class Comparison {
 public:
  // Keeps references. `dt` in seconds.
  Comparison(const Dynamics& dynamics, double dt, Complaints& complaints);

  // The next state in order, the first is number 0: as driven, `length` metres from the start, as stored, and as the
  // plan has it, whose floats tell how much rounding may do. The first state that disagrees is named.
  void add(const State& driven, double length, const State& stored, const std::vector<float>& floats);

  bool failed() const { return failed_; }
  double worst_difference() const { return worst_difference_; }
  double worst_change() const { return worst_change_; }

 private:
  // A figure, what it may be, and the component of the state that it belongs to.
  struct Worst {
    double value = 0;
    double limit = 1;
    std::size_t component = 0;

    void add(double other_value, double other_limit, std::size_t other_component);
    bool passes() const { return !(value <= limit); }
  };

  void judge(const Worst& difference, const Worst& change);

  const Dynamics& dynamics_;
  double dt_;
  Complaints& complaints_;
  std::size_t count_ = 0;
  State differences_;  // of the last state
  State roundings_;
  bool failed_ = false;
  double worst_difference_ = 0;
  double worst_change_ = 0;
};

}  // namespace krait::host
