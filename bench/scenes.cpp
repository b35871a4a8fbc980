// The shipped scenes over many seeds: success, time and vertices to a plan, and the verifier's worst figures.
#include "host/scenes/scenes.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "host/import/import.hpp"
#include "host/input/file.hpp"
#include "host/search/search.hpp"
#include "host/verify/verify.hpp"

namespace krait::host {
namespace {

struct Options {
  std::string folder;  // holds NAME.json and NAME.krait of every shipped scene
  std::string robot = "snake:15";
  std::string planner = "adaptive";
  std::uint64_t seeds = 60;
  double time_limit = 100;
  std::string json;
};

// What one scene gave over all seeds. Unsolved runs count with the time that they took.
struct Row {
  std::string scene;
  std::uint64_t solved = 0;
  std::uint64_t verified = 0;
  std::vector<double> seconds;
  std::vector<double> vertices;
  double step_error = 0;
  double drift = 0;
  double clearance = std::numeric_limits<double>::infinity();
  double goal_depth = std::numeric_limits<double>::infinity();
};

// The value that a share of the sorted values does not exceed.
double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  return values[rank];
}

void judge(const Workspace& workspace, const SearchResult& result, Row& row) {
  const Verdict verdict = verify(workspace, result.plan, result.asked);
  row.verified += verdict.holds ? 1 : 0;
  row.step_error = std::max(row.step_error, verdict.step_error);
  row.drift = std::max(row.drift, verdict.drift);
  row.clearance = std::min(row.clearance, verdict.clearance);
  row.goal_depth = std::min(row.goal_depth, verdict.goal_depth);
}

Row measure(const std::string& scene, const Options& options) {
  const std::filesystem::path folder = options.folder;
  const std::string json = folder / (scene + ".json");
  const std::string compiled = folder / (scene + ".krait");
  const Workspace workspace = import_workspace(json, {});
  const SceneBytes scene_bytes = SceneBytes::read(compiled);

  SearchRequest request;
  request.robot = parse_robot(options.robot);
  request.planner = options.planner;
  request.time_limit = options.time_limit;
  Row row;
  row.scene = scene;
  for (request.seed = 1; request.seed <= options.seeds; ++request.seed) {
    const SearchResult result = run_search(compiled, scene_bytes, request, {});
    row.seconds.push_back(result.seconds);
    row.vertices.push_back(result.plan.statistics.at("vertices").get<double>());
    if (result.plan.status != "solved") continue;
    ++row.solved;
    judge(workspace, result, row);
  }
  return row;
}

nlohmann::ordered_json to_json(const Row& row, const Options& options) {
  return {{"scene", row.scene},
          {"robot", options.robot},
          {"planner", options.planner},
          {"seeds", options.seeds},
          {"solved", row.solved},
          {"verified", row.verified},
          {"time_s_median", quantile(row.seconds, 0.5)},
          {"time_s_p90", quantile(row.seconds, 0.9)},
          {"vertices_median", quantile(row.vertices, 0.5)},
          {"vertices_p90", quantile(row.vertices, 0.9)},
          {"worst_step_error", row.step_error},
          {"worst_drift_m", row.drift},
          {"worst_clearance_m", row.clearance},
          {"worst_goal_depth_m", row.goal_depth}};
}

void print_header(const Options& options) {
  std::printf("%s, %s, %llu seeds\n\n", options.robot.c_str(), options.planner.c_str(),
              static_cast<unsigned long long>(options.seeds));
  std::printf(
      "| scene | solved | verified | time ms, median | 90th | vertices, median | 90th | worst step error | worst drift "
      "mm | least clearance mm | least goal depth mm |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
}

void print_row(const Row& row) {
  std::printf("| %s | %llu | %llu | %.1f | %.1f | %.0f | %.0f | %.1e | %.1f | %.1f | %.1f |\n", row.scene.c_str(),
              static_cast<unsigned long long>(row.solved), static_cast<unsigned long long>(row.verified),
              1e3 * quantile(row.seconds, 0.5), 1e3 * quantile(row.seconds, 0.9), quantile(row.vertices, 0.5),
              quantile(row.vertices, 0.9), row.step_error, 1e3 * row.drift, 1e3 * row.clearance, 1e3 * row.goal_depth);
  std::fflush(stdout);
}

void run(const Options& options) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  print_header(options);
  for (const SceneName& scene : scene_names()) {
    const Row row = measure(scene.name, options);
    print_row(row);
    rows.push_back(to_json(row, options));
  }
  if (!options.json.empty()) write_file(options.json, rows.dump(1) + "\n");
}

}  // namespace
}  // namespace krait::host

int main(int argc, char** argv) {
  krait::host::Options options;
  CLI::App app("The shipped scenes over many seeds", "krait-bench-scenes");
  app.add_option("FOLDER", options.folder, "with NAME.json and NAME.krait of every shipped scene")->required();
  app.add_option("--seeds", options.seeds, "seeds 1 to N")->check(CLI::Range(1, 100000))->capture_default_str();
  app.add_option("--robot", options.robot, "as krait plan has it")->capture_default_str();
  app.add_option("--planner", options.planner, "as krait plan has it")->capture_default_str();
  app.add_option("--time-limit", options.time_limit, "seconds a run")->capture_default_str();
  app.add_option("--json", options.json, "also write the rows here");
  CLI11_PARSE(app, argc, argv);
  try {
    krait::host::run(options);
  } catch (const krait::host::InputError& error) {
    std::fprintf(stderr, "krait-bench-scenes: %s\n", error.what());
    return 2;
  }
  return 0;
}
