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
};

void print_verdict(const Verdict& verdict) {
  for (const std::string& complaint : verdict.complaints) std::printf("%s\n", complaint.c_str());
  if (std::isnan(verdict.step_error)) {
    std::printf("the plan does not hold\n");
    return;
  }
  std::printf("%s: step error %.2g (limit 5e-3), drift %.2g m (limit 0.05), clearance %.4g m, goal depth %.4g m\n",
              verdict.holds ? "the plan holds" : "the plan does not hold", verdict.step_error, verdict.drift,
              verdict.clearance, verdict.goal_depth);
}

void judge(const VerifyOptions& options) {
  SearchRequest request;
  options.query.read(request);
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
  CLI::App* command = app.add_subcommand("verify", "judge a plan against its map, sharing no code with the planner");
  command->add_option("INPUT", o->input, "the map or drawing, or a .krait file")->required();
  command->add_option("PLAN", o->plan, "a plan's JSON")->required();
  o->query.add(*command);
  add_unknown(*command, o->unknown);
  command->footer(
      "Robot, start and goal are what you ask here, with the defaults of krait plan, never what the plan says.");
  command->callback([o] { judge(*o); });
}

}  // namespace krait::host
