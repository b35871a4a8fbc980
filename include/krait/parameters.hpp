// SPDX-License-Identifier: Apache-2.0
/// \file
/// The numbers that steer a search. Defaults first; `paper()` returns those of the paper: A. Wells and E. Plaku,
/// "Adaptive Sampling-Based Motion Planning for Mobile Robots with Differential Constraints", TAROS 2015, from which
/// come the numbers of equations and algorithms. Pages that are named here are installed below share/doc/krait.
#pragma once

#include <cstdint>

#include "krait/math.hpp"
#include "krait/status.hpp"

namespace krait {

/// The largest SearchTuning::group_sample: no group can keep more states.
inline constexpr std::uint32_t kUnboundedSample = 65535;

/// How the search proceeds. The defaults are measured (bench/ABLATIONS.md, which also states for most of them what half
/// and twice the number cost), and few programs change them.
///
/// A region is a triangle of the scene, or all triangles of a named goal together; a portal is an edge that two
/// triangles share. The tree's states in one region form a group. An expansion drives from a state of a group toward a
/// target; each part of a plan that is driven toward one target is a leg. A try is the search between two restarts.
struct SearchTuning {
  static constexpr std::uint32_t kMostSteps = 1000;     ///< the largest max_steps and open_steps
  static constexpr std::uint32_t kMostDoomedSteps = 3;  ///< the largest doomed_steps
  static constexpr std::uint32_t kMostCandidates = 8;   ///< the largest candidates

  // The states of the tree are in groups, one for each region that the tree has reached (Eqns 5 and 6).
  std::uint32_t group_sample = 12;  ///< 1 … 65535: states that a group keeps to grow from, a random sample of all
  // The group with the largest weight grows. The weight is (epsilon + 1 - h / h_max)^alpha beta^n after n selections of
  // the group, where h is the cost of the shortest path of regions to the goal and h_max the largest h (Eqn 7).
  float alpha = 8.0F;     ///< 1 … 64, no unit: strength of the heuristic
  float beta = 0.85F;     ///< above 0, below 1, no unit: a group's weight shrinks so with each selection
  float epsilon = 0.01F;  ///< above 0, up to 1, no unit: keeps every weight positive
  // The cost C of an edge between two regions is at first the distance of their centroids, metres. An expansion that
  // fails raises the costs of the edges of the next region on the shortest path (Eqn 9).
  /// 0 … 1e6: how much a failure raises edge costs; no unit, but with cost_length 0 square metres; 0: costs never
  /// change.
  float gamma = 20.0F;
  /// 0 … 10, in lengths of body 0: with this length l, a failure raises C, at first C0, by
  /// gamma l min(C0, l) / max(C, l), and the edges of the regions within 0.35 l around as well, at most 32 in all; 0:
  /// by gamma / C, as in Eqn 9.
  float cost_length = 1.0F;
  std::uint32_t kappa = 10;  ///< 1 … 10000: expansions between updates of the heuristic costs
  /// 0 … 1e6: after an update that looked at n regions, the next waits for at least n / update_regions expansions; 0:
  /// no such wait.
  std::uint32_t update_regions = 100;
  bool raise_goal = false;  ///< whether a failure in the last region before the goal raises the goal's edges
  // An expansion drives from a state of the group toward a target (Algorithm 2).
  std::uint32_t max_steps = 40;  ///< 1 … 1000: time steps of one expansion, at most
  /// 0 … 1000: the same limit in the open: an expansion goes on past max_steps, up to this number, as long as every
  /// step brings it nearer to its target and it has crossed at most one portal.
  std::uint32_t open_steps = 1000;
  /// 1 … 64: targets are points of the next so many regions on the shortest path from the group's region to the goal.
  std::uint32_t path_regions = 6;
  /// 0 … 100, in lengths of body 0: targets also come from further regions on that path, up to the 32nd, as long as
  /// their centroids lie nearer than this to the centroid of the group's region.
  float path_lengths = 8.0F;
  float near_radius = 0.7F;  ///< 0 … 10, in lengths of body 0: a target counts as reached within this distance
  /// 0 … 10, in lengths of body 0: the same distance for a target that lies in the goal. 0: such an expansion goes on
  /// until the plan may end there, its steps are used up, or a step is not free.
  float goal_near_radius = 0.0F;
  float stray_share = 0.1F;  ///< 0 … 1: share of expansions toward a random point of the workspace instead
  /// 0 … 1: share of gentle turns among the expansions from a group that was often selected.
  float gentle_share = 0.35F;
  /// 0 … 64: points that are drawn, at most, until one is in sight of the state; 0: the first point is used.
  std::uint32_t sight_tries = 16;
  std::uint32_t candidates = 4;  ///< 0 … 8: ways that are sketched before one is driven; 0: none is sketched
  /// 0 … 20: steps, of at most 2 dt each, that the best sketch must get; with fewer no way is driven, and costs rise.
  std::uint32_t least_sketch = 8;
  std::uint32_t doomed_steps = 2;  ///< 0 … 3: this many states before a collision are not kept to grow from
  /// 0 … 1e9: how many expansions the shortest try has if the shortest path from the start to the goal has 90 regions.
  /// If it has n regions, this number is multiplied by (n / 90)², but by at least 0.1 and at most 1 + n / 90. The tries
  /// last 1, 1, 2, 1, 1, 2, 4, … times as long as the shortest (Luby's sequence). 0: the search never restarts.
  std::uint32_t restart_unit = 4000;
  /// 0 … 1e9: for a robot that parks (kParks): if, after so many expansions of a try, no expansion has ended away from
  /// the start, the robot is driven along a way out of the narrow place, and along another one after every so many
  /// further expansions. 0: it is not.
  std::uint32_t stuck_expansions = 16;
  float slowest = 1.0F;  ///< 0.05 … 1: speed set-points are uniform from this share of the top speed to all of it
  /// 0 … 10, in stopping distances of the robot at its present speed: toward a target outside the goal that is nearer
  /// than this, the robot drives at a lower speed, at which this many stopping distances lead to the target. A robot
  /// that brakes weakly then drives no faster than it can stop. Only for robots that have `speed`. 0: at any speed.
  float stopping_ways = 1.0F;
  /// 0 … 1: share of backward drives among the expansions from a group that was often selected, of a robot that can
  /// reverse.
  float reverse_share = 0.2F;
  // Collision.
  bool continuous = true;           ///< whether whole steps are proven free, or states only
  std::uint32_t max_substeps = 16;  ///< 1 … 64, a power of two: how finely a step is cut to prove it
  bool prune_portals = true;        ///< whether portals too narrow for the robot are removed before the search
};

/// The range of a parameter, from least to most, both included.
struct ParameterRange {
  float least = 0.0F;  ///< in the parameter's unit
  float most = 0.0F;   ///< in the parameter's unit; infinity where it has no end
};

/// What a program says of its robot's motion and of its plans.
struct Parameters {
  float dt = 0.1F;  ///< 0.001 … 1 s: a time step
  /// 0 … 10 m: the distance that a plan keeps between the robot's bodies and everything else, and between those bodies
  /// that are tested against each other; what rounding needs comes on top.
  float clearance = 1e-3F;
  float goal_margin = 0.03F;  ///< 0 … 10 m, at most Goal::deepest: how deep inside the goal the plan must end
  /// m/s, 0 … infinity: a plan ends no faster than this, within 5 mm/s; 0: at rest; infinity: at any speed.
  float end_speed = 0.0F;
  SearchTuning tuning;  ///< how the search proceeds

  /// Algorithms 1 and 2 with the paper's constants: discrete collision checks, no pruning, Eqn 9 as printed. O(1).
  static Parameters paper();

  /// Argument::none, or the first parameter that is NaN or out of its range. O(1).
  [[nodiscard]] Argument first_bad() const;
  /// The range of a number of these or of the tuning; {0, 0} for every other argument. O(1).
  static ParameterRange range(Argument argument);
};

/// In lengths of body 0: how much more than Parameters::clearance the tree keeps, so that a plan, which is driven a
/// little beside the tree, keeps that clearance.
inline constexpr float kTreeSlack = 2e-3F;

/// What a search does when the memory for vertices or expansions is full.
enum class WhenFull : std::uint8_t {
  recycle,  ///< drops the vertices of the group that helps least, never the start, and goes on
  stop      ///< ends as tree_full
};

/// What a search may use. Planner::init refuses a number out of its range as bad_argument, with the Argument of its
/// name. lib/MEMORY.md says how many bytes of the block each needs.
struct Limits {
  static constexpr std::uint32_t kMost = (1U << 22U) - 2048;  ///< the most vertices, and the most expansions
  static constexpr std::uint32_t kLeastLegs = 16;             ///< the least way_legs but 0
  static constexpr std::uint32_t kMostLegs = 1'000'000;       ///< the most way_legs

  std::uint32_t vertices = 0;    ///< states kept to grow from, 2 … kMost; 0: as many as the block has room for
  std::uint32_t expansions = 0;  ///< expansions that are kept, 2 … kMost; 0: half as many as vertices
  std::uint64_t iterations = 1'000'000;    ///< expansions that a search makes at most, at least 1
  WhenFull when_full = WhenFull::recycle;  ///< what it does when one of these is used up
  /// 0, or 16 … 1e6: how many legs Planner::improve has room for; half of a plan's steps is the best number. 0: no
  /// memory is taken, and improve cannot be used.
  std::uint32_t way_legs = 0;

  /// The number that `expansions` stands for. O(1).
  std::uint32_t kept_expansions() const { return expansions != 0 ? expansions : vertices / 2 + 1; }

  /// Argument::none, or the first limit that is out of its range. O(1).
  [[nodiscard]] Argument first_bad() const;
};

}  // namespace krait
