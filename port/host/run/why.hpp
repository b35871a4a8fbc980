// SPDX-License-Identifier: Apache-2.0
// Why there is no plan, in words: what stands in the way, where, and what to try. World coordinates, metres.
#pragma once

#include <string>
#include <vector>

#include "host/run/goal_room.hpp"
#include "host/run/run.hpp"
#include "host/run/session.hpp"

namespace krait::host {

// What a start in collision lies against.
std::string why_not_there(const Contact& contact, const krait::Scene& scene, const SearchRequest& request);

// That body 0 has no room in the goal, what it lies against there, and what to do.
std::string why_not_at_goal(const GoalRoom& room, const krait::Scene& scene, const SearchRequest& request);

// Why no free part of the goal is left, and what to do; and a mark at the goal's middle.
std::string why_no_goal(const krait::Scene& scene, const SearchRequest& request);
Mark goal_mark(const krait::Scene& scene, const SearchRequest& request);

// Why a search that has ended has no plan, a line each; empty where it has one.
std::vector<std::string> why_no_plan(Session& session, const krait::Scene& scene, const SearchRequest& request);

// The places that those lines name, local coordinates.
std::vector<Mark> where_no_plan(Session& session, const krait::Scene& scene, const SearchRequest& request);

}  // namespace krait::host
