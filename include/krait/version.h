/* SPDX-License-Identifier: Apache-2.0 */
/** \file
    The versions of the library and of the scene files that it reads, for C and C++. CMake reads them from here. */
#ifndef KRAIT_VERSION_H
#define KRAIT_VERSION_H

/* Of the library, by semver.org: below 1.0 every minor version may change the interface. */
#define KRAIT_VERSION_MAJOR 0 /**< of the library's version */
#define KRAIT_VERSION_MINOR 1 /**< of the library's version, 0 to 99 */
#define KRAIT_VERSION_PATCH 0 /**< of the library's version, 0 to 99 */

/** The library's version as one number, for comparisons: 1.2.3 is 10203. */
#define KRAIT_VERSION_NUMBER (KRAIT_VERSION_MAJOR * 10000 + KRAIT_VERSION_MINOR * 100 + KRAIT_VERSION_PATCH)

/** The version of a scene file: the only one that Scene::open and krait_open accept (FORMAT.md). */
#define KRAIT_SCENE_VERSION 1

#endif
