# GNU for bare-metal RISC-V with picolibc. The file that includes this one sets
#   krait_arch     as -march= takes it. Not with _zicsr, which silently picks the wrong libraries; -misa-spec=2.2
#                  has those instructions in the base set
#   krait_abi      as -mabi= takes it
#   krait_machine  the QEMU program that runs its tests
set(CMAKE_SYSTEM_NAME Generic)
string(REGEX MATCH "rv(32|64)" CMAKE_SYSTEM_PROCESSOR ${krait_arch})
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_C_COMPILER riscv64-unknown-elf-gcc)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
set(CMAKE_ASM_COMPILER riscv64-unknown-elf-gcc)
set(krait_core_options "-march=${krait_arch} -mabi=${krait_abi} -mcmodel=medany -misa-spec=2.2")
foreach(language C CXX ASM)
  set(CMAKE_${language}_FLAGS_INIT "${krait_core_options} -ffunction-sections -fdata-sections")
endforeach()
include(${CMAKE_CURRENT_LIST_DIR}/freestanding_cxx.cmake)

# Debian packages no C++ headers for this compiler; those of newlib for Arm are of the same release of GCC.
set(krait_picolibc /usr/lib/picolibc/riscv64-unknown-elf)
file(GLOB krait_cxx_headers /usr/include/newlib/c++/*)
list(GET krait_cxx_headers -1 krait_cxx_headers)
foreach(folder ${krait_cxx_headers} ${krait_cxx_headers}/arm-none-eabi ${krait_picolibc}/include)
  string(APPEND CMAKE_CXX_FLAGS_INIT " -isystem ${folder}")
endforeach()
string(APPEND CMAKE_C_FLAGS_INIT " -isystem ${krait_picolibc}/include")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-L${krait_picolibc}/lib/${krait_arch}/${krait_abi}")

set(CMAKE_CROSSCOMPILING_EMULATOR
  ${krait_machine} -M virt -bios none -display none -monitor none -serial none -chardev stdio,id=output
  -semihosting-config enable=on,target=native,chardev=output -icount shift=0 -kernel)
include(${CMAKE_CURRENT_LIST_DIR}/find_packages.cmake)
