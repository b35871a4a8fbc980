# SPDX-License-Identifier: Apache-2.0
# Linux on 32-bit Arm (ARMv7, VFPv3-D16: no NEON, which flushes denormals).
set(krait_triplet arm-linux-gnueabihf)
set(krait_processor armv7l)
set(krait_emulator qemu-arm)
include(${CMAKE_CURRENT_LIST_DIR}/linux-gnu.cmake)
