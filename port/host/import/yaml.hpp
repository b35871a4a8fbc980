// SPDX-License-Identifier: Apache-2.0
// Reads YAML into the JSON document that Field checks, within bounds of depth and size.
#pragma once

#include "host/import/format.hpp"
#include "host/input/json.hpp"

namespace krait::host {

// Plain scalars that are numbers become numbers, true and false booleans, all else text. Throws InputError: a syntax
// error with its line, nesting beyond kMaxDepth, a key given twice, aliases that multiply the document.
Json parse_yaml(const std::string& text, const std::string& file);

// A line of the text starts with this key and a colon, or the text is a map in braces that has the key.
bool has_top_key(const std::string& text, const std::string& key);

}  // namespace krait::host
