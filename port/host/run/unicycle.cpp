// SPDX-License-Identifier: Apache-2.0
#include "krait/robot/unicycle.hpp"

#include "host/run/planner_session.hpp"
#include "host/run/sessions.hpp"

namespace krait::host {

std::unique_ptr<Session> unicycle_session(const krait::Scene& scene, const SearchRequest& request, Block& block) {
  return robot_session(Unicycle(unicycle_parameters(request.robot)), scene, request, block);
}

}  // namespace krait::host
