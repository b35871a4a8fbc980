# SPDX-License-Identifier: Apache-2.0
# The C interface, installed only where it was built: `bash port/host/demo` does not build it.
install(CODE "if(NOT EXISTS \"$<TARGET_FILE:krait_c>\")
  message(STATUS \"Not installed: the C interface, which is not built (target krait_c)\")
  return()
endif()")

install(TARGETS krait_c EXPORT krait-c-targets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${PROJECT_SOURCE_DIR}/include/krait/krait.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/krait)
install(EXPORT krait-c-targets NAMESPACE krait:: DESTINATION ${package_folder})
configure_file(krait-c.pc.in krait-c.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/krait-c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

if(NOT TARGET krait_c_robot_check)
  return()
endif()
install(CODE "if(NOT EXISTS \"$<TARGET_FILE:krait_c_robot_check>\")
  message(STATUS \"Not installed: the check of robots in C, which is not built (target krait_c_robot_check)\")
  return()
endif()")

install(TARGETS krait_c_robot_check EXPORT krait-c-robot-check-targets INCLUDES
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT krait-c-robot-check-targets NAMESPACE krait:: DESTINATION ${package_folder})
configure_file(krait-c-robot-check.pc.in krait-c-robot-check.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/krait-c-robot-check.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
