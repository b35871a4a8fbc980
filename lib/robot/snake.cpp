// SPDX-License-Identifier: Apache-2.0
#include "krait/robot/snake.hpp"

namespace krait {

template class FunctionsOf<Snake>;

}  // namespace krait
