/* SPDX-License-Identifier: Apache-2.0 */
/* A robot of the firmware's own. */
#ifndef HOVERER_H
#define HOVERER_H

#include "krait/krait.h"

extern const krait_functions hoverer;

#endif
