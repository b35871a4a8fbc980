/* SPDX-License-Identifier: Apache-2.0 */
/* Plans for a snake; writes "snake STATUS HASH". Exit code: 0 with a plan, 1 without, 2 where planning was refused. */
#include "board.h"
#include "krait/krait.h"

static uint64_t block[32 * 1024];
static krait_scene scene;

static void write_hash(uint64_t hash) {
  char digits[18] = {0};
  for (int i = 0; i < 16; ++i) digits[i] = "0123456789abcdef"[(hash >> (60 - 4 * i)) & 15U];
  digits[16] = '\n';
  write_text(digits);
}

int main(void) {
  const size_t bytes = (size_t)(scene_end - scene_begin);
  if (krait_open(&scene, scene_begin, bytes).status != KRAIT_OK) return 2;

  const krait_robot robot = krait_snake(3);
  const krait_parameters parameters = krait_default_parameters();
  const krait_limits limits = krait_limits_for(sizeof block, &scene, &robot);
  krait_planner* planner;
  if (krait_init(&planner, block, sizeof block, &scene, &robot, &parameters, &limits).status != KRAIT_OK) return 2;

  float start[KRAIT_MAX_STATE];
  if (!krait_rest(&robot, krait_start_pose(&scene, 0), start)) return 2;
  const krait_query query = {start, krait_named_goal(0), 1};
  krait_status status = krait_start(planner, &query);
  while (status == KRAIT_SEARCHING) status = krait_advance(planner, 10);

  write_text("snake ");
  write_text(krait_status_name(status));
  write_text(" ");
  write_hash(krait_statistics_of(planner).hash);
  return status == KRAIT_SOLVED ? 0 : 1;
}
