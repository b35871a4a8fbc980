// SPDX-License-Identifier: Apache-2.0
// The files in page/, which embed.cmake puts into the library.
#pragma once

#include <string_view>

namespace krait::host::page {

extern const std::string_view index_html;
extern const std::string_view style_css;
extern const std::string_view replay_js;

}  // namespace krait::host::page
