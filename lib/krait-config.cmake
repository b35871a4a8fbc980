# SPDX-License-Identifier: Apache-2.0
# find_package(krait [COMPONENTS cxx c robot_check c_robot_check]): the targets krait::krait (cxx) and
# krait::robot_check (robot_check), which need Eigen's headers, and krait::c (c) and krait::c_robot_check
# (c_robot_check), which do not. Without COMPONENTS: cxx, and the others where they are installed. An optional component
# that needs Eigen is not found without it.
include(CMakeFindDependencyMacro)
set(krait_wanted ${krait_FIND_COMPONENTS})
if(NOT krait_wanted)
  set(krait_wanted cxx)
endif()
# Eigen is required with a component that is; where all that need it are optional, they are not found without it.
set(krait_has_eigen TRUE)
foreach(component IN ITEMS cxx robot_check)
  if(component IN_LIST krait_wanted AND (krait_FIND_REQUIRED_${component} OR NOT krait_FIND_COMPONENTS))
    find_dependency(Eigen3 3.4 NO_MODULE)
  elseif(component IN_LIST krait_wanted)
    find_package(Eigen3 3.4 NO_MODULE QUIET)
    set(krait_has_eigen ${Eigen3_FOUND})
  endif()
endforeach()
include(${CMAKE_CURRENT_LIST_DIR}/krait-targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/krait-c-targets.cmake OPTIONAL)
include(${CMAKE_CURRENT_LIST_DIR}/krait-robot-check-targets.cmake OPTIONAL)
if(TARGET krait::c AND TARGET krait::robot_check)
  include(${CMAKE_CURRENT_LIST_DIR}/krait-c-robot-check-targets.cmake OPTIONAL)
endif()

set(krait_cxx_FOUND ${krait_has_eigen})
foreach(component IN ITEMS c robot_check c_robot_check)
  if(TARGET krait::${component})
    set(krait_${component}_FOUND TRUE)
  endif()
endforeach()
if(NOT krait_has_eigen)
  set(krait_robot_check_FOUND FALSE)
endif()
foreach(component IN LISTS krait_wanted)
  if(krait_FIND_REQUIRED_${component} AND NOT krait_${component}_FOUND)
    set(krait_FOUND FALSE)
    set(krait_NOT_FOUND_MESSAGE
      "krait's component ${component} is not installed here (there are cxx and, once its target krait_c, \
krait_robot_check or krait_c_robot_check is built, c, robot_check or c_robot_check)")
  endif()
endforeach()
unset(krait_wanted)
unset(krait_has_eigen)
