// SPDX-License-Identifier: GPL-3.0-or-later
// krait-compile: turns a map or drawing into a scene file. `krait compile` runs it.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "host/compiler/blocked_starts.hpp"
#include "host/compiler/compiler.hpp"
#include "host/compiler/hindered.hpp"
#include "host/compiler/lost_headings.hpp"
#include "host/compiler/reduction_options.hpp"
#include "host/import/import.hpp"
#include "host/input/file.hpp"
#include "host/input/interrupt.hpp"
#include "host/input/json.hpp"
#include "host/input/number_option.hpp"
#include "host/input/output_option.hpp"
#include "host/input/outputs.hpp"
#include "host/input/parse_error.hpp"
#include "host/input/printed_out.hpp"
#include "host/input/progress.hpp"
#include "host/input/word_option.hpp"
#include "host/workspace/heading.hpp"
#include "host/workspace/printed.hpp"

namespace {

using namespace krait::host;

constexpr const char* kStopped = "krait-compile: stopped by you while the map was compiled: nothing is written\n";

void set_start(Workspace& workspace, const std::string& text) {
  const auto v = numbers("--start", text, {kMaxCoordinate, kMaxCoordinate, kMaxAngle},
                         "X,Y,HEADING (metres to 1e7, metres to 1e7, radians to 2 pi)");
  check_heading("--start '" + text + "'", v[2]);
  workspace.starts = {{"start", {v[0], v[1]}, v[2], {}}};
}

// A polygon inside the disc, rounding to the scene's grid included.
void add_goal(Workspace& workspace, const std::string& text) {
  const auto v =
      numbers("--goal", text, {kMaxCoordinate, kMaxCoordinate, kMaxCoordinate}, "X,Y,RADIUS (metres to 1e7)");
  constexpr int kCorners = 32;
  constexpr double kPi = 3.14159265358979323846, kRounding = 0.0002;
  if (!(v[2] >= kLeastGoalRadius)) throw InputError("--goal '" + text + "': the radius must be 1 mm or more");
  Goal goal{"goal", {}};
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * kPi * i / kCorners, radius = v[2] - kRounding;
    goal.polygon.push_back({v[0] + radius * std::cos(angle), v[1] + radius * std::sin(angle)});
  }
  std::erase_if(workspace.goals, [](const Goal& g) { return g.name == "goal"; });
  workspace.goals.push_back(std::move(goal));
}

struct Arguments {
  std::string input, output, start, goal;
  std::string datum;
  ImportOptions map;
  double tolerance = -1;
  bool any_heading = false;
  bool any_start = false;
  bool quiet = false;
  ReductionOptions reduction;
};

bool is_default_growth(const Arguments& arguments, const CompiledScene& scene) {
  return arguments.tolerance < 0 && !arguments.reduction.fits() && tolerance_of(scene) > 0;
}

// Where the default tolerance hinders the robot of --for, the scene with obstacles as they are, if that does less.
// Returns what hinders the robot in the scene that it leaves.
Hindered leave_obstacles_where_they_hinder(const Arguments& arguments, const Workspace& workspace,
                                           const RobotSpec& robot, CompileOptions options, CompiledScene& scene,
                                           std::vector<std::string>& report) {
  Hindered grown = hindered(scene, robot);
  if (grown.count() == 0 || !is_default_growth(arguments, scene)) return grown;
  options.tolerance = 0;
  CompiledScene exact = compile(workspace, options);
  Hindered left = hindered(exact, robot);
  if (left.count() >= grown.count()) return grown;
  report.push_back(
      printed("obstacles as they are (--tolerance 0): grown by up to %.4g m a side, they would leave the "
              "robot of --for no room at a start, or no way to a goal",
              tolerance_of(scene)));
  scene = std::move(exact);
  return left;
}

// Prints the warnings, and leaves none.
void warn_of(std::vector<std::string>& warnings, const Arguments& arguments, Progress& progress) {
  progress.end();
  for (const std::string& warning : warnings) {
    if (!arguments.quiet) std::fprintf(stderr, "krait-compile: warning: %s\n", warning.c_str());
  }
  warnings.clear();
}

void run(const Arguments& arguments, Progress& progress) {
  std::optional<LastWord> word(kStopped);
  const Output output{"-o", arguments.output};
  check_outputs({output}, {arguments.input});
  progress.show("reading the map");
  ImportOptions map = arguments.map;
  if (!arguments.datum.empty()) map.datum = parse_datum(arguments.datum);
  Workspace workspace = import_workspace(arguments.input, map);
  warn_of(workspace.warnings, arguments, progress);  // one of them may be why the map is refused below
  check_outputs({output}, workspace.files);
  if (!arguments.start.empty()) set_start(workspace, arguments.start);
  if (!arguments.goal.empty()) add_goal(workspace, arguments.goal);
  const std::optional<RobotSpec> robot = arguments.reduction.spec();
  workspace = arguments.reduction.apply(std::move(workspace), robot);
  warn_of(workspace.warnings, arguments, progress);
  const CompileOptions options{arguments.tolerance, [&](const std::string& step) { progress.show(step); },
                               arguments.reduction.coarse};
  std::vector<std::string> report;
  CompiledScene scene = arguments.reduction.compiled(workspace, robot, options, report);
  Hindered found;
  std::vector<std::string> narrowed;
  if (robot) found = leave_obstacles_where_they_hinder(arguments, workspace, *robot, options, scene, report);
  if (arguments.any_start) {
    found = {};
  } else if (!robot) {
    found.starts = starts_in_obstacles(scene, arguments.tolerance > 0);
    if (found.starts.empty() && is_default_growth(arguments, scene)) narrowed = narrowed_goals(workspace, scene);
  }
  if (robot && !found.starts.empty() && !arguments.start.empty()) throw InputError("--start: " + found.starts.front());
  word.reset();
  const Interrupt too_late;  // the file becomes whole, and what is said of it is said
  write_file(arguments.output, std::string(scene.bytes.begin(), scene.bytes.end()));
  const std::string lost = arguments.any_heading ? "" : lost_headings(workspace.goals);
  if (!lost.empty()) scene.warnings.insert(scene.warnings.begin(), lost);
  for (std::vector<std::string>* warnings : {&scene.warnings, &found.starts, &found.goals, &narrowed})
    warn_of(*warnings, arguments, progress);
  for (const std::string& line : report) std::fprintf(stderr, "krait-compile: %s\n", line.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Turns a map or drawing into a scene file that krait plans in.\n"
      "Obstacles only ever grow, but for curved paths of an SVG, which are true to 1 mm: a plan for the scene holds\n"
      "on the map. Lengths in metres, angles in radians, world coordinates. Exit code 0: done; 2: bad input, one line\n"
      "on standard error says what and where. Ctrl-C writes nothing; a shell has 130 for it.",
      "krait-compile");
  Arguments arguments;
  app.add_option("INPUT", arguments.input, map_formats())->required();
  app.add_option("-o,--output", arguments.output, "the scene file to write")->check(output_name())->required();
  app.add_option("--start", arguments.start, "X,Y,HEADING: a start named 'start', in place of the file's")
      ->check(not_empty());
  app.add_option("--goal", arguments.goal, "X,Y,RADIUS: a further goal named 'goal', inside this disc")
      ->check(not_empty());
  app.add_flag("--any-heading", arguments.any_heading,
               "no warning of goals whose headings the map has and a scene file has no place for");
  app.add_flag("--any-start", arguments.any_start,
               "no look at whether the starts lie in obstacles, or whether the robot of --for comes to the goals");
  app.add_flag("--quiet", arguments.quiet, "no warnings");
  const std::map<std::string, Unknown> names{
      {"free", Unknown::free}, {"occupied", Unknown::occupied}, {"map", Unknown::map}};
  app.add_option("--unknown", arguments.map.unknown,
                 "how a map's unknown cells count: free, occupied, or map (by its own thresholds)")
      ->transform(CLI::Transformer(names))
      ->check(not_empty())
      ->option_text("free|occupied|map (default: map)");
  app.add_option("--unit", arguments.map.unit, kAboutUnit)
      ->check(number_in(kMinUnit, kMaxUnit, "metres"))
      ->option_text("METRES, 1e-6 to 1e6");
  app.add_option("--datum", arguments.datum, kAboutDatum)->check(not_empty())->option_text("LONGITUDE,LATITUDE");
  app.add_option("--tolerance", arguments.tolerance,
                 "how much a passage may get narrower so that outlines need fewer corners; 0: not at all\n"
                 "(default: 0 for drawings; for maps one cell, but no passage gets narrower than two cells by it,\n"
                 "and no obstacle grows within " +
                     shown(kStartReach) + " m of a start)")
      ->check(number_in(0, kMostTolerance, "metres"))
      ->option_text("METRES, 0 to 4000");
  arguments.reduction.add(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    const int code = app.exit(help);
    if (printed_out()) return code;
    std::fprintf(stderr, "krait-compile: %s\n", kPrintingFailed);
    return 2;
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "krait-compile: %s (see --help)\n", safe_to_print(line_of(error)).c_str());
    return 2;
  }
  Progress progress("krait-compile");
  try {
    run(arguments, progress);
    return 0;
  } catch (const std::bad_alloc&) {
    progress.end();
    std::fprintf(stderr, "krait-compile: %s: not enough memory for a map of this size\n",
                 safe_to_print(arguments.input).c_str());
    return 2;
  } catch (const InputError& error) {
    progress.end();
    std::fprintf(stderr, "krait-compile: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    progress.end();
    std::fprintf(stderr, "krait-compile: internal error, please report it: %s\n", safe_to_print(error.what()).c_str());
    return 3;
  }
}
