# SPDX-License-Identifier: Apache-2.0
# Cortex-M4 with single-precision floating point.
set(krait_core cortex-m4)
set(krait_fpu "-mfpu=fpv4-sp-d16 -mfloat-abi=hard")
set(krait_machine mps2-an386)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
