# SPDX-License-Identifier: Apache-2.0
# Cortex-M55 without its vector unit, whose arithmetic flushes denormals.
set(krait_core cortex-m55+nomve)
set(krait_fpu "-mfloat-abi=hard")
set(krait_machine mps3-an547)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
