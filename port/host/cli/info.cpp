// SPDX-License-Identifier: Apache-2.0
// krait info: what a scene file holds.
#include <cstdio>
#include <memory>

#include "base/arena.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/options.hpp"
#include "host/run/pools.hpp"
#include "host/run/robot_facts.hpp"
#include "host/run/robots.hpp"
#include "host/run/scene_names.hpp"
#include "host/run/session.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

struct InfoOptions {
  std::string scene;
  std::string robot = "snake:15";
  std::string memory = "128K";
  double dt = decimal(Parameters().dt);
};

std::uint64_t print_row(const char* name, std::uint64_t bytes) {
  std::printf("%-26s %10llu\n", name, static_cast<unsigned long long>(bytes));
  return bytes;
}

void print_sections(const format::Header& header) {
  std::printf("\n%-26s %10s\n", "section of flash", "bytes");
  print_row("header", sizeof(format::Header));
  for (std::size_t i = 0; i < format::kSectionCount; ++i) {
    const std::uint32_t end = i + 1 < format::kSectionCount ? header.section_offsets[i + 1] : header.total_bytes;
    print_row(section_name(static_cast<std::uint8_t>(i)).c_str(), end - header.section_offsets[i]);
  }
  print_row("total", header.total_bytes);
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

void print_block(const std::string& robot, const std::string& memory, const krait::Scene& scene, const Robot& core,
                 const Pools& pools) {
  std::printf("%-10sRAM for %s: at least %llu bytes, and %.0f a vertex; ", "block", safe_to_print(robot).c_str(),
              static_cast<unsigned long long>(least_block(scene, core)), bytes_a_vertex(scene, core));
  if (pools.vertices == 0) {
    std::printf("%s is too little\n", memory.c_str());
  } else {
    std::printf("%s holds %u vertices and %u expansions\n", memory.c_str(), pools.vertices, pools.expansions);
  }
}

void print_pools(const Pools& pools) {
  if (pools.vertices == 0) return;
  std::printf("\n%-26s %10s\n", "pool of RAM", "bytes");
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < detail::kPoolCount; ++i) {
    if (pools.bytes[i] > 0) total += print_row(to_string(static_cast<detail::Pool>(i)), pools.bytes[i]);
  }
  print_row("total", total);
}

// Throws InputError for what no block helps.
Pools usable_pools(const krait::Scene& scene, const SearchRequest& request, const Robot& robot) {
  const Pools pools = pools_of(request.memory, scene, robot, request.parameters);
  if (pools.failure.status != Status::arena_too_small) refuse(pools.failure, scene, request);
  return pools;
}

void print_info(const InfoOptions& options) {
  const SceneBytes bytes = SceneBytes::read(options.scene);
  const krait::Scene scene = open_scene(options.scene, bytes);
  SearchRequest request;
  request.robot = parse_robot(options.robot);
  request.memory = parse_memory(options.memory);
  request.parameters.dt = static_cast<float>(options.dt);
  require_usable(options.robot, request.robot);
  const CoreRobot core(request.robot);
  const Pools pools = usable_pools(scene, request, core.view());
  const format::Header& h = scene.header();
  const auto number = [](float x) { return static_cast<double>(x); };
  std::printf("%-10s%s\n", "scene", scene.name());
  std::printf("%-10s%.10g,%.10g to %.10g,%.10g m (world)\n", "bounds", h.origin_x + number(h.bounds_min_x),
              h.origin_y + number(h.bounds_min_y), h.origin_x + number(h.bounds_max_x),
              h.origin_y + number(h.bounds_max_y));
  if (h.origin_x != 0 || h.origin_y != 0) std::printf("%-10s%.10g,%.10g m\n", "origin", h.origin_x, h.origin_y);
  const SceneNames names = names_of(scene);
  std::printf("%-10s%s\n%-10s%s\n", "starts", listed(names.starts).c_str(), "goals", listed(names.goals).c_str());
  std::printf("%-10s%u triangles, %u portals between them", "regions", h.triangles, h.portals);
  if (h.portals > 0) std::printf(", the narrowest %.3f m wide", number(narrowest_portal(scene)));
  std::printf("\n%-10s%u convex pieces, %u vertices\n", "obstacles", h.pieces, h.piece_vertices);
  std::printf("%-10sobstacles grown by at most %.4g m a side, moved inward by at most %.2g m\n", "tolerance",
              number(h.tolerance), number(h.obstacle_error));
  std::printf("%-10sbuckets of %.3g m (at most %u triangles, %u pieces in one), clearance cells of %.3g m\n", "look-up",
              number(h.bucket_size), h.most_bucket_triangles, h.most_bucket_pieces, number(h.clearance_cell));
  std::printf("%-10sversion %u, %u-byte indices\n", "format", h.version, h.index_width);
  print_work(options.robot, work_bound(scene, extent_of(core, request.parameters), request.parameters));
  print_block(options.robot, options.memory, scene, core.view(), pools);
  print_sections(h);
  print_pools(pools);
}

}  // namespace

void add_info(CLI::App& app) {
  const auto o = std::make_shared<InfoOptions>();
  CLI::App* command =
      app.add_subcommand("info", "report what a scene file holds: regions, pieces, flash, RAM, narrowest portal, work");
  command->add_option("SCENE", o->scene, "a .krait file")->required();
  command->add_option("--robot", o->robot, "whose work and memory are stated: as for plan")->capture_default_str();
  command->add_option("--memory", o->memory, "the block that is shared out: as for plan")->capture_default_str();
  command->add_option("--dt", o->dt, with_range("the time step that it plans with, seconds", Argument::dt))
      ->check(number_of(Argument::dt, "seconds"))
      ->capture_default_str();
  command->callback([o] { print_info(*o); });
}

}  // namespace krait::host
