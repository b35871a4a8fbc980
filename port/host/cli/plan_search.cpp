// SPDX-License-Identifier: Apache-2.0
#include "host/cli/plan_search.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "host/cli/plan_summary.hpp"
#include "host/input/interrupt.hpp"
#include "host/run/session.hpp"
#include "host/run/standing.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

// "1200 iterations, 4 m to go", and of a plan that is improved how good it is.
std::string detail_of(const SearchNews& news) {
  const auto iterations = static_cast<unsigned long long>(news.iterations);
  if (news.best.length > 0) {
    return printed("best plan %.1f s, %.1f m, improved %s", news.best.duration, news.best.length,
                   times(news.improvements).c_str());
  }
  if (std::isfinite(news.cost_to_go)) {
    return printed("%llu iterations, cost still to go %.3g", iterations, news.cost_to_go);
  }
  return printed("%llu iterations, %llu vertices", iterations, static_cast<unsigned long long>(news.vertices));
}

// Ctrl-C ends the search with what there is; before and after it, the program.
SearchResult search(const PlanOptions& options, const SearchRequest& request, const SceneBytes& bytes, Block& block,
                    Progress& progress) {
  const Interrupt interrupt;
  progress.show("planning");
  SearchWatch watch;
  watch.tell = [&](const SearchNews& news) {
    progress.show(news.best.length > 0 ? "improving" : "planning", detail_of(news));
  };
  watch.stop = [&] { return interrupt.asked(); };
  SearchResult result = run_search(options.scene, bytes, request, block, watch);
  progress.end();
  return result;
}

// Whether another search to the goal, with the least clearance, has a chance.
bool may_end(const krait::Scene& scene, SearchRequest request) {
  request.parameters.clearance = kLeastClearance;
  return !why_it_hardly_ends(scene, request);
}

krait::Scene checked_scene(const PlanOptions& options, const Ground& ground, Progress& progress) {
  const LastWord word(kStoppedEarly);
  progress.show("checking the scene");
  return open_scene(options.scene, ground.scene);
}

Clearance clearance_for(const krait::Scene& scene, const Ground& ground, const SearchRequest& request, Block& block,
                        Progress& progress) {
  const LastWord word(kStoppedEarly);
  progress.show("finding the clearance");
  return usual_clearance(scene, request, ground.map, block);
}

// Searches with the clearance that was asked for, or else the usual one and, where that search uses up its iterations
// or the robot has no room in the goal with it, the least; which one becomes the request's.
Answer search_clear(const krait::Scene& scene, const Ground& ground, const PlanOptions& options, SearchRequest& request,
                    Block& block, Progress& progress) {
  if (options.clearance || options.paper) return {search(options, request, ground.scene, block, progress), {}};
  Clearance clearance = clearance_for(scene, ground, request, block, progress);
  request.parameters.clearance = clearance.kept;
  SearchResult first = search(options, request, ground.scene, block, progress);
  clearance.no_room = first.plan.status == to_string(Status::no_route);
  const bool in_vain = clearance.no_room || first.plan.status == to_string(Status::budget_used);
  if (!in_vain || !(clearance.kept > kLeastClearance) || !may_end(scene, request)) return {std::move(first), clearance};
  clearance.in_vain = clearance.kept;
  request.parameters.clearance = clearance.kept = kLeastClearance;
  if (request.time_limit) *request.time_limit = std::max(*request.time_limit - first.seconds, 0.0);
  return {search(options, request, ground.scene, block, progress), clearance};
}

// Searches; where obstacles are in the way that the compiler's default tolerance may have grown, the map is compiled
// without it, and that scene, which replaces the first, is searched.
Answer search_in(Ground& ground, const PlanOptions& options, SearchRequest& request, Progress& progress) {
  Block block = block_of(request);
  const krait::Scene scene = checked_scene(options, ground, progress);
  const double growth = static_cast<double>(scene.header().tolerance);
  if (!ground.map || !options.tolerance.empty() || !(growth > 0)) {
    return search_clear(scene, ground, options, request, block, progress);
  }
  try {
    Answer answer = search_clear(scene, ground, options, request, block, progress);
    if (answer.result.plan.status != to_string(Status::no_route)) return answer;
  } catch (const InObstacle&) {
    progress.end();
  }
  progress.end();
  compile_exactly(ground, options, growth);
  return search_clear(checked_scene(options, ground, progress), ground, options, request, block, progress);
}

// Maps are free for the most part: where walls are bright on black, the floor is read as walls.
std::string negate_hint(const std::optional<Workspace>& map) {
  if (!map || !map->cells) return "";
  const std::vector<std::uint8_t>& cells = map->cells->occupied;
  const auto occupied = static_cast<double>(std::count(cells.begin(), cells.end(), 1));
  const double share = occupied / static_cast<double>(cells.size());
  if (!(share > 0.5)) return "";
  return printed(
      "; %.3g %% of the map's cells are obstacles: are bright and dark exchanged (negate, in its YAML file)?",
      100 * share);
}

}  // namespace

Answer search_for(Ground& ground, const PlanOptions& options, SearchRequest& request, Progress& progress) {
  try {
    return search_in(ground, options, request, progress);
  } catch (const InObstacle& error) {
    const std::string robot =
        options.query.robot_given() ? "" : " (the robot is " + options.query.robot + ": --robot asks for another)";
    throw InObstacle(error.what() + robot + negate_hint(ground.map), error.status(), error.where());
  }
}

}  // namespace krait::host
