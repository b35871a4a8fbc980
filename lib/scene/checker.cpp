// SPDX-License-Identifier: Apache-2.0
#include "scene/checker.hpp"

#include <array>
#include <iterator>
#include <utility>

#include "scene/grid_point.hpp"

namespace krait::detail {
namespace {

using format::Header;
using format::Section;

constexpr std::uint32_t kMaxCount = 1U << 27U;  // of any element: keeps every product in 64 bits
constexpr double kMaxOrigin = 1e9;              // metres: krait/format.hpp
constexpr std::size_t kCrcStart = 16;

// Bits that are looked up at once, and tables that they are looked up in: whole bytes of four words take 16 KB, half
// ones of one word 512 bytes, and half ones alone 64.
#if defined(__OPTIMIZE_SIZE__)
constexpr std::uint32_t kBitsAtOnce = 4;
constexpr std::size_t kCrcTables = 1;
#elif UINTPTR_MAX < UINT64_MAX
constexpr std::uint32_t kBitsAtOnce = 4;
constexpr std::size_t kCrcTables = 8;
#else
constexpr std::uint32_t kBitsAtOnce = 8;
constexpr std::size_t kCrcTables = 16;
#endif
constexpr std::uint32_t kBitsMask = (1U << kBitsAtOnce) - 1;
constexpr std::size_t kTablesOfWord = 32 / kBitsAtOnce;
constexpr std::size_t kWordsAtOnce = kCrcTables / kTablesOfWord;

// [k][n]: what the bits n do to the CRC when k as many follow them.
using CrcTable = std::array<std::uint32_t, kBitsMask + 1>;
using CrcTables = std::array<CrcTable, kCrcTables>;

constexpr CrcTables crc_tables() {
  CrcTables tables{};
  for (std::uint32_t n = 0; n <= kBitsMask; ++n) {
    std::uint32_t c = n;
    for (std::uint32_t bit = 0; bit < kBitsAtOnce; ++bit) c = (c & 1U) != 0 ? 0xEDB88320U ^ (c >> 1U) : c >> 1U;
    tables[0][n] = c;
  }
  for (std::size_t k = 1; k < kCrcTables; ++k) {
    for (std::uint32_t n = 0; n <= kBitsMask; ++n) {
      const std::uint32_t before = tables[k - 1][n];
      tables[k][n] = before >> kBitsAtOnce ^ tables[0][before & kBitsMask];
    }
  }
  return tables;
}

// What a word does to the CRC when as many bits follow as the tables before `tables` stand for.
template <std::size_t... k>
std::uint32_t crc_of_word(std::uint32_t word, const CrcTable* tables, std::index_sequence<k...>) {
  return (... ^ tables[kTablesOfWord - 1 - k][word >> (k * kBitsAtOnce) & kBitsMask]);
}

// Reads as many words at a time as the tables suffice for: their look-ups do not wait for each other (slicing:
// M. E. Kounavis and F. L. Berry, A Systematic Approach to Building High Performance Software-Based CRC Generators,
// ISCC 2005). Then byte by byte.
std::uint32_t crc32(const std::byte* bytes, std::size_t size) {
  static constexpr CrcTables tables = crc_tables();
  std::uint32_t crc = 0xFFFFFFFFU;
  std::uint32_t words[kWordsAtOnce > 0 ? kWordsAtOnce : 1];
  for (; kWordsAtOnce > 0 && size >= sizeof words; bytes += sizeof words, size -= sizeof words) {
    std::memcpy(words, bytes, sizeof words);
    words[0] ^= crc;
    crc = 0;
    const CrcTable* table = tables.data();
    for (std::size_t i = std::size(words); i-- > 0; table += kTablesOfWord) {
      crc ^= crc_of_word(words[i], table, std::make_index_sequence<kTablesOfWord>());
    }
  }
  for (; size > 0; ++bytes, --size) {
    crc ^= static_cast<std::uint32_t>(*bytes);
    for (std::uint32_t bit = 0; bit < 8; bit += kBitsAtOnce) crc = crc >> kBitsAtOnce ^ tables[0][crc & kBitsMask];
  }
  return crc ^ 0xFFFFFFFFU;
}

// Whole metres.
bool usable_origin(double x) {
  return x >= -kMaxOrigin && x <= kMaxOrigin && static_cast<double>(static_cast<std::int32_t>(x)) == x;
}

bool on_grid(float x) {
  if (!(x >= -format::kMaxCoordinate && x <= format::kMaxCoordinate)) return false;
  return static_cast<float>(to_grid(x)) * format::kGrid == x;
}
bool on_grid(Vec2 p) { return on_grid(p.x) && on_grid(p.y); }

std::uint64_t align4(std::uint64_t n) { return (n + 3) / 4 * 4; }

// Bytes of a section, from the header's counts.
std::uint64_t section_bytes(const Header& h, Section section) {
  const std::uint64_t width = h.index_width;
  const std::uint64_t buckets = std::uint64_t{h.bucket_columns} * h.bucket_rows;
  switch (section) {
    case Section::vertices:
      return std::uint64_t{h.vertices} * 8;
    case Section::triangle_vertices:
    case Section::triangle_neighbors:
    case Section::triangle_portals:
      return h.triangles * 3 * width;
    case Section::triangle_goals:
      return std::uint64_t{h.triangles} * 2;
    case Section::portal_widths:
      return std::uint64_t{h.portals} * 4;
    case Section::goal_offsets:
      return (std::uint64_t{h.goals} + 1) * 4;
    case Section::goal_vertices:
      return std::uint64_t{h.goal_vertices} * 8;
    case Section::starts:
      return std::uint64_t{h.starts} * sizeof(format::StartRecord);
    case Section::start_angles:
      return std::uint64_t{h.start_angles} * 4;
    case Section::piece_offsets:
      return (std::uint64_t{h.pieces} + 1) * 4;
    case Section::piece_vertices:
      return std::uint64_t{h.piece_vertices} * 8;
    case Section::piece_boxes:
      return std::uint64_t{h.pieces} * 16;
    case Section::bucket_triangle_offsets:
    case Section::bucket_piece_offsets:
      return (buckets + 1) * 4;
    case Section::bucket_triangles:
      return h.bucket_triangles * width;
    case Section::bucket_pieces:
      return h.bucket_pieces * width;
    case Section::clearance:
      return std::uint64_t{h.clearance_columns} * h.clearance_rows;
    case Section::names:
      return h.names_bytes;
    case Section::count:
      break;
  }
  return 0;
}

// Whether x is a positive multiple of `step` grid steps.
bool multiple(float x, std::int32_t step) {
  if (!(x > 0.0F && x <= 2.0F * format::kMaxCoordinate)) return false;
  const std::int32_t steps = grid_steps(x);
  return steps > 0 && steps % step == 0 && static_cast<float>(steps) * format::kGrid == x;
}

// Whether this many cells, and no fewer, reach across the extent.
bool covers(float cell, std::uint32_t cells, float extent) {
  if (cells == 0 || cells > format::kMaxCells) return false;
  const std::int64_t size = grid_steps(cell);
  const std::int64_t length = grid_steps(extent);
  return size * cells >= length && size * (cells - 1) < length;
}

// Exact for any number of vertices: a sum in halves of 32 bits.
bool positive_area(Polygon polygon) {
  std::int64_t high = 0;
  std::int64_t low = 0;
  const GridPoint origin = to_grid(polygon[0]);
  for (int i = 1; i + 1 < polygon.count; ++i) {
    const std::int64_t twice_area = orientation(origin, to_grid(polygon[i]), to_grid(polygon[i + 1]));
    high += twice_area >> 32;
    low += twice_area & 0xFFFFFFFF;
  }
  high += low >> 32;
  return high > 0 || (high == 0 && (low & 0xFFFFFFFF) > 0);
}

// Twice the area of a convex piece.
std::int64_t twice_area(Polygon piece) {
  std::int64_t sum = 0;
  for (int i = 1; i + 1 < piece.count; ++i) {
    sum += orientation(to_grid(piece[0]), to_grid(piece[i]), to_grid(piece[i + 1]));
  }
  return sum;
}

// Every vertex strictly to the left of every edge that it does not end.
bool strictly_convex(Polygon polygon) {
  for (int i = 0; i < polygon.count; ++i) {
    const int next = (i + 1) % polygon.count;
    for (int j = 0; j < polygon.count; ++j) {
      if (j == i || j == next) continue;
      if (orientation(to_grid(polygon[i]), to_grid(polygon[next]), to_grid(polygon[j])) <= 0) return false;
    }
  }
  return true;
}

// Neither a control character, nor a separator of lines, nor a mark that changes the direction of text.
bool is_safe_to_print(std::uint32_t code) {
  const auto within = [code](std::uint32_t first, std::uint32_t last) { return code - first <= last - first; };
  return code >= 0x20 && !within(0x7F, 0x9F) && code != 0x61C && !within(0x200E, 0x200F) && !within(0x2028, 0x202E) &&
         !within(0x2066, 0x2069);
}

// Bytes of the UTF-8 character that begins here, of `remaining`; 0 where there is none, or one that is neither NUL nor
// safe to print.
std::uint32_t character_bytes(const char* text, std::uint32_t remaining) {
  const auto byte = [&](std::uint32_t i) { return static_cast<std::uint32_t>(static_cast<std::uint8_t>(text[i])); };
  const std::uint32_t first = byte(0);
  if (first < 0x80) return is_safe_to_print(first) || first == 0 ? 1 : 0;
  const std::uint32_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || length > remaining) return 0;
  std::uint32_t code = first & (0x7FU >> length);
  for (std::uint32_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return 0;
    code = code << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code >= kLeast[length] && code <= 0x10FFFF && !surrogate && is_safe_to_print(code) ? length : 0;
}

bool equal(const Box& a, const Box& b) {
  return a.min.x == b.min.x && a.min.y == b.min.y && a.max.x == b.max.x && a.max.y == b.max.y;
}

}  // namespace

bool SceneChecker::fail(Section section, std::uint32_t element) {
  failure_ = {Status::bad_scene, static_cast<std::uint8_t>(section), element, 0};
  return false;
}

bool SceneChecker::fail_header(std::uint32_t element) {
  failure_ = {Status::bad_scene, Scene::kHeaderSection, element, 0};
  return false;
}

bool SceneChecker::header(Header& h) {
  if (bytes_ == nullptr || reinterpret_cast<std::uintptr_t>(bytes_) % 4 != 0) return fail_header(0);
  if (size_ < sizeof(Header)) return fail_header(static_cast<std::uint32_t>(size_));
  std::memcpy(&h, bytes_, sizeof(Header));
  return preamble(h) && geometry(h) && layout(h);
}

bool SceneChecker::preamble(const Header& h) {
  if (std::memcmp(h.magic, format::kMagic, sizeof(format::kMagic)) != 0) return fail_header(offsetof(Header, magic));
  if (h.version != format::kVersion) return fail_header(offsetof(Header, version));
  if (h.index_width != 2 && h.index_width != 4) return fail_header(offsetof(Header, index_width));
  if (h.reserved != 0) return fail_header(offsetof(Header, reserved));
  if (h.total_bytes != size_) return fail_header(offsetof(Header, total_bytes));
  if (h.crc32 != crc32(bytes_ + kCrcStart, size_ - kCrcStart)) return fail_header(offsetof(Header, crc32));
  return true;
}

bool SceneChecker::geometry(const Header& h) {
  if (!usable_origin(h.origin_x)) return fail_header(offsetof(Header, origin_x));
  if (!usable_origin(h.origin_y)) return fail_header(offsetof(Header, origin_y));
  if (!on_grid(h.bounds_min_x) || !on_grid(h.bounds_max_x) || !(h.bounds_min_x < h.bounds_max_x)) {
    return fail_header(offsetof(Header, bounds_min_x));
  }
  if (!on_grid(h.bounds_min_y) || !on_grid(h.bounds_max_y) || !(h.bounds_min_y < h.bounds_max_y)) {
    return fail_header(offsetof(Header, bounds_min_y));
  }
  const float width = h.bounds_max_x - h.bounds_min_x;
  const float height = h.bounds_max_y - h.bounds_min_y;
  if (!multiple(h.bucket_size, 1)) return fail_header(offsetof(Header, bucket_size));
  if (!covers(h.bucket_size, h.bucket_columns, width)) return fail_header(offsetof(Header, bucket_columns));
  if (!covers(h.bucket_size, h.bucket_rows, height)) return fail_header(offsetof(Header, bucket_rows));
  if (std::uint64_t{h.bucket_columns} * h.bucket_rows > format::kMaxCells) {
    return fail_header(offsetof(Header, bucket_rows));
  }
  if (!multiple(h.clearance_cell, format::kClearanceUnits)) return fail_header(offsetof(Header, clearance_cell));
  if (!covers(h.clearance_cell, h.clearance_columns, width)) return fail_header(offsetof(Header, clearance_columns));
  if (!covers(h.clearance_cell, h.clearance_rows, height)) return fail_header(offsetof(Header, clearance_rows));
  if (std::uint64_t{h.clearance_columns} * h.clearance_rows > format::kMaxCells) {
    return fail_header(offsetof(Header, clearance_rows));
  }
  if (h.clearance_unit * static_cast<float>(format::kClearanceUnits) != h.clearance_cell) {
    return fail_header(offsetof(Header, clearance_unit));
  }
  if (!(h.obstacle_error >= 0.0F && h.obstacle_error <= 0.1F)) return fail_header(offsetof(Header, obstacle_error));
  if (!(h.tolerance >= 0.0F && h.tolerance <= format::kMaxCoordinate)) return fail_header(offsetof(Header, tolerance));
  return true;
}

bool SceneChecker::layout(const Header& h) {
  const std::uint32_t limit = h.index_width == 2 ? format::kNone16 - 1U : kMaxCount;
  const struct {
    std::uint32_t value, limit, offset;
  } counts[] = {{h.vertices, limit, offsetof(Header, vertices)},
                {h.triangles, limit, offsetof(Header, triangles)},
                {h.portals, limit, offsetof(Header, portals)},
                {h.goals, format::kNone16, offsetof(Header, goals)},
                {h.goal_vertices, kMaxCount, offsetof(Header, goal_vertices)},
                {h.starts, format::kNone16, offsetof(Header, starts)},
                {h.start_angles, kMaxCount, offsetof(Header, start_angles)},
                {h.pieces, limit, offsetof(Header, pieces)},
                {h.piece_vertices, kMaxCount, offsetof(Header, piece_vertices)},
                {h.bucket_triangles, kMaxCount, offsetof(Header, bucket_triangles)},
                {h.bucket_pieces, kMaxCount, offsetof(Header, bucket_pieces)},
                {h.names_bytes, kMaxCount, offsetof(Header, names_bytes)}};
  for (const auto& count : counts) {
    if (count.value > count.limit) return fail_header(count.offset);
  }
  std::uint64_t end = sizeof(Header);
  for (std::size_t i = 0; i < format::kSectionCount; ++i) {
    const auto offset_field = static_cast<std::uint32_t>(offsetof(Header, section_offsets) + 4 * i);
    if (h.section_offsets[i] != align4(end)) return fail_header(offset_field);
    end = align4(end) + section_bytes(h, static_cast<Section>(i));
    if (end > size_) return fail_header(offset_field);
  }
  return align4(end) == size_ || fail_header(offsetof(Header, total_bytes));
}

bool SceneChecker::contents(const Scene& s) {
  return vertices(s) && triangles(s) && adjacency(s) && portals(s) && goals(s) && starts(s) && pieces(s) &&
         buckets(s) && clearance(s) && names(s) && gaps(s);
}

bool SceneChecker::vertices(const Scene& s) {
  for (std::uint32_t i = 0; i < s.header_.vertices; ++i) {
    if (!on_grid(s.vertices_[i]) || !s.inside_bounds(s.vertices_[i])) return fail(Section::vertices, i);
  }
  return true;
}

bool SceneChecker::triangles(const Scene& s) {
  for (Index t = 0; t < s.header_.triangles; ++t) {
    for (int i = 0; i < 3; ++i) {
      if (s.triangle_vertices_[Scene::at(t, i)] >= s.header_.vertices) return fail(Section::triangle_vertices, t);
    }
    if (orientation(to_grid(s.corner(t, 0)), to_grid(s.corner(t, 1)), to_grid(s.corner(t, 2))) <= 0) {
      return fail(Section::triangle_vertices, t);
    }
  }
  return true;
}

bool SceneChecker::adjacency(const Scene& s) {
  Index portals = 0;
  for (Index t = 0; t < s.header_.triangles; ++t) {
    for (int i = 0; i < 3; ++i) {
      const Index n = s.neighbor(t, i);
      const Index portal = s.portal(t, i);
      if (n == kNone) {
        if (portal != kNone) return fail(Section::triangle_portals, t);
        continue;
      }
      if (n >= s.header_.triangles || n == t) return fail(Section::triangle_neighbors, t);
      const Index a = s.triangle_vertices_[Scene::at(t, i)];
      const Index b = s.triangle_vertices_[Scene::at(t, (i + 1) % 3)];
      int back = 0;
      while (back < 3 && !(s.triangle_vertices_[Scene::at(n, back)] == b &&
                           s.triangle_vertices_[Scene::at(n, (back + 1) % 3)] == a)) {
        ++back;
      }
      if (back == 3 || s.neighbor(n, back) != t) return fail(Section::triangle_neighbors, t);
      const Index expected = t < n ? portals++ : s.portal(n, back);
      if (portal != expected) return fail(Section::triangle_portals, t);
    }
  }
  return portals == s.header_.portals || fail_header(offsetof(Header, portals));
}

bool SceneChecker::portals(const Scene& s) {
  for (Index p = 0; p < s.header_.portals; ++p) {
    if (!(s.portal_widths_[p] >= 0.0F && s.portal_widths_[p] <= 4.0F * format::kMaxCoordinate)) {
      return fail(Section::portal_widths, p);
    }
  }
  return true;
}

bool SceneChecker::offsets(Section section, const std::uint32_t* offsets, std::uint32_t count, std::uint32_t total,
                           std::uint32_t least, std::uint32_t most) {
  if (offsets[0] != 0) return fail(section, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (offsets[i + 1] < offsets[i] || offsets[i + 1] > total) return fail(section, i + 1);
    const std::uint32_t length = offsets[i + 1] - offsets[i];
    if (length < least || length > most) return fail(section, i + 1);
  }
  return offsets[count] == total || fail(section, count);
}

bool SceneChecker::goals(const Scene& s) {
  for (Index t = 0; t < s.header_.triangles; ++t) {
    const Index goal = s.goal_of(t);
    if (goal != kNone && goal >= s.header_.goals) return fail(Section::triangle_goals, t);
  }
  if (!offsets(Section::goal_offsets, s.goal_offsets_, s.header_.goals, s.header_.goal_vertices, 3, kMaxCount))
    return false;
  for (std::uint32_t i = 0; i < s.header_.goal_vertices; ++i) {
    if (!on_grid(s.goal_vertices_[i])) return fail(Section::goal_vertices, i);
  }
  for (Index g = 0; g < s.header_.goals; ++g) {
    if (!positive_area(s.goal_polygon(g))) return fail(Section::goal_vertices, s.goal_offsets_[g]);
  }
  return true;
}

bool SceneChecker::starts(const Scene& s) {
  for (std::uint32_t i = 0; i < s.header_.starts; ++i) {
    const format::StartRecord& r = s.starts_[i];
    const bool sound = finite(Vec2{r.x, r.y}) && finite(r.heading) &&
                       std::uint64_t{r.first_angle} + r.angle_count <= s.header_.start_angles;
    if (!sound) return fail(Section::starts, i);
  }
  for (std::uint32_t i = 0; i < s.header_.start_angles; ++i) {
    if (!finite(s.start_angles_[i])) return fail(Section::start_angles, i);
  }
  return true;
}

bool SceneChecker::pieces(const Scene& s) {
  if (!offsets(Section::piece_offsets, s.piece_offsets_, s.header_.pieces, s.header_.piece_vertices,
               format::kMinPieceVertices, format::kMaxPieceVertices)) {
    return false;
  }
  for (std::uint32_t i = 0; i < s.header_.piece_vertices; ++i) {
    if (!on_grid(s.piece_vertices_[i]) || !s.inside_bounds(s.piece_vertices_[i])) {
      return fail(Section::piece_vertices, i);
    }
  }
  // Pieces that together are larger than the workspace overlap; that they are not bounds the work of clearance().
  const GridPoint low = to_grid(s.bounds().min);
  const GridPoint high = to_grid(s.bounds().max);
  std::int64_t room = 2 * std::int64_t{high.x - low.x} * (high.y - low.y);
  for (Index p = 0; p < s.header_.pieces; ++p) {
    if (!strictly_convex(s.piece(p))) return fail(Section::piece_vertices, s.piece_offsets_[p]);
    room -= twice_area(s.piece(p));
    if (room < 0) return fail(Section::piece_vertices, s.piece_offsets_[p]);
    if (!equal(s.piece_box(p), bounding_box(s.piece(p)))) return fail(Section::piece_boxes, p);
  }
  return true;
}

bool SceneChecker::names(const Scene& s) {
  const std::uint64_t expected = 1 + std::uint64_t{s.header_.goals} + s.header_.starts;
  std::uint64_t found = 0;
  for (std::uint32_t i = 0; i < s.header_.names_bytes;) {
    const std::uint32_t length = character_bytes(s.names_ + i, s.header_.names_bytes - i);
    if (length == 0) return fail(Section::names, i);
    found += s.names_[i] == '\0' ? 1U : 0U;
    i += length;
  }
  const bool ended = s.header_.names_bytes > 0 && s.names_[s.header_.names_bytes - 1] == '\0';
  return (found == expected && ended) || fail(Section::names, s.header_.names_bytes);
}

// The bytes between sections are zero.
bool SceneChecker::gaps(const Scene& s) {
  const Header& h = s.header_;
  for (std::size_t i = 0; i < format::kSectionCount; ++i) {
    const std::uint64_t end = h.section_offsets[i] + section_bytes(h, static_cast<Section>(i));
    for (std::uint64_t at = end; at < align4(end); ++at) {
      if (bytes_[at] != std::byte{0}) return fail_header(static_cast<std::uint32_t>(at));
    }
  }
  return true;
}

}  // namespace krait::detail
