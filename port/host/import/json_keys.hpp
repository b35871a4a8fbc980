// SPDX-License-Identifier: Apache-2.0
// Which members a JSON object has, seen without parsing it, so that broken files are recognised too.
#pragma once

#include <string_view>

namespace krait::host {

// The text begins with an object.
bool is_json_object(std::string_view text);

// It does, and that object (no inner one) has this member, in quotes or, as in YAML, without. Linear in the text.
bool has_top_json_key(std::string_view text, std::string_view key);

}  // namespace krait::host
