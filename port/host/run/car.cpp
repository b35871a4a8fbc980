// SPDX-License-Identifier: Apache-2.0
#include "krait/robot/car.hpp"

#include "host/run/planner_session.hpp"
#include "host/run/sessions.hpp"

namespace krait::host {

std::unique_ptr<Session> car_session(const krait::Scene& scene, const SearchRequest& request, Block& block) {
  return robot_session(Car(chain_parameters(request.robot)), scene, request, block);
}

}  // namespace krait::host
