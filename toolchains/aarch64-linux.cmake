# SPDX-License-Identifier: Apache-2.0
# Linux on 64-bit Arm.
set(krait_triplet aarch64-linux-gnu)
set(krait_processor aarch64)
set(krait_emulator qemu-aarch64)
include(${CMAKE_CURRENT_LIST_DIR}/linux-gnu.cmake)
