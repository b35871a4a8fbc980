// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/write.hpp"

#include <algorithm>
#include <bit>
#include <boost/crc.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

#include "host/compiler/grids.hpp"
#include "krait/format.hpp"

namespace krait::host::compiler {
namespace {

static_assert(std::endian::native == std::endian::little, "records are copied as they lie in memory");

using Bytes = std::vector<std::uint8_t>;

constexpr float kMetre = 1.0F / format::kGrid;  // grid steps
constexpr double kClearanceCell = 0.25 * double(kMetre);
constexpr double kLeastClearanceCells = 64;  // across a small scene

float metres(std::int32_t steps) { return static_cast<float>(steps) * format::kGrid; }

float rounded_up(double value) {
  const auto nearest = static_cast<float>(value);
  return double(nearest) >= value ? nearest : std::nextafter(nearest, std::numeric_limits<float>::infinity());
}

template <class Record>
void append(Bytes& bytes, const Record& record) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(&record);
  bytes.insert(bytes.end(), first, first + sizeof record);
}

void append_point(Bytes& bytes, GridPoint p) {
  append(bytes, metres(p.x));
  append(bytes, metres(p.y));
}

std::uint32_t count(std::size_t n) {
  if (n >= kNone) throw InputError("the scene is too large for its format: simplify the drawing or raise --tolerance");
  return static_cast<std::uint32_t>(n);
}

class Writer {
 public:
  Writer(const Workspace& workspace, const SceneParts& parts) : workspace_(workspace), parts_(parts) {}

  Bytes run() {
    number_portals();
    choose_grids();
    write_mesh();
    write_goals();
    write_starts();
    write_pieces();
    write_names();
    // Last: they need the index width that all counts have decided.
    write_indices();
    return join();
  }

 private:
  Bytes& section(format::Section s) { return sections_[static_cast<std::size_t>(s)]; }

  void number_portals() {
    const auto& triangles = parts_.mesh.triangles;
    portals_.resize(3 * triangles.size(), kNone);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t other = triangles[t].neighbors[i];
        if (other == kNone || other < t) continue;
        const auto& across = triangles[other].neighbors;
        // Two triangles share one edge at most.
        const auto back = static_cast<std::uint32_t>(std::find(across, across + 3, t) - across);
        portals_[3 * t + i] = portals_[3 * other + back] = header_.portals++;
        const GridPoint a = corner(t, i), b = corner(t, (i + 1) % 3);
        // Two grid steps: the mesh may bend from the pieces' boundary by less than one.
        append(section(format::Section::portal_widths), rounded_up((distances_.width(a, b) + 4) / double(kMetre)));
      }
    }
  }

  GridPoint corner(std::uint32_t triangle, std::uint32_t i) const {
    return parts_.mesh.vertices[parts_.mesh.triangles[triangle].corners[i]];
  }

  void choose_grids() {
    const GridBox& b = parts_.frame.bounds;
    const double area = (double(b.max.x) - b.min.x) * (double(b.max.y) - b.min.y);
    const double cells = std::clamp(double(parts_.mesh.triangles.size()), 1.0, double(kMostCells));
    buckets_ = grid_shape(b, std::sqrt(area / cells), 1);
    const double extent = double(std::max(b.max.x - b.min.x, b.max.y - b.min.y));
    const double cell = std::min(kClearanceCell, extent / kLeastClearanceCells);
    clearance_ = grid_shape(b, std::max(cell, std::sqrt(area / double(kMostCells))), format::kClearanceUnits);
    header_.bucket_size = metres(buckets_.size);
    header_.bucket_columns = count(static_cast<std::size_t>(buckets_.columns));
    header_.bucket_rows = count(static_cast<std::size_t>(buckets_.rows));
    header_.clearance_cell = metres(clearance_.size);
    header_.clearance_columns = count(static_cast<std::size_t>(clearance_.columns));
    header_.clearance_rows = count(static_cast<std::size_t>(clearance_.rows));
    header_.clearance_unit = metres(clearance_.size / format::kClearanceUnits);
    section(format::Section::clearance) =
        clearances(clearance_, double(clearance_.size) / format::kClearanceUnits, distances_, parts_.pieces);
  }

  void write_mesh() {
    header_.vertices = count(parts_.mesh.vertices.size());
    header_.triangles = count(parts_.mesh.triangles.size());
    for (const GridPoint p : parts_.mesh.vertices) append_point(section(format::Section::vertices), p);
    for (const FreeTriangle& t : parts_.mesh.triangles) {
      append(section(format::Section::triangle_goals),
             t.goal == kNone ? format::kNone16 : static_cast<std::uint16_t>(t.goal));
    }
  }

  void write_goals() {
    header_.goals = count(parts_.goals.size());
    append(section(format::Section::goal_offsets), header_.goal_vertices);
    for (const PlacedGoal& goal : parts_.goals) {
      for (const GridPoint p : goal.polygon) append_point(section(format::Section::goal_vertices), p);
      header_.goal_vertices += count(goal.polygon.size());
      append(section(format::Section::goal_offsets), header_.goal_vertices);
    }
  }

  void write_starts() {
    header_.starts = count(workspace_.starts.size());
    for (const Start& start : workspace_.starts) {
      const Point& origin = parts_.frame.origin;
      append(section(format::Section::starts),
             format::StartRecord{static_cast<float>(start.position.x - origin.x),
                                 static_cast<float>(start.position.y - origin.y), static_cast<float>(start.heading),
                                 header_.start_angles, count(start.angles.size())});
      for (const double angle : start.angles) append(section(format::Section::start_angles), static_cast<float>(angle));
      header_.start_angles += count(start.angles.size());
    }
  }

  void write_pieces() {
    header_.pieces = count(parts_.pieces.size());
    append(section(format::Section::piece_offsets), header_.piece_vertices);
    for (const GridRing& piece : parts_.pieces) {
      GridBox box{piece.front(), piece.front()};
      for (const GridPoint p : piece) {
        append_point(section(format::Section::piece_vertices), p);
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
      }
      append_point(section(format::Section::piece_boxes), box.min);
      append_point(section(format::Section::piece_boxes), box.max);
      boxes_.push_back(box);
      header_.piece_vertices += count(piece.size());
      append(section(format::Section::piece_offsets), header_.piece_vertices);
    }
  }

  void write_names() {
    Bytes& names = section(format::Section::names);
    const auto add = [&](const std::string& name) {
      std::copy_if(name.begin(), name.end(), std::back_inserter(names), [](char c) { return c != '\0'; });
      names.push_back(0);
    };
    add(workspace_.name);
    for (const Goal& goal : workspace_.goals) add(goal.name);
    for (const Start& start : workspace_.starts) add(start.name);
    header_.names_bytes = count(names.size());
  }

  void write_indices() {
    const std::uint32_t most = std::max({header_.vertices, header_.triangles, header_.portals, header_.pieces});
    header_.index_width = most < format::kNone16 ? 2 : 4;
    for (std::uint32_t t = 0; t < parts_.mesh.triangles.size(); ++t) {
      const FreeTriangle& triangle = parts_.mesh.triangles[t];
      for (std::uint32_t i = 0; i < 3; ++i) {
        append_index(format::Section::triangle_vertices, triangle.corners[i]);
        append_index(format::Section::triangle_neighbors, triangle.neighbors[i]);
        append_index(format::Section::triangle_portals, portals_[3 * t + i]);
      }
    }
    std::vector<GridRing> rings;
    for (const FreeTriangle& t : parts_.mesh.triangles) {
      rings.push_back(
          {parts_.mesh.vertices[t.corners[0]], parts_.mesh.vertices[t.corners[1]], parts_.mesh.vertices[t.corners[2]]});
    }
    using enum format::Section;
    write_lists(compiler::bucket_triangles(buckets_, rings), bucket_triangle_offsets, format::Section::bucket_triangles,
                header_.bucket_triangles, header_.most_bucket_triangles);
    write_lists(compiler::bucket_pieces(buckets_, boxes_), bucket_piece_offsets, format::Section::bucket_pieces,
                header_.bucket_pieces, header_.most_bucket_pieces);
  }

  void append_index(format::Section s, std::uint32_t value) {
    if (header_.index_width == 2) {
      append(section(s), static_cast<std::uint16_t>(value));  // kNone becomes kNone16
    } else {
      append(section(s), value);
    }
  }

  void write_lists(const CellLists& lists, format::Section offsets, format::Section items, std::uint32_t& total,
                   std::uint32_t& most) {
    append(section(offsets), total);
    for (std::size_t cell = 0; cell < lists.cells(); ++cell) {
      for (const std::uint32_t item : lists.at(cell)) append_index(items, item);
      const std::uint32_t size = count(lists.at(cell).size());
      total += size;
      most = std::max(most, size);
      append(section(offsets), total);
    }
    count(lists.size());
  }

  Bytes join() {
    std::copy(std::begin(format::kMagic), std::end(format::kMagic), header_.magic);
    header_.version = format::kVersion;
    header_.origin_x = parts_.frame.origin.x;
    header_.origin_y = parts_.frame.origin.y;
    const GridBox& b = parts_.frame.bounds;
    header_.bounds_min_x = metres(b.min.x);
    header_.bounds_min_y = metres(b.min.y);
    header_.bounds_max_x = metres(b.max.x);
    header_.bounds_max_y = metres(b.max.y);
    header_.obstacle_error = rounded_up(parts_.obstacle_error);
    header_.tolerance = rounded_up(parts_.growth);

    Bytes file(sizeof header_);
    for (std::size_t s = 0; s < format::kSectionCount; ++s) {
      file.resize((file.size() + 3) / 4 * 4);
      header_.section_offsets[s] = count(file.size());
      file.insert(file.end(), sections_[s].begin(), sections_[s].end());
    }
    file.resize((file.size() + 3) / 4 * 4);
    header_.total_bytes = count(file.size());
    std::memcpy(file.data(), &header_, sizeof header_);
    boost::crc_32_type crc;
    constexpr std::size_t kFirst = offsetof(format::Header, origin_x);
    crc.process_bytes(file.data() + kFirst, file.size() - kFirst);
    header_.crc32 = crc.checksum();
    std::memcpy(file.data(), &header_, sizeof header_);
    return file;
  }

  const Workspace& workspace_;
  const SceneParts& parts_;
  Distances distances_{parts_.free_boundary};
  format::Header header_{};
  Bytes sections_[format::kSectionCount];
  std::vector<std::uint32_t> portals_;  // three a triangle
  std::vector<GridBox> boxes_;          // of the pieces
  GridShape buckets_;
  GridShape clearance_;
};

}  // namespace

Bytes write_scene(const Workspace& workspace, const SceneParts& parts) { return Writer(workspace, parts).run(); }

}  // namespace krait::host::compiler
