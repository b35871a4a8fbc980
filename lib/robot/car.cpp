// SPDX-License-Identifier: Apache-2.0
#include "krait/robot/car.hpp"

namespace krait {

template class FunctionsOf<Car>;

}  // namespace krait
