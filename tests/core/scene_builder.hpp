// SPDX-License-Identifier: Apache-2.0
// Writes scene bytes by FORMAT.md for rooms made by hand: axis-aligned boxes in a rectangle, and the free part
// triangulated by the grid of all their sides. Independent of the scene compiler.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "draws.hpp"
#include "krait/scene.hpp"

namespace krait::test {

struct Point {
  double x, y;
};
using Ring = std::vector<Point>;

inline Point point(Vec2 p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

inline double distance_to_segment(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

inline double side(Point a, Point b, Point p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

// To a convex counter-clockwise polygon; 0 inside.
inline double distance_to_convex(Point p, const Ring& ring) {
  bool inside = true;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    inside = inside && side(a, b, p) >= 0;
    least = std::min(least, distance_to_segment(p, a, b));
  }
  return inside ? 0.0 : least;
}

inline Ring ring(Polygon polygon) {
  Ring result;
  for (int i = 0; i < polygon.count; ++i) result.push_back(point(polygon[i]));
  return result;
}

inline float snap(double x) { return static_cast<float>(std::round(x * 4096.0) / 4096.0); }

struct Rect {
  double x0, y0, x1, y1;
};

inline std::vector<Vec2> corners(const Rect& r) {
  return {{snap(r.x0), snap(r.y0)}, {snap(r.x1), snap(r.y0)}, {snap(r.x1), snap(r.y1)}, {snap(r.x0), snap(r.y1)}};
}

// The bytes of a scene file, aligned.
class SceneBytes {
 public:
  explicit SceneBytes(std::size_t size = 0) : words_((size + 7) / 8), size_(size) {}

  std::uint8_t* data() { return reinterpret_cast<std::uint8_t*>(words_.data()); }
  const std::uint8_t* data() const { return reinterpret_cast<const std::uint8_t*>(words_.data()); }
  std::size_t size() const { return size_; }

  format::Header header() const { return get<format::Header>(0); }
  template <class T>
  T get(std::size_t offset) const {
    T value;
    std::memcpy(&value, data() + offset, sizeof value);
    return value;
  }
  template <class T>
  void put(std::size_t offset, const T& value) {
    if (offset + sizeof value > size_) throw std::out_of_range("SceneBytes::put");
    std::memcpy(data() + offset, &value, sizeof value);
  }
  // Byte offset of element i of a section of T.
  template <class T>
  std::size_t at(format::Section section, std::size_t i) const {
    return header().section_offsets[static_cast<std::size_t>(section)] + i * sizeof(T);
  }

  // Makes the check sum right again after a change. Bit by bit, unlike the core's table.
  void repair_crc() {
    std::uint32_t crc = 0xFFFFFFFFU;
    for (std::size_t i = offsetof(format::Header, origin_x); i < size_; ++i) {
      crc ^= data()[i];
      for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) * 0xEDB88320U);
    }
    put(offsetof(format::Header, crc32), crc ^ 0xFFFFFFFFU);
  }

 private:
  std::vector<std::uint64_t> words_;
  std::size_t size_;
};

// The sections of a scene before they are bytes.
struct SceneData {
  format::Header header{};  // counts, offsets, length and check sum are written by bytes()
  std::vector<Vec2> vertices;
  std::vector<std::array<Index, 3>> triangles, neighbors, portals;
  std::vector<std::uint16_t> triangle_goals;
  std::vector<float> portal_widths;
  std::vector<std::vector<Vec2>> goals, pieces;
  std::vector<format::StartRecord> starts;
  std::vector<float> start_angles;
  std::vector<std::vector<Index>> bucket_triangles, bucket_pieces;
  std::vector<std::uint8_t> clearance;
  std::vector<std::string> names;

  SceneBytes bytes() const;
};

namespace building {

class Writer {
 public:
  Writer(format::Header& header) : header_(header), bytes_(sizeof header) {}

  void begin(format::Section section) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    header_.section_offsets[static_cast<std::size_t>(section)] = static_cast<std::uint32_t>(bytes_.size());
  }
  template <class T>
  void add(const T& value) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof value);
    std::memcpy(bytes_.data() + at, &value, sizeof value);
  }
  void add_index(Index i) {
    if (header_.index_width == 4) return add(i);
    add(static_cast<std::uint16_t>(i));
  }
  template <class T>
  void section(format::Section section, const std::vector<T>& values) {
    begin(section);
    for (const T& value : values) add(value);
  }
  void indices(format::Section section, const std::vector<std::array<Index, 3>>& values) {
    begin(section);
    for (const auto& three : values) {
      for (const Index i : three) add_index(i);
    }
  }
  template <class T>
  std::uint32_t offsets(format::Section section, const std::vector<std::vector<T>>& lists) {
    begin(section);
    std::uint32_t total = 0;
    add(total);
    for (const auto& list : lists) add(total += static_cast<std::uint32_t>(list.size()));
    return total;
  }
  std::uint32_t polygons(format::Section offset_section, format::Section vertex_section,
                         const std::vector<std::vector<Vec2>>& lists) {
    const std::uint32_t total = offsets(offset_section, lists);
    begin(vertex_section);
    for (const auto& list : lists) {
      for (const Vec2 p : list) add(p);
    }
    return total;
  }
  std::uint32_t lists(format::Section offset_section, format::Section section,
                      const std::vector<std::vector<Index>>& values) {
    const std::uint32_t total = offsets(offset_section, values);
    begin(section);
    for (const auto& list : values) {
      for (const Index i : list) add_index(i);
    }
    return total;
  }
  SceneBytes finish() {
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    header_.total_bytes = static_cast<std::uint32_t>(bytes_.size());
    SceneBytes result(bytes_.size());
    std::memcpy(result.data(), bytes_.data(), bytes_.size());
    result.put(0, header_);
    result.repair_crc();
    return result;
  }

 private:
  format::Header& header_;
  std::vector<std::uint8_t> bytes_;
};

inline std::uint32_t count(std::size_t n) { return static_cast<std::uint32_t>(n); }

template <class T>
std::uint32_t longest(const std::vector<std::vector<T>>& lists) {
  std::size_t most = 0;
  for (const auto& list : lists) most = std::max(most, list.size());
  return count(most);
}

}  // namespace building

inline SceneBytes SceneData::bytes() const {
  using format::Section;
  format::Header h = header;
  std::memcpy(h.magic, format::kMagic, sizeof h.magic);
  h.version = format::kVersion;
  h.vertices = building::count(vertices.size());
  h.triangles = building::count(triangles.size());
  h.portals = building::count(portal_widths.size());
  h.goals = building::count(goals.size());
  h.starts = building::count(starts.size());
  h.start_angles = building::count(start_angles.size());
  h.pieces = building::count(pieces.size());
  h.most_bucket_triangles = building::longest(bucket_triangles);
  h.most_bucket_pieces = building::longest(bucket_pieces);
  building::Writer w(h);
  w.section(Section::vertices, vertices);
  w.indices(Section::triangle_vertices, triangles);
  w.indices(Section::triangle_neighbors, neighbors);
  w.indices(Section::triangle_portals, portals);
  w.section(Section::triangle_goals, triangle_goals);
  w.section(Section::portal_widths, portal_widths);
  h.goal_vertices = w.polygons(Section::goal_offsets, Section::goal_vertices, goals);
  w.section(Section::starts, starts);
  w.section(Section::start_angles, start_angles);
  h.piece_vertices = w.polygons(Section::piece_offsets, Section::piece_vertices, pieces);
  w.begin(Section::piece_boxes);
  for (const auto& piece : pieces) {
    Box box{piece[0], piece[0]};
    for (const Vec2 p : piece) {
      box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
      box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
    w.add(box);
  }
  h.bucket_triangles = w.lists(Section::bucket_triangle_offsets, Section::bucket_triangles, bucket_triangles);
  h.bucket_pieces = w.lists(Section::bucket_piece_offsets, Section::bucket_pieces, bucket_pieces);
  w.section(Section::clearance, clearance);
  w.begin(Section::names);
  for (const std::string& name : names) {
    for (const char c : name) w.add(c);
    w.add('\0');
  }
  std::size_t bytes_of_names = 0;
  for (const std::string& name : names) bytes_of_names += name.size() + 1;
  h.names_bytes = building::count(bytes_of_names);
  return w.finish();
}

// What a scene is made from. Boxes and goals conform to the triangulation; loose pieces do not, which only the
// collision tests care for.
struct Room {
  Rect bounds{0, 0, 10, 10};
  double spacing = 1.0;  // longest side of a grid cell
  std::vector<Rect> boxes;
  std::vector<std::vector<Vec2>> loose_pieces;
  std::vector<Rect> goals;
  std::vector<format::StartRecord> starts;
  std::vector<float> start_angles;
  std::uint8_t index_width = 2;
  unsigned diagonals = 1;  // seed that chooses each cell's diagonal
  double clearance_cell = 0.5;
  double bucket_size = 1.5;
};

namespace building {

inline std::vector<double> grid_lines(double low, double high, double spacing, std::set<double> lines) {
  lines.insert(low);
  lines.insert(high);
  std::vector<double> result;
  for (auto it = lines.begin(); it != lines.end(); ++it) {
    if (*it < low || *it > high) continue;
    if (!result.empty()) {
      const double from = result.back(), gap = *it - from;
      const int parts = std::max(1, static_cast<int>(std::ceil(gap / spacing - 1e-9)));
      for (int i = 1; i < parts; ++i) {
        const double line = static_cast<double>(snap(from + gap * i / parts));
        if (line > result.back() && line < *it) result.push_back(line);
      }
    }
    result.push_back(*it);
  }
  return result;
}

inline bool holds(const Rect& r, double x, double y) {
  return x > static_cast<double>(snap(r.x0)) && x < static_cast<double>(snap(r.x1)) &&
         y > static_cast<double>(snap(r.y0)) && y < static_cast<double>(snap(r.y1));
}

class RoomBuilder {
 public:
  explicit RoomBuilder(const Room& room) : room_(room) {}

  SceneData build() {
    set_header();
    set_pieces();
    triangulate();
    connect();
    fill_buckets();
    fill_clearance();
    for (const Rect& goal : room_.goals) data_.goals.push_back(corners(goal));
    data_.starts = room_.starts;
    data_.start_angles = room_.start_angles;
    data_.names.push_back("room");
    for (std::size_t i = 0; i < room_.goals.size(); ++i) data_.names.push_back("goal" + std::to_string(i));
    for (std::size_t i = 0; i < room_.starts.size(); ++i) data_.names.push_back("start" + std::to_string(i));
    return data_;
  }

 private:
  static std::uint32_t cells(double extent, double size) {
    return std::max(1U, static_cast<std::uint32_t>(std::ceil(extent / size)));
  }

  void set_header() {
    format::Header& h = data_.header;
    h.index_width = room_.index_width;
    h.bounds_min_x = snap(room_.bounds.x0);
    h.bounds_min_y = snap(room_.bounds.y0);
    h.bounds_max_x = snap(room_.bounds.x1);
    h.bounds_max_y = snap(room_.bounds.y1);
    const double width = static_cast<double>(h.bounds_max_x) - static_cast<double>(h.bounds_min_x);
    const double height = static_cast<double>(h.bounds_max_y) - static_cast<double>(h.bounds_min_y);
    h.bucket_size = snap(room_.bucket_size);
    h.bucket_columns = cells(width, static_cast<double>(h.bucket_size));
    h.bucket_rows = cells(height, static_cast<double>(h.bucket_size));
    h.clearance_cell = static_cast<float>(std::round(room_.clearance_cell * 512.0) / 512.0);
    h.clearance_columns = cells(width, static_cast<double>(h.clearance_cell));
    h.clearance_rows = cells(height, static_cast<double>(h.clearance_cell));
    h.clearance_unit = 0.125F * h.clearance_cell;
  }

  void set_pieces() {
    for (const Rect& box : room_.boxes) data_.pieces.push_back(corners(box));
    data_.pieces.insert(data_.pieces.end(), room_.loose_pieces.begin(), room_.loose_pieces.end());
    for (const auto& piece : data_.pieces) rings_.push_back(ring({piece.data(), static_cast<int>(piece.size())}));
  }

  double clearance(Point p) const {
    const format::Header& h = data_.header;
    double least =
        std::min(std::min(p.x - static_cast<double>(h.bounds_min_x), static_cast<double>(h.bounds_max_x) - p.x),
                 std::min(p.y - static_cast<double>(h.bounds_min_y), static_cast<double>(h.bounds_max_y) - p.y));
    for (const Ring& piece : rings_) least = std::min(least, distance_to_convex(p, piece));
    return std::max(least, 0.0);
  }

  void triangulate() {
    std::set<double> xs, ys;
    for (const auto* rects : {&room_.boxes, &room_.goals}) {
      for (const Rect& r : *rects) {
        xs.insert({static_cast<double>(snap(r.x0)), static_cast<double>(snap(r.x1))});
        ys.insert({static_cast<double>(snap(r.y0)), static_cast<double>(snap(r.y1))});
      }
    }
    const format::Header& h = data_.header;
    const auto columns =
        grid_lines(static_cast<double>(h.bounds_min_x), static_cast<double>(h.bounds_max_x), room_.spacing, xs);
    const auto rows =
        grid_lines(static_cast<double>(h.bounds_min_y), static_cast<double>(h.bounds_max_y), room_.spacing, ys);
    for (const double y : rows) {
      for (const double x : columns) data_.vertices.push_back({static_cast<float>(x), static_cast<float>(y)});
    }
    std::mt19937 random(room_.diagonals);
    const Index stride = count(columns.size());
    for (Index row = 0; row + 1 < rows.size(); ++row) {
      for (Index column = 0; column + 1 < columns.size(); ++column) {
        const double x = 0.5 * (columns[column] + columns[column + 1]), y = 0.5 * (rows[row] + rows[row + 1]);
        const bool blocked =
            std::any_of(room_.boxes.begin(), room_.boxes.end(), [&](const Rect& r) { return holds(r, x, y); });
        if (blocked) continue;
        std::uint16_t goal = format::kNone16;
        for (std::size_t g = 0; g < room_.goals.size(); ++g) {
          if (holds(room_.goals[g], x, y)) goal = static_cast<std::uint16_t>(g);
        }
        add_cell(row * stride + column, stride, random() % 2 == 0, goal);
      }
    }
  }

  void add_cell(Index corner, Index stride, bool rising, std::uint16_t goal) {
    const Index a = corner, b = corner + 1, c = corner + stride + 1, d = corner + stride;
    if (rising) {
      data_.triangles.push_back({a, b, c});
      data_.triangles.push_back({a, c, d});
    } else {
      data_.triangles.push_back({a, b, d});
      data_.triangles.push_back({b, c, d});
    }
    data_.triangle_goals.insert(data_.triangle_goals.end(), 2, goal);
  }

  void connect() {
    const std::size_t triangles = data_.triangles.size();
    std::map<std::pair<Index, Index>, std::pair<Index, std::size_t>> edges;
    for (Index t = 0; t < triangles; ++t) {
      for (std::size_t i = 0; i < 3; ++i) edges[{data_.triangles[t][i], data_.triangles[t][(i + 1) % 3]}] = {t, i};
    }
    data_.neighbors.assign(triangles, {kNone, kNone, kNone});
    data_.portals.assign(triangles, {kNone, kNone, kNone});
    for (Index t = 0; t < triangles; ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Index a = data_.triangles[t][i], b = data_.triangles[t][(i + 1) % 3];
        const auto other = edges.find({b, a});
        if (other == edges.end()) continue;
        const auto [n, edge] = other->second;
        data_.neighbors[t][i] = n;
        data_.portals[t][i] = n > t ? count(data_.portal_widths.size()) : data_.portals[n][edge];
        if (n > t) data_.portal_widths.push_back(portal_width(data_.vertices[a], data_.vertices[b]));
      }
    }
  }

  float portal_width(Vec2 a, Vec2 b) const {
    constexpr int kSamples = 64;
    const Point from = point(a), to = point(b);
    double most = 0;
    for (int i = 0; i <= kSamples; ++i) {
      const double t = static_cast<double>(i) / kSamples;
      most = std::max(most, clearance({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)}));
    }
    const double unsampled = std::hypot(to.x - from.x, to.y - from.y) / (2 * kSamples);
    return static_cast<float>(2 * (most + unsampled) * 1.000001);
  }

  // Calls visit(bucket) for those whose square, widened by 4 grid steps, meets the box.
  template <class Visit>
  void buckets_meeting(const std::vector<Vec2>& points, Visit visit) const {
    const format::Header& h = data_.header;
    double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
    for (const Vec2 v : points) {
      const Point p = point(v);
      x0 = std::min(x0, p.x), y0 = std::min(y0, p.y), x1 = std::max(x1, p.x), y1 = std::max(y1, p.y);
    }
    const double size = static_cast<double>(h.bucket_size), wide = 4.0 / 4096;
    for (std::uint32_t row = 0; row < h.bucket_rows; ++row) {
      const double y = static_cast<double>(h.bounds_min_y) + row * size;
      if (y1 < y - wide || y0 > y + size + wide) continue;
      for (std::uint32_t column = 0; column < h.bucket_columns; ++column) {
        const double x = static_cast<double>(h.bounds_min_x) + column * size;
        if (x1 < x - wide || x0 > x + size + wide) continue;
        visit(std::size_t{row} * h.bucket_columns + column);
      }
    }
  }

  // Whether all of the square, given as buckets_meeting does, lies strictly to the right of an edge of the triangle.
  bool beyond_an_edge(const std::array<Index, 3>& triangle, std::size_t bucket) const {
    const format::Header& h = data_.header;
    const double size = static_cast<double>(h.bucket_size), wide = 4.0 / 4096;
    const double x = static_cast<double>(h.bounds_min_x) + static_cast<double>(bucket % h.bucket_columns) * size;
    const double y = static_cast<double>(h.bounds_min_y) + static_cast<double>(bucket / h.bucket_columns) * size;
    const Point square[] = {{x - wide, y - wide},
                            {x + size + wide, y - wide},
                            {x + size + wide, y + size + wide},
                            {x - wide, y + size + wide}};
    for (std::size_t i = 0; i < 3; ++i) {
      const Point a = point(data_.vertices[triangle[i]]), b = point(data_.vertices[triangle[(i + 1) % 3]]);
      if (std::all_of(std::begin(square), std::end(square), [&](Point p) { return side(a, b, p) < 0; })) return true;
    }
    return false;
  }

  void fill_buckets() {
    const std::size_t buckets = std::size_t{data_.header.bucket_columns} * data_.header.bucket_rows;
    data_.bucket_triangles.resize(buckets);
    data_.bucket_pieces.resize(buckets);
    for (Index t = 0; t < data_.triangles.size(); ++t) {
      const auto& [a, b, c] = data_.triangles[t];
      buckets_meeting({data_.vertices[a], data_.vertices[b], data_.vertices[c]}, [&](std::size_t bucket) {
        if (!beyond_an_edge(data_.triangles[t], bucket)) data_.bucket_triangles[bucket].push_back(t);
      });
    }
    for (Index p = 0; p < data_.pieces.size(); ++p) {
      buckets_meeting(data_.pieces[p], [&](std::size_t bucket) { data_.bucket_pieces[bucket].push_back(p); });
    }
  }

  void fill_clearance() {
    const format::Header& h = data_.header;
    const double size = static_cast<double>(h.clearance_cell);
    const double reach = std::sqrt(0.5) * size + 4.0 * 1.5 / 4096;
    for (std::uint32_t row = 0; row < h.clearance_rows; ++row) {
      for (std::uint32_t column = 0; column < h.clearance_columns; ++column) {
        const Point center{static_cast<double>(h.bounds_min_x) + (column + 0.5) * size,
                           static_cast<double>(h.bounds_min_y) + (row + 0.5) * size};
        const double bound = (clearance(center) - reach) / static_cast<double>(h.clearance_unit) - 1e-6;
        data_.clearance.push_back(static_cast<std::uint8_t>(std::clamp(bound, 0.0, 255.0)));
      }
    }
    // At most 8 more than any neighbour; so often that it comes to rest.
    for (std::uint32_t i = 0; i < 32; ++i) limit_steps();
  }

  void limit_steps() {
    const auto columns = static_cast<int>(data_.header.clearance_columns);
    const auto rows = static_cast<int>(data_.header.clearance_rows);
    const auto at = [&](int column, int row) -> std::uint8_t& {
      return data_.clearance[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                             static_cast<std::size_t>(column)];
    };
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        for (int n = 0; n < 9; ++n) {
          const int x = column + n % 3 - 1, y = row + n / 3 - 1;
          if (x < 0 || y < 0 || x >= columns || y >= rows) continue;
          const int limit = at(x, y) + 8;
          if (at(column, row) > limit) at(column, row) = static_cast<std::uint8_t>(limit);
        }
      }
    }
  }

  const Room& room_;
  SceneData data_;
  std::vector<Ring> rings_;
};

}  // namespace building

inline SceneData data_of(const Room& room) { return building::RoomBuilder(room).build(); }

// A scene together with its bytes.
struct OpenScene {
  explicit OpenScene(const Room& room) : bytes(data_of(room).bytes()) {
    const Failure failure = Scene::open(bytes.data(), bytes.size(), scene);
    if (!failure.ok()) {
      throw std::runtime_error("scene_builder: section " + std::to_string(failure.section) + " element " +
                               std::to_string(failure.element));
    }
  }
  OpenScene(const OpenScene&) = delete;
  OpenScene& operator=(const OpenScene&) = delete;

  SceneBytes bytes;
  Scene scene;
};

// A room of `size` metres with random boxes, one of them thin, and a goal of two metres.
inline Room random_room(unsigned seed, double size = 12, int boxes = 8) {
  std::mt19937 random(seed);
  Room room;
  room.bounds = {0, 0, size, size};
  room.diagonals = seed;
  for (int i = 0; i < boxes; ++i) {
    const double x = uniform(random, 0, size - 2), y = uniform(random, 0, size - 2);
    const double width = i == 0 ? 0.01 : uniform(random, 0.2, 2), height = uniform(random, 0.2, 2);
    room.boxes.push_back({x, y, x + width, y + height});
  }
  const double x = uniform(random, 0, size - 2), y = uniform(random, 0, size - 2);
  room.goals.push_back({x, y, x + 2, y + 2});
  return room;
}

}  // namespace krait::test
