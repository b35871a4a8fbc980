// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/reduction_options.hpp"

#include "host/compiler/fit.hpp"
#include "host/input/bytes.hpp"
#include "host/input/json.hpp"
#include "host/input/number_option.hpp"
#include "host/input/word_option.hpp"
#include "host/run/robot_facts.hpp"

namespace krait::host {

std::vector<double> numbers(const std::string& option, const std::string& text, const std::vector<double>& bounds,
                            const std::string& form) {
  const std::optional<std::vector<double>> values = parse_numbers(text, bounds);
  if (!values) throw InputError(option + " '" + text + "': give " + form + hint_of_far_place(text));
  return *values;
}

namespace {

// A budget of 0 bytes holds nothing.
std::uint64_t budget_of(const std::string& option, const std::string& text) {
  if (text.empty()) return 0;
  const std::uint64_t bytes = parse_bytes(option, text);
  if (bytes == 0) throw InputError(option + " " + text + ": give bytes above 0, as 256K or 1M, or leave it out");
  return bytes;
}

}  // namespace

void ReductionOptions::add(CLI::App& app) {
  constexpr double kLeast = 0.001, kMost = 4000;  // metres
  const auto metres = [&](const char* name, std::optional<double>& value, const char* about) {
    app.add_option(name, value, about)->check(number_in(kLeast, kMost, "metres"))->option_text("METRES");
  };
  app.add_option("--crop", crop, "keeps only this box of the map; what lies outside is wall")
      ->check(not_empty())
      ->option_text("X0,Y0,X1,Y1");
  metres("--cell", cell,
         "a map's cells become as large as this, or a drawing is drawn in such cells; a cell is\n"
         "occupied where any part of it was");
  metres("--fill", fill,
         "closes what a disc of this radius cannot touch: gaps, pockets, and what it cannot reach from\n"
         "the starts");
  metres("--corridor", corridor, "keeps only what is this near to the shortest ways from the starts to the goals");
  app.add_option("--for", robot,
                 "closes what this robot cannot touch, as --fill does for a disc, on cells, and takes a corridor's "
                 "ways for it:\n" +
                     model_forms(", ", "N trailers, 0 to " + std::to_string(kMaxLinks)) +
                     ", a shipped robot, or a ROBOT.json")
      ->check(not_empty())
      ->option_text("ROBOT")
      ->excludes("--fill");
  app.add_flag("--coarse", coarse,
               "about half as many regions: less flash and RAM, and a search that is guided by less");
  app.add_option("--flash", flash,
                 "with --for: makes the finest scene file that is no larger, from fine to coarse:\n"
                 "outlines with the error that --tolerance allows (default: half of the clearance that\n"
                 "krait plan keeps), coarse regions, larger cells, corridors")
      ->check(not_empty())
      ->option_text("BYTES, as 1M")
      ->needs("--for");
  app.add_option("--ram", ram,
                 "the same for the robot's block with room for " + std::to_string(kFitVertices) + " vertices")
      ->check(not_empty())
      ->option_text("BYTES, as 256K")
      ->needs("--for");
}

std::optional<RobotSpec> ReductionOptions::spec() const {
  if (robot.empty()) return std::nullopt;
  RobotSpec spec = parse_robot(robot);
  require_usable(robot, spec);
  return spec;
}

Workspace ReductionOptions::apply(Workspace workspace, const std::optional<RobotSpec>& spec) const {
  Reduction reduction;
  if (!crop.empty()) {
    const auto v = numbers("--crop", crop, std::vector<double>(4, kMaxCoordinate), "X0,Y0,X1,Y1 (metres to 1e7)");
    if (!(v[0] < v[2] && v[1] < v[3])) throw InputError("--crop '" + crop + "': give X0 below X1 and Y0 below Y1");
    reduction.crop = Box{{v[0], v[1]}, {v[2], v[3]}};
  }
  reduction.cell = cell;
  reduction.corridor = corridor;
  if (fill) reduction.disc = Girth{*fill, *fill, 0};
  if (spec) reduction.disc = girth_of(*spec);
  const bool has_cells = workspace.cells || cell;
  if (fill || (has_cells && spec)) reduction.fill = reduction.disc;
  if (spec && !has_cells && !fits()) {
    workspace.warnings.emplace_back(
        "--for: closes nothing, since it works on cells and the map is a drawing: give "
        "--cell METRES with it");
  }
  return reduced(std::move(workspace), reduction);
}

CompiledScene ReductionOptions::compiled(const Workspace& workspace, const std::optional<RobotSpec>& spec,
                                         const CompileOptions& options, std::vector<std::string>& report) const {
  if (!spec || !fits()) return compile(workspace, options);
  Budget budget;
  budget.flash = budget_of("--flash", flash);
  budget.ram = budget_of("--ram", ram);
  budget.tolerance = options.tolerance;
  budget.coarse = options.coarse;
  Fitted fitted = fit(workspace, *spec, budget, options.progress);
  report = std::move(fitted.report);
  return std::move(fitted.scene);
}

}  // namespace krait::host
