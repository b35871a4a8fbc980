// SPDX-License-Identifier: Apache-2.0
// Decimal numbers, without the C library's conversions, which bring locales and a heap.
#pragma once

#include <cstdint>

namespace krait::firmware {

// Reads a number of digits only at the beginning of `text`, which is moved behind it. False without digits or beyond
// 64 bits.
bool take_number(const char*& text, std::uint64_t& number);

// Reads a number like -12.25 in the same way: a sign, digits, a point and digits, of which not all are needed. The
// nearest double, as strtod has it. False without digits and with more than 15 of them.
bool take_decimal(const char*& text, double& number);

}  // namespace krait::firmware
