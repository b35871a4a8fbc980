/* SPDX-License-Identifier: Apache-2.0 */
#include "c_program.h"

#include <string.h>

static uint64_t block[1 << 18];
static krait_scene scene;

static void read_plan(krait_planner* planner, const float* start, uint32_t state_size, c_answer* answer) {
  float state[KRAIT_MAX_STATE];
  float control[KRAIT_CONTROL] = {0};
  while (krait_next(planner, state, control)) {
    if (answer->states == 0) answer->starts_at_start = memcmp(state, start, state_size * sizeof *state) == 0;
    ++answer->states;
  }
  answer->ends_at_rest = control[0] == 0.0F && control[1] == 0.0F && !krait_next(planner, state, control);
  krait_rewind(planner);
  answer->begins_again = krait_next(planner, state, control) && memcmp(state, start, state_size * sizeof *state) == 0;
}

c_answer plan_in_c(const krait_robot* robot, const void* file, size_t file_bytes, krait_pose pose,
                   const krait_limits* limits, uint64_t expansions) {
  c_answer answer = {.states = 0};
  answer.failure = krait_open(&scene, file, file_bytes);
  if (answer.failure.status != KRAIT_OK) return answer;

  const krait_parameters parameters = krait_default_parameters();
  const krait_setup setup = {block, sizeof block, &scene, robot};
  krait_planner* planner = NULL;
  answer.failure = krait_init(&planner, &setup, &parameters, limits);
  if (planner == NULL) return answer;

  float start[KRAIT_MAX_STATE];
  if (!krait_rest(robot, pose, start)) return answer;
  const krait_query query = {.start = start, .goal = krait_named_goal(0), .seed = 1};
  krait_status status = krait_start(planner, &query);
  while (status == KRAIT_SEARCHING) status = krait_advance(planner, expansions);

  answer.failure = krait_last_failure(planner);
  answer.statistics = krait_statistics_of(planner);
  read_plan(planner, start, krait_state_size(robot), &answer);
  return answer;
}
