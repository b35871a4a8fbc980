/* SPDX-License-Identifier: Apache-2.0 */
/* A program in C that plans, for c_interface_test.cpp to compare with the C++ planner. */
#ifndef KRAIT_TESTS_C_PROGRAM_H
#define KRAIT_TESTS_C_PROGRAM_H

#include "krait/krait.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct c_answer {
  krait_failure failure;
  krait_statistics statistics;
  uint32_t states;      /* that the cursor gave */
  bool starts_at_start; /* the first of them is the start */
  bool ends_at_rest;    /* with the last one came a control of zeros, and nothing behind it */
  bool begins_again;    /* after krait_rewind the first of them came once more */
} c_answer;

/* Plans in the file's scene from `pose` to the first goal, `expansions` a call. */
c_answer plan_in_c(const krait_robot* robot, const void* file, size_t file_bytes, krait_pose pose,
                   const krait_limits* limits, uint64_t expansions);

#ifdef __cplusplus
}
#endif

#endif
