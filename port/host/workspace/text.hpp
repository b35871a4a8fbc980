// SPDX-License-Identifier: Apache-2.0
// Text that others wrote, as it may be shown to a person: on one line, in one direction, with no command to a terminal.
#pragma once

#include <string>
#include <string_view>

namespace krait::host {

// Whether the text is UTF-8 without control characters (U+0000 to U+001F, U+007F to U+009F), without separators of
// lines and paragraphs (U+2028, U+2029) and without marks that change the direction of text (U+061C, U+200E, U+200F,
// U+202A to U+202E, U+2066 to U+2069). The names in a scene file obey the same rule (FORMAT.md).
bool is_safe_to_print(std::string_view text);

// The text with an escape for each of those characters (\u001B) and for each byte that is no UTF-8 (\xFF); all else
// stays, so that a safe text comes back as it is.
std::string safe_to_print(std::string_view text);

}  // namespace krait::host
