// SPDX-License-Identifier: Apache-2.0
// dynobench's problems: a box-shaped world, box obstacles, and a robot's start and goal.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "host/import/shapes.hpp"
#include "host/import/yaml.hpp"

namespace krait::host {
namespace {

bool recognise(const Source& source) { return has_top_key(source.content, "environment"); }

Obstacle read_obstacle(const Field& field) {
  const Field type = field.at("type");
  if (type.text() != "box") type.fail("only obstacles of type box are known, this is a " + cleaned_name(type.text()));
  return {field.place(), read_box(field, {"angle", "rotation"}), {}};
}

struct Pose {
  Point position;
  double heading = 0;
  std::vector<double> angles;  // of trailers; empty: straight
};

// Those that follow the first three numbers of a state, the headings of a car's trailers; none where they are straight.
std::vector<double> read_trailers(const Field& state, double heading) {
  std::vector<double> angles;
  const std::size_t size = state.size(3, 3 + kMaxLinks);
  for (std::size_t i = 3; i < size; ++i) angles.push_back(state.item(i).number(-kMaxAngle, kMaxAngle, "radians"));
  const bool straight = std::all_of(angles.begin(), angles.end(), [&](double angle) { return angle == heading; });
  return straight ? std::vector<double>() : angles;
}

// Warns where the numbers behind the first three, which have no place in a start, are not zero.
void warn_of_others(const Field& state, std::vector<std::string>& warnings) {
  bool more = false;
  for (std::size_t i = 3; i < state.size(3); ++i) more = more || state.item(i).number(-1e9, 1e9) != 0;
  if (more) warnings.push_back(state.place() + ": only x, y and theta are used, its other numbers are not");
}

Pose read_pose(const Field& state, bool tows, std::vector<std::string>& warnings) {
  state.size(3);
  Pose pose;
  pose.position = {state.item(0).number(-kMaxFarCoordinate, kMaxFarCoordinate, "metres"),
                   state.item(1).number(-kMaxFarCoordinate, kMaxFarCoordinate, "metres")};
  pose.heading = state.item(2).number(-kMaxAngle, kMaxAngle, "radians");
  if (tows) {
    pose.angles = read_trailers(state, pose.heading);
  } else {
    warn_of_others(state, warnings);
  }
  return pose;
}

void read_robot(const Field& robots, Workspace& workspace) {
  if (robots.size() == 0) return;
  if (robots.size() > 1) workspace.warnings.push_back("robots: only the first one's start and goal are used");
  const Field robot = robots.item(0);
  const bool tows =
      robot.has("type") && robot.at("type").value().is_string() && robot.at("type").text().starts_with("car");
  const Pose start = read_pose(robot.at("start"), tows, workspace.warnings);
  workspace.starts.push_back({"start", start.position, start.heading, start.angles});
  const Pose goal = read_pose(robot.at("goal"), tows, workspace.warnings);
  if (!goal.angles.empty()) {
    workspace.warnings.push_back(robot.at("goal").place() + ": its trailers' headings are not used");
  }
  workspace.goals.push_back(pose_goal("goal", {goal.position, kStateGoalRadius, {goal.heading}}));
}

Workspace read(const Source& source, const ImportOptions&) {
  const Json document = parse_yaml(source.content, source.path);
  const Field field(document, source.path);
  const Field environment = field.at("environment");
  Workspace workspace;
  if (field.has("name")) workspace.name = field.at("name").name();
  workspace.min = environment.at("min").point(kMaxFarCoordinate);
  workspace.max = environment.at("max").point(kMaxFarCoordinate);
  if (!(workspace.min.x < workspace.max.x && workspace.min.y < workspace.max.y)) {
    environment.fail("max must be greater than min in x and in y");
  }
  if (environment.has("obstacles") && !environment.at("obstacles").value().is_null()) {
    const Field obstacles = environment.at("obstacles");
    for (std::size_t i = 0; i < obstacles.size(); ++i) workspace.obstacles.push_back(read_obstacle(obstacles.item(i)));
  }
  if (field.has("robots")) read_robot(field.at("robots"), workspace);
  for (std::string& warning : workspace.warnings) warning.insert(0, source.path + ": ");
  return workspace;
}

}  // namespace

const Format kDynobench = {"dynobench YAML", ".yaml", recognise, read};

}  // namespace krait::host
