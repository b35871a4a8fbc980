// SPDX-License-Identifier: Apache-2.0
// krait verify: judges a plan against the map that it was made for, trusting nothing that the plan says.
#include "host/verify/verify.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "host/cli/asked.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/map_options.hpp"
#include "host/cli/options.hpp"
#include "host/input/interrupt.hpp"
#include "host/input/progress.hpp"
#include "host/run/robot_facts.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

struct VerifyOptions {
  std::string input;
  std::string plan;
  QueryOptions query;
  MapOptions map;
  double dt = decimal(Parameters().dt);
  bool all = false;  // complaints, not the first only
};

// The start of the plan's own, where none is asked for: its first state, which is held to stand still in any case.
Start start_of(const PlanFile& plan) {
  Start start{"the plan's", {}, 0, {}};
  if (plan.states.empty() || plan.states[0].size() < 3) return start;
  const std::vector<float>& state = plan.states[0];
  start.position = {plan.origin.x + static_cast<double>(state[0]), plan.origin.y + static_cast<double>(state[1])};
  start.heading = static_cast<double>(state[2]);
  const auto trailers = static_cast<std::size_t>(plan.robot.links);
  if (state.size() > 3 + trailers) start.angles.assign(state.end() - plan.robot.links, state.end());
  return start;
}

// A heading that is not asked for is the plan's own.
Asked asked_of(const Workspace& workspace, SearchRequest request, const QueryOptions& query, const PlanFile& plan) {
  query.read_pose(workspace, request);
  if (!query.asks_heading()) request.facing = query.any_heading ? std::nullopt : plan.goal_facing;
  if (request.start || !request.start_name.empty()) return asked_of(workspace, request);
  const Start start = start_of(plan);
  request.start = StartPose{start.position, start.heading};
  Asked asked = asked_of(workspace, request);
  asked.start = start;
  return asked;
}

// The first complaint, of robot and query before the motion, explains most of the others.
void print_complaints(const Verdict& verdict, bool all) {
  const std::size_t shown = all ? verdict.complaints.size() : std::min<std::size_t>(verdict.complaints.size(), 1);
  for (std::size_t i = 0; i < shown; ++i) std::printf("%s\n", verdict.complaints[i].c_str());
  const std::size_t more = verdict.complaints.size() - shown;
  if (more > 0) std::printf("%zu more, which the first may explain: --all prints them\n", more);
}

void print_verdict(const Verdict& verdict, const RobotSpec& robot, bool all) {
  print_complaints(verdict, all);
  if (std::isnan(verdict.goal_depth)) {  // the plan could not be driven, or not to its end
    std::printf("the plan does not hold\n");
    return;
  }
  const std::string end = least_speed(robot) > 0 ? "never at rest" : printed("end speed %.2g m/s", verdict.end_speed);
  std::printf(
      "%s: as driven, clearance %.4g m, goal depth %.4g m, %s; stored states differ by %.2g, in one step by %.2g\n",
      verdict.holds ? "the plan holds" : "the plan does not hold", verdict.clearance, verdict.goal_depth, end.c_str(),
      verdict.drift, verdict.step_error);
  if (!std::isnan(verdict.heading_error))
    std::printf("as driven, it ends %.4g rad off the heading\n", verdict.heading_error);
}

// To a micrometre or microradian, since the plan's own numbers are floats: -4.34, not -4.340000153.
double to_micro(double number) { return std::round(number * 1e6) / 1e6; }

// "heading 2.5 to 0.1 rad either way, hitches to 0.2 rad"
std::string text(const GoalFacing& facing) {
  std::string all = printed("heading %.10g to %.10g rad", facing.heading, facing.tolerance);
  if (facing.either_way) all += " either way";
  if (facing.hitches) all += printed(", hitches to %.10g rad", *facing.hitches);
  return all;
}

// What the plan was judged by though it was not asked for.
void print_own(const VerifyOptions& options, const Workspace& workspace, const Asked& asked) {
  const Start& start = asked.start;
  std::printf("from %.14g,%.14g,%.14g%s\n", to_micro(start.position.x), to_micro(start.position.y),
              to_micro(start.heading),
              options.query.start.empty() ? ", the plan's own start: --start asks for another" : "");
  const QueryOptions& query = options.query;
  if (query.asks_heading() || query.any_heading) return;
  const Goal* goal = asked.disc_center ? find_goal(workspace, query.goal) : nullptr;
  const std::string own = asked.facing ? "the " + text(*asked.facing) : "any heading";
  const std::string wanted = goal != nullptr && goal->pose ? "the " + text(goal->pose->facing) : own;
  if (own != wanted) {
    std::printf("to %s, the plan's own: the map's goal has %s, for which --heading asks\n", own.c_str(),
                wanted.c_str());
  } else if (asked.facing) {
    std::printf("to %s, the plan's own: --heading asks for another\n", own.c_str());
  }
}

void judge(const VerifyOptions& options) {
  SearchRequest request;
  options.query.read(request);
  request.parameters.dt = static_cast<float>(options.dt);
  std::optional<LastWord> word("krait: stopped by you: the plan is not judged\n");
  Progress progress("krait");
  progress.show("reading the map");
  const Workspace workspace = import_workspace(options.input, options.map.read());
  progress.end();
  for (const std::string& warning : workspace.warnings) warn(warning);
  const PlanFile plan = read_plan(options.plan);
  const Asked asked = asked_of(workspace, request, options.query, plan);
  const Verdict verdict = judged(workspace, plan, asked, progress);
  word.reset();
  progress.end();
  print_verdict(verdict, request.robot, options.all);
  if (verdict.holds) print_own(options, workspace, asked);
  if (!verdict.holds && !options.query.robot_given()) {
    std::printf("judged for %s, the default: --robot asks for another\n", options.query.robot.c_str());
  }
  throw Exit{verdict.holds ? kDone : kHonestNo};
}

}  // namespace

void add_verify(CLI::App& app) {
  const auto o = std::make_shared<VerifyOptions>();
  CLI::App* command = app.add_subcommand("verify", "drive a plan's controls and judge the motion against the map");
  command->add_option("INPUT", o->input, "the map or drawing, or a .krait file")->required();
  command->add_option("PLAN", o->plan, "a plan's JSON")->required();
  o->query.add(*command, {.start = "where the plan begins",
                          .heading = "the plan's own, or any where it has none",
                          .end_speed = "plans of --paper, prior and rrt do not brake, and need inf"});
  o->map.add(*command);
  command->add_option("--dt", o->dt, with_range("the plan's time step, seconds", Argument::dt))
      ->check(number_of(Argument::dt, "seconds"))
      ->capture_default_str();
  command->add_flag("--all", o->all, "print every complaint, not only the first, which explains most others");
  command->footer(
      "Robot, goal, end speed and time step are what you ask here, with the defaults of krait plan, never what the "
      "plan\n"
      "says; plans of --paper, prior and rrt end at any speed: --end-speed inf. So is the start, if you give one; "
      "else\n"
      "it is where the plan begins, and is printed; and the heading at the goal: without --heading the one that the "
      "plan\n"
      "was made for is held, and printed. The last figures are metres and radians, of the stored states\n"
      "against those that the controls lead to.");
  command->callback([o] { judge(*o); });
}

}  // namespace krait::host
