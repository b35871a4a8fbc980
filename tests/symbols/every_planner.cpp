// SPDX-License-Identifier: Apache-2.0
// What a user's program instantiates: every planner with every robot (that with Planner is in lib/c).
#include "krait/krait.hpp"

template class krait::PriorPlanner<krait::Snake>;
template class krait::PriorPlanner<krait::Truck>;
template class krait::PriorPlanner<krait::Car>;
template class krait::PriorPlanner<krait::Unicycle>;
template class krait::PriorPlanner<krait::DifferentialDrive>;
template class krait::RrtPlanner<krait::Snake>;
template class krait::RrtPlanner<krait::Truck>;
template class krait::RrtPlanner<krait::Car>;
template class krait::RrtPlanner<krait::Unicycle>;
template class krait::RrtPlanner<krait::DifferentialDrive>;
