// SPDX-License-Identifier: Apache-2.0
// robot_session for each of the core's robots.
#pragma once

#include "host/run/session.hpp"

namespace krait::host {

std::unique_ptr<Session> snake_session(const krait::Scene& scene, const SearchRequest& request, Block& block);
std::unique_ptr<Session> truck_session(const krait::Scene& scene, const SearchRequest& request, Block& block);
std::unique_ptr<Session> car_session(const krait::Scene& scene, const SearchRequest& request, Block& block);
std::unique_ptr<Session> unicycle_session(const krait::Scene& scene, const SearchRequest& request, Block& block);
std::unique_ptr<Session> differential_drive_session(const krait::Scene& scene, const SearchRequest& request,
                                                    Block& block);

}  // namespace krait::host
