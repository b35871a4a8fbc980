# SPDX-License-Identifier: Apache-2.0
# find_package(krait [COMPONENTS cxx c]): the targets krait::krait (cxx), which needs Eigen's headers, and krait::c (c),
# which needs nothing. Without COMPONENTS: cxx, and c where it is installed.
include(CMakeFindDependencyMacro)
set(krait_wanted ${krait_FIND_COMPONENTS})
if(NOT krait_wanted)
  set(krait_wanted cxx)
endif()
if(cxx IN_LIST krait_wanted)
  find_dependency(Eigen3 3.4 NO_MODULE)
endif()
include(${CMAKE_CURRENT_LIST_DIR}/krait-targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/krait-c-targets.cmake OPTIONAL)

set(krait_cxx_FOUND TRUE)
if(TARGET krait::c)
  set(krait_c_FOUND TRUE)
endif()
foreach(component IN LISTS krait_wanted)
  if(krait_FIND_REQUIRED_${component} AND NOT krait_${component}_FOUND)
    set(krait_FOUND FALSE)
    set(krait_NOT_FOUND_MESSAGE
      "krait's component ${component} is not installed here (there are cxx and, once the target krait_c is built, c)")
  endif()
endforeach()
unset(krait_wanted)
