# SPDX-License-Identifier: Apache-2.0
# 32-bit RISC-V with single-precision floating point.
set(krait_arch rv32imafc)
set(krait_abi ilp32f)
set(krait_machine qemu-system-riscv32)
include(${CMAKE_CURRENT_LIST_DIR}/riscv64-unknown-elf.cmake)
