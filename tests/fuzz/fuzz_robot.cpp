// SPDX-License-Identifier: Apache-2.0
// ROBOT.json: one line or a robot that is read back as itself.
#include <nlohmann/json.hpp>
#include <string>

#include "harness.hpp"
#include "host/robot_file/robot_file.hpp"

namespace {

krait::fuzz::Outcomes robots("a robot");

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace krait::host;
  try {
    const Json document = parse_json(std::string(reinterpret_cast<const char*>(data), size), "robot");
    const RobotSpec robot = read_robot(Field(document, "robot"));
    krait::fuzz::require(robot.bodies.size() == static_cast<std::size_t>(robot.links) + 1, "bodies and links disagree");
    const Json written = to_json(robot);
    krait::fuzz::require(to_json(read_robot(Field(written, "robot"))) == written, "a robot is read back as another");
    robots.accepted.reach();
  } catch (const InputError& error) {
    robots.refused.reach();
    krait::fuzz::require(std::string(error.what()).find('\n') == std::string::npos, "an error of more than one line");
  }
  return 0;
}
