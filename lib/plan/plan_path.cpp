// SPDX-License-Identifier: Apache-2.0
#include "krait/plan.hpp"
#include "plan/motion_tree.hpp"
#include "plan/way.hpp"

namespace krait::detail {

PlanPath::PlanPath(const Way& way, const TargetGrid& grid)
    : way_(&way), grid_(&grid), first_(way.count() > 0 ? 0 : kNone) {}

Index PlanPath::next(Index leg) const {
  if (tree_ != nullptr) return tree_->next_of_path(leg);
  return leg + 1 < way_->count() ? leg + 1 : kNone;
}

Target PlanPath::target(Index leg) const {
  return tree_ != nullptr ? tree_->target(leg) : grid_->unpack((*way_)[leg].target);
}

const PackedTarget& PlanPath::packed(Index leg) const {
  return tree_ != nullptr ? tree_->packed(leg) : (*way_)[leg].target;
}

std::uint32_t PlanPath::steps(Index leg) const { return tree_ != nullptr ? tree_->steps(leg) : (*way_)[leg].steps; }

}  // namespace krait::detail
