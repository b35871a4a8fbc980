// SPDX-License-Identifier: Apache-2.0
#include "host/input/outputs.hpp"

#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <filesystem>
#include <optional>

#include "host/input/file.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {
namespace {

// What a path leads to: a file, or a name in a folder where there is no file yet.
struct Place {
  dev_t device = 0;
  ino_t inode = 0;
  std::string name;

  bool operator==(const Place&) const = default;
};

bool is_null_device(const struct stat& status) { return S_ISCHR(status.st_mode) && status.st_rdev == makedev(1, 3); }

// Nothing where nothing can be overwritten: in /dev/null, and where there is no folder.
std::optional<Place> place_of(const std::string& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) == 0) {
    if (is_null_device(status)) return std::nullopt;
    return Place{status.st_dev, status.st_ino, {}};
  }
  std::error_code nowhere;  // then the folder is "", which there is not
  const std::filesystem::path whole = std::filesystem::absolute(led_to(path), nowhere);
  if (::stat(whole.parent_path().c_str(), &status) != 0) return std::nullopt;
  return Place{status.st_dev, status.st_ino, whole.filename().string()};
}

bool lead_to_one_file(const std::string& one, const std::string& other) {
  const std::optional<Place> place = place_of(one);
  return place && place == place_of(other);
}

}  // namespace

void check_outputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const Output& output = outputs[i];
    if (output.path.empty()) continue;
    const std::string what = output.option + " " + output.path;
    check_writable(output.path);
    for (const std::string& input : inputs) {
      if (!lead_to_one_file(output.path, input)) continue;
      throw InputError(what + ": would overwrite the input " + input + ": choose another file");
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (outputs[k].path.empty() || !lead_to_one_file(output.path, outputs[k].path)) continue;
      throw InputError(what + ": would overwrite the output " + outputs[k].option + " " + outputs[k].path +
                       ": choose another file");
    }
  }
}

}  // namespace krait::host
