# SPDX-License-Identifier: Apache-2.0
# krait_robot_header(HEADER ROBOT PROGRAM) writes HEADER: the ROBOT, the whole path of a ROBOT.json or what else
# `--robot` accepts, as PROGRAM, which is krait, has it. For compiled_robot.cpp its name is compiled.hpp.
function(krait_robot_header header robot program)
  set(file "")
  if(EXISTS ${robot})
    set(file ${robot})
  endif()
  get_filename_component(folder ${header} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  add_custom_command(OUTPUT ${header} VERBATIM DEPENDS ${program} ${file}
    COMMAND ${program} robot ${robot} --cpp ${header} > ${header}.txt)
endfunction()
