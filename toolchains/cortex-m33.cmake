# SPDX-License-Identifier: Apache-2.0
# Cortex-M33 with single-precision floating point.
set(krait_core cortex-m33)
set(krait_fpu "-mfpu=fpv5-sp-d16 -mfloat-abi=hard")
set(krait_machine mps2-an505)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
