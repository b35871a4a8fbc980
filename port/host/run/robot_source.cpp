// SPDX-License-Identifier: Apache-2.0
#include "host/run/robot_source.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <vector>

#include "host/run/robots.hpp"
#include "host/workspace/text.hpp"

namespace krait::host {
namespace {

// What a model is in C++.
struct Class {
  const char* model;
  const char* name;
  const char* header;  // of include/krait/robots
};
#define KRAIT_CLASS(name, Class, file, trailers) {#name, #Class, #file},
constexpr Class kClasses[] = {KRAIT_MODELS(KRAIT_CLASS)};
#undef KRAIT_CLASS

const Class& class_of(const std::string& model) {
  return *std::find_if(std::begin(kClasses), std::end(kClasses), [&](const Class& c) { return model == c.model; });
}

// The shortest that a compiler reads as this very number.
std::string literal(float value) {
  char text[32];
  const auto length = static_cast<std::size_t>(std::to_chars(text, text + sizeof text, value).ptr - text);
  const std::string digits(text, length);
  return digits + (digits.find_first_of(".e") == std::string::npos ? ".0F" : "F");
}
std::string literal(int value) { return std::to_string(value); }

template <class P>
constexpr std::size_t described_bytes() {
  std::size_t bytes = 0;
  P::describe([&]<class Number>(const ParameterField<P, Number>&) { bytes += sizeof(Number); });
  return bytes;
}

template <class P>
std::string fields(const P& parameters) {
  static_assert(described_bytes<P>() == sizeof(P), "describe has left a field out");
  std::string text;
  P::describe([&]<class Number>(const ParameterField<P, Number>& field) {
    text += std::string("    .") + field.name + " = " + literal(parameters.*field.member) + ",\n";
  });
  return text;
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
  const Class& known = class_of(spec.model);
  const std::string space = identifier("robot_" + stem(path));
  std::string text = remarks(spec, name) + "#pragma once\n\n";
  text += std::string("#include \"krait/robots/") + known.header + ".hpp\"\n\n";
  text += "namespace " + space + " {\n\n";
  text += std::string("using Robot = krait::") + known.name + ";\n\n";
  text += "inline constexpr char kName[] = \"" + word(is_robot_file(name) ? stem(name) : name) + "\";\n\n";
  text += "inline constexpr Robot::Parameters kParameters{\n" +
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
