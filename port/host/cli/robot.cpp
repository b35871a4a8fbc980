// SPDX-License-Identifier: Apache-2.0
// krait robot: a robot in numbers, as a picture and as C++. krait robots: the shipped ones.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "host/cli/commands.hpp"
#include "host/input/file.hpp"
#include "host/input/output_option.hpp"
#include "host/input/outputs.hpp"
#include "host/picture/robot_drawing.hpp"
#include "host/robot_file/shipped.hpp"
#include "host/run/robot_facts.hpp"
#include "host/run/robot_source.hpp"
#include "host/workspace/printed.hpp"
#include "host/workspace/ring.hpp"

namespace krait::host {
namespace {

constexpr double kDegrees = 57.29577951308232;  // a radian

struct RobotOptions {
  std::string robot;
  std::string svg;
  std::string png;
  std::string cpp;
};

std::string model_of(const RobotSpec& robot) {
  return robot.links > 0 ? robot.model + ":" + std::to_string(robot.links) : robot.model;
}

std::string source_of(const RobotSpec& robot, const std::string& what) {
  const auto found = robot.sources.find(what);
  return found == robot.sources.end() ? "" : "  " + safe_to_print(found->second);
}

void print_parameters(const RobotSpec& robot) {
  for (const std::string& name : own_parameters(robot)) {
    const std::string value = printed("%.7g %s", robot.parameters.at(name), unit_of(robot.model, name).c_str());
    const std::string source = source_of(robot, name);
    std::printf("  %-22s %-*s%s\n", name.c_str(), source.empty() ? 0 : 30, value.c_str(), source.c_str());
  }
}

// Bodies in a row that are alike share a line.
void print_bodies(const RobotSpec& robot) {
  for (std::size_t k = 0; k < robot.bodies.size();) {
    std::size_t next = k + 1;
    while (next < robot.bodies.size() && same_ring(robot.bodies[next], robot.bodies[k])) ++next;
    const Ring& ring = robot.bodies[k];
    const auto by_x = [](const Point& a, const Point& b) { return a.x < b.x; };
    const auto by_y = [](const Point& a, const Point& b) { return a.y < b.y; };
    const auto [back, front] = std::minmax_element(ring.begin(), ring.end(), by_x);
    const auto [right, left] = std::minmax_element(ring.begin(), ring.end(), by_y);
    const std::string name = next - k == 1 ? printed("body %zu", k) : printed("bodies %zu to %zu", k, next - 1);
    std::printf("  %-22s x %.4g to %.4g m, y %.4g to %.4g m, %zu corners\n", name.c_str(), back->x, front->x, right->y,
                left->y, ring.size());
    k = next;
  }
  const std::string source = source_of(robot, "bodies");
  if (!source.empty()) std::printf("  %s\n", source.c_str());
}

std::string turning_line(const RobotSpec& robot, const RobotFacts& facts) {
  if (facts.lock_radius <= 0) return printed("turns on the spot, within %.4g m of the axle's middle", facts.lock_outer);
  std::string line = printed("radius %.4g m at ", facts.lock_radius) +
                     (facts.least_speed > 0 ? "its least speed" : "full lock") +
                     printed("; the farthest point of body 0 goes round at %.4g m", facts.lock_outer);
  if (facts.folds_at_lock) line += robot.links > 1 ? ", but the trailers fold there" : ", but the trailer folds there";
  return line;
}

std::string swept_line(const RobotSpec& robot, const RobotFacts& facts) {
  const SteadyTurn& turn = facts.tightest;
  std::string line = printed("%.4g m wide in its tightest steady turn", turn.swept_width);
  if (facts.lock_radius > 0) {
    line += printed(", of radius %.4g m (from %.4g to %.4g m around its centre)", turn.radius, turn.inner, turn.outer);
  }
  if (robot.links > 0) line += printed("; hitch angles up to %.0f degrees", turn.hitch_angles.back() * kDegrees);
  return line;
}

std::string stopping_line(const RobotFacts& facts) {
  if (facts.least_speed > 0) return printed("never: it is no slower than %.4g m/s", facts.least_speed);
  if (facts.stops_at_once) return printed("from %.4g m/s at once: its speed is its control", facts.top_speed);
  return printed("from %.4g m/s within %.4g m and %.4g s", facts.top_speed, facts.stopping_distance,
                 facts.stopping_time);
}

std::string step_line(const RobotFacts& facts, double dt) {
  if (!(facts.longest_time_step >= 0.001)) return kNoTimeStep;
  if (facts.longest_time_step < dt) {
    return printed("%.3g s is too long: plan with --dt %.2g or less", dt,
                   std::floor(facts.longest_time_step * 1000) / 1000);
  }
  return printed("%.3g s; Runge-Kutta steps in it: %d in the tree, %d in a plan (fastest rate %.3g a second)", dt,
                 facts.tree_parts, facts.plan_parts, facts.fastest_rate);
}

// Empty where no plan can be driven in such steps.
std::string accuracy_line(const RobotFacts& facts) {
  if (!(facts.step_error > 0)) return "";
  return printed("%.2g mm off after a second at top speed and full lock", 1000 * facts.step_error);
}

// What surprises who has not read the convention, a line each.
std::vector<std::string> warnings_of(const RobotSpec& robot) {
  std::vector<std::string> lines;
  if (const std::string axle = axle_warning(robot); !axle.empty()) lines.push_back(axle);
  if (robot.links > 0 && robot.parameters.at("min_speed") < 0) {
    lines.emplace_back("in reverse no turn is steady: trailers fold unless they are steered");
  }
  return lines;
}

RobotPicture picture_of(const RobotOptions& options, const RobotSpec& robot, const RobotFacts& facts, double dt) {
  RobotPicture picture;
  picture.title = options.robot + (model_of(robot) == options.robot ? "" : " (" + model_of(robot) + ")");
  picture.robot = robot;
  picture.turn = {facts.tightest.radius, facts.tightest.inner, facts.tightest.outer, bodies_in(facts.tightest, robot)};
  if (!robot.about.empty()) picture.lines.push_back(robot.about);
  picture.lines.push_back("turning: " + turning_line(robot, facts));
  picture.lines.push_back("stopping: " + stopping_line(facts));
  picture.lines.push_back("time step: " + step_line(facts, dt));
  if (const std::string line = accuracy_line(facts); !line.empty()) picture.lines.push_back("accuracy: " + line);
  for (const std::string& warning : warnings_of(robot)) picture.lines.push_back("warning: " + warning);
  return picture;
}

void print_report(const RobotOptions& options, const RobotSpec& robot, const RobotFacts& facts, double dt) {
  std::printf("%-10s%s\n", "robot", safe_to_print(options.robot).c_str());
  if (!robot.about.empty()) std::printf("%-10s%s\n", "", safe_to_print(robot.about).c_str());
  std::printf("%-10s%s\n\nparameters\n", "model", model_of(robot).c_str());
  print_parameters(robot);
  std::printf("\nbodies, in the frame of their axle, x ahead\n");
  print_bodies(robot);
  std::printf("\n%-10s%s\n", "turning", turning_line(robot, facts).c_str());
  std::printf("%-10s%s\n", "sweeps", swept_line(robot, facts).c_str());
  std::printf("%-10s%s\n", "stops", stopping_line(facts).c_str());
  std::printf("%-10s%s\n", "time step", step_line(facts, dt).c_str());
  if (const std::string line = accuracy_line(facts); !line.empty()) {
    std::printf("%-10s%s\n", "accuracy", line.c_str());
  }
  for (const std::string& warning : warnings_of(robot)) std::printf("%-10s%s\n", "warning", warning.c_str());
}

void show_robot(const RobotOptions& options) {
  const std::vector<std::string> inputs =
      is_robot_file(options.robot) ? std::vector<std::string>{options.robot} : std::vector<std::string>{};
  check_outputs({{"--svg", options.svg}, {"--png", options.png}, {"--cpp", options.cpp}}, inputs);
  const RobotSpec robot = parse_robot(options.robot);
  const Parameters parameters;
  const auto dt = static_cast<double>(parameters.dt);
  const RobotFacts facts = facts_of(options.robot, robot, parameters);
  const RobotPicture picture = picture_of(options, robot, facts, dt);
  if (!options.svg.empty()) write_file(options.svg, draw_robot_svg(picture));
  if (!options.png.empty()) write_file(options.png, draw_robot_png(picture));
  if (!options.cpp.empty()) write_file(options.cpp, robot_source(robot, options.robot, options.cpp));
  print_report(options, robot, facts, dt);
}

void list_robots() {
  for (const ShippedRobot& shipped : shipped_robots()) {
    const RobotSpec robot = parse_robot(shipped.name);
    std::printf("%-20s%-12s%s\n", shipped.name.c_str(), model_of(robot).c_str(), robot.about.c_str());
  }
}

}  // namespace

void add_robot(CLI::App& app) {
  const auto options = std::make_shared<RobotOptions>();
  CLI::App* one = app.add_subcommand("robot", "report a robot's numbers and what follows from them, and draw it");
  one->add_option("ROBOT", options->robot, "as --robot of krait plan: snake:2, car, a shipped machine, a ROBOT.json, …")
      ->required();
  one->add_option("--svg", options->svg, "draw it to scale, with its sizes")->check(output_name());
  one->add_option("--png", options->png, "draw it to scale, with its sizes")->check(output_name());
  one->add_option("--cpp", options->cpp, "write it as a header in C++, for firmware (port/PORTING.md)")
      ->check(output_name());
  one->callback([options] { show_robot(*options); });
  CLI::App* all = app.add_subcommand("robots", "list the shipped robots: real machines with published numbers");
  all->callback([] { list_robots(); });
}

}  // namespace krait::host
