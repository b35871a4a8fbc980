// SPDX-License-Identifier: Apache-2.0
// Maps far from the world's origin, as national grids have them: moved near to it while they are in double precision.
#pragma once

#include "host/import/format.hpp"

namespace krait::host {

// Where a bound of the map lies beyond kMaxCoordinate, subtracts the bounds' centre, in whole metres, from everything
// in the map, records it in `shift` and, where `warns`, warns. Throws InputError, naming the element, where something
// in the map lies further than four times kMaxCoordinate from the origin that results.
void bring_near(const std::string& file, Workspace& workspace, bool warns);

}  // namespace krait::host
