# SPDX-License-Identifier: Apache-2.0
# The check of robots, installed only where it was built: `bash port/host/demo` does not build it.
install(CODE "if(NOT EXISTS \"$<TARGET_FILE:krait_robot_check>\")
  message(STATUS \"Not installed: the check of robots, which is not built (target krait_robot_check)\")
  return()
endif()")

install(TARGETS krait_robot_check EXPORT krait-robot-check-targets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${PROJECT_SOURCE_DIR}/include/krait/robot_check.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/krait)
install(EXPORT krait-robot-check-targets NAMESPACE krait:: DESTINATION ${package_folder})
