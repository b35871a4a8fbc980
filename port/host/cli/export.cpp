// SPDX-License-Identifier: Apache-2.0
// krait export: writes a map in formats that other programs read.
#include "host/export/export.hpp"

#include <cstdio>
#include <memory>
#include <optional>

#include "host/cli/commands.hpp"
#include "host/cli/map_options.hpp"
#include "host/import/shapes.hpp"
#include "host/input/file.hpp"
#include "host/input/interrupt.hpp"
#include "host/input/output_option.hpp"
#include "host/input/outputs.hpp"
#include "host/input/progress.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

struct ExportOptions {
  std::string map;
  MapOptions options;
  std::string json;
  std::string geojson;
  std::string svg;
};

// A line in a drawing stands for one radius and the usual tolerances.
void warn_of_lines(const Workspace& workspace) {
  const GoalFacing usual;
  for (const Goal& goal : workspace.goals) {
    if (!goal.pose) continue;
    const GoalFacing& facing = goal.pose->facing;
    const bool usual_tolerances = facing.tolerance == usual.tolerance && !facing.either_way && !facing.hitches;
    if (goal.pose->radius == kStateGoalRadius && usual_tolerances) continue;
    warn("goal '" + goal.name +
         printed(
             "' becomes a line of the drawing, which is read as %.4g m and %.4g rad around it, not as the map has it",
             kStateGoalRadius, usual.tolerance));
  }
}

Workspace read(const ExportOptions& o, const std::vector<Output>& outputs, Progress& progress) {
  ImportOptions options = o.options.read();
  options.undoes_shift = true;
  progress.show("reading the map");
  Workspace workspace = import_workspace(o.map, options);
  progress.end();
  check_outputs(outputs, workspace.files);
  for (const std::string& warning : workspace.warnings) warn(warning);
  return workspace;
}

std::vector<FileText> converted(const ExportOptions& o, const Workspace& workspace, Progress& progress) {
  std::vector<FileText> files;
  const auto add = [&](const std::string& path, const char* format, auto convert) {
    if (path.empty()) return;
    progress.show(std::string("making ") + format);
    files.push_back({path, convert(workspace)});
  };
  add(o.json, "JSON", native_json);
  add(o.geojson, "GeoJSON", geojson);
  add(o.svg, "SVG", svg);
  return files;
}

void write(const ExportOptions& o) {
  const std::vector<Output> outputs = {{"--json", o.json}, {"--geojson", o.geojson}, {"--svg", o.svg}};
  if (o.json.empty() && o.geojson.empty() && o.svg.empty()) {
    throw InputError("export: nothing to write: give --geojson, --svg or --json with a file");
  }
  check_outputs(outputs, {o.map});
  std::optional<LastWord> word("krait: stopped by you while the map was converted: nothing is written\n");
  Progress progress("krait");
  const Workspace workspace = read(o, outputs, progress);
  if (!o.svg.empty()) warn_of_lines(workspace);
  const std::vector<FileText> files = converted(o, workspace, progress);
  word.reset();
  write_files(files);
}

}  // namespace

void add_export(CLI::App& app) {
  const auto o = std::make_shared<ExportOptions>();
  CLI::App* command = app.add_subcommand("export", "write a map as GeoJSON, SVG or JSON, which krait reads back");
  command->add_option("MAP", o->map, "a map or drawing as for krait compile, or a .krait file")->required();
  o->options.add(*command);
  command->add_option("--geojson", o->geojson, "write GeoJSON in metres")->check(output_name());
  command->add_option("--svg", o->svg, "write a drawing, a metre of which is 1000 mm")->check(output_name());
  command->add_option("--json", o->json, "write krait's own JSON")->check(output_name());
  command->footer("Occupied cells become rectangles. Coordinates are the map's own, also where it lies far from 0.");
  command->callback([o] { write(*o); });
}

}  // namespace krait::host
