// SPDX-License-Identifier: Apache-2.0
// An instruction that is none must be reported, with the address.
#include "firmware/application.hpp"

namespace krait::firmware {

int run(const Board&, int, const char* const*) { __builtin_trap(); }

}  // namespace krait::firmware
