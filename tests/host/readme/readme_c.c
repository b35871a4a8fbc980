/* SPDX-License-Identifier: Apache-2.0 */
/* Compiles the lines of C of USING.md. */
#include "krait/krait.h"

void drive(const float* control);
int plan_and_drive(krait_scene scene, krait_robot robot, krait_query query);

static uint64_t block[1024];

int plan_and_drive(krait_scene scene, krait_robot robot, krait_query query) {
  krait_planner* planner;
  float state[KRAIT_MAX_STATE];
  float control[KRAIT_CONTROL];
#include "readme_c.inc"
  return status == KRAIT_SOLVED ? 0 : 1;
}
