# SPDX-License-Identifier: Apache-2.0
# Cortex-M7 with double-precision floating point.
set(krait_core cortex-m7)
set(krait_fpu "-mfpu=fpv5-d16 -mfloat-abi=hard")
set(krait_machine mps2-an500)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
