// SPDX-License-Identifier: Apache-2.0
/// \file
/// What a caller must see to. Everything that comes from outside (a scene's bytes, numbers of a query, a robot's
/// answers) is checked in every build, and refused with a Status.
#pragma once

#ifdef KRAIT_ASSERT_HEADER
#include KRAIT_ASSERT_HEADER
#endif

#ifndef KRAIT_ASSERT
/// What a caller must see to, such as that an index is below a count. It is checked where the build names a header,
/// KRAIT_ASSERT_HEADER, that defines the macro as an expression of type void; otherwise the condition is not evaluated,
/// and costs nothing.
#define KRAIT_ASSERT(condition) static_cast<void>(sizeof((condition) ? 1 : 0))
#endif
