// SPDX-License-Identifier: Apache-2.0
#include "krait/robots/truck.hpp"

namespace krait {

template class detail::FunctionsOf<Truck>;

}  // namespace krait
