// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "host/compiler/closed_goals.hpp"
#include "host/reduce/reduce.hpp"
#include "host/run/pools.hpp"
#include "host/run/robots.hpp"
#include "host/run/tracked_clearance.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

constexpr double kRounding = 0.001;  // metres: the most that the compiler moves an outline of cells by

constexpr double kHopeless = 4;  // times the budget: steps that are finer in every way are not tried

// One way to make the scene; metres.
struct Step {
  bool coarse = false;
  double growth = 0;  // of outlines
  std::optional<double> cell, corridor;

  // How far an obstacle may grow.
  double error() const { return growth + (cell ? *cell * std::numbers::sqrt2 : 0); }
};

bool at_least_as_fine(const Step& a, const Step& b) {
  const bool as_wide = !a.corridor || (b.corridor && *a.corridor >= *b.corridor);
  return as_wide && (!a.cell || b.cell) && (!a.coarse || b.coarse) && a.error() <= b.error();
}

struct Outcome {
  CompiledScene scene;
  std::uint64_t ram = 0;
  bool has_way = true;
};

class Fitter {
 public:
  Fitter(const Workspace& workspace, const RobotSpec& robot, const Budget& budget)
      : workspace_(workspace), robot_(robot), core_(robot), girth_(girth_of(robot)), budget_(budget) {
    usual_error_ = std::max(0.0, tracked_clearance(robot, &workspace) / 2 - kRounding);
    error_ = budget.tolerance >= 0 ? budget.tolerance / 2 : usual_error_;
  }

  // The coarsest first.
  std::vector<Step> steps() const {
    std::vector<Step> steps;
    const bool has_query = !workspace_.starts.empty() && !workspace_.goals.empty();
    for (double widths = 2; widths <= 32 && has_cells() && has_query; widths *= std::numbers::sqrt2)
      steps.push_back({true, error_, {}, widths * girth_.outer});
    const double cell = cell_of(error_);
    if (has_cells() && cell >= 2 * workspace_.cells->resolution) steps.push_back({true, error_ / 2, cell, {}});
    for (const bool coarse : {true, false}) {
      if (budget_.coarse && !coarse) break;
      for (const double share : {1.0, 0.5, 0.0}) steps.push_back({coarse, share * error_, {}, {}});
    }
    return steps;
  }

  // A tolerance that allows twice the error, or the usual one where none is allowed; in metres.
  double larger_tolerance() const { return std::stod(printed("%.2g", 2 * (error_ > 0 ? 2 * error_ : usual_error_))); }

  // The same step where that tolerance is given.
  static Step with_tolerance(const Step& step, double tolerance) {
    const double error = tolerance / 2;
    if (step.cell) return {step.coarse, error / 2, cell_of(error), step.corridor};
    return {step.coarse, error, {}, step.corridor};
  }

  Outcome make(const Step& step, const std::function<void(const std::string&)>& progress) const {
    Reduction reduction{{}, step.cell, {}, step.corridor, girth_};
    if (step.cell) reduction.fill = girth_;
    const Workspace workspace = reduced(workspace_, reduction);
    Outcome outcome{compile(workspace, {2 * step.growth, progress, step.coarse, step.error() - step.growth})};
    for (std::size_t i = workspace.warnings.size(); i > workspace_.warnings.size(); --i) {
      std::vector<std::string>& warnings = outcome.scene.warnings;
      warnings.insert(warnings.begin(), "to fit: " + workspace.warnings[i - 1]);
    }
    const std::vector<std::uint8_t>& bytes = outcome.scene.bytes;
    krait::Scene scene;
    (void)krait::Scene::open(bytes.data(), bytes.size(), scene);
    outcome.ram = block_for(scene, core_.view(), kFitVertices);
    outcome.has_way = scene.goal_count() == 0 || !why_closed(scene, robot_, 0);
    return outcome;
  }

  // How many times as large as its part of the budget the larger one of flash and RAM is.
  double excess(const Outcome& outcome) const {
    const auto share = [](std::uint64_t bytes, std::uint64_t most) {
      return most == 0 ? 0 : double(bytes) / double(most);
    };
    return std::max(share(outcome.scene.bytes.size(), budget_.flash), share(outcome.ram, budget_.ram));
  }

  bool fits(const Outcome& outcome) const { return excess(outcome) <= 1; }

  std::string done(const Step& step) const {
    const double error = step.error();
    std::string text = error > 0 ? printed("obstacles grown by at most %.3g m", error) : "obstacles as they are";
    if (step.cell) text += printed(", cells of %.3g m", *step.cell);
    if (step.coarse) text += ", coarse regions";
    if (step.corridor) text += printed(", what is further than %.3g m from the shortest ways closed", *step.corridor);
    return text;
  }

  std::string bytes(const Outcome& outcome) const {
    const auto of = [](std::uint64_t most) {
      return most == 0 ? std::string() : printed(" of %llu", static_cast<unsigned long long>(most));
    };
    return printed("%zu", outcome.scene.bytes.size()) + of(budget_.flash) + " bytes of flash, " +
           printed("%llu", static_cast<unsigned long long>(outcome.ram)) + of(budget_.ram) +
           printed(" of RAM with room for %u vertices", kFitVertices);
  }

 private:
  static double cell_of(double error) { return error / 2 / std::numbers::sqrt2; }

  bool has_cells() const { return workspace_.cells.has_value(); }

  const Workspace& workspace_;
  const RobotSpec& robot_;
  CoreRobot core_;
  Girth girth_;
  Budget budget_;
  double error_ = 0;
  double usual_error_ = 0;
};

// What the workspace lacks for a corridor; empty where it lacks nothing.
std::string corridor_advice(const Workspace& workspace) {
  std::string missing;
  if (workspace.starts.empty()) missing = "a start";
  if (workspace.goals.empty()) missing += (missing.empty() ? "a goal" : " and a goal");
  if (!workspace.cells) missing += (missing.empty() ? "" : " and ") + std::string("--cell METRES");
  return missing.empty() ? "" : "give it " + missing + " so that a corridor may be kept";
}

// What came nearest to the budget.
struct Refused {
  Step step;
  double excess = std::numeric_limits<double>::infinity();
  std::string bytes;
};

using Tell = std::function<void(const std::string&)>;

// Empty where a larger tolerance would hardly help, which one more compilation tells, or what is refused is hopeless.
std::string tolerance_advice(const Fitter& fitter, const Refused& refused, const Tell& progress) {
  constexpr double kHelps = 0.9;
  const double tolerance = fitter.larger_tolerance();
  if (refused.excess > kHopeless || !(tolerance > 0)) return "";
  try {
    const Outcome outcome = fitter.make(Fitter::with_tolerance(refused.step, tolerance), progress);
    if (!outcome.has_way || fitter.excess(outcome) > kHelps * refused.excess) return "";
    return printed("allow more error: with --tolerance %.2g it takes ", tolerance) + fitter.bytes(outcome);
  } catch (const InputError&) {
    return "";
  }
}

std::string joined(std::vector<std::string> advice) {
  std::erase(advice, "");
  std::string text = advice.front();
  for (std::size_t i = 1; i < advice.size(); ++i) text += (i + 1 == advice.size() ? ", or " : ", ") + advice[i];
  return text;
}

}  // namespace

Fitted fit(const Workspace& workspace, const RobotSpec& robot, const Budget& budget, const Tell& progress) {
  const Fitter fitter(workspace, robot, budget);
  std::optional<Fitted> best;
  std::vector<Step> hopeless;
  Refused refused;
  std::string closed;
  for (const Step& step : fitter.steps()) {
    const auto is_finer = [&](const Step& other) { return at_least_as_fine(step, other); };
    if (std::any_of(hopeless.begin(), hopeless.end(), is_finer)) continue;
    try {
      Outcome outcome = fitter.make(step, progress);
      const std::string bytes = fitter.bytes(outcome);
      if (!fitter.fits(outcome)) {
        const double excess = fitter.excess(outcome);
        if (excess < refused.excess) refused = {step, excess, bytes};
        if (excess > kHopeless) hopeless.push_back(step);
        continue;
      }
      if (outcome.has_way) {
        best = Fitted{std::move(outcome.scene), {fitter.done(step), bytes}};
      } else {
        closed = fitter.done(step);
      }
    } catch (const InputError& error) {
      closed = fitter.done(step) + ": " + error.what();
    }
  }
  if (best) return std::move(*best);
  if (refused.bytes.empty())
    throw InputError("no way from the start to the goal is wide enough for the robot, even with " + closed);
  throw InputError("does not fit: " + refused.bytes + " (" + fitter.done(refused.step) + ")" +
                   (closed.empty() ? "" : "; coarser: " + closed) + ": " +
                   joined({"crop the map", corridor_advice(workspace), tolerance_advice(fitter, refused, progress)}));
}

}  // namespace krait::host
