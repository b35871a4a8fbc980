// SPDX-License-Identifier: Apache-2.0
// Any scene that opens can be planned in, and the verifier, which reads the file with code of its own, agrees with
// every plan. The bytes before the scene choose what is planned (plan_choice.hpp).
#include <cstring>
#include <deque>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "host/import/format.hpp"
#include "host/run/run.hpp"
#include "host/verify/verify.hpp"
#include "plan_choice.hpp"
#include "scene_input.hpp"

namespace krait::fuzz {
namespace {

using namespace krait::host;

constexpr std::uint32_t kRestartUnit = 4000;
constexpr std::uint64_t kLittle = 12 * 1024;  // bytes of a block

Landmark restarted("restarted"), solved_restarted("solved after a restart");
Landmark recycled("recycled"), solved_recycled("solved after recycling"), both("restarted and recycled");
Landmark little_memory("solved in little memory");
Landmark paper("solved with the paper's parameters"), paper_recycled("the paper's parameters, recycled");
Landmark pose("solved for a pose"), either_way("solved for a pose either way round"), hitched("solved for hitches");
Landmark any_speed("solved at any end speed");
Landmark improved("improved"), improved_pose("improved for a pose");
Landmark repaired("regions repaired");
Landmark ends[] = {Landmark("solved"), Landmark("no_route"), Landmark("budget_used")};
Landmark refusals[] = {Landmark("arena_too_small"), Landmark("start_in_collision"), Landmark("start_outside"),
                       Landmark("goal_in_obstacle"), Landmark("bad_scene")};

// One for each name.
template <std::size_t count>
std::deque<Landmark> landmarks(const std::string& words, const char* const (&names)[count]) {
  std::deque<Landmark> all;
  for (const char* name : names) all.emplace_back(words + name);
  return all;
}
std::deque<Landmark> robots = landmarks("solved for a ", kRobots);
std::deque<Landmark> planners = landmarks("solved by ", kPlanners);

void reach_named(Landmark* first, std::size_t count, const std::string& text) {
  for (std::size_t i = 0; i < count; ++i) {
    if (text.find(first[i].name()) != std::string::npos) first[i].reach();
  }
}

void look_at_plan(const PlanChoice& choice, const SearchResult& result) {
  robots[choice.robot % std::size(kRobots)].reach();
  planners[choice.planner % std::size(kPlanners)].reach();
  if (result.plan.statistics->at("restarts") > 0) solved_restarted.reach();
  if (result.plan.statistics->at("recycled") > 0) solved_recycled.reach();
  if (choice.bytes() <= kLittle) little_memory.reach();
  if (choice.paper()) paper.reach();
  if (choice.at_any_speed()) any_speed.reach();
  if (result.plan.statistics->value("improvements", 0) > 0) {
    improved.reach();
    if (choice.pose()) improved_pose.reach();
  }
  if (!result.asked.facing) return;
  pose.reach();
  if (result.asked.facing->either_way) either_way.reach();
  if (result.asked.facing->hitches && result.plan.robot.links > 0) hitched.reach();
}

void look_at(const PlanChoice& choice, const SearchResult& result) {
  reach_named(ends, std::size(ends), result.plan.status);
  if (result.plan.statistics->at("restarts") > 0) restarted.reach();
  if (result.plan.statistics->at("recycled") > 0) {
    recycled.reach();
    if (result.plan.statistics->at("restarts") > 0) both.reach();
    if (choice.paper()) paper_recycled.reach();
  }
  if (result.plan.statistics->at("regions_repaired") > 0) repaired.reach();
  if (result.plan.status == "solved") look_at_plan(choice, result);
}

Workspace workspace_of(SceneInput& input) {
  const Source source{"scene", std::string(reinterpret_cast<const char*>(input.data()), input.size())};
  return kSceneFile.read(source, {});
}

// In the middle of the first goal.
void ask_for_pose(const PlanChoice& choice, const Workspace& workspace, SearchRequest& request) {
  if (workspace.goals.empty()) return;
  const Ring& corners = workspace.goals.front().polygon;
  GoalDisc disc{{}, 0.3};
  for (const Point& corner : corners) {
    disc.center.x += corner.x / static_cast<double>(corners.size());
    disc.center.y += corner.y / static_cast<double>(corners.size());
  }
  request.goal = disc;
  request.facing = GoalFacing{(choice.goal >> 3U) * std::numbers::pi / 16, 0.2, (choice.goal & 2U) != 0};
  if ((choice.goal & 4U) != 0) request.facing->hitches = 0.4;
}

SearchRequest request_of(const PlanChoice& choice, SceneInput& input) {
  SearchRequest request;
  request.robot = parse_robot(kRobots[choice.robot % std::size(kRobots)]);
  request.planner = kPlanners[choice.planner % std::size(kPlanners)];
  request.seed = choice.seed;
  if (choice.paper()) request.parameters = Parameters::paper();
  if (!choice.paper()) request.parameters.tuning.restart_unit = kRestartUnit >> choice.restarts % 13U;
  if (choice.at_any_speed()) request.parameters.end_speed = std::numeric_limits<float>::infinity();
  if (choice.pose()) ask_for_pose(choice, workspace_of(input), request);
  request.memory = choice.bytes();
  request.iterations = 2000;
  request.improve = choice.improvement / 64.0;
  return request;
}

void plan(SceneInput& input, const PlanChoice& choice) {
  const SearchRequest request = request_of(choice, input);
  const SearchResult result = run_search("scene", SceneBytes::copy(input.data(), input.size()), request, {});
  require(result.plan.status != "internal", "a plan was not replayed");
  look_at(choice, result);
  if (result.plan.status != "solved" || choice.paper()) return;  // the paper's plans are free at their states only
  const Verdict verdict = verify(workspace_of(input), result.plan, result.asked);
  for (const std::string& complaint : verdict.complaints) std::fprintf(stderr, "fuzz: %s\n", complaint.c_str());
  require(verdict.holds, "a plan does not hold");
}

}  // namespace
}  // namespace krait::fuzz

namespace {

using Choice = krait::fuzz::PlanChoice;

}  // namespace

// Most changed scenes do not open: three in four times only one byte of what is chosen changes.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  const unsigned rest = seed / 4;
  if (size < sizeof(Choice)) return krait::fuzz::change_scene(data, size, most, rest);
  if (seed % 4 == 0) {
    return sizeof(Choice) +
           krait::fuzz::change_scene(data + sizeof(Choice), size - sizeof(Choice), most - sizeof(Choice), rest);
  }
  data[rest % sizeof(Choice)] = static_cast<std::uint8_t>(rest / sizeof(Choice));
  return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace krait::fuzz;
  if (size < sizeof(Choice)) return 0;
  Choice choice;
  std::memcpy(&choice, data, sizeof choice);
  SceneInput input(data + sizeof choice, size - sizeof choice);
  try {
    plan(input, choice);
  } catch (const krait::host::InputError& error) {
    reach_named(refusals, std::size(refusals), error.what());
  }
  return 0;
}
