// SPDX-License-Identifier: GPL-3.0-or-later
// The headings of goals, for which a scene file has no place.
#pragma once

#include <string>
#include <vector>

#include "host/workspace/workspace.hpp"

namespace krait::host {

// Which options of krait plan ask for them, on one line; empty where no goal has one.
std::string lost_headings(const std::vector<Goal>& goals);

}  // namespace krait::host
