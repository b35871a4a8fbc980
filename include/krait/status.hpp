// SPDX-License-Identifier: Apache-2.0
// Every answer of the core, one enum; the names are the ones in JSON.
#pragma once

#include <cstdint>

namespace krait {

enum class Status : std::uint8_t {
  ok,                  // of open and init: done
  ready,               // of a planner since init: call start
  searching,           // not ended: call advance again
  solved,              // a plan is ready
  no_route,            // no path of regions leads from the start to the goal for a robot of this width
  budget_used,         // Limits::iterations expansions were made
  tree_full,           // no memory for vertices or expansions, and nothing that may be recycled
  time_used,           // set by a port that watches a clock
  bad_scene,           // Failure::section and element say where; of start: the scene is no longer that of init
  bad_robot,           // a dimension or limit of the robot is unusable
  bad_argument,        // a parameter, pose or goal is NaN, infinite or out of range; Failure::element says which
  start_outside,       // the start's position lies outside the workspace
  start_in_collision,  // a body of the robot overlaps an obstacle, the bounds or another body at the start
  goal_in_obstacle,    // no free part of the goal is left
  arena_too_small,     // Failure::bytes_needed says how large the block must be
  bad_arithmetic,      // floating point contracted, relaxed, rounded otherwise or flushed: build with -ffp-contract=off
  internal             // the plan's replay did not reproduce it: a bug of krait
};

// Lower-case name as in the enum. The pointer is to static storage.
const char* to_string(Status status);

// Which argument is wrong: Failure::element of bad_argument and bad_robot.
enum class Argument : std::uint8_t {
  none,
  block,
  scene,
  start,
  goal,
  iterations,
  vertices,
  expansions,
  when_full,
  way_legs,
  alpha,
  beta,
  gamma,
  kappa,
  update_regions,
  group_sample,
  epsilon,
  dt,
  max_steps,
  open_steps,
  path_regions,
  near_radius,
  clearance,
  stray_share,
  gentle_share,
  sight_tries,
  candidates,
  least_sketch,
  doomed_steps,
  restart_unit,
  slowest,
  reverse_share,
  cost_length,
  goal_margin,
  end_speed,
  max_substeps,
  robot_dimensions,
  robot_polygon,
  robot_sizes
};

// Lower-case name as in the enum. The pointer is to static storage.
const char* to_string(Argument argument);

// What went wrong, where. Fields that do not apply are zero.
struct Failure {
  Status status = Status::ok;
  std::uint8_t section = 0;        // bad_scene: format::Section, or Scene::kHeaderSection
  std::uint32_t element = 0;       // bad_scene: index in the section; bad_argument, bad_robot: Argument
  std::uint64_t bytes_needed = 0;  // arena_too_small
  float most = 0.0F;               // bad_argument, dt: the longest time step in seconds that the robot allows

  [[nodiscard]] bool ok() const { return status == Status::ok; }
};

}  // namespace krait
