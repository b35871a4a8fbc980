# SPDX-License-Identifier: Apache-2.0
# GNU for bare-metal RISC-V with picolibc. The file that includes this one sets
#   krait_arch     as -march= takes it. Not with _zicsr, which silently picks the wrong libraries; -misa-spec=2.2
#                  has those instructions in the base set
#   krait_abi      as -mabi= takes it
#   krait_machine  the QEMU program that runs its tests
string(REGEX MATCH "rv(32|64)" CMAKE_SYSTEM_PROCESSOR ${krait_arch})
set(krait_triplet riscv64-unknown-elf)
set(krait_options "-march=${krait_arch} -mabi=${krait_abi} -mcmodel=medany -misa-spec=2.2")
set(krait_emulator ${krait_machine} -M virt -bios none)
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)

# Debian packages no C++ headers for this compiler; those of newlib for Arm are of the same release of GCC.
set(krait_picolibc /usr/lib/picolibc/riscv64-unknown-elf)
file(GLOB krait_cxx_headers /usr/include/newlib/c++/*)
list(GET krait_cxx_headers -1 krait_cxx_headers)
foreach(folder ${krait_cxx_headers} ${krait_cxx_headers}/arm-none-eabi ${krait_picolibc}/include)
  string(APPEND CMAKE_CXX_FLAGS_INIT " -isystem ${folder}")
endforeach()
string(APPEND CMAKE_C_FLAGS_INIT " -isystem ${krait_picolibc}/include")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-L${krait_picolibc}/lib/${krait_arch}/${krait_abi}")
