// SPDX-License-Identifier: Apache-2.0
// krait verify: judges a plan against the map that it was made for, trusting nothing that the plan says.
#include "host/verify/verify.hpp"

#include <cmath>
#include <cstdio>
#include <memory>

#include "host/cli/asked.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/options.hpp"

namespace krait::host {
namespace {

struct VerifyOptions {
  std::string input;
  std::string plan;
  QueryOptions query;
  std::string unknown = "map";
  double dt = 0.1;
};

void print_verdict(const Verdict& verdict) {
  for (const std::string& complaint : verdict.complaints) std::printf("%s\n", complaint.c_str());
  if (std::isnan(verdict.goal_depth)) {  // the plan could not be driven, or not to its end
    std::printf("the plan does not hold\n");
    return;
  }
  std::printf(
      "%s: as driven, clearance %.4g m, goal depth %.4g m, end speed %.2g m/s; stored states differ by %.2g, in one "
      "step by %.2g\n",
      verdict.holds ? "the plan holds" : "the plan does not hold", verdict.clearance, verdict.goal_depth,
      verdict.end_speed, verdict.drift, verdict.step_error);
}

void judge(const VerifyOptions& options) {
  SearchRequest request;
  options.query.read(request);
  if (!(options.dt >= 0.001 && options.dt <= 1)) throw InputError("--dt: give seconds from 0.001 to 1");
  request.parameters.dt = static_cast<float>(options.dt);
  const Workspace workspace = import_workspace(options.input, {parse_unknown(options.unknown)});
  for (const std::string& warning : workspace.warnings) std::fprintf(stderr, "krait: warning: %s\n", warning.c_str());
  const PlanFile plan = read_plan(options.plan);
  const Verdict verdict = verify(workspace, plan, asked_of(workspace, request));
  print_verdict(verdict);
  throw Exit{verdict.holds ? kDone : kHonestNo};
}

}  // namespace

void add_verify(CLI::App& app) {
  const auto o = std::make_shared<VerifyOptions>();
  CLI::App* command = app.add_subcommand("verify", "drive a plan's controls and judge the motion against the map");
  command->add_option("INPUT", o->input, "the map or drawing, or a .krait file")->required();
  command->add_option("PLAN", o->plan, "a plan's JSON")->required();
  o->query.add(*command);
  add_unknown(*command, o->unknown);
  command->add_option("--dt", o->dt, "the plan's time step, seconds, 0.001 to 1")->capture_default_str();
  command->footer(
      "Robot, start, goal, end speed and time step are what you ask here, with the defaults of krait plan, never what\n"
      "the plan says; plans of --paper, prior and rrt end at any speed: --end-speed inf. The last figures are metres\n"
      "and radians, of the stored states against those that the controls lead to.");
  command->callback([o] { judge(*o); });
}

}  // namespace krait::host
