// SPDX-License-Identifier: GPL-3.0-or-later
// The options by which a map is made smaller.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/compiler/compiler.hpp"
#include "host/reduce/reduce.hpp"

namespace krait::host {

// As many numbers as there are bounds, with commas between, each from minus to plus its bound. Throws InputError that
// names the option and the form.
std::vector<double> numbers(const std::string& option, const std::string& text, const std::vector<double>& bounds,
                            const std::string& form);

struct ReductionOptions {
  std::string crop;
  std::optional<double> cell, fill, corridor;
  std::string robot, flash, ram;
  bool coarse = false;

  void add(CLI::App& app);
  bool fits() const { return !flash.empty() || !ram.empty(); }  // whether a scene is to fit a machine
  // The robot of --for, if there is one. Throws InputError.
  std::optional<RobotSpec> spec() const;
  // The workspace cropped, in its cells, filled and within its corridor, for that robot. Throws InputError.
  Workspace apply(Workspace workspace, const std::optional<RobotSpec>& spec) const;
  // The scene of what apply() returned; what fit() reports is put into `report`. Throws InputError.
  CompiledScene compiled(const Workspace& workspace, const std::optional<RobotSpec>& spec,
                         const CompileOptions& options, std::vector<std::string>& report) const;
};

}  // namespace krait::host
