// SPDX-License-Identifier: Apache-2.0
// The bytes of a scene file: header and sections. FORMAT.md beside this file says what they mean;
// the scene compiler writes these records and Scene::open checks them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "krait/geometry.hpp"
#include "krait/version.h"

namespace krait::format {

inline constexpr std::uint8_t kMagic[4] = {'K', 'R', 'S', 'C'};
inline constexpr std::uint16_t kVersion = KRAIT_SCENE_VERSION;

// Coordinates are multiples of this grid, in metres (2^-12 m, a quarter of a millimetre), and at most
// kMaxCoordinate from the local origin, so that grid coordinates fit 23 bits and every float is exact.
inline constexpr int kGridBits = 12;
inline constexpr float kGrid = 1.0F / 4096.0F;
inline constexpr float kMaxCoordinate = 2000.0F;

// An absent neighbour, portal or goal: all bits set in the section's index width.
inline constexpr std::uint16_t kNone16 = 0xFFFF;
inline constexpr std::uint32_t kNone32 = 0xFFFFFFFF;

inline constexpr int kMinPieceVertices = kMinVertices;
inline constexpr int kMaxPieceVertices = kMaxVertices;
inline constexpr std::uint8_t kMaxClearance = 255;
inline constexpr int kClearanceUnits = 8;          // of Header::clearance_unit in a clearance cell
inline constexpr int kCellMargin = 4;              // grid steps by which cells are widened: readers find them in float
inline constexpr std::uint32_t kMaxCells = 65536;  // of buckets, and of clearance cells
inline constexpr std::uint32_t kMostLooks = 16;    // clearance cells in and around all pieces, a byte of the file

// Sections follow the header in this order, each at the next multiple of 4 bytes. "index" is an unsigned
// integer of Header::index_width bytes.
enum class Section : std::uint8_t {
  vertices,            // float[2] each: x, y in metres, on the grid
  triangle_vertices,   // index[3] a triangle, counter-clockwise
  triangle_neighbors,  // index[3]: the triangle across the edge from vertex i to vertex i + 1, or none
  triangle_portals,  // index[3]: the portal of that edge, or none where there is no neighbour; portals are numbered in
                     // the order in which a scan of the triangles and their edges first meets them
  triangle_goals,    // uint16 a triangle: the goal that it belongs to, or none
  portal_widths,     // float a portal: twice the largest clearance along the edge, rounded up, metres
  goal_offsets,      // uint32[goals + 1]: first vertex of each goal's polygon
  goal_vertices,     // float[2] each: counter-clockwise, simple, on the grid
  starts,            // StartRecord each
  start_angles,      // float each: trailer headings, radians
  piece_offsets,     // uint32[pieces + 1]: first vertex of each convex obstacle piece
  piece_vertices,    // float[2] each: counter-clockwise, strictly convex, on the grid
  piece_boxes,       // float[4] a piece: min x, min y, max x, max y
  bucket_triangle_offsets,  // uint32[buckets + 1]
  bucket_triangles,         // index each: triangles that meet the bucket's widened square, ascending
  bucket_piece_offsets,     // uint32[buckets + 1]
  bucket_pieces,            // index each: pieces whose box meets the bucket's widened square, ascending
  clearance,                // uint8 a cell: see Header::clearance_unit
  names,                    // NUL-terminated UTF-8: the scene's name, then each goal's, then each start's
  count
};
inline constexpr std::size_t kSectionCount = static_cast<std::size_t>(Section::count);

// All integers and floats little-endian; no padding anywhere in this record.
struct Header {
  std::uint8_t magic[4];
  std::uint16_t version;
  std::uint8_t index_width;  // 2 or 4: the width of every index section
  std::uint8_t reserved;     // 0
  std::uint32_t total_bytes;
  std::uint32_t crc32;  // CRC-32 (IEEE 802.3, reflected) of the bytes from offset 16 to the end

  double origin_x;  // world = origin + local, metres
  double origin_y;
  float bounds_min_x;  // the workspace, local metres, on the grid
  float bounds_min_y;
  float bounds_max_x;
  float bounds_max_y;

  std::uint32_t vertices;
  std::uint32_t triangles;
  std::uint32_t portals;
  std::uint32_t goals;
  std::uint32_t goal_vertices;
  std::uint32_t starts;
  std::uint32_t start_angles;
  std::uint32_t pieces;
  std::uint32_t piece_vertices;

  float bucket_size;  // metres; bucket (i, j) covers bounds_min + [i, i+1] x [j, j+1] * bucket_size
  std::uint32_t bucket_columns;
  std::uint32_t bucket_rows;
  std::uint32_t bucket_triangles;
  std::uint32_t bucket_pieces;
  std::uint32_t most_bucket_triangles;  // largest list of one bucket
  std::uint32_t most_bucket_pieces;

  float clearance_cell;  // metres; cell (i, j) covers bounds_min + [i, i+1] x [j, j+1] * clearance_cell
  std::uint32_t clearance_columns;
  std::uint32_t clearance_rows;
  float clearance_unit;  // metres; a cell's byte times this bounds from below the distance from any point of
                         // the widened cell to the nearest obstacle or bound; 0 where the cell meets one

  float obstacle_error;  // metres: no point of an obstacle is further than this outside the pieces
  float tolerance;       // metres: how far simplification may have grown an obstacle

  std::uint32_t names_bytes;
  std::uint32_t section_offsets[kSectionCount];  // bytes from the start of the file
};
static_assert(offsetof(Header, origin_x) == 16);
static_assert(sizeof(Header) == 16 + 16 + 16 + 9 * 4 + 7 * 4 + 4 * 4 + 3 * 4 + 4 * kSectionCount);
static_assert(sizeof(Header) % 4 == 0);

struct StartRecord {
  float x;
  float y;
  float heading;  // radians
  std::uint32_t first_angle;
  std::uint32_t angle_count;  // 0: every trailer has the heading
};
static_assert(sizeof(StartRecord) == 20);

}  // namespace krait::format
