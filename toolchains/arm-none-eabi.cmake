# GNU Arm Embedded for a Cortex-M core. The file that includes this one sets
#   krait_core     the core, as -mcpu= takes it
#   krait_fpu      the options that choose its floating point
#   krait_machine  the QEMU machine that runs its tests
set(CMAKE_SYSTEM_NAME Generic)
string(REGEX REPLACE "[+].*" "" CMAKE_SYSTEM_PROCESSOR ${krait_core})
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc)
set(krait_core_options "-mcpu=${krait_core} -mthumb ${krait_fpu}")
foreach(language C CXX ASM)
  set(CMAKE_${language}_FLAGS_INIT "${krait_core_options} -ffunction-sections -fdata-sections")
endforeach()
include(${CMAKE_CURRENT_LIST_DIR}/freestanding_cxx.cmake)

set(CMAKE_CROSSCOMPILING_EMULATOR
  qemu-system-arm -M ${krait_machine} -display none -monitor none -serial none -chardev stdio,id=output
  -semihosting-config enable=on,target=native,chardev=output -icount shift=0 -kernel)
include(${CMAKE_CURRENT_LIST_DIR}/find_packages.cmake)
