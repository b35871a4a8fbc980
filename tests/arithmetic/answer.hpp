// SPDX-License-Identifier: Apache-2.0
// Asks a planner whether it would plan with the arithmetic of this file.
#pragma once

#include "krait/krait.hpp"

namespace krait::test {

// A robot that is compiled in this file.
class OwnUnicycle : public Unicycle {
 public:
  using Unicycle::Unicycle;
};

// "exact" or "bad_arithmetic", by the answer of init, which next finds that the scene was not opened. Inlined: each
// file has its own flags.
[[gnu::always_inline]] inline const char* answer() {
  static Planner planner;
  static const Scene scene;
  static const OwnUnicycle robot{UnicycleParameters{}};
  const Failure failure = planner.init({nullptr, 0, &scene, robot});
  const bool not_opened =
      failure.status == Status::bad_argument && failure.element == static_cast<std::uint32_t>(Argument::scene);
  return not_opened ? "exact" : to_string(failure.status);
}

}  // namespace krait::test
