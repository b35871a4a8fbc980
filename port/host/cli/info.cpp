// SPDX-License-Identifier: Apache-2.0
// krait info: what a scene file holds.
#include <cstdio>
#include <memory>

#include "host/cli/commands.hpp"
#include "host/run/robots.hpp"
#include "host/run/run.hpp"

namespace krait::host {
namespace {

void print_names(const char* what, Index count, auto name) {
  std::printf("%-10s", what);
  for (Index i = 0; i < count; ++i) std::printf("%s%s", i == 0 ? "" : ", ", name(i));
  std::printf("%s\n", count == 0 ? "none" : "");
}

void print_sections(const format::Header& header) {
  std::printf("\n%-26s %10s\n%-26s %10zu\n", "section", "bytes", "header", sizeof(format::Header));
  for (std::size_t i = 0; i < format::kSectionCount; ++i) {
    const std::uint32_t end = i + 1 < format::kSectionCount ? header.section_offsets[i + 1] : header.total_bytes;
    std::printf("%-26s %10u\n", section_name(static_cast<std::uint8_t>(i)).c_str(), end - header.section_offsets[i]);
  }
  std::printf("%-26s %10u\n", "total", header.total_bytes);
}

float narrowest_portal(const krait::Scene& scene) {
  float width = kInfinity;
  for (Index p = 0; p < scene.portal_count(); ++p) width = std::min(width, scene.portal_width(p));
  return width;
}

// The most that one call of advance(1) does.
void print_work(const std::string& robot, const Work& work) {
  const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
  std::printf("%-10sadvance(1) of %s: at most %llu placements, %llu Runge-Kutta steps, %llu polygon distances", "work",
              safe_to_print(robot).c_str(), number(work.placements), number(work.runge_kutta_steps),
              number(work.polygon_distances));
  std::printf(" (%llu pieces near a body), %llu heap operations, %llu sketched steps, %llu discs looked at\n",
              number(work.pieces_near), number(work.heap_operations), number(work.sketched_steps), number(work.discs));
}

void print_info(const std::string& path, const std::string& robot) {
  const SceneBytes bytes = SceneBytes::read(path);
  const krait::Scene scene = open_scene(path, bytes);
  const Parameters parameters;
  const Work work = work_bound(scene, extent_of(parse_robot(robot), parameters), parameters);
  const format::Header& h = scene.header();
  const auto number = [](float x) { return static_cast<double>(x); };
  std::printf("%-10s%s\n", "scene", scene.name());
  std::printf("%-10s%.10g,%.10g to %.10g,%.10g m (world)\n", "bounds", h.origin_x + number(h.bounds_min_x),
              h.origin_y + number(h.bounds_min_y), h.origin_x + number(h.bounds_max_x),
              h.origin_y + number(h.bounds_max_y));
  if (h.origin_x != 0 || h.origin_y != 0) std::printf("%-10s%.10g,%.10g m\n", "origin", h.origin_x, h.origin_y);
  print_names("starts", scene.start_count(), [&](Index i) { return scene.start_name(i); });
  print_names("goals", scene.goal_count(), [&](Index i) { return scene.goal_name(i); });
  std::printf("%-10s%u triangles, %u portals between them", "regions", h.triangles, h.portals);
  if (h.portals > 0) std::printf(", the narrowest %.3f m wide", number(narrowest_portal(scene)));
  std::printf("\n%-10s%u convex pieces, %u vertices\n", "obstacles", h.pieces, h.piece_vertices);
  std::printf("%-10sobstacles grown by at most %.4g m a side, moved inward by at most %.2g m\n", "tolerance",
              number(h.tolerance) / 2, number(h.obstacle_error));
  std::printf("%-10sbuckets of %.3g m (at most %u triangles, %u pieces in one), clearance cells of %.3g m\n", "look-up",
              number(h.bucket_size), h.most_bucket_triangles, h.most_bucket_pieces, number(h.clearance_cell));
  std::printf("%-10sversion %u, %u-byte indices\n", "format", h.version, h.index_width);
  print_work(robot, work);
  print_sections(h);
}

}  // namespace

void add_info(CLI::App& app) {
  const auto path = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("info", "report what a scene file holds: regions, pieces, bytes, narrowest portal, work");
  command->add_option("SCENE", *path, "a .krait file")->required();
  const auto robot = std::make_shared<std::string>("snake:15");
  command->add_option("--robot", *robot, "whose work is bounded: as for plan")->capture_default_str();
  command->callback([path, robot] { print_info(*path, *robot); });
}

}  // namespace krait::host
