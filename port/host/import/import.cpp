// SPDX-License-Identifier: Apache-2.0
#include "host/import/import.hpp"

#include <filesystem>

#include "host/import/format.hpp"
#include "host/import/mistaken.hpp"
#include "host/import/shift.hpp"
#include "host/input/file.hpp"
#include "host/input/json.hpp"
#include "host/workspace/heading.hpp"

namespace krait::host {
namespace {

const Format* const kFormats[] = {&kSceneFile, &kSvg,      &kGeoJson,   &kNative,
                                  &kTpcap,     &kMovingAi, &kMapServer, &kDynobench};

const Format* by_content(const Source& source) {
  for (const Format* format : kFormats) {
    if (format->recognise(source)) return format;
  }
  return nullptr;
}

const Format* by_name(const std::string& path) {
  for (const Format* format : kFormats) {
    if (path.ends_with(format->extension)) return format;
  }
  return nullptr;
}

[[noreturn]] void refuse(const Source& source) {
  throw InputError(source.path + ": is in no known format; known are " + kSceneFile.name + ", " + map_formats());
}

// An option that says nothing of the format, which its user hardly knows.
void refuse_useless(const Source& source, const Format& format, const ImportOptions& options) {
  const auto judge = [&](const char* option, bool given, bool used) {
    if (given && !used)
      throw InputError(source.path + ": " + option + " says nothing of " + format.name + ": leave it out");
  };
  judge("--unknown", options.unknown != Unknown::map, format.uses.unknown);
  judge("--unit", options.unit.has_value(), format.uses.unit);
  judge("--datum", options.datum.has_value(), format.uses.datum);
}

// Empty where the name says the format, or none. Two formats may have one extension.
std::string misnamed(const std::string& path, const Format& format) {
  const Format* named = by_name(path);
  if (named == nullptr || path.ends_with(format.extension)) return "";
  return path + ": is read as " + format.name + ", which it is, whatever its name says";
}

// A map's author may have meant degrees; a map of others may also just count its turns.
void warn_of_degrees(const std::string& file, Workspace& workspace) {
  const auto judge = [&](const std::string& place, double heading) {
    if (is_over_a_turn(heading))
      workspace.warnings.push_back(file + ": " + place + ": " + heading_over_a_turn(heading));
  };
  for (const Start& start : workspace.starts) judge("start \"" + start.name + "\"", start.heading);
  for (const Goal& goal : workspace.goals) {
    if (goal.pose) judge("goal \"" + goal.name + "\"", goal.pose->facing.heading);
  }
  if (workspace.cells) judge("the origin's yaw", workspace.cells->yaw);
}

// Some editors and spreadsheets begin a text with a byte order mark, which no format has a use for.
std::string without_mark(std::string content) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (content.starts_with(kMark)) content.erase(0, kMark.size());
  return content;
}

}  // namespace

std::string map_formats() {
  std::string names;
  for (const Format* format : kFormats) {
    if (format != &kSceneFile) names += (names.empty() ? "" : ", ") + std::string(format->name);
  }
  return names;
}

std::string misnamed_scene(const std::string& path) { return safe_to_print(misnamed(path, kSceneFile)); }

bool is_map(const Source& source) { return by_content(source) != nullptr; }

Workspace read_workspace(const Source& source, const ImportOptions& options) {
  if (const auto what = mistaken(source)) throw InputError(source.path + ": " + *what);
  const Format* format = by_content(source);
  if (format == nullptr) format = by_name(source.path);
  if (format == nullptr) refuse(source);
  refuse_useless(source, *format, options);
  Workspace workspace = format->read(source, options);
  if (const std::string warning = misnamed(source.path, *format); !warning.empty()) {
    workspace.warnings.push_back(warning);
  }
  warn_of_degrees(source.path, workspace);
  bring_near(source.path, workspace, !options.undoes_shift);
  workspace.files.push_back(source.path);
  for (std::string& warning : workspace.warnings) warning = safe_to_print(warning);
  return workspace;
}

Workspace import_workspace(const std::string& path, const ImportOptions& options) {
  Workspace workspace = read_workspace({path, without_mark(read_file(path, kMaxMapBytes))}, options);
  if (workspace.name.empty()) workspace.name = cleaned_name(std::filesystem::path(path).stem().string());
  return workspace;
}

}  // namespace krait::host
