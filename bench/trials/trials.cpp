// SPDX-License-Identifier: Apache-2.0
#include "trials/trials.hpp"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <nlohmann/json.hpp>

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

constexpr double kLongest = 1e6;  // s, a trial's limit

// Files by path, each read once.
class Problems {
 public:
  const host::SceneBytes& scene(const std::string& path) {
    auto found = scenes_.find(path);
    if (found == scenes_.end()) found = scenes_.emplace(path, host::SceneBytes::read(path)).first;
    return found->second;
  }

  const host::Workspace& workspace(const std::string& path) {
    auto found = workspaces_.find(path);
    if (found == workspaces_.end()) found = workspaces_.emplace(path, host::import_workspace(path, {})).first;
    return found->second;
  }

 private:
  std::map<std::string, host::SceneBytes> scenes_;
  std::map<std::string, host::Workspace> workspaces_;
};

host::Point point_of(const Field& triple) {
  return {triple.item(0).number(-host::kMaxCoordinate, host::kMaxCoordinate),
          triple.item(1).number(-host::kMaxCoordinate, host::kMaxCoordinate)};
}

SearchRequest request_of(const Field& line) {
  SearchRequest request;
  request.robot = host::parse_robot(line.at("robot").text());
  request.seed = static_cast<std::uint64_t>(line.at("seed").integer(0, INT64_MAX));
  request.planner = line.at("planner").text();
  request.iterations = UINT64_MAX;
  request.time_limit = line.at("limit_s").number(1e-6, kLongest);
  if (line.has("start")) {
    const Field start = line.at("start");
    request.start = host::StartPose{point_of(start), start.item(2).number(-host::kMaxAngle, host::kMaxAngle)};
  }
  if (line.has("goal")) {
    const Field goal = line.at("goal");
    request.goal = host::GoalDisc{point_of(goal), goal.item(2).number(1e-6, host::kMaxCoordinate)};
  }
  return request;
}

std::map<std::string, double> settings_of(const Field& line) {
  std::map<std::string, double> settings;
  if (!line.has("set")) return settings;
  const Field set = line.at("set");
  for (const auto& [name, value] : set.value().items()) settings[name] = set.at(name.c_str()).number(0, UINT32_MAX);
  return settings;
}

Trial trial_of(const Field& line) {
  line.keys({"trial", "seed", "scene", "input", "robot", "planner", "set", "limit_s", "start", "goal"});
  return {line.at("scene").text(), line.at("input").text(), settings_of(line), request_of(line)};
}

// Of this thread.
double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The time between its making and a call that passed without this thread on a processor.
class Waiting {
 public:
  double seconds() const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
    return passed.count() - (processor_seconds() - processor_begin_);
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double processor_begin_ = processor_seconds();
};

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

Json answer_to(const Field& line, Problems& problems, const Choose& choose, Verify verify) {
  Json answer = {{"trial", line.at("trial").value()}};
  const Trial trial = trial_of(line);
  const Solve solve = choose(trial);
  const host::Workspace& workspace = problems.workspace(trial.input);
  const host::SceneBytes& scene = problems.scene(trial.scene);
  try {
    const Waiting waiting;
    const SearchResult result = solve(scene);
    const double waited = waiting.seconds();
    answer["status"] = result.plan.status;
    answer.update(*result.plan.statistics);
    answer["waited_s"] = waited;
    if (verify == Verify::yes && result.plan.status == "solved") judge(workspace, result, answer);
  } catch (const InputError& error) {
    answer["status"] = "refused";
    answer["complaint"] = error.what();
  }
  return answer;
}

}  // namespace

void answer_trials(const Choose& choose, Verify verify) {
  Problems problems;
  std::string text;
  while (std::getline(std::cin, text)) {
    const Json line = host::parse_json(text, "standard input");
    std::cout << answer_to(Field(line, "standard input"), problems, choose, verify).dump() << std::endl;
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

void print_build(const std::map<std::string, std::string>& libraries) {
  Json build = {{"compiler", KRAIT_COMPILER}, {"flags", KRAIT_FLAGS}, {"build_type", KRAIT_BUILD_TYPE}};
  for (const auto& [name, version] : libraries) build[name] = version;
  std::cout << build.dump() << std::endl;
}

}  // namespace krait::bench
