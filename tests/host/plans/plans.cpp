// SPDX-License-Identifier: GPL-3.0-or-later
// Plans over random scenes, robots and seeds, each judged by the verifier against the drawing itself, which includes
// the open-loop replay of its controls in double precision: plans [--from SEED] [N]. N plans, 100 or with
// KRAIT_LONG_TESTS=1 5,000; SEED is the first scene's. Exits 1 when one does not hold.
#include <cstdio>
#include <limits>
#include <map>
#include <string>

#include "../../long_tests.hpp"
#include "host/compiler/compiler.hpp"
#include "host/run/session.hpp"
#include "options.hpp"
#include "random_workspace.hpp"

namespace krait::host::test {
namespace {

constexpr int kQueries = 12;  // of a scene

struct Tally {
  std::map<std::string, std::uint64_t> ends;
  std::map<std::string, std::uint64_t> solved_by_robot;
  std::uint64_t scenes = 0, solved = 0, failed = 0;
  double step_error = 0, drift = 0;
  double clearance = std::numeric_limits<double>::infinity();
  double goal_depth = std::numeric_limits<double>::infinity();

  void add(const Verdict& verdict) {
    ++(verdict.holds ? solved : failed);
    step_error = std::max(step_error, verdict.step_error);
    drift = std::max(drift, verdict.drift);
    clearance = std::min(clearance, verdict.clearance);
    goal_depth = std::min(goal_depth, verdict.goal_depth);
  }

  void print() const {
    std::printf("%llu scenes, %llu plans that hold, %llu that do not\n", static_cast<unsigned long long>(scenes),
                static_cast<unsigned long long>(solved), static_cast<unsigned long long>(failed));
    for (const auto& [end, count] : ends)
      std::printf("  %s: %llu\n", end.c_str(), static_cast<unsigned long long>(count));
    for (const auto& [robot, count] : solved_by_robot) {
      std::printf("  solved, %s: %llu\n", robot.c_str(), static_cast<unsigned long long>(count));
    }
    std::printf("worst step error %.2g, drift %.2g m, clearance %.3g m, goal depth %.3g m\n", step_error, drift,
                clearance, goal_depth);
  }
};

std::string name_of(const RobotSpec& robot) {
  return robot.links > 0 ? robot.model + ":" + std::to_string(robot.links) : robot.model;
}

void plan(const Workspace& workspace, const SceneBytes& bytes, const SearchRequest& request, const std::string& label,
          Tally& tally) {
  static Block block;
  try {
    if (8 * block.size() < request.memory) block = block_of(request);
    const SearchResult result = run_search("scene", bytes, request, block, {});
    ++tally.ends[result.plan.status];
    if (result.plan.status == "internal") ++tally.failed;
    if (result.plan.status != "solved") return;
    const Verdict verdict = verify(workspace, result.plan, result.asked);
    tally.add(verdict);
    ++tally.solved_by_robot[name_of(request.robot)];
    for (const std::string& complaint : verdict.complaints) {
      std::printf("%s, %s, %s: %s\n", label.c_str(), name_of(request.robot).c_str(), request.planner.c_str(),
                  complaint.c_str());
    }
  } catch (const InputError& error) {
    const std::string line = error.what();
    ++tally.ends[line.substr(0, line.find(':'))];
  }
}

void plan_in_scene(std::uint64_t seed, std::uint64_t wanted, Tally& tally) {
  std::mt19937_64 random(seed);
  const Workspace workspace = random_workspace(random);
  SceneBytes bytes;
  try {
    const CompiledScene scene = compile(workspace, {});
    bytes = SceneBytes::copy(scene.bytes.data(), scene.bytes.size());
  } catch (const InputError&) {  // obstacles cover all of it
    ++tally.ends["no free space"];
    return;
  }
  ++tally.scenes;
  for (int query = 0; query < kQueries && tally.solved + tally.failed < wanted; ++query) {
    const std::string label = "scene " + std::to_string(seed) + ", query " + std::to_string(query);
    plan(workspace, bytes, random_request(workspace, random), label, tally);
  }
}

}  // namespace
}  // namespace krait::host::test

int main(int argc, char** argv) {
  using namespace krait::host::test;
  const Options options = read_options(argc, argv, krait::test::by_length(100, 5'000), 0);
  Tally tally;
  for (std::uint64_t seed = options.first_scene; tally.solved + tally.failed < options.plans; ++seed) {
    plan_in_scene(seed, options.plans, tally);
  }
  tally.print();
  return tally.failed == 0 ? 0 : 1;
}
