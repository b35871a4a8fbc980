/* SPDX-License-Identifier: Apache-2.0 */
/* The scene, compiled in: SCENE names the file. */
__asm(
    "  .pushsection .rodata\n"
    "  .balign 4\n"
    "  .global scene_begin\n"
    "  .global scene_end\n"
    "scene_begin:\n"
    "  .incbin \"" SCENE
    "\"\n"
    "scene_end:\n"
    "  .popsection\n");
