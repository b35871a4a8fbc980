/* SPDX-License-Identifier: Apache-2.0 */
#include <stdio.h>

#include "hoverer.h"
#include "krait/krait.h"

/* The hoverer's, but half as far. */
static bool travel_too_little(const void* self, const float* s, const float* u, float dt, const float* next,
                              krait_travel* travel) {
  const bool limits_hold = hoverer.travel(self, s, u, dt, next, travel);
  travel[0].path *= 0.5F;
  return limits_hold;
}

static uint32_t check(const krait_functions* functions) {
  static const krait_range states[] = {{-9, 9}, {-9, 9}, {-1, 1}, {-1, 1}};
  static const krait_range controls[] = {{-2, 2}, {-2, 2}};
  const krait_robot robot = krait_own_robot(functions, NULL);
  const krait_ranges ranges = krait_default_ranges(states, controls);
  char text[2000];
  const uint32_t faults = krait_check_robot(&robot, &ranges, 1000, 1, text, sizeof text);
  printf("%s", text);
  return faults;
}

int main(void) {
  krait_functions leaper = hoverer;
  leaper.travel = travel_too_little;
  return check(&hoverer) == 0 && check(&leaper) > 0 ? 0 : 1;
}
