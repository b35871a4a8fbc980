// SPDX-License-Identifier: Apache-2.0
#include "host/cli/ground.hpp"

#include <cstdint>
#include <utility>
#include <vector>

#include "host/cli/commands.hpp"
#include "host/cli/compiler_process.hpp"
#include "host/input/file.hpp"
#include "host/input/interrupt.hpp"
#include "host/input/outputs.hpp"

namespace krait::host {
namespace {

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

}  // namespace

Ground read_ground(const PlanOptions& options, SearchRequest& request, Progress& progress) {
  std::optional<LastWord> word(kStoppedEarly);
  progress.show("reading the file");
  const std::string content = read_file(options.scene, UINT32_MAX);
  if (is_scene_file(content)) {
    progress.end();
    options.query.read_pose({}, request);
    warn(misnamed_scene(options.scene));
    const std::vector<std::string> unread = options.of_maps();
    if (unread.empty()) return {SceneBytes::copy(content.data(), content.size()), std::nullopt};
    throw InputError(unread.front() + " is for maps, but " + options.scene +
                     " is compiled already: use it with krait compile, or plan in the map itself");
  }
  progress.show("reading the map");
  Workspace map = import_workspace(options.scene, options.map.read());
  progress.end();  // the compiler has its own, and its own last word
  word.reset();
  check_outputs(options.outputs(), map.files);  // also those that the map names
  options.query.read_pose(map, request);
  return {compiled(options, options.tolerance), std::move(map)};
}

void compile_exactly(Ground& ground, const PlanOptions& options, double growth) {
  ground.scene = compiled(options, "0", true);
  ground.grown = growth;
}

}  // namespace krait::host
