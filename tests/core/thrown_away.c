/* SPDX-License-Identifier: Apache-2.0 */
/* Must not compile: every result that says what went wrong is thrown away. */
#include "krait/krait.h"

void plan(krait_scene* scene, krait_planner* planner, const krait_robot* robot, const krait_setup* setup,
          const krait_query* query, float* state) {
  krait_open(scene, NULL, 0);
  krait_rest(robot, krait_start_pose(scene, 0), state);
  krait_init(&planner, setup, NULL, NULL);
  krait_start(planner, query);
  krait_advance(planner, 1);
  krait_last_failure(planner);
}
