// SPDX-License-Identifier: Apache-2.0
#include "krait/search/rrt.hpp"

#include "search/search_members.hpp"

namespace krait {

template class Search<RrtPlanner, NearestPoints>;

}  // namespace krait
