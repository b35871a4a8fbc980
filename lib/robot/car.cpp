// SPDX-License-Identifier: Apache-2.0
#include "krait/robots/car.hpp"

namespace krait {

template class detail::FunctionsOf<Car>;

}  // namespace krait
