# SPDX-License-Identifier: Apache-2.0
# Cortex-M3: no floating point in hardware.
set(krait_core cortex-m3)
set(krait_fpu "-mfloat-abi=soft")
set(krait_machine mps2-an385)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
