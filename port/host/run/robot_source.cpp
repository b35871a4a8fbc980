// SPDX-License-Identifier: Apache-2.0
#include "host/run/robot_source.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <vector>

#include "host/run/robots.hpp"
#include "host/workspace/text.hpp"

namespace krait::host {
namespace {

// What a robot's class is called, and where it stands.
struct Class {
  const char* name;
  const char* header;  // of include/krait/robots
  const char* parameters;
};
Class class_of(const Snake&) { return {"Snake", "snake", "ChainParameters"}; }
Class class_of(const Truck&) { return {"Truck", "truck", "ChainParameters"}; }
Class class_of(const Car&) { return {"Car", "car", "ChainParameters"}; }
Class class_of(const Unicycle&) { return {"Unicycle", "unicycle", "UnicycleParameters"}; }
Class class_of(const DifferentialDrive&) {
  return {"DifferentialDrive", "differential_drive", "DifferentialDriveParameters"};
}

// The shortest that a compiler reads as this very number.
std::string literal(float value) {
  char text[32];
  const auto length = static_cast<std::size_t>(std::to_chars(text, text + sizeof text, value).ptr - text);
  const std::string digits(text, length);
  return digits + (digits.find_first_of(".e") == std::string::npos ? ".0F" : "F");
}
std::string literal(int value) { return std::to_string(value); }

template <class Number>
std::string field(const char* name, Number value) {
  return std::string("    .") + name + " = " + literal(value) + ",\n";
}

// The bindings name every field, so that none can be added and forgotten here.
std::string fields(const ChainParameters& parameters) {
  const auto [trailers, body_length, body_width, body_offset, wheelbase, hitch_length, max_speed, min_speed,
              max_steering, max_acceleration, max_steering_rate, self_collision_gap, max_hitch_angle] = parameters;
  return field("trailers", trailers) + field("body_length", body_length) + field("body_width", body_width) +
         field("body_offset", body_offset) + field("wheelbase", wheelbase) + field("hitch_length", hitch_length) +
         field("max_speed", max_speed) + field("min_speed", min_speed) + field("max_steering", max_steering) +
         field("max_acceleration", max_acceleration) + field("max_steering_rate", max_steering_rate) +
         field("self_collision_gap", self_collision_gap) + field("max_hitch_angle", max_hitch_angle);
}

std::string fields(const UnicycleParameters& parameters) {
  const auto [body_length, body_width, max_speed, min_speed, max_turn_rate] = parameters;
  return field("body_length", body_length) + field("body_width", body_width) + field("max_speed", max_speed) +
         field("min_speed", min_speed) + field("max_turn_rate", max_turn_rate);
}

std::string fields(const DifferentialDriveParameters& parameters) {
  const auto [body_length, body_width, wheel_radius, track_width, max_wheel_speed, max_wheel_acceleration] = parameters;
  return field("body_length", body_length) + field("body_width", body_width) + field("wheel_radius", wheel_radius) +
         field("track_width", track_width) + field("max_wheel_speed", max_wheel_speed) +
         field("max_wheel_acceleration", max_wheel_acceleration);
}

std::string body_name(int k) { return "kBody" + std::to_string(k); }

bool same_polygon(Polygon a, Polygon b) {
  const auto same = [](Vec2 p, Vec2 q) { return p.x == q.x && p.y == q.y; };
  return std::equal(a.vertices, a.vertices + a.count, b.vertices, b.vertices + b.count, same);
}

// Bodies in a row that are alike share an array.
std::string bodies(const Robot& robot) {
  std::string arrays;
  std::string list;
  int first_alike = 0;
  for (int k = 0; k < robot.body_count(); ++k) {
    const Polygon body = robot.body(k);
    if (k == 0 || !same_polygon(body, robot.body(first_alike))) {
      first_alike = k;
      arrays += "inline constexpr krait::Vec2 " + body_name(k) + "[] = {\n";
      for (int i = 0; i < body.count; ++i) {
        arrays += "    {" + literal(body[i].x) + ", " + literal(body[i].y) + "},\n";
      }
      arrays += "};\n";
    }
    list += "    {" + body_name(first_alike) + ", " + std::to_string(body.count) + "},\n";
  }
  return arrays + "inline constexpr krait::Polygon kBodies[] = {\n" + list + "};\n";
}

bool is_plain(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

// The text with a single `_` for whatever stands between letters and digits.
std::string identifier(const std::string& text) {
  std::string name;
  for (const char c : text) {
    if (is_plain(c)) {
      name += c;
    } else if (name.empty() || name.back() != '_') {
      name += '_';
    }
  }
  return name;
}

// The text with `_` for all that a command line or a line of JSON would have to quote.
std::string word(std::string text) {
  for (char& c : text) {
    if (!is_plain(c) && c != '-' && c != '.' && c != ':') c = '_';
  }
  return text;
}

std::string stem(const std::string& path) { return std::filesystem::path(path).stem().string(); }

std::string remarks(const RobotSpec& spec, const std::string& name) {
  const std::string about = spec.about.empty() ? "" : ": " + safe_to_print(spec.about);
  return "// The robot " + safe_to_print(name) + about + ", as krait plan has it.\n" +
         "// Written by krait robot --cpp: change the robot and write it again.\n";
}

}  // namespace

std::string robot_source(const RobotSpec& spec, const std::string& name, const std::string& path) {
  const CoreRobot core(spec);
  const Class known = core.visit([](const auto& robot) { return class_of(robot); });
  const std::string space = identifier("robot_" + stem(path));
  std::string text = remarks(spec, name) + "#pragma once\n\n";
  text += std::string("#include \"krait/robots/") + known.header + ".hpp\"\n\n";
  text += "namespace " + space + " {\n\n";
  text += std::string("using Robot = krait::") + known.name + ";\n\n";
  text += "inline constexpr char kName[] = \"" + word(is_robot_file(name) ? stem(name) : name) + "\";\n\n";
  text += std::string("inline constexpr krait::") + known.parameters + " kParameters{\n" +
          core.visit([](const auto& robot) { return fields(robot.parameters()); }) + "};\n\n";
  text += "// Metres, in the frame of each body's axle, x ahead.\n" + bodies(core.view()) + "\n";
  text +=
      "// A planner refers to its robot, which has up to 2 KB: make it static.\n"
      "inline Robot make() {\n"
      "  Robot robot(kParameters);\n"
      "  int k = 0;\n"
      "  for (const krait::Polygon& body : kBodies) robot.set_body(k++, body);\n"
      "  return robot;\n"
      "}\n\n";
  return text + "}  // namespace " + space + "\n";
}

}  // namespace krait::host
