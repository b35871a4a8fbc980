// SPDX-License-Identifier: Apache-2.0
#include "krait/scene.hpp"

#include <bit>
#include <type_traits>

#include "scene/checker.hpp"

namespace krait {

static_assert(std::endian::native == std::endian::little, "scene files are little-endian and used in place");
static_assert(sizeof(Vec2) == 8 && sizeof(Box) == 16);

using format::Section;

Failure Scene::open(const void* bytes, std::size_t size, Scene& scene) {
  detail::SceneChecker checker(static_cast<const std::byte*>(bytes), size);
  Scene candidate;
  if (checker.header(candidate.header_)) {
    candidate.view(static_cast<const std::byte*>(bytes));
    checker.contents(candidate);
  }
  if (checker.failure().ok()) scene = candidate;
  return checker.failure();
}

void Scene::view(const std::byte* bytes) {
  const auto section = [&](Section s) { return bytes + header_.section_offsets[static_cast<std::size_t>(s)]; };
  const auto indices = [&](Section s) { return IndexArray(section(s), header_.index_width == 4); };
  const auto array = [&](Section s, auto& out) {
    out = reinterpret_cast<std::remove_reference_t<decltype(out)>>(section(s));
  };
  words_ = reinterpret_cast<const std::uint32_t*>(bytes);
  array(Section::vertices, vertices_);
  triangle_vertices_ = indices(Section::triangle_vertices);
  triangle_neighbors_ = indices(Section::triangle_neighbors);
  triangle_portals_ = indices(Section::triangle_portals);
  array(Section::triangle_goals, triangle_goals_);
  array(Section::portal_widths, portal_widths_);
  array(Section::goal_offsets, goal_offsets_);
  array(Section::goal_vertices, goal_vertices_);
  array(Section::starts, starts_);
  array(Section::start_angles, start_angles_);
  array(Section::piece_offsets, piece_offsets_);
  array(Section::piece_vertices, piece_vertices_);
  array(Section::piece_boxes, piece_boxes_);
  array(Section::bucket_triangle_offsets, bucket_triangle_offsets_);
  bucket_triangles_ = indices(Section::bucket_triangles);
  array(Section::bucket_piece_offsets, bucket_piece_offsets_);
  bucket_pieces_ = indices(Section::bucket_pieces);
  array(Section::clearance, clearance_);
  array(Section::names, names_);
  const Vec2 origin = bounds().min;
  buckets_ = {origin, 1.0F / header_.bucket_size, static_cast<std::int32_t>(header_.bucket_columns),
              static_cast<std::int32_t>(header_.bucket_rows)};
  clearance_grid_ = {origin, header_, clearance_};
}

// FNV-1a by words.
std::uint32_t Scene::fingerprint() const {
  constexpr std::uint32_t kHeaderWords = sizeof(format::Header) / 4;
  constexpr std::uint32_t kOthers = 256;
  const std::uint32_t words = header_.total_bytes / 4;
  const std::uint32_t stride = words / kOthers + 1;
  std::uint32_t sum = 0;
  for (std::uint32_t i = 0; i < words; i += i + 1 < kHeaderWords ? 1 : stride) sum = (sum ^ words_[i]) * 0x01000193U;
  return sum;
}

const char* Scene::nth_name(Index n) const {
  const char* name = names_;
  for (; n > 0; --n) {
    while (*name != '\0') ++name;
    ++name;
  }
  return name;
}

Index Scene::find_goal(const char* goal) const {
  const char* name = nth_name(1);
  for (Index i = 0; i < goal_count(); ++i) {
    if (std::strcmp(name, goal) == 0) return i;
    while (*name++ != '\0') continue;
  }
  return kNone;
}

ScenePose Scene::start(Index start) const {
  KRAIT_ASSERT(start < start_count());
  const format::StartRecord& record = starts_[start];
  return {{record.x, record.y}, record.heading, start_angles_ + record.first_angle, record.angle_count};
}

}  // namespace krait
