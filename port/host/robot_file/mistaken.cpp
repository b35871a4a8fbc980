// SPDX-License-Identifier: Apache-2.0
#include "host/robot_file/mistaken.hpp"

#include "host/import/format.hpp"
#include "host/import/image.hpp"
#include "host/import/json_keys.hpp"
#include "host/import/mistaken.hpp"

namespace krait::host {
namespace {

constexpr const char* kIsMap =
    "is a map, not a robot: give it as the MAP of krait plan MAP --robot ROBOT; krait robots lists robots";
constexpr const char* kIsImage =
    "is an image, not a robot: give the map's YAML file, which names it, as the MAP of krait plan MAP --robot ROBOT";
constexpr const char* kIsPlan =
    "is a plan, not a robot: the object that is its \"robot\" may be one in a file of its own";
constexpr const char* kIsUrdf =
    "is a robot's URDF, which is not read: write its lengths and limits into a ROBOT.json (port/host/README.md)";
constexpr const char* kIsDynobench =
    "is a robot of dynobench, which is not read: write its lengths and limits into a ROBOT.json (port/host/README.md)";

std::optional<std::string> mistaken_json(const std::string& content) {
  if (has_top_json_key(content, "model")) return std::nullopt;
  if (has_top_json_key(content, "bounds") || has_top_json_key(content, "features")) return kIsMap;
  if (has_top_json_key(content, "controls")) return kIsPlan;
  return std::nullopt;
}

}  // namespace

std::optional<std::string> mistaken_robot(const std::string& path, const std::string& content) {
  if (is_json_object(content)) return mistaken_json(content);
  if (is_image(content)) return kIsImage;
  if (is_map({path, content})) return kIsMap;
  if (is_urdf(content)) return kIsUrdf;
  if (is_dynobench_robot(content)) return kIsDynobench;
  return std::nullopt;
}

}  // namespace krait::host
