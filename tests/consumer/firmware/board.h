/* SPDX-License-Identifier: Apache-2.0 */
/* What the firmware asks of a board. */
#ifndef FIRMWARE_BOARD_H
#define FIRMWARE_BOARD_H

#ifdef __cplusplus
extern "C" {
#endif

/* Writes text to whoever listens. */
void write_text(const char* text);

/* The scene that is compiled in. */
extern const unsigned char scene_begin[], scene_end[];

#ifdef __cplusplus
}
#endif

#endif
