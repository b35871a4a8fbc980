// SPDX-License-Identifier: Apache-2.0
#include "host/cli/plan_options.hpp"

#include <cmath>
#include <utility>

#include "host/cli/commands.hpp"
#include "host/input/output_option.hpp"
#include "host/input/word_option.hpp"
#include "host/run/robot_facts.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

constexpr double kImprove = 10;               // times the first plan's collision checks
constexpr double kLeastChecks = 300'000;      // of improvement, where nobody says how much
constexpr const char* kRoomToImprove = "1M";  // of memory: a smaller block can spare none

// What keeps the first plan.
std::string kept_by(const PlanOptions& options) {
  if (options.improve) return "--improve 0";
  return options.paper ? "--paper" : "--planner " + options.planner;
}

// The default of --improve. Of the rivals and the paper's algorithm it is their own plan that is wanted.
void improve_as_usual(SearchRequest& request, bool paper) {
  if (paper || request.planner != "adaptive" || request.memory < parse_memory(kRoomToImprove)) return;
  request.improve = kImprove;
  request.improve_least = kLeastChecks;
}

// The rivals are not asked to brake.
void refuse_braking(const PlanOptions& options) {
  const std::optional<double>& speed = options.query.end_speed;
  if (options.planner == "adaptive" || !speed || std::isinf(*speed)) return;
  throw InputError("--end-speed: --planner " + options.planner +
                   " does not brake, its plans end at any speed: leave it out, or give inf");
}

// Of the tuning, prior reads alpha and beta, and rrt nothing.
void refuse_unread(const PlanOptions& options) {
  if (options.planner == "adaptive") return;
  const bool has_groups = options.planner == "prior";
  const std::pair<const char*, bool> unread[] = {{"--alpha", options.alpha && !has_groups},
                                                 {"--beta", options.beta && !has_groups},
                                                 {"--gamma", options.gamma.has_value()},
                                                 {"--kappa", options.kappa.has_value()}};
  for (const auto& [name, is_given] : unread) {
    if (!is_given) continue;
    throw InputError(std::string(name) + ": --planner " + options.planner + " does not read it: leave it out");
  }
}

// Where nothing is improved, --stop-within ends nothing.
void judge_stop_within(const PlanOptions& options, const SearchRequest& request) {
  if (!(request.stop_within > 0) || request.improve > 0) return;
  if (options.improve || options.paper || options.planner != "adaptive") {
    throw InputError("--stop-within: " + kept_by(options) +
                     " keeps the first plan: leave one of them out, or give --improve a number above 0");
  }
  warn(printed("--stop-within: a --memory under %s keeps the first plan, unless --improve is given", kRoomToImprove));
}

}  // namespace

void PlanOptions::add(CLI::App& command) {
  command_ = &command;
  add_ground();
  add_search();
  add_improvement();
  add_tuning();
  add_outputs();
}

void PlanOptions::add_ground() {
  command_
      ->add_option("SCENE", scene,
                   "a .krait file, from krait compile; or a map or drawing, which is compiled and which the plan is\n"
                   "checked against:\n" +
                       map_formats())
      ->required();
  query.add(*command_, {.start = "its first",
                        .heading = "that of the map's goal, else any",
                        .end_speed = "inf with --paper; --planner prior and rrt do not brake, and take inf only"});
  map.add(*command_);
  command_
      ->add_option("--tolerance", tolerance,
                   "how much a map's passages may get narrower, in metres, as for krait compile\n"
                   "(default: one cell, but to no less than two; 0 where that leaves no plan)")
      ->check(number_in(0, kMostTolerance, "metres"));
}

void PlanOptions::add_search() {
  command_
      ->add_option("--planner", planner,
                   "the search: adaptive (the paper's), prior ([18], its costs never change), rrt")
      ->check(one_of({"adaptive", "prior", "rrt"}))
      ->capture_default_str();
  command_->add_option("--seed", seed, "of the random numbers: the same seed has the same plan")
      ->check(whole_number(UINT64_MAX))
      ->capture_default_str();
  command_->add_option("--memory", memory, "the planner's one block, as 128K, 64M")->capture_default_str();
  command_->add_option("--iterations", iterations, "expansions, at most")
      ->check(whole_number(UINT64_MAX, "expansions", 1))
      ->capture_default_str();
}

void PlanOptions::add_improvement() {
  command_
      ->add_option("--time-limit", time_limit,
                   "seconds for finding and improving a plan, after which the best one so far is the result\n"
                   "(default: none; a limit makes the result depend on the machine)")
      ->check(number_in(1e-9, 1e9, "seconds"));
  command_
      ->add_option(
          "--improve", improve,
          "search for a better plan with this many times the collision checks that the first one took,\n"
          "0 to 1e6; the best is the result, proven and verified as the first would be\n" +
              printed(
                  "(default: %.7g, or more where those make fewer than %.7g checks; 0, the first plan, with --paper,\n"
                  "--planner prior or rrt, or a --memory under %s)",
                  kImprove, kLeastChecks, kRoomToImprove))
      ->check(number_in(0, 1e6, "times the first plan's checks"));
  command_
      ->add_option("--stop-within", stop_within,
                   "improve no further where the plan is longer than the shortest way by this share at most, as 0.05\n"
                   "(default: never; refused where --improve 0, --paper or --planner prior or rrt keep the first plan)")
      ->check(number_in(1e-6, 1e6, "a share of the shortest way"));
}

void PlanOptions::add_tuning() {
  const Parameters defaults;
  const auto search = [&](const char* name, auto& value, const char* text, Argument argument, auto normal) {
    const std::string about = printed("%s (default %.7g)", with_range(text, argument).c_str(), decimal(normal));
    return command_->add_option(name, value, about);
  };
  constexpr const char* kPlain = "a number without unit";
  const SearchTuning& tuning = defaults.tuning;
  search("--alpha", alpha, "strength of the heuristic, not with rrt", Argument::alpha, tuning.alpha)
      ->check(number_of(Argument::alpha, kPlain));
  search("--beta", beta, "penalty of a selection, not with rrt", Argument::beta, tuning.beta)
      ->check(number_of(Argument::beta, kPlain));
  search("--gamma", gamma, "how much failures raise edge costs (0: never), with adaptive only", Argument::gamma,
         tuning.gamma)
      ->check(number_of(Argument::gamma, kPlain));
  search("--kappa", kappa, "expansions between updates of the costs, with adaptive only", Argument::kappa,
         float(tuning.kappa))
      ->check(whole_number_of(Argument::kappa, "expansions"));
  command_
      ->add_option(
          "--clearance", clearance,
          with_range("metres kept to obstacles on top of rounding", Argument::clearance) +
              printed(" (default: 2 %% of the robot's width\nand half a map's cell, less where there is too little room"
                      " for it or no plan with it,\nat least %.4g; that with --paper)",
                      decimal(defaults.clearance)))
      ->check(number_of(Argument::clearance, "metres"));
  search("--dt", dt, "a time step, seconds", Argument::dt, defaults.dt)->check(number_of(Argument::dt, "seconds"));
  command_->add_flag("--paper", paper,
                     "Algorithms 1 and 2 with the paper's constants: states are checked, steps between them are not");
}

void PlanOptions::add_outputs() {
  command_->add_option("-o,--output", json, "write the plan as JSON")->check(output_name());
  command_->add_option("--csv", csv, "write states and controls as a table")->check(output_name());
  command_->add_option("--svg", svg, "draw the plan")->check(output_name());
  command_->add_option("--png", png, "draw the plan")->check(output_name());
  command_
      ->add_option("--html", html,
                   "write a page that replays the plan and the search, for any browser, without network")
      ->check(output_name());
}

SearchRequest PlanOptions::read() const {
  SearchRequest request;
  if (paper) request.parameters = Parameters::paper();
  query.read(request);
  refuse_braking(*this);
  refuse_unread(*this);
  require_usable(query.robot, request.robot);
  request.planner = planner;
  request.seed = seed;
  request.memory = parse_memory(memory);
  request.iterations = iterations;
  request.time_limit = time_limit;
  if (improve) {
    request.improve = *improve;
  } else {
    improve_as_usual(request, paper);
  }
  request.stop_within = stop_within;
  Parameters& p = request.parameters;
  if (alpha) p.tuning.alpha = static_cast<float>(*alpha);
  if (beta) p.tuning.beta = static_cast<float>(*beta);
  if (gamma) p.tuning.gamma = static_cast<float>(*gamma);
  if (kappa) p.tuning.kappa = *kappa;
  if (clearance) p.clearance = static_cast<float>(*clearance);
  if (dt) p.dt = static_cast<float>(*dt);
  judge_stop_within(*this, request);
  return request;
}

std::vector<std::string> PlanOptions::of_maps() const {
  std::vector<std::string> names = map.given();
  if (command_->count("--tolerance") > 0) names.emplace_back("--tolerance");
  return names;
}

bool PlanOptions::draws() const { return !svg.empty() || !png.empty() || !html.empty(); }

std::vector<Output> PlanOptions::outputs() const {
  return {{"-o", json}, {"--csv", csv}, {"--svg", svg}, {"--png", png}, {"--html", html}};
}

std::vector<std::string> PlanOptions::inputs() const {
  std::vector<std::string> names = {scene};
  if (query.robot_is_file()) names.push_back(query.robot);
  return names;
}

}  // namespace krait::host
