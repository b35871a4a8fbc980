// SPDX-License-Identifier: Apache-2.0
// Amounts of memory on a command line.
#pragma once

#include <cstdint>
#include <string>

namespace krait::host {

// "128K", "64M", "1G" (powers of 1024) or a number of bytes; at most 64G. Throws InputError that names the option.
std::uint64_t parse_bytes(const std::string& option, const std::string& text);

}  // namespace krait::host
