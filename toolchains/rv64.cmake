# SPDX-License-Identifier: Apache-2.0
# 64-bit RISC-V with double-precision floating point.
set(krait_arch rv64imafdc)
set(krait_abi lp64d)
set(krait_machine qemu-system-riscv64)
include(${CMAKE_CURRENT_LIST_DIR}/riscv64-unknown-elf.cmake)
