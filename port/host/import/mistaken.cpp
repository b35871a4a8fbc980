// SPDX-License-Identifier: Apache-2.0
#include "host/import/mistaken.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "host/import/image.hpp"
#include "host/import/json_keys.hpp"
#include "host/import/yaml.hpp"

namespace krait::host {
namespace {

struct Kind {
  std::string_view mark;
  const char* advice;
};

constexpr const char* kCompressed = "is compressed: unpack it first";
constexpr const char* kPicture =
    "is a picture of a kind that is not read: convert it to PNG, and give a map_server YAML that names it";
constexpr const char* kWebPage = "is a web page, not a map: give the map that it shows";

constexpr Kind kFirstBytes[] = {{"\x1F\x8B", kCompressed},
                                {"PK\x03\x04", kCompressed},
                                {"BZh", kCompressed},
                                {"\xFD"
                                 "7zXZ",
                                 kCompressed},
                                {"GIF8", kPicture},
                                {"II*", kPicture},
                                {"RIFF", kPicture},
                                {"%PDF", "is a PDF: save its drawing as SVG"},
                                {"SQLite format 3", "is a database: export its polygons as GeoJSON"},
                                {"#VRML", "is a three-dimensional model: draw its plan as SVG"},
                                {"version 1",
                                 "is a list of MovingAI queries: give the .map that they "
                                 "belong to"}};

constexpr std::string_view kUrdf = "<robot";

// First elements of XML, in lower case.
constexpr Kind kElements[] = {{"<!doctype html", kWebPage},
                              {"<html", kWebPage},
                              {"<osm", "is OpenStreetMap's XML: convert it to GeoJSON"},
                              {"<kml", "is KML: convert it to GeoJSON"},
                              {"<gpx", "is a GPS track, not a map: a map has areas"},
                              {kUrdf, "is a robot's URDF, not a map"},
                              {"<world", "is a simulator's world, not a map: give the map_server YAML"}};

std::string head_of(const std::string& content) {
  std::string head = content.substr(0, 1024);
  std::transform(head.begin(), head.end(), head.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return head;
}

// Whether the head of XML has the element, and no drawing before it.
bool has_first(const std::string& head, std::string_view element) { return head.find(element) < head.find("<svg"); }

// As krait's pictures begin, which name their one group.
bool is_own_picture(const std::string& head, const std::string& content) {
  return head.find("role=\"img\"><title>") != std::string::npos &&
         content.find("<g id=\"figure\"") != std::string::npos;
}

std::string image_alone(const std::string& path) {
  return "is an image alone; give the map's YAML file, which names the image and its scale, or write one, a line each: "
         "image: " +
         std::filesystem::path(path).filename().string() +
         ", resolution: 0.05 (metres a pixel), origin: [0, 0, 0], negate: 0, occupied_thresh: 0.65, free_thresh: 0.196";
}

std::optional<std::string> mistaken_xml(const std::string& content) {
  const std::string head = head_of(content);
  if (is_own_picture(head, content)) return "is a picture that krait has drawn, not a map: give the map itself";
  for (const Kind& kind : kElements) {
    if (has_first(head, kind.mark)) return kind.advice;
  }
  return std::nullopt;
}

std::optional<std::string> mistaken_json(const std::string& content) {
  if (has_top_json_key(content, "bounds")) return std::nullopt;
  if (has_top_json_key(content, "model")) return "is a robot, not a map: give it to --robot";
  if (has_top_json_key(content, "controls")) return "is a plan, not a map: krait verify MAP PLAN judges it";
  if (has_top_json_key(content, "arcs")) return "is TopoJSON: convert it to GeoJSON";
  return std::nullopt;
}

}  // namespace

bool is_urdf(const std::string& content) { return has_first(head_of(content), kUrdf); }

bool is_dynobench_robot(const std::string& content) {
  return has_top_key(content, "dynamics") && !has_top_key(content, "environment");
}

std::optional<std::string> mistaken(const Source& source) {
  const std::string& content = source.content;
  if (is_image(content)) return image_alone(source.path);
  for (const Kind& kind : kFirstBytes) {
    if (content.starts_with(kind.mark)) return kind.advice;
  }
  if (is_json_object(content)) return mistaken_json(content);
  const std::size_t first = text_begin(content);
  if (first == std::string::npos) return std::nullopt;
  if (content[first] == '<') return mistaken_xml(content);
  if (is_dynobench_robot(content))
    return "is a robot of dynobench, not a map: give a problem, which has an environment, and the robot as a "
           "ROBOT.json";
  const bool is_dxf = content[first] == '0' && content.substr(first, 20).find("SECTION") != std::string::npos;
  if (is_dxf) return "is a DXF drawing: save it as SVG";
  return std::nullopt;
}

}  // namespace krait::host
