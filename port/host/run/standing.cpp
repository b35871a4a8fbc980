// SPDX-License-Identifier: Apache-2.0
#include "host/run/standing.hpp"

#include <vector>

#include "decomposition/locate.hpp"
#include "host/run/goal_room.hpp"
#include "host/run/own_check.hpp"
#include "host/run/query.hpp"
#include "host/run/why.hpp"

namespace krait::host {

std::optional<std::string> why_it_cannot_start(const krait::Scene& scene, const SearchRequest& request) {
  const CoreRobot core(request.robot);
  const Robot robot = core.view();
  const std::vector<float> state = state_at(robot, scene, resolve_start(scene, request));
  Contact contact = OwnCheck(robot, scene, request.parameters).contact(state.data());
  const Vec2 at{state[0], state[1]};
  if (contact.kind == ContactKind::none && detail::locate(scene, at) == kNone) {
    contact = {.kind = ContactKind::ground, .at = at};
  }
  if (contact.kind == ContactKind::none) return std::nullopt;
  return why_not_there(contact, scene, request);
}

std::optional<std::string> why_it_never_ends(const krait::Scene& scene, const SearchRequest& request) {
  const GoalRoom room = room_in_goal(scene, request);
  return room.none ? std::optional(why_not_at_goal(room, scene, request)) : std::nullopt;
}

std::optional<std::string> why_it_hardly_ends(const krait::Scene& scene, const SearchRequest& request) {
  const GoalRoom room = room_in_goal(scene, request);
  return room.found ? std::nullopt : std::optional(why_not_at_goal(room, scene, request));
}

}  // namespace krait::host
