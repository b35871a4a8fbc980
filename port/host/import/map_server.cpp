// SPDX-License-Identifier: Apache-2.0
// ROS map_server's maps: a YAML file with scale, origin and thresholds, and an image. Readings of pixels are those of
// ROS 2's nav2_map_server; a pixel that is not opaque is unknown in every mode.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host/import/image.hpp"
#include "host/import/yaml.hpp"
#include "host/workspace/cell_frame.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

enum class Mode { trinary, scale, raw };
enum class Reading { free, occupied, unknown };

struct Rules {
  Mode mode = Mode::trinary;
  bool negate = false;
  double occupied = 0;  // occupied above
  double free = 0;      // free below
  Unknown unknown = Unknown::map;
};

struct Counts {
  std::size_t unknown = 0;
  std::size_t saver_grey_free = 0;  // free, yet of the grey that map_saver writes for unknown
  bool saver_grey_square = false;   // four cells of that grey form a square
};

bool recognise(const Source& source) {
  if (has_top_key(source.content, "environment")) return false;
  return has_top_key(source.content, "image") || has_top_key(source.content, "occupied_thresh") ||
         has_top_key(source.content, "resolution");
}

Mode read_mode(const Field& field) {
  if (!field.has("mode")) return Mode::trinary;
  const std::string mode = field.at("mode").text();
  if (mode == "trinary") return Mode::trinary;
  if (mode == "scale") return Mode::scale;
  if (mode == "raw") return Mode::raw;
  field.at("mode").fail("must be trinary, scale or raw, is \"" + cleaned_name(mode) + "\"");
}

bool read_negate(const Field& field) {
  if (!field.has("negate")) return false;
  const Field negate = field.at("negate");
  return negate.value().is_boolean() ? negate.value().get<bool>() : negate.integer(0, 1) == 1;
}

Rules read_rules(const Field& field, Unknown unknown) {
  Rules rules{read_mode(field), read_negate(field), field.at("occupied_thresh").number(0, 1),
              field.at("free_thresh").number(0, 1), unknown};
  if (rules.free > rules.occupied) field.at("free_thresh").fail("must not be over occupied_thresh");
  if (rules.mode == Mode::raw && rules.negate) {
    field.at("negate").fail("ROS 1 and ROS 2 read it differently with mode raw; set it to 0 and invert the image");
  }
  return rules;
}

double color(const Pixel& pixel) { return (pixel.red + pixel.green + pixel.blue) / (3 * 65535.0); }

// From 0 free to 1 occupied; below 0: no reading. In trinary mode map_server averages alpha with the colours.
double occupancy(const Pixel& pixel, bool has_alpha, const Rules& rules) {
  double shade = color(pixel);
  if (rules.mode == Mode::trinary && has_alpha) {
    shade = (pixel.red + pixel.green + pixel.blue + pixel.alpha) / (4 * 65535.0);
  }
  if (rules.mode != Mode::raw) return rules.negate ? shade : 1 - shade;
  const double percent = std::round(shade * 255);
  return percent <= 100 ? percent / 100 : -1;
}

Reading read_pixel(const Pixel& pixel, bool has_alpha, const Rules& rules) {
  const double occupied = occupancy(pixel, has_alpha, rules);
  if (pixel.alpha < 65535 || occupied < 0) return Reading::unknown;
  if (rules.occupied < occupied) return Reading::occupied;
  if (occupied < rules.free) return Reading::free;
  return Reading::unknown;
}

bool is_saver_grey(const Pixel& pixel) { return std::lround(color(pixel) * 255) == 205; }

std::uint8_t occupied_cell(const Pixel& pixel, bool has_alpha, const Rules& rules, Counts& counts) {
  switch (read_pixel(pixel, has_alpha, rules)) {
    case Reading::occupied:
      return 1;
    case Reading::unknown:
      counts.unknown += 1;
      return rules.unknown == Unknown::free ? 0 : 1;
    case Reading::free:
      if (!is_saver_grey(pixel)) return 0;
      counts.saver_grey_free += 1;
      return rules.unknown == Unknown::occupied ? 1 : 0;
  }
  return 1;
}

bool has_saver_grey_square(const Image& image) {
  const auto grey = [&](int x, int y) { return is_saver_grey(image.at(x, y)); };
  for (int row = 1; row < image.rows; ++row) {
    for (int i = 1; i < image.columns; ++i) {
      if (grey(i, row) && grey(i - 1, row) && grey(i, row - 1) && grey(i - 1, row - 1)) return true;
    }
  }
  return false;
}

// Whether so much that reads as free has map_saver's grey that it is hardly by chance. What a mapping robot has not
// seen are areas; a pen's soft edge has single pixels of every grey, which are as free as the file says.
bool looks_unknown(const Counts& counts, const CellMap& cells) {
  constexpr std::size_t kChance = 1000;  // one cell in so many
  return counts.saver_grey_free > 0 &&
         (counts.saver_grey_square || kChance * counts.saver_grey_free >= cells.occupied.size());
}

Counts fill(const Image& image, const Rules& rules, CellMap& cells) {
  Counts counts;
  cells.columns = image.columns;
  cells.rows = image.rows;
  cells.occupied.reserve(image.pixels.size());
  for (int row = image.rows - 1; row >= 0; --row) {
    for (int column = 0; column < image.columns; ++column) {
      cells.occupied.push_back(occupied_cell(image.at(column, row), image.has_alpha, rules, counts));
    }
  }
  counts.saver_grey_square = counts.saver_grey_free > 0 && has_saver_grey_square(image);
  return counts;
}

std::string share(std::size_t part, const CellMap& cells) {
  return printed("%.3g %%", 100.0 * static_cast<double>(part) / static_cast<double>(cells.occupied.size()));
}

void warn(const std::string& file, const Counts& counts, const Rules& rules, Workspace& workspace) {
  const CellMap& cells = *workspace.cells;
  if (counts.unknown > 0 && rules.unknown == Unknown::map) {
    workspace.warnings.push_back(file + ": " + share(counts.unknown, cells) +
                                 " of the cells are unknown and count as obstacles; --unknown free makes them free" +
                                 (rules.mode == Mode::raw ? "; mode raw knows pixels up to 100 only" : ""));
  }
  if (counts.unknown > 0 && rules.unknown == Unknown::free) {
    workspace.warnings.push_back(file + ": " + share(counts.unknown, cells) +
                                 " of the cells are unknown and count as free, as asked");
  }
  if (looks_unknown(counts, cells) && rules.unknown == Unknown::map) {
    workspace.warnings.push_back(file + ": " + share(counts.saver_grey_free, cells) +
                                 " of the cells are grey 205, map_saver's mark for unknown, which reads as free by "
                                 "this file's thresholds (free_thresh " +
                                 shown(rules.free) + "); --unknown occupied makes them obstacles");
  }
}

// The bounds are the rectangle that contains the placed map; what of it lies outside a turned map is an obstacle.
void set_bounds(const Field& field, Workspace& workspace) {
  const CellMap& cells = *workspace.cells;
  const CellFrame frame(cells);
  const double columns = cells.columns, rows = cells.rows;
  const Ring corners = {frame.world(0, 0), frame.world(columns, 0), frame.world(columns, rows), frame.world(0, rows)};
  workspace.min = workspace.max = corners[0];
  for (const Point& corner : corners) {
    if (std::abs(corner.x) > kMaxFarCoordinate || std::abs(corner.y) > kMaxFarCoordinate) {
      field.at("resolution")
          .fail("the map reaches further than " + shown(kMaxFarCoordinate) + " m from the world's origin");
    }
    workspace.min = {std::min(workspace.min.x, corner.x), std::min(workspace.min.y, corner.y)};
    workspace.max = {std::max(workspace.max.x, corner.x), std::max(workspace.max.y, corner.y)};
  }
  if (cells.yaw == 0) return;
  const Point low = {workspace.min.x - cells.resolution, workspace.min.y - cells.resolution};
  const Point high = {workspace.max.x + cells.resolution, workspace.max.y + cells.resolution};
  workspace.obstacles.push_back(
      {"the outside of the turned map", {low, {high.x, low.y}, high, {low.x, high.y}}, {corners}});
}

void read_placement(const Field& field, CellMap& cells) {
  cells.resolution = field.at("resolution").number(1e-4, 1e4, "metres a cell");
  const Field origin = field.at("origin");
  if (origin.size() != 3) origin.fail("must be [x, y, yaw]");
  cells.origin = {origin.item(0).number(-kMaxFarCoordinate, kMaxFarCoordinate, "metres"),
                  origin.item(1).number(-kMaxFarCoordinate, kMaxFarCoordinate, "metres")};
  cells.yaw = origin.item(2).number(-kMaxAngle, kMaxAngle, "radians");
}

// Where the image lies: its path is relative to the YAML file's folder.
std::string image_path(const Field& field, const std::string& file) {
  const std::string name = field.at("image").text();
  if (name.empty() || name.find('\0') != std::string::npos) field.at("image").fail("must be the path of an image");
  return (std::filesystem::path(file).parent_path() / name).string();
}

Image read_map_image(const Field& field, const std::string& path) {
  try {
    return read_image(path);
  } catch (const InputError& error) {
    field.at("image").fail(error.what());
  }
}

Workspace read(const Source& source, const ImportOptions& options) {
  const Json document = parse_yaml(source.content, source.path);
  const Field field(document, source.path);
  field.require({"image", "resolution", "origin", "occupied_thresh", "free_thresh"});
  const Rules rules = read_rules(field, options.unknown);
  Workspace workspace;
  workspace.cells.emplace();
  read_placement(field, *workspace.cells);
  workspace.files.push_back(image_path(field, source.path));
  const Image image = read_map_image(field, workspace.files.back());
  if (image.lossy) {
    workspace.warnings.push_back(workspace.files.back() +
                                 ": is a JPEG, whose compression blurs cells along walls; a PNG keeps them");
  }
  const Counts counts = fill(image, rules, *workspace.cells);
  set_bounds(field, workspace);
  warn(source.path, counts, rules, workspace);
  return workspace;
}

}  // namespace

const Format kMapServer = {"map_server YAML", ".yaml", recognise, read, {.unknown = true}};

}  // namespace krait::host
