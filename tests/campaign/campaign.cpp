// SPDX-License-Identifier: GPL-3.0-or-later
// Whether plans hold as they are driven: campaign [--from SEED] [--query Q] [N]. Draws scenes from SEED on, and for
// each robots of all models, sizes, speeds and time steps; plans with the core alone; drives each plan's controls in
// double precision and sweeps that motion (judge.hpp), until N plans are judged, 150 or with KRAIT_LONG_TESTS=1 10,000.
// With --query only that query of the scene SEED. Exits 1 when a plan does not hold.
#include <cstdio>
#include <cstring>
#include <ctime>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "../host/plans/options.hpp"
#include "../long_tests.hpp"
#include "draw.hpp"
#include "host/compiler/compiler.hpp"

namespace krait::campaign {
namespace {

constexpr int kQueries = 24;              // of a scene
constexpr std::uint64_t kWork = 200'000;  // placements of a body a query
constexpr double kNear = 0.01;            // m: plans that come so near are counted
constexpr std::uint64_t kIterations = 5000;

// Of this process, s.
double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Counts {
  std::uint64_t asked = 0, plans = 0, held = 0, collide = 0, off_limits = 0, miss = 0, astray = 0, internal = 0;
  std::uint64_t steps = 0, near = 0;
  double clearance = std::numeric_limits<double>::infinity(), depth = std::numeric_limits<double>::infinity();
  double position_error = 0, angle_error = 0, excess = 0;
  int most_parts = 0;

  void add(const Verdict& verdict) {
    ++plans;
    held += verdict.holds() ? 1 : 0;
    collide += verdict.collisions.empty() ? 0 : 1;
    off_limits += verdict.off_limits.empty() ? 0 : 1;
    miss += verdict.misses.empty() ? 0 : 1;
    astray += verdict.others.empty() ? 0 : 1;
    near += verdict.clearance < kNear ? 1 : 0;
    clearance = std::min(clearance, verdict.clearance);
    depth = std::min(depth, verdict.depth);
    position_error = std::max(position_error, verdict.position_error);
    angle_error = std::max(angle_error, verdict.angle_error);
    excess = std::max(excess, verdict.excess);
    most_parts = std::max(most_parts, verdict.most_parts);
  }
};

struct Tally {
  Counts counts[kModels];
  std::map<std::string, std::uint64_t> ends;
  std::uint64_t scenes = 0, judged = 0, failed = 0;
  double compiling = 0, planning = 0, judging = 0;  // s

  void print() const {
    std::printf("%llu scenes, %llu plans, %llu that do not hold or internal\n", static_cast<unsigned long long>(scenes),
                static_cast<unsigned long long>(judged), static_cast<unsigned long long>(failed));
    std::printf("%-10s %6s %6s %6s %6s %7s %6s %6s %6s %8s %8s %10s %10s %10s %9s %9s %6s\n", "model", "asked", "plans",
                "near", "held", "collide", "limits", "miss", "astray", "internal", "steps", "clearance", "goal depth",
                "position", "angle", "excess", "parts");
    for (int m = 0; m < kModels; ++m) {
      const Counts& c = counts[m];
      const auto whole = [](std::uint64_t x) { return static_cast<unsigned long long>(x); };
      std::printf(
          "%-10s %6llu %6llu %6llu %6llu %7llu %6llu %6llu %6llu %8llu %8llu %10.2g %10.2g %10.2g %9.2g %9.2g %6d\n",
          name(static_cast<Model>(m)), whole(c.asked), whole(c.plans), whole(c.near), whole(c.held), whole(c.collide),
          whole(c.off_limits), whole(c.miss), whole(c.astray), whole(c.internal), whole(c.steps), c.clearance, c.depth,
          c.position_error, c.angle_error, c.excess, c.most_parts);
    }
    for (const auto& [end, count] : ends)
      std::printf("  %s: %llu\n", end.c_str(), static_cast<unsigned long long>(count));
    std::printf("processor time: compiling %.1f s, planning %.1f s, judging %.1f s\n", compiling, planning, judging);
  }
};

void report(const std::string& label, const Verdict& verdict) {
  std::printf("%s\n", label.c_str());
  for (const auto* lines : {&verdict.collisions, &verdict.off_limits, &verdict.misses, &verdict.others}) {
    for (const std::string& line : *lines) std::printf("    %s\n", line.c_str());
  }
}

void plan_and_judge(const std::string& label, const Scene& scene, const Field& field, const DrawnQuery& drawn, bool all,
                    Tally& tally) {
  Counts& counts = tally.counts[static_cast<int>(drawn.query.robot.model)];
  const double begin = processor_time();
  const Planned planned = plan(scene, drawn.query);
  tally.planning += processor_time() - begin;
  ++counts.asked;
  ++tally.ends[planned.end];
  const std::string line = label + ": " + describe(drawn.query);
  if (all) std::printf("%s: %s\n", line.c_str(), planned.end.c_str());
  if (planned.end == "internal") {
    ++counts.internal;
    ++tally.failed;
    std::printf("%s\n    internal\n", line.c_str());
  }
  if (!planned.solved) return;
  const double judging = processor_time();
  const Verdict verdict = judge(drawn.query.robot, field, drawn.goal, planned.plan);
  tally.judging += processor_time() - judging;
  counts.steps += planned.plan.controls.size() / 2;
  counts.add(verdict);
  ++tally.judged;
  if (verdict.holds()) return;
  ++tally.failed;
  report(line, verdict);
}

// Nothing where obstacles cover all of the scene.
std::optional<host::CompiledScene> compile(const DrawnScene& drawn, std::uint64_t seed) {
  try {
    return host::compile(drawn.workspace, {});
  } catch (const host::InputError& error) {
    if (std::string(error.what()).rfind("no free space", 0) != 0) throw;
    std::printf("--from %llu: the map is refused: %s\n", static_cast<unsigned long long>(seed), error.what());
    return std::nullopt;
  }
}

// A query by its number, or all of them.
void plan_in_scene(std::uint64_t seed, std::optional<std::uint64_t> only, std::uint64_t wanted, Tally& tally) {
  const DrawnScene drawn = draw_scene(seed);
  const double begin = processor_time();
  const std::optional<host::CompiledScene> made = compile(drawn, seed);
  if (!made) return;
  const host::CompiledScene& compiled = *made;
  std::vector<std::uint64_t> bytes((compiled.bytes.size() + 7) / 8);
  std::memcpy(bytes.data(), compiled.bytes.data(), compiled.bytes.size());
  Scene scene;
  if (!Scene::open(bytes.data(), compiled.bytes.size(), scene).ok()) {
    std::printf("scene %llu does not open\n", static_cast<unsigned long long>(seed));
    ++tally.failed;
    return;
  }
  const Field field(drawn.workspace, {scene.header().origin_x, scene.header().origin_y});
  tally.compiling += processor_time() - begin;
  ++tally.scenes;
  for (int number = 0; number < kQueries && tally.judged < wanted; ++number) {
    if (only && number != static_cast<int>(*only)) continue;
    DrawnQuery query = draw_query(drawn, scene, field, seed, number);
    query.query.work = kWork;
    query.query.iterations = kIterations;
    const std::string label = "--from " + std::to_string(seed) + " --query " + std::to_string(number);
    plan_and_judge(label, scene, field, query, only.has_value(), tally);
  }
}

}  // namespace
}  // namespace krait::campaign

int main(int argc, char** argv) {
  using namespace krait::campaign;
  const std::uint64_t plans = krait::test::by_length(150, 10'000);
  const krait::host::test::Options options = krait::host::test::read_options(argc, argv, plans, kQueries);
  Tally tally;
  if (options.query) {
    plan_in_scene(options.first_scene, options.query, options.plans, tally);
  } else {
    for (std::uint64_t seed = options.first_scene; tally.judged < options.plans; ++seed) {
      plan_in_scene(seed, {}, options.plans, tally);
    }
  }
  tally.print();
  return tally.failed == 0 ? 0 : 1;
}
