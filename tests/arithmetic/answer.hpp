// Asks a planner whether it would plan with the arithmetic of this file.
#pragma once

#include "krait/krait.hpp"

namespace krait::test {

// "exact" or "bad_arithmetic", by the answer of init. Inlined: each file has its own flags.
template <template <class> class AnyPlanner>
[[gnu::always_inline]] inline const char* answer() {
  static AnyPlanner<Unicycle> planner;
  static const Scene scene;
  static const Unicycle robot{UnicycleParameters{}};
  Limits limits;
  limits.vertices = 2;
  const Status status = planner.init(nullptr, 0, scene, robot, Parameters(), limits).status;
  return status == Status::arena_too_small ? "exact" : name(status);
}

}  // namespace krait::test
