// SPDX-License-Identifier: Apache-2.0
// One file for every reason that the checker has to reject a scene, made from a sound one; the check sum is the
// caller's to repair.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "scene_builder.hpp"

namespace krait::test::evil {

using format::Header;
using format::Section;

inline constexpr std::uint8_t kHeader = Scene::kHeaderSection;
inline const float kNan = std::numeric_limits<float>::quiet_NaN();

// Three by two cells of one metre without the box in the middle of the lower row; 8 triangles at least.
inline SceneData sound() {
  Room room;
  room.bounds = {0, 0, 4, 3};
  room.boxes = {{1, 1, 2, 2}, {3, 2, 3.5, 2.5}};
  room.goals = {{3, 0, 4, 1}, {0, 2, 1, 3}};
  room.starts = {{0.5F, 0.5F, 0.0F, 0, 2}};
  room.start_angles = {0.0F, 0.0F};
  return data_of(room);
}

struct Evil {
  std::string name;
  std::uint8_t section;
  std::uint32_t element;
  std::function<void(SceneBytes&)> spoil;
};

inline void PrintTo(const Evil& evil, std::ostream* out) { *out << evil.name; }

template <class T>
Evil header(std::string name, std::size_t offset, T value) {
  return {std::move(name), kHeader, static_cast<std::uint32_t>(offset), [=](SceneBytes& b) { b.put(offset, value); }};
}

template <class T>
Evil header_at(std::string name, std::size_t blamed, std::size_t offset, T value) {
  return {std::move(name), kHeader, static_cast<std::uint32_t>(blamed), [=](SceneBytes& b) { b.put(offset, value); }};
}

// Element `i` of a section of T becomes `value`; `element` is blamed.
template <class T>
Evil element(std::string name, Section section, std::uint32_t element, std::size_t i, T value) {
  return {std::move(name), static_cast<std::uint8_t>(section), element,
          [=](SceneBytes& b) { b.put(b.at<T>(section, i), value); }};
}

// Square cells of `steps` grid steps that cover the four by three metres: columns, then rows.
inline Evil too_many_cells(std::string name, std::size_t size, std::size_t columns, std::uint32_t steps) {
  return {std::move(name), kHeader, static_cast<std::uint32_t>(columns + 4), [=](SceneBytes& b) {
            b.put(size, static_cast<float>(steps) * format::kGrid);
            b.put(columns, (4 * 4096 + steps - 1) / steps);
            b.put(columns + 4, (3 * 4096 + steps - 1) / steps);
          }};
}

// A scene whose data were spoiled before they were written.
inline Evil written(std::string name, std::uint8_t section, std::uint32_t element,
                    std::function<void(SceneData&)> spoil) {
  return {std::move(name), section, element, [spoil](SceneBytes& b) {
            SceneData data = sound();
            spoil(data);
            b = data.bytes();
          }};
}

// The triangle and edge of the first portal.
inline std::pair<std::uint32_t, std::size_t> first_portal() {
  const SceneData data = sound();
  for (std::uint32_t t = 0; t < data.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (data.neighbors[t][i] != kNone) return {t, i};
    }
  }
  return {};
}

// A triangle and edge without neighbour.
inline std::pair<std::uint32_t, std::size_t> first_wall() {
  const SceneData data = sound();
  for (std::uint32_t t = 0; t < data.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (data.neighbors[t][i] == kNone) return {t, i};
    }
  }
  return {};
}

inline std::vector<Evil> header_evils() {
  const auto big = std::uint32_t{0xFFFFFFFF};
  std::vector<Evil> evils = {
      header("magic", offsetof(Header, magic), std::uint8_t{'X'}),
      header("version", offsetof(Header, version), std::uint16_t{2}),
      header("index_width", offsetof(Header, index_width), std::uint8_t{3}),
      header("index_width_zero", offsetof(Header, index_width), std::uint8_t{0}),
      header("reserved", offsetof(Header, reserved), std::uint8_t{1}),
      header("total_bytes", offsetof(Header, total_bytes), std::uint32_t{4}),
      header("total_bytes_huge", offsetof(Header, total_bytes), big),
      header("origin_x_nan", offsetof(Header, origin_x), std::numeric_limits<double>::quiet_NaN()),
      header("origin_x_huge", offsetof(Header, origin_x), 1e300),
      header("origin_y_infinite", offsetof(Header, origin_y), std::numeric_limits<double>::infinity()),
      header("bounds_off_grid", offsetof(Header, bounds_min_x), 0.1F),
      header("bounds_nan", offsetof(Header, bounds_min_x), kNan),
      header("bounds_too_far", offsetof(Header, bounds_min_x), -2001.0F),
      header("bounds_reversed", offsetof(Header, bounds_min_x), 5.0F),
      header_at("bounds_empty", offsetof(Header, bounds_min_x), offsetof(Header, bounds_max_x), 0.0F),
      header("bounds_y_reversed", offsetof(Header, bounds_min_y), 5.0F),
      header_at("bounds_y_nan", offsetof(Header, bounds_min_y), offsetof(Header, bounds_max_y), kNan),
      header("origin_in_parts_of_metres", offsetof(Header, origin_x), 2.5),
      header("bucket_size_nan", offsetof(Header, bucket_size), kNan),
      header("bucket_size_zero", offsetof(Header, bucket_size), 0.0F),
      header("bucket_size_huge", offsetof(Header, bucket_size), 1e30F),
      header("bucket_size_off_grid", offsetof(Header, bucket_size), 1.5001F),
      header("bucket_columns_to_spare", offsetof(Header, bucket_columns), std::uint32_t{4}),
      header("bucket_columns_zero", offsetof(Header, bucket_columns), std::uint32_t{0}),
      header("bucket_columns_few", offsetof(Header, bucket_columns), std::uint32_t{1}),
      header("bucket_columns_huge", offsetof(Header, bucket_columns), big),
      header("bucket_rows_zero", offsetof(Header, bucket_rows), std::uint32_t{0}),
      header("bucket_rows_huge", offsetof(Header, bucket_rows), big),
      header("clearance_cell_nan", offsetof(Header, clearance_cell), kNan),
      header("clearance_cell_no_multiple_of_8_steps", offsetof(Header, clearance_cell), 0.5F + 4 * format::kGrid),
      header("clearance_columns_few", offsetof(Header, clearance_columns), std::uint32_t{2}),
      header("clearance_columns_huge", offsetof(Header, clearance_columns), big),
      header("clearance_rows_zero", offsetof(Header, clearance_rows), std::uint32_t{0}),
      header("clearance_rows_huge", offsetof(Header, clearance_rows), big),
      header("clearance_columns_to_spare", offsetof(Header, clearance_columns), std::uint32_t{9}),
      header("clearance_unit_no_eighth", offsetof(Header, clearance_unit), 0.125F),
      too_many_cells("buckets_too_many", offsetof(Header, bucket_size), offsetof(Header, bucket_columns), 54),
      too_many_cells("clearance_cells_too_many", offsetof(Header, clearance_cell), offsetof(Header, clearance_columns),
                     48),
      header("clearance_unit_nan", offsetof(Header, clearance_unit), kNan),
      header("clearance_unit_zero", offsetof(Header, clearance_unit), 0.0F),
      header("clearance_unit_huge", offsetof(Header, clearance_unit), 1e30F),
      header("obstacle_error_negative", offsetof(Header, obstacle_error), -0.01F),
      header("obstacle_error_nan", offsetof(Header, obstacle_error), kNan),
      header("obstacle_error_huge", offsetof(Header, obstacle_error), 1.0F),
      header("tolerance_negative", offsetof(Header, tolerance), -1.0F),
      header("tolerance_nan", offsetof(Header, tolerance), kNan),
      header("tolerance_huge", offsetof(Header, tolerance), 2049.0F)};
  const std::pair<const char*, std::size_t> counts[] = {{"vertices", offsetof(Header, vertices)},
                                                        {"triangles", offsetof(Header, triangles)},
                                                        {"portals", offsetof(Header, portals)},
                                                        {"goals", offsetof(Header, goals)},
                                                        {"goal_vertices", offsetof(Header, goal_vertices)},
                                                        {"starts", offsetof(Header, starts)},
                                                        {"start_angles", offsetof(Header, start_angles)},
                                                        {"pieces", offsetof(Header, pieces)},
                                                        {"piece_vertices", offsetof(Header, piece_vertices)},
                                                        {"bucket_triangles", offsetof(Header, bucket_triangles)},
                                                        {"bucket_pieces", offsetof(Header, bucket_pieces)},
                                                        {"names_bytes", offsetof(Header, names_bytes)}};
  for (const auto& [name, offset] : counts) evils.push_back(header(std::string(name) + "_huge", offset, big));
  for (std::size_t i = 0; i < format::kSectionCount; ++i) {
    const std::size_t offset = offsetof(Header, section_offsets) + 4 * i;
    evils.push_back(header("section_offset_beyond_" + std::to_string(i), offset, std::uint32_t{0x7FFFFFFC}));
    evils.push_back(header("section_offset_zero_" + std::to_string(i), offset, std::uint32_t{0}));
  }
  evils.push_back({"section_offset_misaligned", kHeader, offsetof(Header, section_offsets) + 4, [](SceneBytes& b) {
                     const std::size_t field = offsetof(Header, section_offsets) + 4;
                     b.put(field, b.get<std::uint32_t>(field) + 1);
                   }});
  evils.push_back({"portals_one_too_few", kHeader, offsetof(Header, portals), [](SceneBytes& b) {
                     SceneData data = sound();
                     data.portal_widths.push_back(1.0F);
                     b = data.bytes();
                   }});
  return evils;
}

inline std::vector<Evil> geometry_evils() {
  const auto triangles = static_cast<std::uint8_t>(Section::triangle_vertices);
  const auto neighbors = static_cast<std::uint8_t>(Section::triangle_neighbors);
  const auto portal_section = static_cast<std::uint8_t>(Section::triangle_portals);
  const auto [portal_triangle, portal_edge] = first_portal();
  const auto [wall_triangle, wall_edge] = first_wall();
  const std::uint32_t t = portal_triangle, w = wall_triangle;
  const std::size_t e = portal_edge, we = wall_edge;
  const std::size_t flat = 3 * std::size_t{t} + e, wall_flat = 3 * std::size_t{w} + we;
  std::vector<Evil> evils = {
      element("vertex_off_grid", Section::vertices, 2, 4, 0.1F),
      element("vertex_nan", Section::vertices, 2, 5, kNan),
      element("vertex_infinite", Section::vertices, 2, 5, kInfinity),
      element("vertex_outside_bounds", Section::vertices, 1, 2, 5.0F),
      element("triangle_vertex_out_of_range", Section::triangle_vertices, 1, 3, std::uint16_t{60000}),
      element("triangle_vertex_none", Section::triangle_vertices, 1, 4, format::kNone16),
      written("triangle_clockwise", triangles, 3,
              [](SceneData& d) { std::swap(d.triangles[3][0], d.triangles[3][1]); }),
      written("triangle_flat", triangles, 3, [](SceneData& d) { d.triangles[3][0] = d.triangles[3][1]; }),
      element("neighbor_out_of_range", Section::triangle_neighbors, t, flat, std::uint16_t{60000}),
      element("neighbor_itself", Section::triangle_neighbors, t, flat, static_cast<std::uint16_t>(t)),
      written("neighbor_that_shares_no_edge", neighbors, t,
              [t, e](SceneData& d) { d.neighbors[t][e] = building::count(d.triangles.size()) - 1; }),
      written("neighbor_one_way", neighbors, t,
              [t, e](SceneData& d) {
                const Index n = d.neighbors[t][e];
                for (Index& back : d.neighbors[n]) {
                  if (back == t) back = kNone;
                }
              }),
      element("portal_where_no_neighbor", Section::triangle_portals, w, wall_flat, std::uint16_t{0}),
      element("portal_missing", Section::triangle_portals, t, flat, format::kNone16),
      element("portal_out_of_range", Section::triangle_portals, t, flat, std::uint16_t{60000}),
      written("portals_out_of_order", portal_section, t, [t, e](SceneData& d) { d.portals[t][e] += 1; }),
      element("portal_width_negative", Section::portal_widths, 2, 2, -1.0F),
      element("portal_width_nan", Section::portal_widths, 2, 2, kNan),
      element("portal_width_infinite", Section::portal_widths, 2, 2, kInfinity),
      element("triangle_goal_out_of_range", Section::triangle_goals, 1, 1, std::uint16_t{2})};
  evils.push_back(written("portals_differ_on_both_sides", portal_section, 0, [t, e](SceneData& d) {
    const Index n = d.neighbors[t][e];
    for (std::size_t i = 0; i < 3; ++i) {
      if (d.neighbors[n][i] == t) d.portals[n][i] += 1;
    }
  }));
  evils.back().element = sound().neighbors[t][e];
  return evils;
}

inline std::vector<Evil> goal_and_start_evils() {
  const auto goal_section = static_cast<std::uint8_t>(Section::goal_vertices);
  const auto starts = static_cast<std::uint8_t>(Section::starts);
  return {element("goal_offset_first", Section::goal_offsets, 0, 0, std::uint32_t{1}),
          element("goal_offset_falls", Section::goal_offsets, 2, 1, std::uint32_t{8}),
          element("goal_offset_beyond", Section::goal_offsets, 1, 1, std::uint32_t{9}),
          element("goal_of_two_vertices", Section::goal_offsets, 1, 1, std::uint32_t{2}),
          element("goal_offsets_end_early", Section::goal_offsets, 2, 2, std::uint32_t{7}),
          element("goal_vertex_nan", Section::goal_vertices, 5, 10, kNan),
          element("goal_vertex_off_grid", Section::goal_vertices, 5, 11, 0.3F),
          written("goal_clockwise", goal_section, 4,
                  [](SceneData& d) { std::reverse(d.goals[1].begin(), d.goals[1].end()); }),
          written("goal_flat", goal_section, 0, [](SceneData& d) { d.goals[0][2] = d.goals[0][3] = d.goals[0][0]; }),
          written("start_nan", starts, 0, [](SceneData& d) { d.starts[0].y = kNan; }),
          written("start_heading_infinite", starts, 0, [](SceneData& d) { d.starts[0].heading = kInfinity; }),
          written("start_angles_beyond", starts, 0, [](SceneData& d) { d.starts[0].angle_count = 3; }),
          written("start_angles_wrap", starts, 0, [](SceneData& d) { d.starts[0].first_angle = 0xFFFFFFFF; }),
          element("start_angle_nan", Section::start_angles, 1, 1, kNan)};
}

inline std::vector<Evil> piece_evils() {
  const auto pieces = static_cast<std::uint8_t>(Section::piece_vertices);
  const auto piece_offsets = static_cast<std::uint8_t>(Section::piece_offsets);
  return {
      element("piece_offset_first", Section::piece_offsets, 0, 0, std::uint32_t{1}),
      element("piece_offset_falls", Section::piece_offsets, 1, 1, std::uint32_t{0xFFFFFFFF}),
      element("piece_of_two_vertices", Section::piece_offsets, 1, 1, std::uint32_t{2}),
      element("piece_offsets_end_early", Section::piece_offsets, 2, 2, std::uint32_t{7}),
      written("piece_of_nine_vertices", piece_offsets, 1,
              [](SceneData& d) {
                d.pieces[0] = {{1, 1},    {1.5, 0.75}, {2, 1},    {2.25, 1.25}, {2.25, 1.5},
                               {2, 1.75}, {1.5, 2},    {1, 1.75}, {0.75, 1.5}};
              }),
      element("piece_vertex_nan", Section::piece_vertices, 5, 11, kNan),
      element("piece_vertex_off_grid", Section::piece_vertices, 5, 10, 3.0001F),
      element("piece_vertex_too_far", Section::piece_vertices, 5, 10, 3000.0F),
      element("piece_vertex_out_of_bounds", Section::piece_vertices, 5, 10, 4.5F),
      written("pieces_larger_than_the_bounds", pieces, 3 * 4,
              [](SceneData& d) {
                d.pieces.assign(5, {{0, 0}, {4, 0}, {4, 1}, {0, 1}});
              }),
      written("piece_clockwise", pieces, 4, [](SceneData& d) { std::reverse(d.pieces[1].begin(), d.pieces[1].end()); }),
      written("piece_with_straight_corner", pieces, 0,
              [](SceneData& d) {
                d.pieces[0] = {{1, 1}, {1.5, 1}, {2, 1}, {2, 2}};
              }),
      written("piece_not_convex", pieces, 0,
              [](SceneData& d) {
                d.pieces[0] = {{1, 1}, {2, 1}, {1.25, 1.25}, {1, 2}};
              }),
      written("piece_star", pieces, 0,
              [](SceneData& d) {
                d.pieces[0] = {{1, 0}, {1.75, 2}, {0, 0.75}, {2, 0.75}, {0.25, 2}};
              }),
      written("piece_repeated_vertex", pieces, 0,
              [](SceneData& d) {
                d.pieces[0] = {{1, 1}, {2, 1}, {2, 1}, {2, 2}};
              }),
      element("piece_box_too_small", Section::piece_boxes, 1, 6, 3.25F),
      element("piece_box_nan", Section::piece_boxes, 0, 0, kNan)};
}

// Triangles of half a square grid step, one on the other, each as long as a strip of 4096 cells of a quarter of a
// metre.
inline SceneData slivers(std::size_t count) {
  Room room;
  room.bounds = {0, 0, 1024, 0.25};
  room.spacing = room.bucket_size = 1024;
  room.clearance_cell = 0.25;
  const float step = format::kGrid;
  room.loose_pieces.assign(count, {{0, 0}, {1024, step}, {1024 - step, step}});
  return data_of(room);
}

// Each is looked at in 4096 cells.
inline std::vector<Evil> sliver_evils() {
  constexpr std::size_t kSlivers = 1000;
  const std::size_t allowed = 16 * slivers(kSlivers).bytes().size() / 4096;
  return {{"slivers_on_each_other", static_cast<std::uint8_t>(Section::piece_vertices),
           static_cast<std::uint32_t>(3 * allowed), [](SceneBytes& b) { b = slivers(kSlivers).bytes(); }}};
}

inline std::vector<Evil> bucket_evils() {
  const auto triangle_list = static_cast<std::uint8_t>(Section::bucket_triangles);
  const auto piece_list = static_cast<std::uint8_t>(Section::bucket_pieces);
  const auto triangle_offsets = static_cast<std::uint8_t>(Section::bucket_triangle_offsets);
  const auto piece_offsets = static_cast<std::uint8_t>(Section::bucket_piece_offsets);
  const SceneData data = sound();
  const auto buckets = building::count(data.bucket_triangles.size());
  const auto first = building::count(data.bucket_triangles[0].size());
  const auto longest = static_cast<std::uint32_t>(
      std::find_if(data.bucket_triangles.begin(), data.bucket_triangles.end(),
                   [&](const auto& list) { return list.size() == building::longest(data.bucket_triangles); }) -
      data.bucket_triangles.begin());
  std::uint32_t most_pieces = 0;
  while (data.bucket_pieces[most_pieces].empty()) ++most_pieces;
  const std::uint32_t end_of_second = first + building::count(data.bucket_triangles[1].size());
  return {
      element("bucket_offset_first", Section::bucket_triangle_offsets, 0, 0, std::uint32_t{1}),
      element("bucket_offset_beyond", Section::bucket_triangle_offsets, 1, 1, std::uint32_t{0xFFFFFFF0}),
      element("bucket_offsets_end_early", Section::bucket_triangle_offsets, buckets, buckets, first),
      element("bucket_triangle_out_of_range", Section::bucket_triangles, 1, 1, std::uint16_t{60000}),
      element("bucket_triangle_none", Section::bucket_triangles, 0, 0, format::kNone16),
      written("bucket_triangles_descend", triangle_list, 1,
              [](SceneData& d) { std::swap(d.bucket_triangles[0][0], d.bucket_triangles[0][1]); }),
      written("bucket_triangle_twice", triangle_list, 1,
              [](SceneData& d) { d.bucket_triangles[0][1] = d.bucket_triangles[0][0]; }),
      {"bucket_longer_than_most", triangle_offsets, longest + 1,
       [](SceneBytes& b) {
         const std::size_t field = offsetof(Header, most_bucket_triangles);
         b.put(field, b.get<std::uint32_t>(field) - 1);
       }},
      element("bucket_piece_offset_first", Section::bucket_piece_offsets, 0, 0, std::uint32_t{1}),
      element("bucket_piece_out_of_range", Section::bucket_pieces, 0, 0, std::uint16_t{2}),
      {"bucket_pieces_longer_than_most", piece_offsets, most_pieces + 1,
       [](SceneBytes& b) { b.put(offsetof(Header, most_bucket_pieces), std::uint32_t{0}); }},
      written("bucket_piece_twice", piece_list, 1,
              [](SceneData& d) {
                for (auto& list : d.bucket_pieces) list.clear();
                d.bucket_pieces[0] = {0, 0};
              }),
      header("bucket_triangles_shorter_than_most", offsetof(Header, most_bucket_triangles), std::uint32_t{1000}),
      header("bucket_pieces_shorter_than_most", offsetof(Header, most_bucket_pieces), std::uint32_t{1000}),
      written("bucket_triangle_left_out", triangle_list, end_of_second - 1,
              [](SceneData& d) { d.bucket_triangles[1].pop_back(); }),
      written("bucket_piece_left_out", piece_list, 0, [=](SceneData& d) { d.bucket_pieces[most_pieces].pop_back(); }),
      written("bucket_pieces_all_left_out", piece_list, 0,
              [](SceneData& d) {
                for (auto& list : d.bucket_pieces) list.clear();
              }),
      written("bucket_triangle_elsewhere", triangle_list, first,
              [=](SceneData& d) { d.bucket_triangles[0].push_back(building::count(d.triangles.size()) - 1); }),
      written("bucket_piece_elsewhere", piece_list, 1, [](SceneData& d) {
        d.bucket_pieces[0] = {0, 1};
      })};
}

// Bytes of the 8 by 6 cells of half a metre.
inline std::vector<Evil> clearance_evils() {
  const auto cell = [](std::string name, std::uint32_t blamed, std::uint32_t at, int value) {
    return element(std::move(name), Section::clearance, blamed, at, static_cast<std::uint8_t>(value));
  };
  return {cell("clearance_jumps_up", 8 * 1 + 3, 8 * 1 + 3, 9), cell("clearance_jumps_to_the_most", 1, 0, 255),
          cell("clearance_at_the_bounds", 8 * 4, 8 * 4, 1), cell("clearance_in_a_piece", 8 * 2 + 2, 8 * 2 + 2, 1),
          cell("clearance_beside_a_piece", 8 * 1 + 4, 8 * 1 + 4, 8)};
}

// A name of five letters leaves three bytes after all names.
inline std::vector<Evil> gap_evils() {
  const auto with_gap = [] {
    SceneData data = sound();
    data.names[0] = "rooms";
    return data.bytes();
  };
  return {{"byte_in_a_gap", kHeader, static_cast<std::uint32_t>(with_gap().size() - 1), [=](SceneBytes& b) {
             b = with_gap();
             b.put(b.size() - 1, std::uint8_t{1});
           }}};
}

// The scene's name of four letters becomes these bytes.
inline Evil bad_name(std::string name, std::uint32_t blamed, const std::array<unsigned, 4>& bytes) {
  return {std::move(name), static_cast<std::uint8_t>(Section::names), blamed, [bytes](SceneBytes& b) {
            const std::size_t first = b.at<std::uint8_t>(Section::names, 0);
            for (std::size_t i = 0; i < bytes.size(); ++i) b.put(first + i, static_cast<std::uint8_t>(bytes[i]));
          }};
}

inline std::vector<Evil> utf8_evils() {
  return {bad_name("name_with_escape", 1, {'a', 0x1B, '[', 'm'}),
          bad_name("name_with_delete", 3, {'a', 'b', 'c', 0x7F}),
          bad_name("name_with_c1_control", 1, {'a', 0xC2, 0x9B, 'c'}),
          bad_name("name_with_arabic_letter_mark", 1, {'a', 0xD8, 0x9C, 'c'}),
          bad_name("name_with_right_to_left_mark", 0, {0xE2, 0x80, 0x8F, 'c'}),
          bad_name("name_with_line_separator", 0, {0xE2, 0x80, 0xA8, 'c'}),
          bad_name("name_with_right_to_left_override", 0, {0xE2, 0x80, 0xAE, 'c'}),
          bad_name("name_with_isolate", 1, {'a', 0xE2, 0x81, 0xA6}),
          bad_name("name_with_stray_byte", 1, {'a', 0x80, 'b', 'c'}),
          bad_name("name_with_half_a_character", 1, {'a', 0xC3, 'b', 'c'}),
          bad_name("name_with_two_bytes_for_one", 0, {0xC0, 0xAF, 'b', 'c'}),
          bad_name("name_with_three_bytes_for_two", 0, {0xE0, 0x82, 0x80, 'c'}),
          bad_name("name_with_four_bytes_for_three", 0, {0xF0, 0x82, 0x82, 0xAC}),
          bad_name("name_with_a_surrogate", 0, {0xED, 0xA0, 0x80, 'c'}),
          bad_name("name_beyond_unicode", 0, {0xF4, 0x90, 0x80, 0x80}),
          bad_name("name_with_byte_of_no_character", 0, {0xF5, 0x80, 0x80, 0x80})};
}

inline std::vector<Evil> name_evils() {
  const auto names = static_cast<std::uint8_t>(Section::names);
  return {written("name_missing", names, 5 + 6 + 6, [](SceneData& d) { d.names.pop_back(); }),
          written("name_too_many", names, 5 + 6 + 6 + 7 + 5, [](SceneData& d) { d.names.push_back("more"); }),
          written("names_empty", names, 0, [](SceneData& d) { d.names.clear(); }),
          {"names_end_within_a_character", names, 5 + 6 + 6 + 7 - 1,
           [](SceneBytes& b) {
             b.put(b.at<std::uint8_t>(Section::names, 0) + b.header().names_bytes - 1, std::uint8_t{0xC3});
           }},
          {"name_without_end", names, 5 + 6 + 6 + 7, [](SceneBytes& b) {
             // A name ends one byte early, and the last byte is no end.
             const std::size_t start = b.at<std::uint8_t>(Section::names, 0);
             b.put(start + 1, std::uint8_t{0});
             b.put(start + b.header().names_bytes - 1, std::uint8_t{'x'});
           }}};
}

inline std::vector<Evil> all_evils() {
  std::vector<Evil> all;
  for (const auto& evils : {header_evils(), geometry_evils(), goal_and_start_evils(), piece_evils(), sliver_evils(),
                            bucket_evils(), clearance_evils(), name_evils(), utf8_evils(), gap_evils()}) {
    all.insert(all.end(), evils.begin(), evils.end());
  }
  return all;
}

}  // namespace krait::test::evil
