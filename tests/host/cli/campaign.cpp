// SPDX-License-Identifier: Apache-2.0
#include "host/cli/campaign.hpp"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "../../long_tests.hpp"
#include "host/cli/program.hpp"
#include "host/run/session.hpp"
#include "paths.hpp"

namespace krait::host {
namespace {

Asked asked_of(const Workspace& workspace, const Query& query) {
  Asked asked;
  asked.robot = query.robot;
  asked.start =
      query.start ? Start{"start", query.start->position, query.start->heading, {}} : workspace.starts.front();
  if (query.goal) {
    asked.disc_center = query.goal->center;
    asked.disc_radius = query.goal->radius;
  } else {
    asked.goal = workspace.goals.front().polygon;
  }
  return asked;
}

SearchRequest request_of(const Query& query, std::uint64_t seed) {
  SearchRequest request;
  request.robot = query.robot;
  request.start = query.start;
  request.goal = query.goal;
  request.seed = seed;
  return request;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

// What the plans of a campaign came to, and the worst that the verifier measured.
struct Summary {
  std::vector<double> seconds;
  std::vector<double> vertices;
  std::uint64_t verified = 0;
  double step_error = 0;
  double drift = 0;
  double clearance = kLargestClearance;
  double self_clearance = INFINITY;
  double goal_depth = INFINITY;

  void add(const Verdict& verdict) {
    verified += verdict.holds ? 1 : 0;
    step_error = std::max(step_error, verdict.step_error);
    drift = std::max(drift, verdict.drift);
    clearance = std::min(clearance, verdict.clearance);
    self_clearance = std::min(self_clearance, verdict.self_clearance);
    goal_depth = std::min(goal_depth, verdict.goal_depth);
  }

  void print(const std::string& title, std::uint64_t count) const {
    std::printf(
        "%s: %llu of %llu; time median %.2f ms, 90 %% %.2f ms; vertices median %.0f, 90 %% %.0f; worst step error "
        "%.2g, drift %.2g m, clearance %.2g m, between bodies %.2g m, goal depth %.2g m\n",
        title.c_str(), static_cast<unsigned long long>(verified), static_cast<unsigned long long>(count),
        1e3 * quantile(seconds, 0.5), 1e3 * quantile(seconds, 0.9), quantile(vertices, 0.5), quantile(vertices, 0.9),
        step_error, drift, clearance, self_clearance, goal_depth);
  }
};

}  // namespace

std::uint64_t seeds(std::uint64_t quick, std::uint64_t thorough) { return test::by_length(quick, thorough); }

void compile_input(const Query& query, const std::filesystem::path& directory) {
  const char* unknown = query.import.unknown == Unknown::occupied ? "occupied"
                        : query.import.unknown == Unknown::free   ? "free"
                                                                  : "map";
  const Outcome outcome = run_program(test::program_path("krait"),
                                      {"compile", query.input, "-o", query.compiled, "--unknown", unknown}, directory);
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
}

void expect_all_solved(const std::string& title, const Query& query, std::uint64_t count) {
  const Workspace workspace = import_workspace(query.input, query.import);
  const Asked asked = asked_of(workspace, query);
  const SceneBytes bytes = SceneBytes::read(query.compiled);
  Summary summary;
  Block block = block_of(request_of(query, 1));
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE(title + ", seed " + std::to_string(seed));
    const SearchResult result = run_search(query.compiled, bytes, request_of(query, seed), block, {});
    summary.seconds.push_back(result.seconds);
    summary.vertices.push_back(result.plan.statistics->at("vertices").get<double>());
    EXPECT_EQ(result.plan.status, "solved");
    if (result.plan.status != "solved") continue;
    const Verdict verdict = verify(workspace, result.plan, asked);
    EXPECT_THAT(verdict.complaints, testing::IsEmpty());
    EXPECT_TRUE(verdict.holds);
    summary.add(verdict);
  }
  summary.print(title, count);
}

}  // namespace krait::host
