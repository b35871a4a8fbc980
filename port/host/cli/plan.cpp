// SPDX-License-Identifier: Apache-2.0
// krait plan: compiles the map where it is given one, searches, checks its own result, writes and draws it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "host/cli/asked.hpp"
#include "host/cli/clearance.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/compiler_process.hpp"
#include "host/cli/map_options.hpp"
#include "host/cli/options.hpp"
#include "host/input/file.hpp"
#include "host/input/interrupt.hpp"
#include "host/input/output_option.hpp"
#include "host/input/outputs.hpp"
#include "host/input/progress.hpp"
#include "host/input/word_option.hpp"
#include "host/picture/picture.hpp"
#include "host/run/query.hpp"
#include "host/run/robot_facts.hpp"
#include "host/verify/verify.hpp"
#include "host/workspace/printed.hpp"
#include "host/workspace/ring.hpp"

namespace krait::host {
namespace {

struct PlanOptions {
  std::string compiler;  // the path of krait-compile
  std::string scene;     // or a map
  MapOptions map;
  std::string tolerance;
  std::vector<std::string> map_options;  // those of compile that were given
  QueryOptions query;
  std::string planner = "adaptive";
  std::uint64_t seed = 1;
  std::string memory = std::to_string(kUsualMegabytes) + "M";
  std::uint64_t iterations = SearchRequest().iterations;
  std::optional<double> time_limit;
  std::optional<double> improve;
  double stop_within = 0;
  std::optional<double> alpha;
  std::optional<double> beta;
  std::optional<double> gamma;
  std::optional<std::uint32_t> kappa;
  std::optional<double> clearance;
  std::optional<double> dt;
  bool paper = false;
  std::string json;
  std::string csv;
  std::string svg;
  std::string png;
  std::string html;
};

// The scene to plan in and, where the user names a map and no compiled scene, that map.
struct Ground {
  SceneBytes scene;
  std::optional<Workspace> map;
  double grown = 0;  // metres a side, by which obstacles were grown and then were not, since nothing else left a way
};

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

SearchRequest request_of(const PlanOptions& options) {
  SearchRequest request;
  if (options.paper) request.parameters = Parameters::paper();
  options.query.read(request);
  refuse_braking(options);
  refuse_unread(options);
  require_usable(options.query.robot, request.robot);
  request.planner = options.planner;
  request.seed = options.seed;
  request.memory = parse_memory(options.memory);
  request.iterations = options.iterations;
  request.time_limit = options.time_limit;
  if (options.improve) {
    request.improve = *options.improve;
  } else {
    improve_as_usual(request, options.paper);
  }
  request.stop_within = options.stop_within;
  Parameters& p = request.parameters;
  if (options.alpha) p.tuning.alpha = static_cast<float>(*options.alpha);
  if (options.beta) p.tuning.beta = static_cast<float>(*options.beta);
  if (options.gamma) p.tuning.gamma = static_cast<float>(*options.gamma);
  if (options.kappa) p.tuning.kappa = *options.kappa;
  if (options.clearance) p.clearance = static_cast<float>(*options.clearance);
  if (options.dt) p.dt = static_cast<float>(*options.dt);
  return request;
}

// The states in the map's coordinates, and the control that is held from each on. A float has 9 digits; a position far
// from 0 has more.
std::string csv_of(const PlanFile& plan) {
  std::string text = "t";
  for (const std::string& name : plan.state_names) text += "," + name;
  for (const std::string& name : control_names(plan.robot)) text += "," + name;
  text += "\n";
  const auto append = [&](double value) { text += printed("%.9g", value); };
  const auto place = [&](double origin, float local) {
    text += printed(origin == 0 ? ",%.9g" : ",%.13g", origin + static_cast<double>(local));
  };
  for (std::size_t i = 0; i < plan.states.size(); ++i) {
    append(plan.dt * static_cast<double>(i));
    place(plan.origin.x, plan.states[i][0]);
    place(plan.origin.y, plan.states[i][1]);
    for (std::size_t k = 2; k < plan.states[i].size(); ++k) {
      text += ",";
      append(static_cast<double>(plan.states[i][k]));
    }
    for (std::size_t k = 0; k < 2; ++k) {
      text += ",";
      if (i < plan.controls.size()) append(static_cast<double>(plan.controls[i][k]));
    }
    text += "\n";
  }
  return text;
}

// Against the map itself; a compiled scene has its pieces only.
Verdict verdict_on(const SearchResult& result, const Ground& ground, const SearchRequest& request,
                   const PlanOptions& options, Progress& progress) {
  progress.show("verifying", std::to_string(result.plan.controls.size()) + " steps");
  if (ground.map) return verify(*ground.map, result.plan, asked_of(*ground.map, request));
  return verify(import_workspace(options.scene, {}), result.plan, result.asked);
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

void draw(const SearchRequest& request, const SceneBytes& bytes, const SearchResult& result, const PlanOptions& options,
          Progress& progress) {
  if (options.svg.empty() && options.png.empty() && options.html.empty()) return;
  std::fflush(stdout);  // the answer: to draw, the whole search is repeated
  progress.show("drawing");
  const Picture picture = watch_search(options.scene, bytes, request, result.plan);
  if (!options.svg.empty()) write_file(options.svg, draw_svg(picture));
  if (!options.png.empty()) write_file(options.png, draw_png(picture));
  if (!options.html.empty()) write_file(options.html, draw_html(picture));
  progress.end();
}

void print_quality(const SearchResult& result, const SearchRequest& request, const SceneBytes& bytes,
                   const Verdict& verdict) {
  const bool far = verdict.clearance >= kLargestClearance;
  std::printf("as driven: least clearance %s%.4g m, ", far ? "at least " : "", verdict.clearance);
  if (least_speed(request.robot) > 0) {
    std::printf("never at rest");
  } else {
    std::printf("speed at the end %.3g m/s", verdict.end_speed);
  }
  if (!std::isnan(verdict.heading_error)) std::printf(", %.3g rad off the heading", verdict.heading_error);
  const double shortest = shortest_way_of(result.plan, request, open_scene(result.plan.scene, bytes));
  const double length = result.plan.statistics->at("plan_length_m").get<double>();
  if (shortest > 0.1)
    std::printf(", %.2f times the shortest way that is wide enough (%.1f m)", length / shortest, shortest);
  std::printf("\n");
}

// "1 time", "3 times"
std::string times(std::uint64_t count) {
  return printed("%llu time%s", static_cast<unsigned long long>(count), count == 1 ? "" : "s");
}

// "1 body", "3 bodies"
std::string bodies(std::size_t count) { return count == 1 ? "1 body" : printed("%zu bodies", count); }

// What improvement made of the first plan.
void print_improvement(const SearchResult& result, const SearchRequest& request) {
  const auto& s = *result.plan.statistics;
  const auto improvements = s.at("improvements").get<std::uint64_t>();
  if (improvements > 0) {
    std::printf("improved %s in %.4f s: %.1f s became %.1f s, %.1f m became %.1f m\n", times(improvements).c_str(),
                s.at("improve_time_s").get<double>(), result.first.duration, s.at("plan_duration_s").get<double>(),
                result.first.length, s.at("plan_length_m").get<double>());
  } else if (result.near_shortest) {
    std::printf("the first plan was not improved\n");
  } else if (result.stopped) {
    std::printf("no better plan was found before you stopped it\n");
  } else if (result.late) {
    std::printf("no better plan was found within the time limit\n");
  } else {
    std::printf("no better plan was found in %.7g times the first plan's collision checks\n",
                s.at("improve").get<double>());
  }
  if (result.near_shortest) {
    std::printf("  longer than the shortest way by less than %.7g %%, as asked (--stop-within)\n",
                100 * request.stop_within);
  }
}

// "goal 'dock': within 0.1 m of 18,2, heading 1.57 rad, within 0.1 rad"; "goal: within 1 m of 18,2, any heading"
std::string goal_text(const SearchRequest& request) {
  const GoalDisc& goal = *request.goal;
  std::string text = request.goal_name.empty() ? "goal" : "goal '" + request.goal_name + "'";
  text += printed(": within %.6g m of %.10g,%.10g, ", goal.radius, goal.center.x, goal.center.y);
  if (!request.facing) return text + "any heading";
  const GoalFacing& facing = *request.facing;
  text += printed("heading %.6g rad", facing.heading);
  if (facing.either_way) text += " or the opposite one";
  text += printed(", within %.6g rad", facing.tolerance);
  if (facing.hitches) text += printed(", hitches straight within %.6g rad", *facing.hitches);
  return text;
}

void print_summary(const SearchResult& result, const SearchRequest& request, const Ground& ground,
                   const PlanOptions& options, const std::optional<Clearance>& clearance) {
  const PlanFile& plan = result.plan;
  const auto& s = *plan.statistics;
  std::printf("%s: %s (%s) in %s, seed %llu: %.4f s, %llu iterations, %llu vertices\n", plan.status.c_str(),
              plan.robot.model.c_str(), bodies(plan.robot.bodies.size()).c_str(), plan.scene.c_str(),
              static_cast<unsigned long long>(plan.seed), s.at("time_s").get<double>(),
              s.at("iterations").get<unsigned long long>(), s.at("vertices").get<unsigned long long>());
  if (request.goal) {
    const bool of_map = request.facing && !options.query.heading;
    std::printf("  %s%s\n", goal_text(request).c_str(), of_map ? " (--any-heading asks for the place alone)" : "");
  }
  if (result.stopped) {
    std::printf("stopped by you after %llu iterations%s\n", s.at("iterations").get<unsigned long long>(),
                plan.states.empty() ? "" : ": this is the best plan so far");
  }
  if (ground.grown > 0) {
    std::printf(
        "  the map's cells as they are (--tolerance 0): with obstacles grown by up to %.4g m there was no plan\n",
        ground.grown);
  }
  const bool no_route = plan.status == to_string(Status::no_route);  // the reason names the clearance
  if (clearance && !no_route) std::printf("  %s\n", text(*clearance, ground.map).c_str());
  for (const std::string& reason : result.why) std::printf("  %s\n", reason.c_str());
  if (plan.states.empty()) return;
  std::printf("plan: %zu steps, %.1f s, %.1f m, hash %s, verified\n", plan.controls.size(),
              s.at("plan_duration_s").get<double>(), s.at("plan_length_m").get<double>(),
              s.at("hash").get<std::string>().c_str());
}

// "1200 iterations, 4 m to go", and of a plan that is improved how good it is.
std::string detail_of(const SearchNews& news) {
  const auto iterations = static_cast<unsigned long long>(news.iterations);
  if (news.best.length > 0) {
    return printed("best plan %.1f s, %.1f m, improved %s", news.best.duration, news.best.length,
                   times(news.improvements).c_str());
  }
  if (std::isfinite(news.cost_to_go)) {
    return printed("%llu iterations, cost still to go %.3g", iterations, news.cost_to_go);
  }
  return printed("%llu iterations, %llu vertices", iterations, static_cast<unsigned long long>(news.vertices));
}

// Ctrl-C ends the search with what there is; before and after it, the program.
SearchResult search(const PlanOptions& options, const SearchRequest& request, const SceneBytes& bytes, Block& block,
                    Progress& progress) {
  const Interrupt interrupt;
  SearchWatch watch;
  watch.tell = [&](const SearchNews& news) {
    progress.show(news.best.length > 0 ? "improving" : "planning", detail_of(news));
  };
  watch.stop = [&] { return interrupt.asked(); };
  SearchResult result = run_search(options.scene, bytes, request, block, watch);
  progress.end();
  return result;
}

std::vector<Output> outputs_of(const PlanOptions& options) {
  return {{"-o", options.json},
          {"--csv", options.csv},
          {"--svg", options.svg},
          {"--png", options.png},
          {"--html", options.html}};
}

std::vector<std::string> inputs_of(const PlanOptions& options) {
  std::vector<std::string> inputs = {options.scene};
  if (options.query.robot_is_file()) inputs.push_back(options.query.robot);
  return inputs;
}

// `tolerance` as the option's value; empty: the compiler's default.
SceneBytes compiled(const PlanOptions& options, const std::string& tolerance, bool again = false) {
  std::vector<std::string> arguments = options.map.arguments();
  arguments.emplace_back("--any-heading");  // the request has those of the goals
  arguments.emplace_back("--any-start");    // and may begin elsewhere
  if (!tolerance.empty()) arguments.insert(arguments.end(), {"--tolerance", tolerance});
  if (again) arguments.emplace_back("--quiet");  // it has warned
  const std::string scene = run_compiler(options.compiler, options.scene, arguments);
  return SceneBytes::copy(scene.data(), scene.size());
}

// The request's goal becomes the map's where that is a pose.
Ground read_ground(const PlanOptions& options, SearchRequest& request, Progress& progress) {
  const std::string content = read_file(options.scene, UINT32_MAX);
  if (is_scene_file(content)) {
    options.query.read_pose({}, request);
    warn(misnamed_scene(options.scene));
    if (options.map_options.empty()) return {SceneBytes::copy(content.data(), content.size()), std::nullopt};
    throw InputError(options.map_options.front() + " is for maps, but " + options.scene +
                     " is compiled already: use it with krait compile, or plan in the map itself");
  }
  progress.show("reading the map");
  Workspace map = import_workspace(options.scene, options.map.read());
  progress.end();                                 // the compiler has its own
  check_outputs(outputs_of(options), map.files);  // also those that the map names
  options.query.read_pose(map, request);
  return {compiled(options, options.tolerance), std::move(map)};
}

// Warns of a ROBOT.json that leaves body 0 to its lengths, which place it where its user hardly wants it.
void warn_of_axle(const PlanOptions& options, const RobotSpec& robot) {
  if (!options.query.robot_is_file() || !same_ring(robot.bodies[0], default_bodies(robot)[0])) return;
  const std::string warning = axle_warning(robot);
  if (!warning.empty()) warn(safe_to_print(options.query.robot) + ": " + warning);
}

// A search and the distance that it kept to obstacles, where --clearance was not set.
struct Answer {
  SearchResult result;
  std::optional<Clearance> clearance;
};

// Searches with the clearance that was asked for, or else the usual one and, where that search uses up its iterations,
// the least; which one becomes the request's.
Answer search_clear(const krait::Scene& scene, const Ground& ground, const PlanOptions& options, SearchRequest& request,
                    Block& block, Progress& progress) {
  if (options.clearance || options.paper) return {search(options, request, ground.scene, block, progress), {}};
  Clearance clearance = usual_clearance(scene, request, ground.map, block);
  request.parameters.clearance = clearance.kept;
  SearchResult first = search(options, request, ground.scene, block, progress);
  const bool in_vain = first.plan.status == to_string(Status::budget_used);
  if (!in_vain || !(clearance.kept > kLeastClearance)) return {std::move(first), clearance};
  clearance.in_vain = clearance.kept;
  request.parameters.clearance = clearance.kept = kLeastClearance;
  if (request.time_limit) *request.time_limit = std::max(*request.time_limit - first.seconds, 0.0);
  return {search(options, request, ground.scene, block, progress), clearance};
}

// Searches; where obstacles are in the way that the compiler's default tolerance may have grown, the map is compiled
// without it, and that scene, which replaces the first, is searched.
Answer search_in(Ground& ground, const PlanOptions& options, SearchRequest& request, Progress& progress) {
  Block block = block_of(request);
  const krait::Scene scene = open_scene(options.scene, ground.scene);
  const double growth = static_cast<double>(scene.header().tolerance);
  if (!ground.map || !options.tolerance.empty() || !(growth > 0)) {
    return search_clear(scene, ground, options, request, block, progress);
  }
  try {
    Answer answer = search_clear(scene, ground, options, request, block, progress);
    if (answer.result.plan.status != to_string(Status::no_route)) return answer;
  } catch (const InObstacle&) {
    progress.end();
  }
  ground.scene = compiled(options, "0", true);
  ground.grown = growth;
  return search_clear(open_scene(options.scene, ground.scene), ground, options, request, block, progress);
}

// Runs search_in; where --robot was not set, a refusal of the start or the goal names the robot.
Answer search_for(Ground& ground, const PlanOptions& options, SearchRequest& request, Progress& progress) {
  try {
    return search_in(ground, options, request, progress);
  } catch (const InObstacle& error) {
    if (options.query.robot_given()) throw;
    throw InObstacle(std::string(error.what()) + " (the robot is " + options.query.robot +
                     ": --robot asks for another)");
  }
}

void plan(const PlanOptions& options) {
  SearchRequest request = request_of(options);
  judge_stop_within(options, request);
  check_outputs(outputs_of(options), inputs_of(options));  // before work that may take long
  warn_of_axle(options, request.robot);
  Progress progress("krait");
  Ground ground = read_ground(options, request, progress);
  auto [result, clearance] = search_for(ground, options, request, progress);
  Verdict verdict;
  const int code = judge(result, ground, request, options, verdict, progress);
  if (!options.json.empty()) write_file(options.json, to_json(result.plan).dump() + "\n");
  if (!options.csv.empty()) write_file(options.csv, csv_of(result.plan));
  print_summary(result, request, ground, options, clearance);
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
  const auto o = std::make_shared<PlanOptions>();
  o->compiler = compiler_path(program);
  const Parameters defaults;
  CLI::App* command = app.add_subcommand("plan", "find a plan in a map or scene, check it, write it and draw it");
  command
      ->add_option("SCENE", o->scene,
                   "a .krait file, from krait compile; or a map or drawing, which is compiled and which the plan is\n"
                   "checked against:\n" +
                       map_formats())
      ->required();
  o->query.add(*command, {.start = "its first",
                          .heading = "that of the map's goal, else any",
                          .end_speed = "inf with --paper; --planner prior and rrt do not brake, and take inf only"});
  o->map.add(*command);
  command
      ->add_option("--tolerance", o->tolerance,
                   "how much a map's passages may get narrower, in metres, as for krait compile\n"
                   "(default: one cell, but to no less than two; 0 where that leaves no plan)")
      ->check(number_in(0, kMostTolerance, "metres"));
  command
      ->add_option("--planner", o->planner,
                   "the search: adaptive (the paper's), prior ([18], its costs never change), rrt")
      ->check(one_of({"adaptive", "prior", "rrt"}))
      ->capture_default_str();
  command->add_option("--seed", o->seed, "of the random numbers: the same seed has the same plan")
      ->check(whole_number(UINT64_MAX))
      ->capture_default_str();
  command->add_option("--memory", o->memory, "the planner's one block, as 128K, 64M")->capture_default_str();
  command->add_option("--iterations", o->iterations, "expansions, at most")
      ->check(whole_number(UINT64_MAX, "expansions", 1))
      ->capture_default_str();
  command
      ->add_option("--time-limit", o->time_limit,
                   "seconds for finding and improving a plan, after which the best one so far is the result\n"
                   "(default: none; a limit makes the result depend on the machine)")
      ->check(number_in(1e-9, 1e9, "seconds"));
  command
      ->add_option(
          "--improve", o->improve,
          "search for a better plan with this many times the collision checks that the first one took,\n"
          "0 to 1e6; the best is the result, proven and verified as the first would be\n" +
              printed(
                  "(default: %.7g, or more where those make fewer than %.7g checks; 0, the first plan, with --paper,\n"
                  "--planner prior or rrt, or a --memory under %s)",
                  kImprove, kLeastChecks, kRoomToImprove))
      ->check(number_in(0, 1e6, "times the first plan's checks"));
  command
      ->add_option("--stop-within", o->stop_within,
                   "improve no further where the plan is longer than the shortest way by this share at most, as 0.05\n"
                   "(default: never; refused where --improve 0, --paper or --planner prior or rrt keep the first plan)")
      ->check(number_in(1e-6, 1e6, "a share of the shortest way"));
  const auto search = [&](const char* name, auto& value, const char* text, Argument argument, auto normal) {
    const std::string about = printed("%s (default %.7g)", with_range(text, argument).c_str(), decimal(normal));
    return command->add_option(name, value, about);
  };
  constexpr const char* kPlain = "a number without unit";
  const SearchTuning& tuning = defaults.tuning;
  search("--alpha", o->alpha, "strength of the heuristic, not with rrt", Argument::alpha, tuning.alpha)
      ->check(number_of(Argument::alpha, kPlain));
  search("--beta", o->beta, "penalty of a selection, not with rrt", Argument::beta, tuning.beta)
      ->check(number_of(Argument::beta, kPlain));
  search("--gamma", o->gamma, "how much failures raise edge costs (0: never), with adaptive only", Argument::gamma,
         tuning.gamma)
      ->check(number_of(Argument::gamma, kPlain));
  search("--kappa", o->kappa, "expansions between updates of the costs, with adaptive only", Argument::kappa,
         float(tuning.kappa))
      ->check(whole_number_of(Argument::kappa, "expansions"));
  command
      ->add_option(
          "--clearance", o->clearance,
          with_range("metres kept to obstacles on top of rounding", Argument::clearance) +
              printed(" (default: 2 %% of the robot's width\nand half a map's cell, less where there is too little room"
                      " for it or no plan with it,\nat least %.4g; that with --paper)",
                      decimal(defaults.clearance)))
      ->check(number_of(Argument::clearance, "metres"));
  search("--dt", o->dt, "a time step, seconds", Argument::dt, defaults.dt)->check(number_of(Argument::dt, "seconds"));
  command->add_flag("--paper", o->paper,
                    "Algorithms 1 and 2 with the paper's constants: states are checked, steps between them are not");
  command->add_option("-o,--output", o->json, "write the plan as JSON")->check(output_name());
  command->add_option("--csv", o->csv, "write states and controls as a table")->check(output_name());
  command->add_option("--svg", o->svg, "draw the plan")->check(output_name());
  command->add_option("--png", o->png, "draw the plan")->check(output_name());
  command
      ->add_option("--html", o->html,
                   "write a page that replays the plan and the search, for any browser, without network")
      ->check(output_name());
  command->footer(defaults_table());
  command->callback([o, command] {
    o->map_options = o->map.given();
    if (command->count("--tolerance") > 0) o->map_options.emplace_back("--tolerance");
    plan(*o);
  });
}

}  // namespace krait::host
