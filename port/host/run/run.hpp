// SPDX-License-Identifier: Apache-2.0
// Runs the core on a scene for a robot named by the user: the bridge from the workstation to the library.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/picture/picture.hpp"
#include "host/plan_file/plan_file.hpp"
#include "host/verify/verify.hpp"
#include "krait/parameters.hpp"
#include "krait/scene.hpp"
#include "krait/status.hpp"

namespace krait::host {

// A pose or disc of the command line, world coordinates.
struct StartPose {
  Point position;
  double heading = 0;
};
struct GoalDisc {
  Point center;
  double radius = 0;
};

inline constexpr std::uint64_t kUsualMegabytes = 64;  // of the block, by default

struct SearchRequest {
  RobotSpec robot;
  std::string planner = "adaptive";
  std::uint64_t seed = 1;
  std::optional<StartPose> start;  // absent: the scene's start `start_name`, or its first
  std::string start_name;
  std::optional<GoalDisc> goal;                   // absent: the scene's goal `goal_name`, or its first
  std::string goal_name;                          // beside `goal`: of the map's goal that it is
  std::optional<GoalFacing> facing;               // only with `goal`
  std::uint64_t memory = kUsualMegabytes << 20U;  // bytes of the block
  std::uint64_t iterations = Limits().iterations;
  std::optional<double> time_limit;  // seconds
  double improve = 0;        // multiples of the first plan's collision checks that a better one is looked for by
  double improve_least = 0;  // collision checks: where `improve` times the first plan's are fewer, more multiples
  double stop_within = 0;    // ends that where the plan is longer than the shortest way by this share at most; 0: never
  Parameters parameters;
  std::function<std::string(const Point&)> obstacle_at;  // the map's own name of the obstacle at a place of the world,
                                                         // or nothing; may be empty: a compiled scene has pieces only

  // m/s: how fast the plan may end; absent: at any speed. Only the adaptive search is asked to brake.
  std::optional<double> end_speed() const {
    const auto speed = static_cast<double>(parameters.end_speed);
    const bool brakes = planner == "adaptive" || planner == "plain";
    return brakes && speed < std::numeric_limits<double>::infinity() ? std::optional(speed) : std::nullopt;
  }

  // `improve`, or the least whole number of multiples that makes improve_least checks.
  double multiples_of(std::uint64_t first_checks) const {
    return std::max(improve, std::ceil(improve_least / static_cast<double>(std::max<std::uint64_t>(first_checks, 1))));
  }
};

// Bytes of a scene file, aligned as Scene::open needs them.
class SceneBytes {
 public:
  // Throws InputError.
  static SceneBytes read(const std::string& path);
  static SceneBytes copy(const void* bytes, std::size_t size);

  const void* data() const { return words_.data(); }
  std::size_t size() const { return size_; }

 private:
  std::vector<std::uint64_t> words_;
  std::size_t size_ = 0;
};

// Whether the bytes of a file begin as those of a compiled scene do.
bool is_scene_file(std::string_view content);

// Obstacles are where the robot starts, or all over the goal; the mark, in local coordinates, is where.
class InObstacle : public InputError {
 public:
  InObstacle(const std::string& line, Status status, Mark where)
      : InputError(line), status_(status), where_(std::move(where)) {}
  Status status() const { return status_; }
  const Mark& where() const { return where_; }

 private:
  Status status_;
  Mark where_;
};

// Opens the scene; throws InputError that names section and element of what is wrong.
krait::Scene open_scene(const std::string& path, const SceneBytes& bytes);

// "magic", "triangle_vertices", …
std::string section_name(std::uint8_t section);

struct PlanMeasure {
  double length = 0;    // metres
  double duration = 0;  // seconds
};

// How far a search is.
struct SearchNews {
  std::uint64_t iterations = 0;
  std::uint64_t vertices = 0;
  double cost_to_go = 0;           // from the nearest region reached: metres, and what failures have added to them;
                                   // infinite where the planner knows none
  std::uint64_t improvements = 0;  // better plans than the first
  PlanMeasure best;                // zeros before the first plan
};

struct SearchWatch {
  std::function<void(const SearchNews&)> tell;  // called some five times a second; may be empty
  std::function<bool()> stop;                   // asked often; true ends the search as a time limit does; may be empty
};

struct SearchResult {
  PlanFile plan;
  Asked asked;                     // what the verifier holds it to, world coordinates
  double seconds;                  // from opening the scene to the best plan
  std::vector<std::string> why{};  // there is no plan, a line each
  PlanMeasure first{};             // of the first plan; zeros where there is none
  bool stopped = false;            // by SearchWatch::stop
  bool late = false;               // SearchRequest::time_limit ended it
  bool near_shortest = false;      // SearchRequest::stop_within ended its improvement
};

// Opens the scene, plans, and copies the plan. Every Status that is a result of a search is returned in plan.status;
// arguments that cannot be used throw InputError.
SearchResult run_search(const std::string& scene_path, const SceneBytes& bytes, const SearchRequest& request,
                        const SearchWatch& watch);

// Metres, from where the plan begins to where it ends: no way of the reference point through passages that are wide
// enough for a disc in body 0 and the clearance is shorter. NaN where the regions know none.
double shortest_way_of(const PlanFile& plan, const SearchRequest& request, const krait::Scene& scene);

// The same search again, watched: the workspace, its regions, the costs as they changed, the tree as it grew.
Picture watch_search(const std::string& scene_path, const SceneBytes& bytes, const SearchRequest& request,
                     const PlanFile& plan);

// Of a search that could not begin: the workspace, the robot at its start, and where it stands in an obstacle.
Picture picture_of_refusal(const std::string& scene_path, const SceneBytes& bytes, const SearchRequest& request,
                           const InObstacle& refusal);

}  // namespace krait::host
