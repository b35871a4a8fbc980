# SPDX-License-Identifier: Apache-2.0
# Numbers of a board that krait_board must refuse, each with a sentence that names what is wrong; and some that it must
# take. cmake -P refused_boards.cmake
if(DEFINED WORDS)
  include(${CMAKE_CURRENT_LIST_DIR}/../../port/bare_metal/check_board.cmake)
  cmake_parse_arguments(arg "" "COUNTER;STACK;CONSOLE" "FLASH;SCENE;RAM" ${WORDS})
  krait_check_board(my-board)
  return()
endif()

# expect(PATTERN WORD…): what the check says of these words, "" for nothing.
function(expect pattern)
  execute_process(COMMAND ${CMAKE_COMMAND} "-DWORDS=${ARGN}" -P ${CMAKE_CURRENT_LIST_FILE}
    RESULT_VARIABLE code ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  if(pattern STREQUAL "" AND code EQUAL 0)
    return()
  endif()
  if(pattern STREQUAL "" OR code EQUAL 0 OR NOT said MATCHES "krait_board\\(my-board …\\): ${pattern}")
    message(SEND_ERROR "${ARGN}: \"${pattern}\" was expected, and the check said: ${said}")
  endif()
endfunction()

set(flash FLASH 0x08000000 512K)
set(scene SCENE 0x08080000 1M)
set(ram RAM 536870912 131072)
set(counter COUNTER 168000000)
expect("" ${flash} ${scene} ${ram} ${counter})
expect("" ${flash} ${scene} ${ram} ${counter} STACK 0x2000 CONSOLE my_console)
expect("give FLASH an address and a length.*, not \"\"" ${scene} ${ram} ${counter})
expect("give SCENE an address and a length.*, not \"0x08080000\"" ${flash} SCENE 0x08080000 ${ram} ${counter})
expect("give SCENE an address and a length.*, not \"0x08080000;1MB\"" ${flash} SCENE 0x08080000 1MB ${ram} ${counter})
expect("give RAM an address and a length.*, not \"0x20000000;64K;64K\"" ${flash} ${scene} RAM 0x20000000 64K 64K
  ${counter})
expect("give COUNTER .* in hertz.*, not \"\"" ${flash} ${scene} ${ram})
expect("give COUNTER .* in hertz.*, not \"168MHz\"" ${flash} ${scene} ${ram} COUNTER 168MHz)
expect("give STACK a length.*, not \"8KB\"" ${flash} ${scene} ${ram} ${counter} STACK 8KB)
expect("\"FLSH;0x08000000;512K\" is nothing that it knows" FLSH 0x08000000 512K ${scene} ${ram} ${counter})
