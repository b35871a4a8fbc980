// SPDX-License-Identifier: Apache-2.0
// The scene, linked into the program: KRAIT_SCENE names the file.
__asm(
    "  .pushsection .scene, \"a\"\n"
    "  .balign 4\n"
    "  .incbin \"" KRAIT_SCENE
    "\"\n"
    "  .popsection\n");
