/* SPDX-License-Identifier: Apache-2.0 */
#include "../board.h"

#include <stdio.h>

void write_text(const char* text) { fputs(text, stdout); }
