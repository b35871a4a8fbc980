// SPDX-License-Identifier: Apache-2.0
// Repeats a search with an eye on it. The core is deterministic, so what is seen is what happened.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <unordered_map>

#include "decomposition/regions.hpp"
#include "host/run/local_point.hpp"
#include "host/run/query.hpp"
#include "host/run/robots.hpp"
#include "host/run/run.hpp"
#include "host/run/session.hpp"
#include "host/run/why.hpp"

namespace krait::host {
namespace {

constexpr std::uint64_t kFrames = 60;           // of costs, at most
constexpr std::uint32_t kTreeVertices = 20000;  // shown, at most
constexpr std::size_t kRecorded = 2'000'000;    // vertices kept while the search is repeated, at most

Ring ring(Polygon polygon) {
  Ring result;
  for (int i = 0; i < polygon.count; ++i) result.push_back(local_point(polygon[i]));
  return result;
}

void draw_scene(const krait::Scene& scene, Picture& picture) {
  picture.title = scene.name();
  picture.min = local_point(scene.bounds().min);
  picture.max = local_point(scene.bounds().max);
  for (Index p = 0; p < scene.piece_count(); ++p) picture.obstacle_pieces.push_back(ring(scene.piece(p)));
  for (Index t = 0; t < scene.triangle_count(); ++t) {
    picture.triangles.push_back(
        {{local_point(scene.corner(t, 0)), local_point(scene.corner(t, 1)), local_point(scene.corner(t, 2))}});
  }
}

CostFrame costs_now(const detail::Regions& regions, std::uint64_t iteration) {
  CostFrame frame;
  frame.iteration = iteration;
  for (Index t = 0; t < regions.scene().triangle_count(); ++t) frame.costs.push_back(regions.cost(regions.region(t)));
  return frame;
}

// Of a state: two that share it would be drawn as one.
std::uint64_t key_of(const std::vector<float>& state) {
  const auto* bytes = reinterpret_cast<const char*>(state.data());
  return std::hash<std::string_view>{}({bytes, state.size() * sizeof(float)});
}

// The motion tree as it grew, which the planner itself does not keep: its first vertices, some 100 bytes each.
class TreeRecorder {
 public:
  explicit TreeRecorder(const std::vector<float>& start) { add(start, 0, 0); }

  void add_step(const std::vector<float>& from, const std::vector<float>& to, std::uint64_t iteration) {
    if (vertices_.size() == kRecorded) return;
    const auto parent = vertex_of_.find(key_of(from));
    if (parent != vertex_of_.end()) add(to, parent->second, static_cast<std::uint32_t>(iteration));
  }

  // Whole branches, with all their bends, since a chord could lead through an obstacle: the ways from the root to every
  // n-th vertex, n the first power of two with which they are few enough; the root alone where there is none.
  std::vector<TreeVertex> thinned() const {
    for (std::size_t stride = 1; stride <= vertices_.size(); stride *= 2) {
      const std::vector<bool> stays = ways_to_every(stride);
      if (std::count(stays.begin(), stays.end(), true) <= kTreeVertices) return only(stays);
    }
    return {vertices_.front()};
  }

 private:
  std::vector<bool> ways_to_every(std::size_t stride) const {
    std::vector<bool> stays(vertices_.size(), false);
    stays[0] = true;
    for (std::size_t v = 0; v < vertices_.size(); v += stride) {
      for (std::size_t at = v; !stays[at]; at = vertices_[at].parent) stays[at] = true;
    }
    return stays;
  }

  // The vertices that stay; so do their parents.
  std::vector<TreeVertex> only(const std::vector<bool>& stays) const {
    std::vector<TreeVertex> shown;
    std::vector<std::uint32_t> place(vertices_.size(), 0);
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      if (!stays[v]) continue;
      place[v] = static_cast<std::uint32_t>(shown.size());
      shown.push_back(vertices_[v]);
      shown.back().parent = place[vertices_[v].parent];
    }
    return shown;
  }

  void add(const std::vector<float>& state, std::uint32_t parent, std::uint32_t iteration) {
    vertex_of_[key_of(state)] = static_cast<std::uint32_t>(vertices_.size());
    vertices_.push_back({state[0], state[1], parent, iteration});
  }

  std::vector<TreeVertex> vertices_;
  std::unordered_map<std::uint64_t, std::uint32_t> vertex_of_;
};

// A call that drives a way to the goal once more does not count as an iteration.
void watch(Session& session, std::uint64_t iterations, Picture& picture) {
  const std::uint64_t slice = iterations / kFrames + 1;
  TreeRecorder recorder(session.query().start);
  picture.frames.push_back(costs_now(session.regions(), 0));
  std::uint64_t done = 0;
  while (done < iterations && session.status() == Status::searching) {
    const std::uint64_t until = std::min(done + slice, iterations);
    while (done < until && session.status() == Status::searching) {
      (void)session.advance_watched([&](const auto& from, const auto& to) { recorder.add_step(from, to, done + 1); });
      done = session.statistics().iterations;
    }
    picture.frames.push_back(costs_now(session.regions(), done));
  }
  picture.tree = recorder.thinned();
}

// By triangle, whether portals of that width lead from it to the goal.
std::vector<bool> joined_to(const krait::Scene& scene, const krait::Goal& goal, float width) {
  std::vector<bool> joined(scene.triangle_count(), false);
  std::vector<Index> open;
  const auto reach = [&](Index triangle) {
    if (joined[triangle]) return;
    joined[triangle] = true;
    open.push_back(triangle);
  };
  for (Index t = 0; t < scene.triangle_count(); ++t) {
    if (goal.covers(scene, t)) reach(t);
  }
  while (!open.empty()) {
    const Index triangle = open.back();
    open.pop_back();
    for (int edge = 0; edge < 3; ++edge) {
      const Index portal = scene.portal(triangle, edge);
      if (portal != kNone && scene.portal_width(portal) >= width) reach(scene.neighbor(triangle, edge));
    }
  }
  return joined;
}

// The search ended since every way from the start is narrower than the robot, as are those from other regions, or since
// the robot has no room in the goal.
void cut_off(const Bottleneck& bottleneck, const krait::Scene& scene, const krait::Goal& goal, Picture& picture) {
  std::vector<bool> joined(scene.triangle_count(), false);
  if (!bottleneck.at_goal) joined = joined_to(scene, goal, bottleneck.needed);
  for (CostFrame& frame : picture.frames) {
    for (std::size_t t = 0; t < joined.size(); ++t) {
      if (!joined[t]) frame.costs[t] = kInfinity;
    }
  }
}

}  // namespace

Picture watch_search(const std::string& scene_path, const SceneBytes& bytes, const SearchRequest& request,
                     const PlanFile& plan) {
  Block block = block_of(request);
  const krait::Scene scene = open_scene(scene_path, bytes);
  Picture picture;
  picture.plan = plan;
  draw_scene(scene, picture);
  const std::unique_ptr<Session> session = start_session(scene, request, block);
  picture.start = session->query().start;
  watch(*session, plan.statistics->at("iterations").get<std::uint64_t>(), picture);
  session->stop_for_time();  // as its budget, its memory or its user did
  if (plan.states.empty()) picture.marks = where_no_plan(*session, scene, request);
  if (plan.status == to_string(Status::no_route)) {
    cut_off(session->bottleneck(), scene, resolve_goal(scene, request), picture);
  }
  return picture;
}

Picture picture_of_refusal(const std::string& scene_path, const SceneBytes& bytes, const SearchRequest& request,
                           const InObstacle& refusal) {
  const krait::Scene scene = open_scene(scene_path, bytes);
  const CoreRobot core(request.robot);
  Picture picture;
  picture.plan = plan_form(scene, request, resolve_goal(scene, request));
  picture.plan.status = to_string(refusal.status());
  draw_scene(scene, picture);
  picture.start = state_at(core.view(), scene, resolve_start(scene, request));
  picture.marks = {refusal.where()};
  return picture;
}

}  // namespace krait::host
