// SPDX-License-Identifier: GPL-3.0-or-later
// An independent reader of scene files and brute-force geometry: the oracle of the compiler's tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../ring_oracle.hpp"
#include "host/workspace/workspace.hpp"
#include "krait/format.hpp"

namespace krait::host::test {

inline double twice_area(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

inline bool convex_contains(const Ring& ring, Point p) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0) return false;
  }
  return true;
}

struct SceneView {
  format::Header header;
  std::vector<Ring> triangles;
  std::vector<std::uint32_t> neighbors, portals;  // three a triangle
  std::vector<std::uint16_t> triangle_goals;
  std::vector<float> widths;
  std::vector<Ring> goals, pieces;
  std::vector<std::vector<std::uint32_t>> bucket_triangles, bucket_pieces;
  std::vector<std::uint8_t> clearance;
  std::vector<std::string> names;
};

class Reader {
 public:
  explicit Reader(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {
    std::memcpy(&header_, bytes.data(), sizeof header_);
  }

  SceneView read() const {
    using S = format::Section;
    SceneView v{};
    v.header = header_;
    const auto points = ring(S::vertices, 0, header_.vertices);
    for (std::uint32_t t = 0; t < header_.triangles; ++t) {
      v.triangles.emplace_back();
      for (std::uint32_t i = 3 * t; i < 3 * t + 3; ++i) {
        v.triangles.back().push_back(points.at(index(S::triangle_vertices, i)));
        v.neighbors.push_back(index(S::triangle_neighbors, i));
        v.portals.push_back(index(S::triangle_portals, i));
      }
      v.triangle_goals.push_back(get<std::uint16_t>(S::triangle_goals, t));
    }
    for (std::uint32_t p = 0; p < header_.portals; ++p) v.widths.push_back(get<float>(S::portal_widths, p));
    v.goals = rings(S::goal_offsets, S::goal_vertices, header_.goals);
    v.pieces = rings(S::piece_offsets, S::piece_vertices, header_.pieces);
    v.bucket_triangles = lists(S::bucket_triangle_offsets, S::bucket_triangles);
    v.bucket_pieces = lists(S::bucket_piece_offsets, S::bucket_pieces);
    for (std::uint32_t c = 0; c < header_.clearance_columns * header_.clearance_rows; ++c) {
      v.clearance.push_back(get<std::uint8_t>(S::clearance, c));
    }
    std::string name;
    for (std::uint32_t i = 0; i < header_.names_bytes; ++i) {
      const char c = get<char>(S::names, i);
      if (c != '\0') name += c;
      if (c == '\0') v.names.push_back(std::exchange(name, {}));
    }
    return v;
  }

 private:
  template <class T>
  T get(format::Section s, std::size_t i) const {
    T value;
    const std::size_t at = header_.section_offsets[static_cast<std::size_t>(s)] + i * sizeof(T);
    if (at + sizeof(T) > bytes_.size()) throw std::out_of_range("section");
    std::memcpy(&value, bytes_.data() + at, sizeof(T));
    return value;
  }
  std::uint32_t index(format::Section s, std::size_t i) const {
    if (header_.index_width == 4) return get<std::uint32_t>(s, i);
    const auto value = get<std::uint16_t>(s, i);
    return value == format::kNone16 ? format::kNone32 : value;
  }
  Ring ring(format::Section s, std::size_t first, std::size_t last) const {
    Ring points;
    for (std::size_t i = first; i < last; ++i) {
      points.push_back({static_cast<double>(get<float>(s, 2 * i)), static_cast<double>(get<float>(s, 2 * i + 1))});
    }
    return points;
  }
  std::vector<Ring> rings(format::Section offsets, format::Section points, std::uint32_t count) const {
    std::vector<Ring> result;
    for (std::uint32_t i = 0; i < count; ++i) {
      result.push_back(ring(points, get<std::uint32_t>(offsets, i), get<std::uint32_t>(offsets, i + 1)));
    }
    return result;
  }
  std::vector<std::vector<std::uint32_t>> lists(format::Section offsets, format::Section items) const {
    std::vector<std::vector<std::uint32_t>> result(header_.bucket_columns * header_.bucket_rows);
    for (std::size_t b = 0; b < result.size(); ++b) {
      const auto end = get<std::uint32_t>(offsets, b + 1);
      for (auto i = get<std::uint32_t>(offsets, b); i < end; ++i) result[b].push_back(index(items, i));
    }
    return result;
  }

  const std::vector<std::uint8_t>& bytes_;
  format::Header header_;
};

}  // namespace krait::host::test
