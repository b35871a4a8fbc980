// SPDX-License-Identifier: Apache-2.0
/// \file
/// The bytes of a scene file: header and sections. FORMAT.md (installed in share/doc/krait/include/krait) says what
/// they mean; the scene compiler writes these records and Scene::open checks them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "krait/geometry.hpp"
#include "krait/version.h"

/// The records of a scene file and their limits.
namespace krait::format {

inline constexpr std::uint8_t kMagic[4] = {'K', 'R', 'S', 'C'};  ///< the first bytes of every scene file
inline constexpr std::uint16_t kVersion = KRAIT_SCENE_VERSION;   ///< the only one that is read

// Coordinates are multiples of this grid (a quarter of a millimetre), and at most kMaxCoordinate from the local origin,
// so that grid coordinates fit 23 bits and every float is exact.
inline constexpr int kGridBits = 12;  ///< a grid step is 2^-kGridBits metres
/// Metres: a grid step, of which every coordinate is a multiple.
inline constexpr float kGrid = 1.0F / static_cast<float>(1 << kGridBits);
inline constexpr float kMaxCoordinate = 2000.0F;  ///< metres, from the local origin, in x and in y

// An absent neighbour, portal or goal: all bits set in the section's index width.
inline constexpr std::uint16_t kNone16 = 0xFFFF;      ///< none, where Header::index_width is 2, and of triangle_goals
inline constexpr std::uint32_t kNone32 = 0xFFFFFFFF;  ///< none, where Header::index_width is 4

inline constexpr int kMinPieceVertices = kMinVertices;  ///< the least of an obstacle piece
inline constexpr int kMaxPieceVertices = kMaxVertices;  ///< the most of an obstacle piece
inline constexpr std::uint8_t kMaxClearance = 255;      ///< the largest byte of a clearance cell
inline constexpr int kClearanceUnits = 8;  ///< the side of a clearance cell, in units of Header::clearance_unit
/// Grid steps by which each cell is widened on every side, since a reader finds a point's cell in floats, which round.
inline constexpr int kCellMargin = 4;
inline constexpr std::uint32_t kMaxCells = 65536;  ///< the most buckets, and the most clearance cells
/// How many comparisons of a clearance cell with a piece Scene::open makes at most for each byte of the file. It
/// refuses a file that needs more, so that its work is bounded by the length of the file.
inline constexpr std::uint32_t kMostLooks = 16;

/// Sections follow the header in this order, each at the next multiple of 4 bytes. "index" is an unsigned
/// integer of Header::index_width bytes. The number of a section is Failure::section of bad_scene.
enum class Section : std::uint8_t {
  vertices,            ///< float[2] each: x, y in metres, on the grid
  triangle_vertices,   ///< index[3] a triangle, counter-clockwise
  triangle_neighbors,  ///< index[3]: the triangle across the edge from vertex i to vertex i + 1, or none
  triangle_portals,    ///< index[3]: the portal of that edge, or none where there is no neighbour; portals are numbered
                       ///< in the order in which a scan of the triangles and their edges first meets them
  triangle_goals,      ///< uint16 a triangle: the goal that it belongs to, or none
  portal_widths,       ///< float a portal: twice the largest clearance along the edge, rounded up, metres
  goal_offsets,        ///< uint32[goals + 1]: first vertex of each goal's polygon
  goal_vertices,       ///< float[2] each: counter-clockwise, simple, on the grid
  starts,              ///< StartRecord each
  start_angles,        ///< float each: trailer headings, radians
  piece_offsets,       ///< uint32[pieces + 1]: first vertex of each convex obstacle piece
  piece_vertices,      ///< float[2] each: counter-clockwise, strictly convex, on the grid
  piece_boxes,         ///< float[4] a piece: min x, min y, max x, max y
  bucket_triangle_offsets,  ///< uint32[buckets + 1]: first of bucket_triangles of each bucket
  bucket_triangles,         ///< index each: triangles that meet the bucket's widened square, ascending
  bucket_piece_offsets,     ///< uint32[buckets + 1]: first of bucket_pieces of each bucket
  bucket_pieces,            ///< index each: pieces whose box meets the bucket's widened square, ascending
  clearance,                ///< uint8 a cell: see Header::clearance_unit
  names,                    ///< NUL-terminated UTF-8: the scene's name, then each goal's, then each start's
  count                     ///< the number of sections, and no section
};
inline constexpr std::size_t kSectionCount = static_cast<std::size_t>(Section::count);  ///< the number of sections

/// The first 216 bytes of a scene file. All integers and floats little-endian; no padding anywhere in this record.
struct Header {
  std::uint8_t magic[4];      ///< kMagic
  std::uint16_t version;      ///< kVersion
  std::uint8_t index_width;   ///< 2 or 4: the width of every index section
  std::uint8_t reserved;      ///< 0
  std::uint32_t total_bytes;  ///< length of the file, a multiple of 4
  std::uint32_t crc32;        ///< CRC-32 (IEEE 802.3, reflected) of the bytes from offset 16 to the end

  double origin_x;     ///< world = origin + local: whole metres, at most 1e9 either way
  double origin_y;     ///< in y as in x: whole metres, at most 1e9 either way
  float bounds_min_x;  ///< the least x of the workspace: local metres, on the grid
  float bounds_min_y;  ///< the least y: local metres, on the grid
  float bounds_max_x;  ///< the largest x: local metres, on the grid, above bounds_min_x
  float bounds_max_y;  ///< the largest y: local metres, on the grid, above bounds_min_y

  // Each count is at most 2^27, or 65,534 where it is of something that is named by an index of 2 bytes.
  std::uint32_t vertices;        ///< count, of the triangles' corners
  std::uint32_t triangles;       ///< count; 0: everything is blocked
  std::uint32_t portals;         ///< count, of edges between two triangles
  std::uint32_t goals;           ///< count, at most 65,535
  std::uint32_t goal_vertices;   ///< count, of all goals' polygons together
  std::uint32_t starts;          ///< count, at most 65,535
  std::uint32_t start_angles;    ///< count, of all starts together
  std::uint32_t pieces;          ///< count, of convex obstacle pieces
  std::uint32_t piece_vertices;  ///< count, of all pieces together

  float bucket_size;  ///< metres, a multiple of kGrid; bucket (i, j) covers bounds_min + [i, i+1] x [j, j+1] *
                      ///< bucket_size
  std::uint32_t bucket_columns;         ///< as many as cover the bounds, none to spare
  std::uint32_t bucket_rows;            ///< as many as cover the bounds; columns times rows is at most kMaxCells
  std::uint32_t bucket_triangles;       ///< length of all lists of triangles together
  std::uint32_t bucket_pieces;          ///< length of all lists of pieces together
  std::uint32_t most_bucket_triangles;  ///< largest list of one bucket: bounds the work of a look-up
  std::uint32_t most_bucket_pieces;     ///< the same of pieces

  float clearance_cell;  ///< metres, a multiple of 8 kGrid; cell (i, j) covers bounds_min + [i, i+1] x [j, j+1] *
                         ///< clearance_cell
  std::uint32_t clearance_columns;  ///< as many as cover the bounds, none to spare
  std::uint32_t clearance_rows;     ///< as many as cover the bounds; columns times rows is at most kMaxCells
  float clearance_unit;  ///< metres, clearance_cell / kClearanceUnits; a cell's byte times this bounds from below the
                         ///< distance from any point of the widened cell to the nearest obstacle or bound; 0 where the
                         ///< cell meets one

  float obstacle_error;  ///< metres, 0 … 0.1: no point of an obstacle is further than this outside the pieces
  float tolerance;       ///< metres, 0 … 2000: how far simplification may have grown an obstacle

  std::uint32_t names_bytes;                     ///< length of the names
  std::uint32_t section_offsets[kSectionCount];  ///< bytes from the start of the file, in the order of Section
};
static_assert(offsetof(Header, origin_x) == 16);
static_assert(sizeof(Header) == 16 + 16 + 16 + 9 * 4 + 7 * 4 + 4 * 4 + 3 * 4 + 4 * kSectionCount);
static_assert(sizeof(Header) % 4 == 0);

/// A start. No padding anywhere in this record.
struct StartRecord {
  float x;                    ///< local metres
  float y;                    ///< local metres
  float heading;              ///< radians
  std::uint32_t first_angle;  ///< where its trailers' headings begin in the section start_angles
  std::uint32_t angle_count;  ///< how many trailers' headings it has; 0: every trailer has the heading
};
static_assert(sizeof(StartRecord) == 20);

}  // namespace krait::format
