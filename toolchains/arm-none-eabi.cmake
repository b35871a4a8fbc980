# SPDX-License-Identifier: Apache-2.0
# GNU Arm Embedded for a Cortex-M core. The file that includes this one sets
#   krait_core     the core, as -mcpu= takes it
#   krait_fpu      the options that choose its floating point
#   krait_machine  the QEMU machine that runs its tests
string(REGEX REPLACE "[+].*" "" CMAKE_SYSTEM_PROCESSOR ${krait_core})
set(krait_triplet arm-none-eabi)
set(krait_options "-mcpu=${krait_core} -mthumb ${krait_fpu}")
set(krait_emulator qemu-system-arm -M ${krait_machine})
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
