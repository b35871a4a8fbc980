// SPDX-License-Identifier: Apache-2.0
// krait plan: compiles the map where it is given one, searches, checks its own result, writes and draws it.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "host/cli/asked.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/compiler_process.hpp"
#include "host/cli/ground.hpp"
#include "host/cli/plan_options.hpp"
#include "host/cli/plan_search.hpp"
#include "host/cli/plan_summary.hpp"
#include "host/input/file.hpp"
#include "host/input/interrupt.hpp"
#include "host/input/outputs.hpp"
#include "host/input/progress.hpp"
#include "host/picture/picture.hpp"
#include "host/plan_file/plan_table.hpp"
#include "host/run/robot_facts.hpp"
#include "host/verify/obstacle_near.hpp"
#include "host/verify/verify.hpp"
#include "host/workspace/printed.hpp"
#include "host/workspace/ring.hpp"

namespace krait::host {
namespace {

// Warns of a ROBOT.json that leaves body 0 to its lengths, which place it where its user hardly wants it.
void warn_of_axle(const PlanOptions& options, const RobotSpec& robot) {
  if (!options.query.robot_is_file() || !same_ring(robot.bodies[0], default_bodies(robot)[0])) return;
  const std::string warning = axle_warning(robot);
  if (!warning.empty()) warn(safe_to_print(options.query.robot) + ": " + warning);
}

// Against the map itself; a compiled scene has its pieces only.
Verdict verdict_on(const SearchResult& result, const Ground& ground, const SearchRequest& request,
                   const PlanOptions& options, Progress& progress) {
  progress.show("verifying");
  if (ground.map) return judged(*ground.map, result.plan, asked_of(*ground.map, request), progress);
  return judged(import_workspace(options.scene, {}), result.plan, result.asked, progress);
}

// A plan that does not hold is no plan: its arrays are emptied and the status says why. Returns the exit code, and
// writes the verdict on a plan.
int judge(SearchResult& result, const Ground& ground, const SearchRequest& request, const PlanOptions& options,
          Verdict& verdict, Progress& progress) {
  if (result.plan.status != "solved") return result.plan.status == "internal" ? kOwnBug : kHonestNo;
  verdict = verdict_on(result, ground, request, options, progress);
  progress.end();
  if (verdict.holds) return kDone;
  result.plan.status = "verification_failed";
  result.plan.states.clear();
  result.plan.controls.clear();
  for (const std::string& complaint : verdict.complaints) std::fprintf(stderr, "krait: %s\n", complaint.c_str());
  if (options.paper) return kHonestNo;
  std::fprintf(stderr,
               "krait: the plan does not hold: a bug of krait, please report it with the map and the options\n");
  return kOwnBug;
}

// Checks the result and writes it; Ctrl-C comes too late for that. Returns the exit code.
int finish(SearchResult& result, const Ground& ground, const SearchRequest& request, const PlanOptions& options,
           Verdict& verdict, Progress& progress) {
  const Interrupt too_late;
  const int code = judge(result, ground, request, options, verdict, progress);
  if (!options.json.empty()) write_file(options.json, to_json(result.plan).dump() + "\n");
  if (!options.csv.empty()) write_file(options.csv, plan_table(result.plan));
  return code;
}

std::vector<FileText> drawings(const PlanOptions& options, const Picture& picture) {
  std::vector<FileText> files;
  if (!options.svg.empty()) files.push_back({options.svg, draw_svg(picture)});
  if (!options.png.empty()) files.push_back({options.png, draw_png(picture)});
  if (!options.html.empty()) files.push_back({options.html, draw_html(picture)});
  return files;
}

void draw(const SearchRequest& request, const SceneBytes& bytes, const SearchResult& result, const PlanOptions& options,
          Progress& progress) {
  if (!options.draws()) return;
  std::fflush(stdout);  // the answer: to draw, the whole search is repeated
  std::optional<LastWord> word("krait: stopped by you while pictures were drawn: none is written\n");
  progress.show("drawing");
  const std::vector<FileText> files = drawings(options, watch_search(options.scene, bytes, request, result.plan));
  word.reset();
  write_files(files);
  progress.end();
}

// " (shown in a.png, b.html)"; nothing where nothing is drawn.
std::string pictures_of(const PlanOptions& options) {
  std::string files;
  for (const std::string* file : {&options.svg, &options.png, &options.html}) {
    if (!file->empty()) files += (files.empty() ? "" : ", ") + *file;
  }
  return files.empty() ? "" : " (shown in " + files + ")";
}

// A start or goal in an obstacle is drawn, and refused.
Answer answer_for(Ground& ground, const PlanOptions& options, SearchRequest& request, Progress& progress) {
  try {
    return search_for(ground, options, request, progress);
  } catch (const InObstacle& refusal) {
    progress.end();
    if (options.draws())
      write_files(drawings(options, picture_of_refusal(options.scene, ground.scene, request, refusal)));
    throw InObstacle(refusal.what() + pictures_of(options), refusal.status(), refusal.where());
  }
}

// Names the map's obstacles in the answers to the request, which the map must outlive.
void name_obstacles(const Workspace& map, SearchRequest& request) {
  constexpr double kReach = 1;  // m, as far as an obstacle may have grown from it on most maps
  request.obstacle_at = [&map](const Point& at) { return obstacle_near(map, at, kReach); };
}

void plan(const PlanOptions& options) {
  SearchRequest request = options.read();
  check_outputs(options.outputs(), options.inputs());  // before work that may take long
  warn_of_axle(options, request.robot);
  Progress progress("krait");
  Ground ground = read_ground(options, request, progress);
  if (ground.map) name_obstacles(*ground.map, request);
  auto [result, clearance] = answer_for(ground, options, request, progress);
  Verdict verdict;
  const int code = finish(result, ground, request, options, verdict, progress);
  print_summary(result, request, ground, options.query.heading.has_value(), clearance);
  if (request.improve > 0 && !result.plan.controls.empty()) print_improvement(result, request);
  if (code == kDone) print_quality(result, request, ground.scene, verdict);
  draw(request, ground.scene, result, options, progress);
  throw Exit{code};
}

std::string defaults_table() {
  std::string text =
      "Robots, with their parameters' defaults (metres, radians, seconds; change them in a ROBOT.json):\n";
  for (const std::string& model : robot_models()) {
    text += "  " + model + ":";
    for (const auto& [name, value] : default_parameters(model)) {
      text += printed(" %s %.7g", name.c_str(), value);
    }
    text += "\n";
  }
  return text +
         "Ends: solved (exit 0); no_route, budget_used, tree_full, time_used, also by Ctrl-C (exit 1); bad input (exit "
         "2).";
}

}  // namespace

void add_plan(CLI::App& app, const char* program) {
  const auto options = std::make_shared<PlanOptions>();
  options->compiler = compiler_path(program);
  CLI::App* command = app.add_subcommand("plan", "find a plan in a map or scene, check it, write it and draw it");
  options->add(*command);
  command->footer(defaults_table());
  command->callback([options] { plan(*options); });
}

}  // namespace krait::host
