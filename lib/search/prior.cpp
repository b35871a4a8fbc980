// SPDX-License-Identifier: Apache-2.0
#include "krait/search/prior.hpp"

#include "search/grouped_members.hpp"

namespace krait {

template class Search<PriorPlanner, Groups>;
template class GroupedSearch<PriorPlanner, Groups>;

}  // namespace krait
