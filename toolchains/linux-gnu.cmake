# SPDX-License-Identifier: Apache-2.0
# GNU for Linux. The file that includes this one sets
#   krait_triplet    of the compiler
#   krait_processor  as uname -m gives it
#   krait_emulator   the QEMU program that runs its tests
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR ${krait_processor})
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_C_COMPILER ${krait_triplet}-gcc)
set(CMAKE_CXX_COMPILER ${krait_triplet}-g++)
foreach(language C CXX)
  set(CMAKE_${language}_FLAGS_INIT "-ffunction-sections -fdata-sections")
endforeach()

set(CMAKE_FIND_ROOT_PATH /usr/${krait_triplet})
set(CMAKE_CROSSCOMPILING_EMULATOR ${krait_emulator} -L /usr/${krait_triplet})
include(${CMAKE_CURRENT_LIST_DIR}/find_packages.cmake)
