// SPDX-License-Identifier: Apache-2.0
/// \file
/// Names, units and ranges of the parameters of the library's robots, for the files, help and pages of a workstation. A
/// program that does not use them does not contain them.
#pragma once

namespace krait {

/// A number among a robot's parameters P.
template <class P, class Number>
struct ParameterField {
  const char* name;       ///< that of the member, which is that in a ROBOT.json, too
  Number P::*member;      ///< where it stands
  const char* unit = "";  ///< in words, plural; empty for fields that ROBOT.json does not contain because the model
                          ///< determines them
  float least = 0.0F;     ///< in the unit
  float most = 0.0F;      ///< in the unit
};

/// A dimension of a robot.
template <class P>
constexpr ParameterField<P, float> length_field(const char* name, float P::*member) {
  return {name, member, "metres", 0.001F, 1000.0F};
}

/// A limit of a robot: of a speed, a rate or an acceleration.
template <class P>
constexpr ParameterField<P, float> limit_field(const char* name, float P::*member, const char* unit) {
  return {name, member, unit, 0.001F, 1e4F};
}

/// The least speed of a robot, at most 0: below 0 it drives backwards.
template <class P>
constexpr ParameterField<P, float> reverse_field(const char* name, float P::*member) {
  return {name, member, "metres a second", -1e4F, 0.0F};
}

/// The extremes of a robot's motion.
struct Extremes {
  float speed;    ///< m/s, of any body's frame
  float turn;     ///< rad/s, of any body
  float braking;  ///< m/s^2, straight ahead at top speed; 0: it stops at once
};

/// The parameters that a robot of class R has by default.
template <class R>
constexpr typename R::Parameters defaults_of() {
  if constexpr (requires { R::defaults(); }) {
    return R::defaults();
  } else {
    return {};
  }
}

}  // namespace krait
