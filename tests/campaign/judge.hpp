// SPDX-License-Identifier: Apache-2.0
// Judges a plan by what its controls do: driven from its first state in double precision and swept.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "drive.hpp"
#include "field.hpp"

namespace krait::campaign {

// What the core gave: (steps + 1) * state_size and steps * 2 floats.
struct PlanRecord {
  std::vector<float> states;
  std::vector<float> controls;
  float dt = 0;
};

struct Disc {
  double x, y, radius;
};
using Region = std::variant<host::Ring, Disc>;  // the goal, in the field's coordinates

struct Verdict {
  // One line each: what, when and by how much.
  std::vector<std::string> collisions;
  std::vector<std::string> off_limits;
  std::vector<std::string> misses;  // of the goal
  std::vector<std::string> others;  // states that are not where the controls lead, NaN, what cannot be driven

  bool holds() const { return collisions.empty() && off_limits.empty() && misses.empty() && others.empty(); }

  double clearance = 0;       // m, the least seen: to obstacles, bounds and between bodies; negative: overlap
  double position_error = 0;  // m, the largest distance of a stored position from the driven one
  double angle_error = 0;     // rad, of a stored heading or steering angle from the driven one
  double excess = 0;          // the largest beyond a limit, as a share of it
  double depth = 0;           // m, of the driven end in the goal; negative outside
  int most_parts = 0;         // that a time step was divided into
};

// Between two poses that are looked at no point of a body goes further than kCoarsest, or it is proven by the distances
// at both that nothing comes nearer than kCare in between.
inline constexpr double kCare = 5e-4;           // m
inline constexpr double kCoarsest = 1e-4;       // m
inline constexpr double kLimitShare = 1e-4;     // of a limit: rounding that is let pass
inline constexpr double kPositionError = 5e-4;  // m, of a stored state, and
inline constexpr double kPositionShare = 5e-6;  // of the way of body 0's ends more, and by what a heading
inline constexpr double kHeadingShare = 6e-8;   // as a float is off by, of itself, times that way
inline constexpr double kAngleError = 2e-3;     // rad, of a stored state: twice what a plan's proof allows

Verdict judge(const Robot& robot, const Field& field, const Region& goal, const PlanRecord& plan);

}  // namespace krait::campaign
