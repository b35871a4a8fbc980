// SPDX-License-Identifier: Apache-2.0
/// \file
/// Statuses and their details, and why a search found no plan.
#pragma once

#include <cstdint>

#include "krait/geometry.hpp"

namespace krait {

// Has the attribute here, and keeps it in its definition: the compiler warns where a Status is thrown away.
enum class [[nodiscard]] Status : std::uint8_t;

/// How a call or a search has ended.
enum class Status : std::uint8_t {
  ok,                  ///< of open and init: done
  ready,               ///< of a planner since init: call start
  searching,           ///< not ended: call advance again
  solved,              ///< a plan is ready
  no_route,            ///< no path of regions leads from the start to the goal for a robot of this width
  budget_used,         ///< Limits::iterations expansions were made
  tree_full,           ///< no memory for vertices or expansions, and nothing that may be recycled
  time_used,           ///< set by stop_for_time, for a port that watches a clock
  bad_scene,           ///< Failure::section and element say where; of start: the scene is no longer that of init
  bad_robot,           ///< a dimension, limit, body or size of the robot is unusable; Failure::element says which
  bad_argument,        ///< a parameter, pose or goal is NaN, infinite or out of range; Failure::element says which
  start_outside,       ///< the start's position lies outside the scene's bounds
  start_in_collision,  ///< a body of the robot is too near to an obstacle, the bounds or another body at the start, or
                       ///< its position lies in no triangle: Planner::contact says which
  goal_in_obstacle,    ///< no part of the goal is free
  arena_too_small,     ///< Failure::bytes_needed says how large the block must be
  bad_arithmetic,  ///< floating point contracted, relaxed, rounded otherwise or flushed: build with -ffp-contract=off
  internal         ///< the plan's replay did not reproduce it: a bug of krait
};

/// Lower-case name as in the enum, "unknown" of any other value. The pointer is to static storage. O(characters of all
/// names).
const char* to_string(Status status);

/// Which argument is wrong: Failure::element of bad_argument and bad_robot.
enum class Argument : std::uint8_t {
  none,              ///< none is
  block,             ///< Setup::block: null or not aligned
  scene,             ///< Setup::scene: null or not opened
  start,             ///< Query::start: null, not finite, or beyond the robot's limits
  goal,              ///< Query::goal: Goal::valid says no
  iterations,        ///< Limits::iterations
  vertices,          ///< Limits::vertices
  expansions,        ///< Limits::expansions
  when_full,         ///< Limits::when_full
  way_legs,          ///< Limits::way_legs
  alpha,             ///< SearchTuning::alpha
  beta,              ///< SearchTuning::beta
  gamma,             ///< SearchTuning::gamma
  kappa,             ///< SearchTuning::kappa
  update_regions,    ///< SearchTuning::update_regions
  group_sample,      ///< SearchTuning::group_sample
  epsilon,           ///< SearchTuning::epsilon
  dt,                ///< Parameters::dt, or longer than the robot allows: Failure::most
  max_steps,         ///< SearchTuning::max_steps
  open_steps,        ///< SearchTuning::open_steps
  path_regions,      ///< SearchTuning::path_regions
  path_lengths,      ///< SearchTuning::path_lengths
  near_radius,       ///< SearchTuning::near_radius
  goal_near_radius,  ///< SearchTuning::goal_near_radius
  clearance,         ///< Parameters::clearance
  stray_share,       ///< SearchTuning::stray_share
  gentle_share,      ///< SearchTuning::gentle_share
  sight_tries,       ///< SearchTuning::sight_tries
  candidates,        ///< SearchTuning::candidates
  least_sketch,      ///< SearchTuning::least_sketch
  doomed_steps,      ///< SearchTuning::doomed_steps
  restart_unit,      ///< SearchTuning::restart_unit
  stuck_expansions,  ///< SearchTuning::stuck_expansions
  slowest,           ///< SearchTuning::slowest
  stopping_ways,     ///< SearchTuning::stopping_ways
  reverse_share,     ///< SearchTuning::reverse_share
  cost_length,       ///< SearchTuning::cost_length
  goal_margin,       ///< Parameters::goal_margin
  end_speed,         ///< Parameters::end_speed
  max_substeps,      ///< SearchTuning::max_substeps
  robot_dimensions,  ///< bad_robot: the robot's sound() is false
  robot_polygon,     ///< bad_robot: a body is not convex, counter-clockwise, of 3 to 8 vertices
  robot_sizes        ///< bad_robot: a size of your own robot is out of range, or a robot was never constructed; the
                     ///< library's robots have robot_dimensions for too many trailers
};

/// Lower-case name as in the enum, "unknown" of any other value. The pointer is to static storage. O(characters of all
/// names).
const char* to_string(Argument argument);

/// What went wrong, where. Fields that do not apply are zero.
struct [[nodiscard]] Failure {
  Status status = Status::ok;      ///< ok where nothing did
  std::uint8_t section = 0;        ///< bad_scene: format::Section, or Scene::kHeaderSection
  std::uint32_t element = 0;       ///< bad_scene: index in the section, or the header's byte; of bad_argument and
                                   ///< bad_robot an Argument; else 0
  std::uint64_t bytes_needed = 0;  ///< arena_too_small: the length of the block that suffices
  float most = 0.0F;               ///< bad_argument, dt: the longest time step in seconds that the robot allows

  /// Whether nothing went wrong. O(1).
  [[nodiscard]] bool ok() const { return status == Status::ok; }
};

/// The kind of thing that a robot is too near to.
enum class ContactKind : std::uint8_t {
  none,      ///< nothing
  obstacle,  ///< a piece of the scene
  bounds,    ///< the bounds of the workspace
  body,      ///< another body of the robot
  ground     ///< the position lies in no triangle of the scene
};

/// What a body is too near to, and where. Metres, local coordinates.
struct Contact {
  ContactKind kind = ContactKind::none;  ///< what it is too near to; where that is nothing, the rest means nothing
  Index body = 0;                        ///< the robot's body, 0 … body_count - 1
  Index other = kNone;                   ///< the piece, or the other body; else kNone
  float distance = 0.0F;                 ///< metres between the two; 0 where they overlap
  float needed = 0.0F;                   ///< metres that they must keep: the clearance, and what rounding needs
  Vec2 at{};                             ///< metres: the middle between their nearest points, or a point of both
};

/// The narrowest place of the widest way from the start to the goal. Metres, local coordinates.
struct Bottleneck {
  float width = 0.0F;    ///< metres, of a disc that passes there; 0 where no way leads to the goal at all
  float needed = 0.0F;   ///< metres, of the disc that lies in body 0, with the clearance on both sides
  Vec2 at{};             ///< metres: the place, where there is a way
  bool at_goal = false;  ///< true: the robot cannot stand in the goal, and the place is the goal's point of most room
};

/// The region from which a search has made most expansions, as a rule without success.
struct Effort {
  Vec2 at{};                ///< metres, local coordinates: the middle of that region
  std::uint32_t tries = 0;  ///< expansions from there since the last restart; 0: there was none
};

}  // namespace krait
