# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts down: headers, the archive, the pages that headers name, licence and notices, and what
# find_package and pkg-config read. Box2D's part is inside the archive; Eigen's headers are the user's.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/krait)

# First of all: an install that cannot be whole writes nothing.
install(CODE "if(NOT EXISTS \"$<TARGET_FILE:krait>\")
  message(FATAL_ERROR \"krait: nothing is installed, since $<TARGET_FILE:krait> is missing: build the target krait\")
endif()")

install(TARGETS krait EXPORT krait-targets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/krait DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN *.hpp PATTERN version.h PATTERN robot_check.hpp EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR})
# In the folders that they have here, which the comments of headers and their links name.
foreach(folder lib lib/robot)
  file(GLOB pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.md)
  install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder})
endforeach()
foreach(page include/krait/FORMAT.md port/host/robot_file/ROBOTS.md tests/TRUST.md bench/ABLATIONS.md
    bench/targets/RESULTS.md)
  cmake_path(GET page PARENT_PATH folder)
  install(FILES ${PROJECT_SOURCE_DIR}/${page} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder})
endforeach()

install(EXPORT krait-targets NAMESPACE krait:: DESTINATION ${package_folder})
write_basic_package_version_file(krait-config-version.cmake
  COMPATIBILITY SameMinorVersion)  # from 1.0 on SameMajorVersion
install(FILES krait-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/krait-config-version.cmake DESTINATION ${package_folder})

file(RELATIVE_PATH prefix_of_pkgconfig /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
list(TRANSFORM definitions PREPEND -D OUTPUT_VARIABLE cflags)
list(PREPEND cflags ${flags})
list(JOIN cflags " " cflags)
string(REPLACE "\"" "\\\"" cflags "${cflags}")
configure_file(krait.pc.in krait.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/krait.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
