// SPDX-License-Identifier: Apache-2.0
#include "host/import/import.hpp"

#include <array>
#include <filesystem>

#include "host/import/format.hpp"
#include "host/import/image.hpp"
#include "host/import/shift.hpp"
#include "host/input/file.hpp"
#include "host/input/json.hpp"

namespace krait::host {
namespace {

constexpr std::uint64_t kMaxFileBytes = 64U << 20;

const std::array<const Format*, 8> kFormats = {&kSceneFile, &kSvg,      &kTpcap,     &kGeoJson,
                                               &kNative,    &kMovingAi, &kMapServer, &kDynobench};

[[noreturn]] void refuse(const Source& source) {
  if (is_image(source.content)) {
    throw InputError(source.path +
                     ": is an image alone; give the map's YAML file, which names the image and its scale");
  }
  std::string names;
  for (const Format* format : kFormats) names += (names.empty() ? "" : ", ") + std::string(format->name);
  throw InputError(source.path + ": is in no known format; known are " + names);
}

}  // namespace

Workspace read_workspace(const Source& source, const ImportOptions& options) {
  for (const Format* format : kFormats) {
    if (!format->recognise(source)) continue;
    Workspace workspace = format->read(source, options);
    bring_near(source.path, workspace);
    workspace.files.push_back(source.path);
    for (std::string& warning : workspace.warnings) warning = safe_to_print(warning);
    return workspace;
  }
  refuse(source);
}

Workspace import_workspace(const std::string& path, const ImportOptions& options) {
  Workspace workspace = read_workspace({path, read_file(path, kMaxFileBytes)}, options);
  if (workspace.name.empty()) workspace.name = cleaned_name(std::filesystem::path(path).stem().string());
  return workspace;
}

}  // namespace krait::host
