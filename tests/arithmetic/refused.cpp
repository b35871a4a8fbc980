// SPDX-License-Identifier: Apache-2.0
// A user's file that must not compile with the flags of its target.
#include "krait/krait.hpp"

krait::Planner planner;
