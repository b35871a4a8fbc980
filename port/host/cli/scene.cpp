// SPDX-License-Identifier: Apache-2.0
// krait scene: writes one of the shipped scenes as JSON.
#include <cstdio>
#include <memory>

#include "host/cli/commands.hpp"
#include "host/input/output_option.hpp"
#include "host/plan_file/plan_file.hpp"
#include "host/scenes/scenes.hpp"

namespace krait::host {

void add_scene(CLI::App& app) {
  struct Options {
    std::string name;
    double scale = 1;
    std::string output;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("scene", "write one of the shipped scenes as JSON");
  std::string about = "which:";
  for (const SceneName& scene : scene_names()) about += std::string("\n") + scene.name + ": " + scene.description;
  command->add_option("NAME", options->name, about)->required();
  command->add_option("--scale", options->scale, "size of the scene; passages, walls and goal keep theirs")
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "file to write")->check(output_name())->required();
  command->callback([options] { write_file(options->output, scene_json(options->name, options->scale)); });
}

}  // namespace krait::host
