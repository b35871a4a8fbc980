/* SPDX-License-Identifier: Apache-2.0 */
/* The firmware's own robot, as in ../firmware/hoverer.hpp: a hovering box, pushed along x and y. State x y vx vy,
   control the accelerations. Compiled with -ffp-contract=off, so that it computes the same everywhere. */
#include "hoverer.h"

#include <math.h>

static float norm(float x, float y) { return sqrtf(x * x + y * y); }

static float clamped(float x) { return x < -2.0F ? -2.0F : x > 2.0F ? 2.0F : x; }

static void derivative(const void* self, const float* s, const float* u, float* ds) {
  (void)self;
  ds[0] = s[2];
  ds[1] = s[3];
  ds[2] = u[0];
  ds[3] = u[1];
}

static void steer(const void* self, const float* s, const krait_target* target, float* u) {
  (void)self;
  const float x = target->x - s[0];
  const float y = target->y - s[1];
  const float speed = target->speed / (norm(x, y) + 0.1F);
  u[0] = clamped(5.0F * (speed * x - s[2]));
  u[1] = clamped(5.0F * (speed * y - s[3]));
}

static bool within_limits(const void* self, const float* s) {
  (void)self;
  return s[2] * s[2] + s[3] * s[3] <= 2.0F;
}

static krait_polygon body(const void* self, int k) {
  static const krait_point corners[] = {{-0.3F, -0.3F}, {0.3F, -0.3F}, {0.3F, 0.3F}, {-0.3F, 0.3F}};
  (void)self;
  (void)k;
  const krait_polygon box = {corners, 4};
  return box;
}

static void place(const void* self, const float* s, krait_frame* frames) {
  (void)self;
  frames[0].x = s[0];
  frames[0].y = s[1];
  frames[0].sin = 0.0F;
  frames[0].cos = 1.0F;
}

static bool travel(const void* self, const float* s, const float* u, float dt, const float* next, krait_travel* most) {
  (void)self;
  (void)next;
  const float faster = dt * norm(u[0], u[1]); /* the speed changes by */
  most[0].path = dt * (norm(s[2], s[3]) + faster);
  most[0].turn = 0.0F;
  most[0].bend = dt * faster / 8.0F;
  most[0].twist = 0.0F;
  return true; /* the limits hold all the way: they do at both ends, and the velocity goes straight */
}

const krait_functions hoverer = {
    .exact = krait_exact,
    .state_size = 4,
    .control_size = 2,
    .body_count = 1,
    .derivative = derivative,
    .steer = steer,
    .within_limits = within_limits,
    .body = body,
    .place = place,
    .travel = travel,
};
