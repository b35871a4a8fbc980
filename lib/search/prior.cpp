// SPDX-License-Identifier: Apache-2.0
#include "krait/search/prior.hpp"

namespace krait {

template class Search<PriorPlanner, Groups>;
template class GroupedSearch<PriorPlanner>;

}  // namespace krait
