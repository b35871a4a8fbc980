// SPDX-License-Identifier: Apache-2.0
#include "trials/trials.hpp"

#include <cstdio>
#include <iostream>

#include "host/import/import.hpp"
#include "host/input/json.hpp"
#include "host/verify/verify.hpp"

namespace krait::bench {
namespace {

using host::Field;
using host::InputError;
using host::Json;
using host::SearchRequest;
using host::SearchResult;

host::Point point_of(const Field& triple) {
  return {triple.item(0).number(-host::kMaxCoordinate, host::kMaxCoordinate),
          triple.item(1).number(-host::kMaxCoordinate, host::kMaxCoordinate)};
}

SearchRequest request_of(const Setup& setup, const Field& trial) {
  trial.keys({"trial", "seed", "start", "goal"});
  SearchRequest request;
  request.robot = host::parse_robot(setup.robot);
  request.planner = setup.planner;
  request.seed = static_cast<std::uint64_t>(trial.at("seed").integer(0, INT64_MAX));
  request.iterations = UINT64_MAX;
  request.time_limit = setup.time_limit;
  if (trial.has("start")) {
    const Field start = trial.at("start");
    request.start = host::StartPose{point_of(start), start.item(2).number(-host::kMaxAngle, host::kMaxAngle)};
  }
  if (trial.has("goal")) {
    const Field goal = trial.at("goal");
    request.goal = host::GoalDisc{point_of(goal), goal.item(2).number(1e-6, host::kMaxCoordinate)};
  }
  return request;
}

// The verifier's figures; null where it had nothing to measure.
void judge(const host::Workspace& workspace, const SearchResult& result, Json& answer) {
  const host::Verdict verdict = host::verify(workspace, result.plan, result.asked);
  answer["verified"] = verdict.holds;
  answer["step_error"] = verdict.step_error;
  answer["drift_m"] = verdict.drift;
  answer["clearance_m"] = verdict.clearance;
  answer["goal_depth_m"] = verdict.goal_depth;
  if (!verdict.holds) answer["complaint"] = verdict.complaints.front();
}

Json answer_to(const Setup& setup, const host::Workspace& workspace, const Solve& solve, const Field& trial) {
  Json answer = {{"trial", trial.at("trial").value()}};
  const SearchRequest request = request_of(setup, trial);
  try {
    const SearchResult result = solve(request);
    answer["status"] = result.plan.status;
    answer.update(result.plan.statistics);
    if (result.plan.status == "solved") judge(workspace, result, answer);
  } catch (const InputError& error) {
    answer["status"] = "refused";
    answer["complaint"] = error.what();
  }
  return answer;
}

}  // namespace

void add_options(CLI::App& app, Setup& setup) {
  app.add_option("--scene", setup.scene, "a .krait file")->required();
  app.add_option("--input", setup.input, "the map or drawing that it was compiled from")->required();
  app.add_option("--robot", setup.robot, "as krait plan has it")->capture_default_str();
  app.add_option("--planner", setup.planner, "one of those that the subcommand planners lists")->required();
  app.add_option("--time-limit", setup.time_limit, "seconds a trial")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

void answer_trials(const Setup& setup, const Solve& solve) {
  const host::Workspace workspace = host::import_workspace(setup.input, {});
  std::string line;
  while (std::getline(std::cin, line)) {
    const Json trial = host::parse_json(line, "standard input");
    std::cout << answer_to(setup, workspace, solve, Field(trial, "standard input")).dump() << std::endl;
  }
}

int run_program(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), error.what());
    return 2;
  }
  return 0;
}

void print_build() {
  const Json build = {{"compiler", KRAIT_COMPILER}, {"flags", KRAIT_FLAGS}, {"build_type", KRAIT_BUILD_TYPE}};
  std::cout << build.dump() << std::endl;
}

}  // namespace krait::bench
