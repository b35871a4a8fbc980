// SPDX-License-Identifier: Apache-2.0
// krait-bench-search: trials of the core's planners.
#include <cstdio>

#include "host/run/session.hpp"
#include "trials/planners.hpp"
#include "trials/trials.hpp"

namespace krait::bench {
namespace {

void print_planners() {
  for (const CorePlanner& planner : core_planners()) std::printf("%s\t%s\n", planner.name, planner.description);
}

// The block is the same for all trials: its pages are in memory before any clock starts.
void answer(std::uint64_t megabytes, Verify verify) {
  const std::uint64_t memory = megabytes << 20U;
  host::Block block(memory / 8);
  const auto choose = [&](const Trial& trial) -> Solve {
    const CorePlanner& planner = core_planner(trial.request.planner);
    host::SearchRequest request = trial.request;
    request.planner = planner.search;
    request.parameters = planner.parameters;
    set_parameters(trial.settings, request.parameters);
    request.memory = memory;
    return [&trial, &block, request](const host::SceneBytes& scene) {
      return host::run_search(trial.scene, scene, request, block, {});
    };
  };
  answer_trials(choose, verify);
}

int run(int argc, char** argv) {
  std::uint64_t megabytes = 1024;
  bool unverified = false;
  CLI::App app("Trials of the core's planners", "krait-bench-search");
  app.require_subcommand(1);
  app.add_subcommand("build", "how this program was compiled")->callback([] { print_build(); });
  app.add_subcommand("planners", "name and description of every planner")->callback(print_planners);
  CLI::App* trials = app.add_subcommand("trials", "answer the trials on standard input");
  trials->add_option("--memory", megabytes, "megabytes of the planner's block")
      ->check(CLI::Range(1, 65536))
      ->capture_default_str();
  trials->add_flag("--unverified", unverified, "do not verify plans: for counting the search's instructions");
  trials->callback([&] { answer(megabytes, unverified ? Verify::no : Verify::yes); });
  return run_program(app, argc, argv);
}

}  // namespace
}  // namespace krait::bench

int main(int argc, char** argv) { return krait::bench::run(argc, argv); }
