# SPDX-License-Identifier: Apache-2.0
# GNU for a machine without an operating system, run by QEMU with semihosting. The file that includes this one sets
#   CMAKE_SYSTEM_PROCESSOR
#   krait_triplet   of the compiler
#   krait_options   that choose the core
#   krait_emulator  the QEMU program with its machine
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_C_COMPILER ${krait_triplet}-gcc)
set(CMAKE_CXX_COMPILER ${krait_triplet}-g++)
set(CMAKE_ASM_COMPILER ${krait_triplet}-gcc)
foreach(language C CXX ASM)
  set(CMAKE_${language}_FLAGS_INIT "${krait_options} -ffunction-sections -fdata-sections")
endforeach()

# Without what needs an operating system or a heap: exceptions, run-time type information, locks around statics,
# destructors at exit, unwind tables, errno.
string(APPEND CMAKE_CXX_FLAGS_INIT
  " -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-use-cxa-atexit -fno-unwind-tables"
  " -fno-asynchronous-unwind-tables -fno-math-errno")

set(CMAKE_CROSSCOMPILING_EMULATOR
  ${krait_emulator} -display none -monitor none -serial none -chardev stdio,id=output
  -semihosting-config enable=on,target=native,chardev=output -icount shift=0 -kernel)
include(${CMAKE_CURRENT_LIST_DIR}/find_packages.cmake)
