// SPDX-License-Identifier: Apache-2.0
#include "krait/robots/snake.hpp"

namespace krait {

template class detail::FunctionsOf<Snake>;

}  // namespace krait
