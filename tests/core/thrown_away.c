/* SPDX-License-Identifier: Apache-2.0 */
/* Must not compile: every result that says what went wrong is thrown away. */
#include "krait/krait.h"

void plan(krait_scene* scene, krait_planner* planner, const krait_robot* robot, const krait_setup* setup,
          const krait_query* query, const krait_ranges* ranges, float* state, float* control) {
  krait_open(scene, NULL, 0);
  krait_rest(robot, krait_start_pose(scene, 0), state);
  krait_init(&planner, setup, NULL, NULL);
  krait_start(planner, query);
  krait_advance(planner, 1);
  krait_improve(planner, 1);
  krait_last_failure(planner);
  krait_next(planner, state, control);
  krait_check_robot(robot, ranges, 1, 1, NULL, 0);
}
