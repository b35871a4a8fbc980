// SPDX-License-Identifier: Apache-2.0
/// \file
/// A checked, read-only view of a scene file, used in place (it may lie in flash). FORMAT.md (installed
/// in share/doc/krait/include/krait) describes the bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "krait/format.hpp"
#include "krait/geometry.hpp"
#include "krait/status.hpp"

namespace krait {

namespace detail {
class SceneChecker;
}

/// Integers of the file's index width, in place: it refers to the file's bytes. Every function is O(1).
class IndexArray {
 public:
  IndexArray() = default;  ///< of nothing

  /// Integer i of the file's array, or kNone. The array does not know its length, so i is not checked.
  Index operator[](std::size_t i) const {
    KRAIT_ASSERT(data_ != nullptr);
    if (wide_) return reinterpret_cast<const std::uint32_t*>(data_)[i];
    const Index index = reinterpret_cast<const std::uint16_t*>(data_)[i];
    return index == format::kNone16 ? kNone : index;
  }

 private:
  friend class Scene;
  // The integers from `data` on, each of 4 bytes if `wide`, else of 2, and aligned to that; they must stay.
  IndexArray(const std::byte* data, bool wide) : data_(data), wide_(wide) {}

  const std::byte* data_ = nullptr;
  bool wide_ = false;
};

/// A cell of a CellGrid.
struct Cell {
  std::int32_t column;  ///< 0 … CellGrid::columns - 1, in the direction of x
  std::int32_t row;     ///< 0 … CellGrid::rows - 1, in the direction of y
};

/// Square cells over the bounds. Every function is O(1).
struct CellGrid {
  Vec2 origin{};             ///< metres, local coordinates: the least corner of cell (0, 0)
  float per_metre = 1;       ///< cells in a metre
  std::int32_t columns = 0;  ///< cells in the direction of x
  std::int32_t rows = 0;     ///< cells in the direction of y

  /// The cell that contains p, clamped to the grid; any finite p.
  Cell cell(Vec2 p) const {
    return {clamped((p.x - origin.x) * per_metre, columns), clamped((p.y - origin.y) * per_metre, rows)};
  }
  /// The number of a cell of the grid, by rows.
  std::size_t index(Cell c) const {
    KRAIT_ASSERT(c.column >= 0 && c.column < columns && c.row >= 0 && c.row < rows);
    return static_cast<std::size_t>(c.row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c.column);
  }

 private:
  static std::int32_t clamped(float x, std::int32_t cells) {
    const float last = static_cast<float>(cells - 1);
    return static_cast<std::int32_t>(math::clamp(x, 0.0F, last));
  }
};

/// A lower bound of the distance to the nearest obstacle or bound, by place. It refers to the file's bytes. Every
/// function is O(1).
class ClearanceGrid {
 public:
  ClearanceGrid() = default;  ///< 0 everywhere

  /// At most the distance from p to the nearest obstacle or bound, metres; 0 where p lies near one or outside.
  float at(Vec2 p) const {
    const float column = (p.x - origin_.x) * per_metre_;
    const float row = (p.y - origin_.y) * per_metre_;
    const bool inside = column * (columns_ - column) > 0.0F && row * (rows_ - row) > 0.0F;
    if (!inside) return 0.0F;
    const auto cell = static_cast<std::uint32_t>(row) * stride_ + static_cast<std::uint32_t>(column);
    return unit_ * static_cast<float>(cells_[cell]);
  }

 private:
  friend class Scene;
  // A grid of the cells of a file with this header, from `origin` on, local metres; the bytes must stay.
  ClearanceGrid(Vec2 origin, const format::Header& header, const std::uint8_t* cells)
      : origin_(origin),
        per_metre_(1.0F / header.clearance_cell),
        unit_(header.clearance_unit),
        columns_(static_cast<float>(header.clearance_columns)),
        rows_(static_cast<float>(header.clearance_rows)),
        stride_(header.clearance_columns),
        cells_(cells) {}

  Vec2 origin_{};
  float per_metre_ = 1.0F;
  float unit_ = 0.0F;
  float columns_ = 0.0F;
  float rows_ = 0.0F;
  std::uint32_t stride_ = 0;
  const std::uint8_t* cells_ = nullptr;
};

/// A start of the scene, in its local coordinates, and the trailers' headings where it has them. Metres, radians.
struct ScenePose {
  Vec2 position;              ///< local metres, of the robot's position
  float heading;              ///< radians, of body 0
  const float* angles;        ///< radians: angle_count of them, in the file's bytes
  std::uint32_t angle_count;  ///< how many trailers' headings there are; 0: every trailer has the heading
};

/// A view of a scene file that was checked. It refers to the file's bytes, which must stay, unchanged, for as long as
/// it is used; copies are views of the same bytes. Every function is O(1) where nothing else is stated. Of a scene that
/// was not opened only bytes, fingerprint, inside_bounds and the counts may be called.
class Scene {
 public:
  static constexpr std::uint8_t kHeaderSection = 255;  ///< Failure::section for the header; the element is an offset

  /// Checks every byte that the core later relies on, then views them; the bytes must stay, unchanged, for as long
  /// as the scene is used. Reads only [bytes, bytes + size); writes to `scene` only, and only where it succeeds.
  /// `bytes` is aligned to 4; where it is not, or null, the failure is at the header's first byte. Returns bad_scene
  /// with section and element, or ok. O(size log l), l the longest list of a bucket.
  static Failure open(const void* bytes, std::size_t size, Scene& scene);

  std::uint32_t bytes() const { return header_.total_bytes; }  ///< length of the file; 0 of one that was not opened

  /// A checksum, taken now, of the header and of up to 256 words spread evenly over the rest of the file. A planner
  /// compares it at each start with that of init. It detects another file, whose header has another CRC, and any
  /// changed run longer than 1/256 of the file plus a word; single changed words elsewhere are detected by open only. 0
  /// for a scene that was not opened. Work: reads at most 310 words.
  std::uint32_t fingerprint() const;

  const format::Header& header() const { return header_; }  ///< a copy of the file's, which this view owns
  /// The workspace, local metres.
  Box bounds() const {
    return {{header_.bounds_min_x, header_.bounds_min_y}, {header_.bounds_max_x, header_.bounds_max_y}};
  }
  /// Whether p, local metres, lies in the bounds or on them; false for NaN.
  bool inside_bounds(Vec2 p) const {
    return p.x >= header_.bounds_min_x && p.x <= header_.bounds_max_x && p.y >= header_.bounds_min_y &&
           p.y <= header_.bounds_max_y;
  }

  // The decomposition. Edge i of a triangle goes from its vertex i to vertex (i + 1) % 3.
  Index triangle_count() const { return header_.triangles; }  ///< triangles, numbered from 0
  Index portal_count() const { return header_.portals; }      ///< edges between two triangles, numbered from 0
  /// Corner i, 0 … 2, of a triangle, counter-clockwise, local metres.
  Vec2 corner(Index triangle, int i) const { return vertices_[triangle_vertices_[edge_at(triangle, i)]]; }
  /// The middle of a triangle, local metres.
  Vec2 centroid(Index triangle) const {
    return (1.0F / 3.0F) * (corner(triangle, 0) + corner(triangle, 1) + corner(triangle, 2));
  }
  /// The triangle across edge 0 … 2, or kNone at obstacles and bounds.
  Index neighbor(Index triangle, int edge) const { return triangle_neighbors_[edge_at(triangle, edge)]; }
  /// The portal of edge 0 … 2, or kNone where there is no neighbour.
  Index portal(Index triangle, int edge) const { return triangle_portals_[edge_at(triangle, edge)]; }
  /// Metres, 0 … 8000: twice the largest clearance along the portal, rounded up.
  float portal_width(Index portal) const {
    KRAIT_ASSERT(portal < portal_count());
    return portal_widths_[portal];
  }
  /// The goal that a triangle lies in, or kNone.
  Index goal_of(Index triangle) const {
    KRAIT_ASSERT(triangle < triangle_count());
    const std::uint16_t goal = triangle_goals_[triangle];
    return goal == format::kNone16 ? kNone : goal;
  }

  Index goal_count() const { return header_.goals; }  ///< goals, numbered from 0
  const char* name() const { return names_; }         ///< of the scene: UTF-8 in the file's bytes, safe to print
  /// The name of a goal: UTF-8 in the file's bytes, safe to print. O(bytes of the names before it).
  const char* goal_name(Index goal) const {
    KRAIT_ASSERT(goal < goal_count());
    return nth_name(1 + goal);
  }
  /// A goal's polygon in the file's bytes, counter-clockwise, of 3 vertices or more; local metres.
  Polygon goal_polygon(Index goal) const {
    KRAIT_ASSERT(goal < goal_count());
    const std::uint32_t first = goal_offsets_[goal];
    return {goal_vertices_ + first, static_cast<int>(goal_offsets_[goal + 1] - first)};
  }
  /// The goal of that name, or kNone. O(bytes of the names).
  Index find_goal(const char* goal) const;

  Index start_count() const { return header_.starts; }  ///< starts, numbered from 0
  /// The name of a start: UTF-8 in the file's bytes, safe to print. O(bytes of the names before it).
  const char* start_name(Index start) const {
    KRAIT_ASSERT(start < start_count());
    return nth_name(1 + header_.goals + start);
  }
  /// A start of the scene, 0 … start_count() - 1, which is not checked. Its angles lie in the file's bytes and stay
  /// valid for as long as these.
  ScenePose start(Index start) const;

  // Obstacles.
  Index piece_count() const { return header_.pieces; }  ///< convex obstacle pieces, numbered from 0
  /// A piece in the file's bytes: 3 to 8 vertices, strictly convex, counter-clockwise, local metres.
  Polygon piece(Index piece) const {
    KRAIT_ASSERT(piece < piece_count());
    const std::uint32_t first = piece_offsets_[piece];
    return {piece_vertices_ + first, static_cast<int>(piece_offsets_[piece + 1] - first)};
  }
  /// The smallest box around a piece, local metres.
  Box piece_box(Index piece) const {
    KRAIT_ASSERT(piece < piece_count());
    return piece_boxes_[piece];
  }

  // Buckets: triangles and pieces by place. A bucket's list ends where that of the next one begins.
  const CellGrid& buckets() const { return buckets_; }  ///< a bucket's number is CellGrid::index
  /// Where the list of a bucket's triangles begins; `bucket` is at most the number of buckets.
  std::uint32_t bucket_triangles_begin(std::size_t bucket) const {
    KRAIT_ASSERT(bucket <= bucket_count());
    return bucket_triangle_offsets_[bucket];
  }
  /// Entry i of all buckets' lists of triangles: a triangle that meets the bucket, ascending in each.
  Index bucket_triangle(std::uint32_t i) const {
    KRAIT_ASSERT(i < header_.bucket_triangles);
    return bucket_triangles_[i];
  }
  /// Where the list of a bucket's pieces begins; `bucket` is at most the number of buckets.
  std::uint32_t bucket_pieces_begin(std::size_t bucket) const {
    KRAIT_ASSERT(bucket <= bucket_count());
    return bucket_piece_offsets_[bucket];
  }
  /// Entry i of all buckets' lists of pieces: a piece whose box meets the bucket, ascending in each.
  Index bucket_piece(std::uint32_t i) const {
    KRAIT_ASSERT(i < header_.bucket_pieces);
    return bucket_pieces_[i];
  }

  const ClearanceGrid& clearance() const { return clearance_grid_; }  ///< how far obstacles and bounds are, at least

 private:
  static std::size_t at(Index triangle, int i) { return std::size_t{triangle} * 3 + static_cast<std::size_t>(i); }
  std::size_t edge_at(Index triangle, int i) const {
    KRAIT_ASSERT(triangle < triangle_count() && i >= 0 && i < 3);
    return at(triangle, i);
  }
  std::size_t bucket_count() const { return std::size_t{header_.bucket_columns} * header_.bucket_rows; }
  // The header of a scene that was not opened, which contains no point.
  static format::Header unopened() {
    format::Header header{};
    header.bounds_min_x = 1.0F;
    header.bounds_max_x = -1.0F;
    return header;
  }
  const char* nth_name(Index n) const;
  void view(const std::byte* bytes);

  format::Header header_ = unopened();
  const std::uint32_t* words_ = nullptr;  // of the whole file
  const Vec2* vertices_ = nullptr;
  IndexArray triangle_vertices_;
  IndexArray triangle_neighbors_;
  IndexArray triangle_portals_;
  const std::uint16_t* triangle_goals_ = nullptr;
  const float* portal_widths_ = nullptr;
  const std::uint32_t* goal_offsets_ = nullptr;
  const Vec2* goal_vertices_ = nullptr;
  const format::StartRecord* starts_ = nullptr;
  const float* start_angles_ = nullptr;
  const std::uint32_t* piece_offsets_ = nullptr;
  const Vec2* piece_vertices_ = nullptr;
  const Box* piece_boxes_ = nullptr;
  const std::uint32_t* bucket_triangle_offsets_ = nullptr;
  IndexArray bucket_triangles_;
  const std::uint32_t* bucket_piece_offsets_ = nullptr;
  IndexArray bucket_pieces_;
  const std::uint8_t* clearance_ = nullptr;
  const char* names_ = nullptr;
  CellGrid buckets_;
  ClearanceGrid clearance_grid_;

  friend class detail::SceneChecker;
};

}  // namespace krait
