# SPDX-License-Identifier: Apache-2.0
# Makes the target krait_box2d: the headers and the one file of Box2D 2.4.1 that the core uses, its polygon distance.
# The variable KRAIT_BOX2D_SOURCE, of CMake or else of the environment, names an unpacked source, for builds without a
# network or with krait in FetchContent; without it, port/host/setup puts one into build/deps/box2d.
set(KRAIT_BOX2D_SOURCE "$ENV{KRAIT_BOX2D_SOURCE}" CACHE PATH "Unpacked source of Box2D 2.4.1")
set(box2d ${KRAIT_BOX2D_SOURCE})
if(NOT box2d)
  set(box2d ${PROJECT_SOURCE_DIR}/build/deps/box2d)
endif()
set(box2d_distance ${box2d}/src/collision/b2_distance.cpp)
if(NOT EXISTS ${box2d_distance})
  message(FATAL_ERROR "krait: no source of Box2D 2.4.1 in ${box2d}: "
    "run port/host/setup, or set KRAIT_BOX2D_SOURCE to an unpacked one")
endif()

# Its call counters are writable globals: a data race between planners, and they overflow. The copy goes without them.
file(READ ${box2d_distance} source)
string(REGEX MATCHALL "\n[^\n;]*b2_gjk[A-Z][^\n;]*" counter_lines "${source}")
list(LENGTH counter_lines counter_line_count)
if(NOT counter_line_count EQUAL 4)
  message(FATAL_ERROR "krait: expected the 4 counter lines of Box2D 2.4.1 in ${box2d_distance}, found ${counter_line_count}")
endif()
string(REGEX REPLACE "\n[^\n]*b2_gjk[A-Z][^\n]*" "\n" source "${source}")
set(box2d_copy ${PROJECT_BINARY_DIR}/box2d)
file(CONFIGURE OUTPUT ${box2d_copy}/b2_distance_source.h CONTENT "${source}" @ONLY)
file(WRITE ${box2d_copy}/b2_user_settings.h.in
"#pragma once
#include <stdint.h>
#define b2_lengthUnitsPerMeter 1.0f
#define b2_maxPolygonVertices 8
struct b2BodyUserData { uintptr_t pointer = 0; };
struct b2FixtureUserData { uintptr_t pointer = 0; };
struct b2JointUserData { uintptr_t pointer = 0; };
// Declared and never defined: any path that allocates or logs fails at link time.
void* b2Alloc(int32 size);
void b2Free(void* memory);
void b2Log(const char* format, ...);
")
configure_file(${box2d_copy}/b2_user_settings.h.in ${box2d_copy}/b2_user_settings.h COPYONLY)

add_library(krait_box2d INTERFACE)
target_include_directories(krait_box2d SYSTEM INTERFACE ${box2d}/include ${box2d_copy})
target_compile_definitions(krait_box2d INTERFACE B2_USER_SETTINGS)
