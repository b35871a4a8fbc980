// SPDX-License-Identifier: Apache-2.0
#include "host/cli/clearance.hpp"

#include <algorithm>

#include "host/run/session.hpp"
#include "host/run/tracked_clearance.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

bool has_cells(const std::optional<Workspace>& map) { return map && map->cells; }

// What has no room for the request's clearance; empty where start and widest way have.
std::string too_narrow(const krait::Scene& scene, const SearchRequest& request, Block& block) {
  try {
    const std::unique_ptr<Session> session = start_session(scene, request, block);
    session->stop_for_time();
    const Bottleneck widest = session->bottleneck();
    return widest.width < widest.needed ? "every way to the goal has" : "";
  } catch (const InObstacle&) {
    return "the start has";
  }
}

}  // namespace

Clearance usual_clearance(const krait::Scene& scene, const SearchRequest& request, const std::optional<Workspace>& map,
                          Block& block) {
  const float most = Parameters::range(Argument::clearance).most / 2;
  const double tracked = tracked_clearance(request.robot, map ? &*map : nullptr);
  Clearance clearance;
  clearance.kept = clearance.usual = std::clamp(static_cast<float>(tracked), kLeastClearance, most);
  for (SearchRequest twice = request; clearance.kept > kLeastClearance;) {
    twice.parameters.clearance = 2 * clearance.kept;
    const std::string narrow = too_narrow(scene, twice, block);
    if (narrow.empty()) break;
    clearance.narrow = narrow;
    clearance.kept = std::max(clearance.kept / 2, kLeastClearance);
  }
  return clearance;
}

std::string text(const Clearance& clearance, const std::optional<Workspace>& map) {
  const char* usual =
      has_cells(map) ? "2 % of the robot's width and half a cell of the map" : "2 % of the robot's width";
  const double kept = decimal(clearance.kept);
  if (clearance.in_vain > 0) {
    const char* form = clearance.no_room
                           ? "clearance %.4g m: with %.4g m the robot has no room in the goal (the usual is %.4g m, %s)"
                           : "clearance %.4g m: a search with %.4g m used up its iterations (the usual is %.4g m, %s)";
    return printed(form, kept, decimal(clearance.in_vain), decimal(clearance.usual), usual);
  }
  if (clearance.narrow.empty()) return printed("clearance %.4g m: %s (--clearance asks for another)", kept, usual);
  return printed("clearance %.4g m: %s too little room for twice the usual %.4g m, %s", kept, clearance.narrow.c_str(),
                 decimal(clearance.usual), usual);
}

}  // namespace krait::host
