// SPDX-License-Identifier: Apache-2.0
#include "host/run/standing.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "decomposition/locate.hpp"
#include "host/run/own_check.hpp"
#include "host/run/query.hpp"
#include "host/run/why.hpp"

namespace krait::host {
namespace {

// Of body 0 alone, which needs no trailers.
RobotSpec lead_of(RobotSpec robot) {
  robot.links = 0;
  robot.bodies.resize(1);
  return robot;
}

// Poses that a goal allows, over its disc by the golden angle, the middle first, and over its headings.
std::vector<Start> allowed_poses(const GoalDisc& disc, const GoalFacing& facing) {
  constexpr int kPlaces = 250, kHeadings = 10;  // each of these on either side of the one that is asked for
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<Start> poses;
  for (int i = 0; i < kPlaces; ++i) {
    const double out = disc.radius * std::sqrt(double(i) / kPlaces);
    const Point place{disc.center.x + out * std::cos(golden * i), disc.center.y + out * std::sin(golden * i)};
    for (int j = 0; j <= 2 * kHeadings; ++j) {
      const int off = (j % 2 == 0 ? 1 : -1) * ((j + 1) / 2);
      const double heading = facing.heading + facing.tolerance * off / kHeadings;
      poses.push_back({"goal", place, heading, {}});
      if (facing.either_way) poses.push_back({"goal", place, heading + std::numbers::pi, {}});
    }
  }
  return poses;
}

}  // namespace

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

std::optional<std::string> why_it_hardly_ends(const krait::Scene& scene, const SearchRequest& request) {
  if (!request.goal || !request.facing) return std::nullopt;
  const CoreRobot core(lead_of(request.robot));
  const Robot robot = core.view();
  OwnCheck check(robot, scene, request.parameters);
  const std::vector<Start> poses = allowed_poses(*request.goal, *request.facing);
  Contact first;
  for (const Start& pose : poses) {
    const Contact contact = check.contact(state_at(robot, scene, pose).data());
    if (contact.kind == ContactKind::none) return std::nullopt;
    if (first.kind == ContactKind::none) first = contact;
  }
  return why_not_at_goal(first, static_cast<int>(poses.size()), scene, request);
}

}  // namespace krait::host
