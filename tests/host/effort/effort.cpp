// SPDX-License-Identifier: GPL-3.0-or-later
// Whether searches cost what budgets.txt says that they cost: effort [--update] [SCENE…]. Vertices and placements of
// the robot, median and 90th percentile over fixed seeds: the same on every machine. A tenth more or less is a failure,
// since a budget that is too large sees nothing; --update writes the file anew. Exits 1 when a budget does not hold, 2
// on bad input.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "host/compiler/compiler.hpp"
#include "host/run/session.hpp"
#include "host/scenes/scenes.hpp"
#include "krait/robots/all.hpp"
#include "paths.hpp"

namespace krait::host {
namespace {

constexpr std::uint64_t kSeeds = 20;
constexpr std::uint64_t kIterations = 20'000;  // of a search; one that uses them up costs what it has cost
constexpr std::uint64_t kMemory = 8U << 20U;   // bytes; enough that nothing is given up
constexpr const char* kAbout =
    "# What searches cost, over seeds 1 to 20: how many were solved, vertices and placements of the robot.\n"
    "# Written by build/host/bin/effort --update.\n"
    "# scene, scale, robot, planner: solved, vertices (median, 90 %), placements (median, 90 %)\n";

std::string budgets_path() { return test::source_path("tests/host/effort/budgets.txt"); }

struct Kind {
  double scale;
  std::string robot;
  std::string planner;  // or "paper": adaptive with the paper's parameters; "pose": to the goal's middle within 0.1 m
                        // and 0.1 rad, to four headings in turn; "straight": and the hitches within 0.2 rad
};

// One of every model, and what else is worth its time.
std::vector<Kind> kinds() {
  std::vector<Kind> all = {{1, "snake:5", "adaptive"}, {2, "snake:15", "adaptive"},      {0.75, "snake:15", "adaptive"},
                           {1, "snake:5", "paper"},    {1, "unicycle", "prior"},         {1, "car", "pose"},
                           {1, "diff_drive", "pose"},  {1, "unicycle2", "pose"},         {1, "truck:1", "pose"},
                           {1, "truck:2", "pose"},     {1, "kinematic_truck:1", "pose"}, {1, "snake:5", "pose"},
                           {1, "snake:15", "pose"},    {1, "truck:1", "straight"},       {1, "truck:2", "straight"}};
  const auto add = [&](const std::string& model, const std::string& trailers) {
    all.push_back({1, trailers == "-" ? model : model + ":" + trailers, "adaptive"});
  };
#define KRAIT_ADD(name, Class, file, trailers) add(#name, #trailers);
  KRAIT_MODELS(KRAIT_ADD)
#undef KRAIT_ADD
  return all;
}

struct Cost {
  std::uint64_t solved = 0;
  std::uint64_t numbers[4] = {};  // vertices, median and 90 %; placements, the same
};

using Costs = std::map<std::string, Cost>;

std::uint64_t quantile(std::vector<std::uint64_t> values, std::size_t tenths) {
  std::sort(values.begin(), values.end());
  return values[(values.size() - 1) * tenths / 10];
}

// The pose in the middle of the scene's goal that the seed's turn is.
void ask_pose(const Workspace& workspace, const Kind& kind, SearchRequest& request) {
  Point middle{};
  const Ring& goal = workspace.goals.front().polygon;
  for (const Point& corner : goal) {
    const auto share = 1.0 / static_cast<double>(goal.size());
    middle = {middle.x + share * corner.x, middle.y + share * corner.y};
  }
  request.goal = GoalDisc{middle, 0.1};
  request.facing = GoalFacing{static_cast<double>(request.seed % 4) * std::numbers::pi / 2, 0.1, false, {}};
  if (kind.planner == "straight") request.facing->hitches = 0.2;
}

Cost measure(const Workspace& workspace, const SceneBytes& bytes, const Kind& kind) {
  SearchRequest request;
  request.robot = parse_robot(kind.robot);
  const bool paper = kind.planner == "paper";
  const bool pose = kind.planner == "pose" || kind.planner == "straight";
  request.planner = paper || pose ? "adaptive" : kind.planner;
  if (paper) request.parameters = Parameters::paper();
  request.iterations = kIterations;
  request.memory = kMemory;
  Block block = block_of(request);
  Cost cost;
  std::vector<std::uint64_t> vertices, placements;
  for (request.seed = 1; request.seed <= kSeeds; ++request.seed) {
    if (pose) ask_pose(workspace, kind, request);
    const SearchResult result = run_search("scene", bytes, request, block, {});
    cost.solved += result.plan.status == "solved" ? 1 : 0;
    vertices.push_back(result.plan.statistics->at("vertices").get<std::uint64_t>());
    placements.push_back(result.plan.statistics->at("collision_checks").get<std::uint64_t>());
  }
  cost.numbers[0] = quantile(vertices, 5);
  cost.numbers[1] = quantile(vertices, 9);
  cost.numbers[2] = quantile(placements, 5);
  cost.numbers[3] = quantile(placements, 9);
  return cost;
}

void measure_scene(const std::string& scene, Costs& costs) {
  std::map<double, SceneBytes> compiled;
  std::map<double, Workspace> workspaces;
  for (const Kind& kind : kinds()) {
    if (!compiled.contains(kind.scale)) {
      workspaces[kind.scale] = make_scene(scene, kind.scale).workspace;
      const CompiledScene result = compile(workspaces[kind.scale], {});
      compiled[kind.scale] = SceneBytes::copy(result.bytes.data(), result.bytes.size());
    }
    std::ostringstream name;
    name << scene << ' ' << kind.scale << ' ' << kind.robot << ' ' << kind.planner;
    costs[name.str()] = measure(workspaces[kind.scale], compiled[kind.scale], kind);
  }
}

std::string line(const Cost& cost) {
  std::string text = std::to_string(cost.solved);
  for (const std::uint64_t number : cost.numbers) text += ' ' + std::to_string(number);
  return text;
}

Costs read_budgets() {
  Costs budgets;
  std::ifstream file(budgets_path());
  for (std::string text; std::getline(file, text);) {
    const std::size_t colon = text.find(": ");
    if (text.starts_with('#') || colon == std::string::npos) continue;
    Cost& budget = budgets[text.substr(0, colon)];
    std::istringstream numbers(text.substr(colon + 2));
    numbers >> budget.solved;
    for (std::uint64_t& number : budget.numbers) numbers >> number;
  }
  return budgets;
}

bool write_budgets(const Costs& costs) {
  std::ofstream file(budgets_path());
  file << kAbout;
  for (const auto& [name, cost] : costs) file << name << ": " << line(cost) << '\n';
  file.close();
  return file.good();
}

bool holds(const Cost& cost, const Cost& budget) {
  bool within = cost.solved == budget.solved;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint64_t apart =
        cost.numbers[i] > budget.numbers[i] ? cost.numbers[i] - budget.numbers[i] : budget.numbers[i] - cost.numbers[i];
    within = within && 10 * apart <= budget.numbers[i];
  }
  return within;
}

bool compare(const Costs& costs) {
  const Costs budgets = read_budgets();
  bool all = true;
  for (const auto& [name, cost] : costs) {
    const auto budget = budgets.find(name);
    const bool good = budget != budgets.end() && holds(cost, budget->second);
    std::printf("%s %s: %s, budget %s\n", good ? "holds" : "FAILS", name.c_str(), line(cost).c_str(),
                budget == budgets.end() ? "none" : line(budget->second).c_str());
    all = all && good;
  }
  if (!all) std::printf("where it should be so: build/host/bin/effort --update, and look at what changed\n");
  return all;
}

int run(std::vector<std::string> scenes) {
  const bool update = !scenes.empty() && scenes.front() == "--update";
  if (update) scenes.erase(scenes.begin());
  Costs costs;
  if (scenes.empty()) {
    for (const SceneName& scene : scene_names()) scenes.emplace_back(scene.name);
  } else if (update) {
    costs = read_budgets();
  }
  for (const std::string& scene : scenes) measure_scene(scene, costs);
  if (!update) return compare(costs) ? 0 : 1;
  if (write_budgets(costs)) return 0;
  std::fprintf(stderr, "effort: %s cannot be written\n", budgets_path().c_str());
  return 2;
}

}  // namespace
}  // namespace krait::host

int main(int argc, char** argv) {
  using namespace krait::host;
  try {
    return run({argv + 1, argv + argc});
  } catch (const InputError& error) {
    std::fprintf(stderr, "effort: %s; usage: effort [--update] [SCENE…]\n", error.what());
    return 2;
  }
}
