// SPDX-License-Identifier: Apache-2.0
// The replay page: its files in page/ with the picture's data put in. The numbers travel as little-endian arrays in
// Base64: lengths in millimetres, headings in units of pi / 32768 rad, costs as levels (colors.hpp).
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string_view>

#include "host/picture/colors.hpp"
#include "host/picture/figure.hpp"
#include "host/picture/page_files.hpp"
#include "host/picture/picture.hpp"
#include "host/picture/poses.hpp"

namespace krait::host {

namespace {

using nlohmann::json;

constexpr std::size_t kMostLevels = 750'000;  // of all frames: a megabyte in Base64
constexpr std::size_t kMostStates = 6'000;

std::string base64(const std::string& bytes) {
  static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t i) {
    return i < bytes.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) : 0U;
  };
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t group = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (const int shift : {18, 12, 6, 0}) text += kDigits[group >> shift & 63U];
  }
  for (std::size_t i = bytes.size(); i % 3 != 0; ++i) text[text.size() - 3 + i % 3] = '=';
  return text;
}

// An array of numbers of one width, in the page's byte order.
class Array {
 public:
  void u8(std::uint8_t value) { bytes_ += static_cast<char>(value); }
  void u16(std::uint16_t value) {
    u8(static_cast<std::uint8_t>(value & 0xFFU));
    u8(static_cast<std::uint8_t>(value >> 8));
  }
  void u32(std::uint32_t value) {
    u16(static_cast<std::uint16_t>(value & 0xFFFFU));
    u16(static_cast<std::uint16_t>(value >> 16));
  }
  void f32(float value) { u32(std::bit_cast<std::uint32_t>(value)); }
  void millimetres(double metres) {
    const double value = std::clamp(std::round(metres * 1000), -2e9, 2e9);
    u32(static_cast<std::uint32_t>(static_cast<std::int32_t>(value)));
  }
  void point(double x, double y) {
    millimetres(x);
    millimetres(y);
  }
  void heading(double radians) {
    const double turns = std::remainder(radians, 2 * std::numbers::pi) / std::numbers::pi;  // -1 .. 1
    u16(static_cast<std::uint16_t>(static_cast<std::int32_t>(std::lround(turns * 32768))));
  }
  std::string text() const { return base64(bytes_); }

 private:
  std::string bytes_;
};

json rings(const std::vector<Ring>& all) {
  Array sizes;
  Array points;
  for (const Ring& ring : all) {
    sizes.u32(static_cast<std::uint32_t>(ring.size()));
    for (const Point& corner : ring) points.point(corner.x, corner.y);
  }
  return {{"sizes", sizes.text()}, {"points", points.text()}};
}

std::string triangles(const Picture& picture) {
  Array points;
  for (const Triangle& triangle : picture.triangles) {
    for (const Point& corner : triangle.corners) points.point(corner.x, corner.y);
  }
  return points.text();
}

// All frames, or every n-th and the last, so that there are no more levels than kMostLevels; at least the first and the
// last.
std::vector<const CostFrame*> chosen_frames(const Picture& picture) {
  std::vector<const CostFrame*> chosen;
  if (picture.frames.empty()) return chosen;
  const std::size_t before_last = picture.frames.size() - 1;
  const std::size_t most = std::max<std::size_t>(2, kMostLevels / std::max<std::size_t>(1, picture.triangles.size()));
  const std::size_t stride = std::max<std::size_t>(1, (before_last + most - 2) / (most - 1));
  for (std::size_t i = 0; i < before_last; i += stride) chosen.push_back(&picture.frames[i]);
  chosen.push_back(&picture.frames.back());
  return chosen;
}

json frames(const Picture& picture) {
  Array levels;
  json iterations = json::array();
  const double top = picture.frames.empty() ? 0 : top_cost(picture.frames.front().costs);
  for (const CostFrame* frame : chosen_frames(picture)) {
    for (const float cost : frame->costs) levels.u8(cost_level(cost, top));
    iterations.push_back(frame->iteration);
  }
  return {{"iterations", iterations}, {"top", std::round(top * 1000) / 1000}, {"levels", levels.text()}};
}

json tree(const Picture& picture) {
  Array points;
  Array parents;
  Array iterations;
  for (const TreeVertex& vertex : picture.tree) {
    points.point(vertex.x, vertex.y);
    parents.u32(vertex.parent);
    iterations.u32(vertex.iteration);
  }
  return {{"points", points.text()}, {"parents", parents.text()}, {"iterations", iterations.text()}};
}

json motion(const PlanFile& plan) {
  const std::size_t stride = plan.states.size() / kMostStates + 1;
  Array times;
  Array states;
  Array points;
  Array headings;
  for (std::size_t i = 0; i < plan.states.size(); i += stride) {
    const bool last = i + stride >= plan.states.size();
    const std::size_t at = last ? plan.states.size() - 1 : i;
    times.f32(static_cast<float>(static_cast<double>(at) * plan.dt));
    for (const float value : plan.states[at]) states.f32(value);
    for (const Pose& pose : body_poses(plan.robot, plan.states[at])) {
      points.point(pose.x, pose.y);
      headings.heading(pose.heading);
    }
  }
  return {{"times", times.text()}, {"states", states.text()}, {"points", points.text()}, {"headings", headings.text()}};
}

// Where the bodies stand before a search that found no plan; empty where there is one.
json start(const Picture& picture) {
  Array points;
  Array headings;
  if (picture.plan.states.empty() && !picture.start.empty()) {
    for (const Pose& pose : body_poses(picture.plan.robot, picture.start)) {
      points.point(pose.x, pose.y);
      headings.heading(pose.heading);
    }
  }
  return {{"points", points.text()}, {"headings", headings.text()}};
}

std::string marks(const Picture& picture) {
  Array points;
  for (const Mark& mark : picture.marks) points.point(mark.at.x, mark.at.y);
  return points.text();
}

std::string ramp() {
  Array colors;
  for (int level = 0; level <= kInfiniteLevel; ++level) {
    const Color color = level_color(static_cast<std::uint8_t>(level));
    for (const std::uint8_t part : {color.red, color.green, color.blue}) colors.u8(part);
  }
  return colors.text();
}

json names(const PlanFile& plan) {
  json list = json::array();
  for (const std::string& name : plan.state_names) list.push_back(printable(name));
  return list;
}

// "<" and its like are written as escapes, so that no text can end the script element that holds the JSON.
std::string harmless(const json& data) {
  std::string text;
  for (const char c : data.dump(-1, ' ', true, json::error_handler_t::replace)) {
    if (c == '<') {
      text += "\\u003c";
    } else if (c == '>') {
      text += "\\u003e";
    } else if (c == '&') {
      text += "\\u0026";
    } else {
      text += c;
    }
  }
  return text;
}

std::string escaped(const std::string& text) {
  static const std::map<char, std::string> kEntities = {
      {'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
  std::string html;
  for (const char c : text) {
    const auto entity = kEntities.find(c);
    html += entity == kEntities.end() ? std::string(1, c) : entity->second;
  }
  return html;
}

// Replaces each {{name}} of the template once; what is put in is not searched again.
std::string filled(std::string_view form, const std::map<std::string_view, std::string_view>& parts) {
  std::string text;
  for (;;) {
    const std::size_t begin = form.find("{{");
    if (begin == std::string_view::npos) break;
    const std::size_t end = form.find("}}", begin);
    text.append(form.substr(0, begin)).append(parts.at(form.substr(begin + 2, end - begin - 2)));
    form.remove_prefix(end + 2);
  }
  return text.append(form);
}

}  // namespace

std::string draw_html(const Picture& picture) {
  check(picture);
  const PlanFile& plan = picture.plan;
  const std::string title = picture.title.empty() ? "krait" : printable(picture.title);
  std::string line;
  for (const std::string& fact : facts(picture)) line += (line.empty() ? "" : " · ") + fact;
  const json data = {{"bounds", {picture.min.x, picture.min.y, picture.max.x, picture.max.y}},
                     {"origin", {plan.origin.x, plan.origin.y}},
                     {"obstacles", rings(picture.obstacle_pieces)},
                     {"triangles", triangles(picture)},
                     {"frames", frames(picture)},
                     {"tree", tree(picture)},
                     {"goal", rings({plan.goal_polygon})},
                     {"arrows", rings(goal_arrows(plan))},
                     {"bodies", rings(plan.robot.bodies)},
                     {"front", rings({front_mark(plan.robot)})},
                     {"names", names(plan)},
                     {"motion", motion(plan)},
                     {"start", start(picture)},
                     {"marks", marks(picture)},
                     {"ramp", ramp()}};
  return filled(page::index_html, {{"title", escaped(title)},
                                   {"facts", escaped(line)},
                                   {"style", page::style_css},
                                   {"script", page::replay_js},
                                   {"data", harmless(data)}});
}

}  // namespace krait::host
