// SPDX-License-Identifier: Apache-2.0
#include "krait/search/planner.hpp"

namespace krait {

template class Search<Planner, Groups>;
template class GroupedSearch<Planner>;

}  // namespace krait
