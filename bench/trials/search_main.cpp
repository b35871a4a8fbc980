// SPDX-License-Identifier: Apache-2.0
// krait-bench-search: trials of the core's planners.
#include <cstdio>

#include "host/run/session.hpp"
#include "trials/planners.hpp"
#include "trials/trials.hpp"

namespace krait::bench {
namespace {

struct Options {
  Setup setup;
  std::uint64_t megabytes = 1024;
  std::vector<std::string> settings;
};

void print_planners() {
  for (const CorePlanner& planner : core_planners()) std::printf("%s\t%s\n", planner.name, planner.description);
}

// The block is the same for all trials: its pages are in memory before any clock starts.
void answer(const Options& options) {
  const CorePlanner& planner = core_planner(options.setup.planner);
  Parameters parameters = planner.parameters;
  for (const std::string& setting : options.settings) set_parameter(setting, parameters);
  const host::SceneBytes scene = host::SceneBytes::read(options.setup.scene);
  const std::uint64_t memory = options.megabytes << 20U;
  host::Block block(memory / 8);
  answer_trials(options.setup, [&](host::SearchRequest request) {
    request.planner = planner.search;
    request.parameters = parameters;
    request.memory = memory;
    return host::run_search(options.setup.scene, scene, request, block, {});
  });
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("Trials of the core's planners", "krait-bench-search");
  app.require_subcommand(1);
  app.add_subcommand("build", "how this program was compiled")->callback(print_build);
  app.add_subcommand("planners", "name and description of every planner")->callback(print_planners);
  CLI::App* trials = app.add_subcommand("trials", "answer the trials on standard input");
  add_options(*trials, options.setup);
  trials->add_option("--memory", options.megabytes, "megabytes of the planner's block")
      ->check(CLI::Range(1, 65536))
      ->capture_default_str();
  trials->add_option("--set", options.settings, "NAME=NUMBER: alpha, beta, gamma or kappa; may be given again");
  trials->callback([&options] { answer(options); });
  return run_program(app, argc, argv);
}

}  // namespace
}  // namespace krait::bench

int main(int argc, char** argv) { return krait::bench::run(argc, argv); }
