// SPDX-License-Identifier: Apache-2.0
// The options of krait plan, and the search that they ask for.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/cli/map_options.hpp"
#include "host/cli/options.hpp"
#include "host/input/outputs.hpp"
#include "host/run/run.hpp"

namespace krait::host {

struct PlanOptions {
  std::string compiler;  // the path of krait-compile
  std::string scene;     // or a map
  MapOptions map;
  std::string tolerance;
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

  void add(CLI::App& command);

  // Throws InputError for options that cannot be used or do not go together, and warns of one that has no effect.
  SearchRequest read() const;

  std::vector<std::string> of_maps() const;  // the names of those given that only a map heeds
  bool draws() const;                        // a picture, or the page
  std::vector<Output> outputs() const;
  std::vector<std::string> inputs() const;  // files that the command reads

 private:
  void add_ground();
  void add_search();
  void add_improvement();
  void add_tuning();
  void add_outputs();
  CLI::App* command_ = nullptr;
};

}  // namespace krait::host
