// SPDX-License-Identifier: Apache-2.0
/// \file
/// Names, units and ranges of the parameters of the library's robots, for the files, help and pages of a workstation. A
/// program that does not use them does not contain them. Every function is O(1).
///
/// These ranges lie within what a robot's sound() accepts, and are narrower on purpose. sound() is in the flash of
/// every program and refuses only what the planner cannot compute with, such as a length that is 0, negative or not
/// finite. A workstation also refuses what is most likely a mistake of units or typing, such as a body of 10 km.
#pragma once

namespace krait {

/// A number among a robot's parameters P.
template <class P, class Number>
struct ParameterField {
  const char* name;       ///< the name of the member, and of the field in a ROBOT.json
  Number P::*member;      ///< the member
  const char* unit = "";  ///< in words, plural; empty for fields that ROBOT.json does not contain because the model
                          ///< determines them
  float least = 0.0F;     ///< in the unit
  float most = 0.0F;      ///< in the unit
};

inline constexpr float kLeastLimit = 0.001F;   ///< the least of a length or a limit, in its unit
inline constexpr float kMostLength = 1000.0F;  ///< metres: the most of a length
inline constexpr float kMostLimit = 1e4F;      ///< the most of a limit, in its unit

/// The field of a dimension of a robot.
template <class P>
constexpr ParameterField<P, float> length_field(const char* name, float P::*member) {
  return {name, member, "metres", kLeastLimit, kMostLength};
}

/// The field of a limit of a robot: of a speed, a rate or an acceleration.
template <class P>
constexpr ParameterField<P, float> limit_field(const char* name, float P::*member, const char* unit) {
  return {name, member, unit, kLeastLimit, kMostLimit};
}

/// The field of the least speed of a robot, at most 0: below 0 it drives backwards.
template <class P>
constexpr ParameterField<P, float> reverse_field(const char* name, float P::*member) {
  return {name, member, "metres a second", -kMostLimit, 0.0F};
}

/// The extremes of a robot's motion.
struct Extremes {
  float speed;    ///< m/s, of any body's frame
  float turn;     ///< rad/s, of any body
  float braking;  ///< m/s^2, straight ahead at top speed; 0: it stops at once
};

namespace detail {

// m/s: the most of the two limits of a speed, forwards and backwards.
template <class P>
constexpr float fastest(const P& parameters) {
  return parameters.max_speed > -parameters.min_speed ? parameters.max_speed : -parameters.min_speed;
}

}  // namespace detail

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
