// SPDX-License-Identifier: Apache-2.0
#include "krait/robot/truck.hpp"

namespace krait {

template class FunctionsOf<Truck>;

}  // namespace krait
