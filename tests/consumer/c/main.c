/* SPDX-License-Identifier: Apache-2.0 */
/* Plans for a snake and for a robot of its own; writes a line "ROBOT STATUS HASH" each. Exit code: the number of robots
   without a plan, 100 for a scene that cannot be used. */
#include "board.h"
#include "hoverer.h"
#include "krait/krait.h"

static uint64_t block[32 * 1024];
static krait_scene scene;

static void write_hash(uint64_t hash) {
  char digits[18] = {0};
  for (int i = 0; i < 16; ++i) digits[i] = "0123456789abcdef"[(hash >> (60 - 4 * i)) & 15U];
  digits[16] = '\n';
  write_text(digits);
}

static int report(const char* name, const krait_robot* robot, const float* start) {
  const krait_setup setup = {block, sizeof block, &scene, robot};
  krait_planner* planner;
  krait_status status = krait_init(&planner, &setup, NULL, NULL).status;
  const krait_query query = {start, krait_named_goal(0), 1};
  if (status == KRAIT_OK) status = krait_start(planner, &query);
  while (status == KRAIT_SEARCHING) status = krait_advance(planner, 10);

  write_text(name);
  write_text(" ");
  write_text(krait_status_name(status));
  write_text(" ");
  write_hash(status == KRAIT_SOLVED ? krait_statistics_of(planner).hash : 0);
  return status == KRAIT_SOLVED ? 0 : 1;
}

static int plan_for_snake(krait_pose pose) {
  const krait_robot robot = krait_snake(3);
  float start[KRAIT_MAX_STATE];
  return krait_rest(&robot, pose, start) ? report("snake", &robot, start) : 1;
}

static int plan_for_hoverer(krait_pose pose) {
  const krait_robot robot = krait_own_robot(&hoverer, NULL);
  const float start[] = {pose.x, pose.y, 0.0F, 0.0F};
  return report("hoverer", &robot, start);
}

int main(void) {
  const size_t bytes = (size_t)(scene_end - scene_begin);
  if (krait_open(&scene, scene_begin, bytes).status != KRAIT_OK) return 100;
  if (krait_facts(&scene).starts == 0) return 100;
  const krait_pose pose = krait_start_pose(&scene, 0);
  return plan_for_snake(pose) + plan_for_hoverer(pose);
}
