// SPDX-License-Identifier: Apache-2.0
// Ways out of a pose in a narrow place, as drivers pull out of a parking space: a straight move, then arcs in
// alternating gears and to alternating sides, each as far as body 0 can go, until one leads out. Driven in reverse they
// end in the pose.
#pragma once

#include <cstdint>

#include "collision/obstacles.hpp"
#include "krait/geometry.hpp"
#include "krait/goal.hpp"

namespace krait::detail {

// A straight line or an arc of body 0's origin, driven in one gear.
struct Move {
  Pose inner;     // of body 0 at the end nearer to the pose
  float radius;   // metres, above 0
  float length;   // metres
  int turn;       // the circle's centre lies to the left (1) or the right (-1) of body 0; 0: the move is straight
  bool backward;  // whether body 0 drives backwards on the way out, and so forwards on the way in

  // Body 0 when it has gone `way` metres out.
  Pose at(float way) const;
  Pose outer() const { return at(length); }

  // The same move, driven the other way from its outer end.
  Move reversed() const { return {outer(), radius, length, turn, !backward}; }

  // Where a body is, seen from the move.
  struct Offset {
    float way;     // metres out along the move, negative before its inner end
    float aside;   // metres to the left of it
    float turned;  // radians to the left of its direction there
  };
  Offset offset(const Pose& body) const;
};

class PullOuts {
 public:
  static constexpr int kMostMoves = 16;    // of a way out
  static constexpr int kMost = 16;         // ways out that are kept: bench/ABLATIONS.md, "Cars park"
  static constexpr int kMostLooks = 8192;  // bounds the work; bays take 500 to 2,000

  // What drives out.
  struct Body {
    Polygon outline;
    float length;     // metres
    float radius;     // metres, above 0: of arcs
    float clearance;  // metres, that it keeps at least
    // In steps of a way's cost, for each step that its last arc is shorter than the longest that matters.
    float short_cost = 0.0F;
  };

  // Finds the ways out of the poses that the goal allows, those with the least cost of all: with the sharpest arcs and
  // much room to obstacles, or else with less room, or else with wider arcs. At most kMostLooks placements of the body
  // (Obstacles::room) a pose, room and radius, nine of them a pose; what would take more is not found.
  void find(const Scene& scene, const Goal& goal, const Body& body);

  // Finds the ways out of one pose so.
  void find(const Scene& scene, const Pose& pose, const Body& body);

  int count() const { return count_; }

  // Of a way out, from the pose on.
  int moves(int way) const { return ways_[way].moves; }
  Move move(int way, int number) const;

  // Body 0 where the way ends.
  const Pose& end(int way) const { return ways_[way].end; }

 private:
  struct Way {
    float cost;  // in steps
    Pose end;
    std::uint8_t steps[kMostMoves];  // of the moves
    std::uint8_t moves;
    std::int8_t side;    // to which the first arc turns
    bool straight_back;  // whether the first move is driven backwards,
    bool arc_back;       // and the first arc
    bool counters;       // whether the last arc is driven in the gear of the one before it
    bool opposite;       // whether it leads out of the second pose
  };

  float metres(int steps) const;

  Move move_of(const Way& way, const Pose& inner, int number) const;

  // How many steps of a move are free, at most `most`.
  int free_steps(const Obstacles& obstacles, const Move& move, int most);

  bool free(const Obstacles& obstacles, const Pose& at);

  // Finds the ways out of the first of the poses, or of both.
  void find_ways(const Scene& scene, bool both);

  // Adds the ways out of one of the poses.
  void find_from(const Obstacles& obstacles, bool opposite);

  // Follows the arcs of a way that has its straight move.
  void follow(const Obstacles& obstacles, Way way, Pose inner);

  // Keeps the way whose last arc has come out after `turned` steps of arcs, and the way that goes on to turn all of
  // them back.
  void come_out(const Obstacles& obstacles, Way way, const Move& last, int turned);

  // Whether a way of that cost would be kept.
  bool pays(float cost) const { return count_ < kMost || cost < ways_[kMost - 1].cost; }
  void keep(const Way& way);

  Body body_;  // with the radius of the arcs that were tried last
  Pose poses_[2];
  int looks_;  // that remain
  int count_;
  Way ways_[kMost];
};

}  // namespace krait::detail
