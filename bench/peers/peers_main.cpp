// SPDX-License-Identifier: Apache-2.0
// krait-bench-peers: trials of OMPL's planners.
#include <ompl/config.h>
#include <ompl/util/Console.h>

#include <cstdio>

#include "peers/solve.hpp"
#include "trials/trials.hpp"

namespace krait::bench {
namespace {

void print_planners() {
  for (const PeerPlanner& planner : peer_planners())
    std::printf("%s\t%s\n", planner.name.c_str(), planner.description.c_str());
}

void answer() {
  const auto choose = [](const Trial& trial) -> Solve {
    const PeerPlanner& planner = peer_planner(trial.request.planner);
    return [&trial, &planner, tuning = tuned(planner, trial.settings)](const host::SceneBytes& scene) {
      return solve(planner, tuning, trial.scene, scene, trial.request);
    };
  };
  answer_trials(choose, Verify::yes);
}

int run(int argc, char** argv) {
  ompl::msg::noOutputHandler();
  CLI::App app("Trials of OMPL's planners", "krait-bench-peers");
  app.require_subcommand(1);
  app.add_subcommand("build", "how this program was compiled")->callback([] {
    const std::string version = std::to_string(OMPL_MAJOR_VERSION) + "." + std::to_string(OMPL_MINOR_VERSION) + "." +
                                std::to_string(OMPL_PATCH_VERSION);
    print_build({{"ompl", version}});
  });
  app.add_subcommand("planners", "name and description of every planner")->callback(print_planners);
  CLI::App* trials = app.add_subcommand("trials", "answer the trials on standard input");
  trials->callback(answer);
  return run_program(app, argc, argv);
}

}  // namespace
}  // namespace krait::bench

int main(int argc, char** argv) { return krait::bench::run(argc, argv); }
