// SPDX-License-Identifier: Apache-2.0
// Must not compile: every result that says what went wrong is thrown away.
#include "krait/krait.hpp"

void plan(krait::Planner& planner, const krait::Scene& scene, const krait::Unicycle& robot) {
  krait::Scene opened;
  krait::Scene::open(nullptr, 0, opened);
  planner.init({nullptr, 0, &scene, robot});
  planner.start(krait::Query());
  planner.advance(1);
  planner.advance(1, [](const float*, const float*) {});
  planner.status();
  planner.failure();
}
