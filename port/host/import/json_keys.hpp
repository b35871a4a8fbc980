// SPDX-License-Identifier: Apache-2.0
// Where a text begins, and which members a JSON object has, seen without parsing it, so that broken files are
// recognised too.
#pragma once

#include <string_view>

namespace krait::host {

// The place of the first character behind white space and a byte order mark; npos where there is none.
std::size_t text_begin(std::string_view text);

// The text begins with an object.
bool is_json_object(std::string_view text);

// It does, and that object (no inner one) has this member. Linear in the text.
bool has_top_json_key(std::string_view text, std::string_view key);

}  // namespace krait::host
