// SPDX-License-Identifier: Apache-2.0
#include "last_metres/pull_outs.hpp"

#include "last_metres/arc.hpp"

namespace krait::detail {
namespace {

// Measured: bench/ABLATIONS.md, "Cars park" and "Cars leave narrow places".
constexpr float kStep = 0.01F;                                             // lengths of body 0
constexpr std::uint8_t kStraights[] = {0, 10, 24, 40, 70, 100, 130, 160};  // steps of the straight moves that are tried
constexpr int kOut[] = {50, 100, 160};               // steps of an arc after which it has come out
constexpr int kFarOut = kOut[2];                     // steps of the longest last arc that matters
constexpr float kMostTurn = 1.8F;                    // radians of all arcs
constexpr int kMostMoveSteps = 255;                  // of all arcs
constexpr float kRooms[] = {0.01F, 0.005F, 0.002F};  // lengths of body 0 that ways keep more than the clearance
constexpr float kWider[] = {1.0F, 2.0F, 4.0F};       // of the radius of arcs, which swing body 0's ends out less
constexpr float kGearCost = 100.0F;                  // steps that a change of gears costs

constexpr int kStrides[] = {5, 1};  // steps between two looks, and where one is not free
constexpr bool kGears[] = {false, true};
constexpr std::int8_t kSides[] = {1, -1};

}  // namespace

Pose Move::at(float way) const { return along(inner, turn, radius, backward ? -way : way); }

Move::Offset Move::offset(const Pose& body) const {
  const Vec2 ahead = direction(inner.heading);
  const auto side = static_cast<float>(turn);
  const Vec2 inward = side * left_of(ahead);  // from the inner end to the circle's centre
  const Vec2 apart = body.position - inner.position;
  const Vec2 out = apart - radius * inward;
  const float angle = turn == 0 ? 0.0F : math::atan2(cross(out, inward), -dot(out, inward));
  const float along = turn == 0 ? dot(apart, ahead) : side * radius * angle;
  const float aside = turn == 0 ? cross(ahead, apart) : side * (radius - krait::length(out));
  const SinCos off = body.heading - (inner.heading + math::sin_cos(angle));
  return {backward ? -along : along, aside, math::atan2(off.sin, off.cos)};
}

void PullOuts::find(const Scene& scene, const Goal& goal, const Body& body) {
  body_ = body;
  const SinCos heading = math::sin_cos(goal.facing().heading);
  poses_[0] = {goal.center(), heading};
  poses_[1] = {goal.center(), opposite(heading)};
  find_ways(scene, goal.facing().either_way);
}

void PullOuts::find(const Scene& scene, const Pose& pose, const Body& body) {
  body_ = body;
  poses_[0] = pose;
  find_ways(scene, false);
}

void PullOuts::find_ways(const Scene& scene, bool both) {
  count_ = 0;
  const float sharpest = body_.radius;
  for (const float wider : kWider) {
    body_.radius = wider * sharpest;
    for (const float room : kRooms) {
      const Obstacles obstacles(scene, body_.clearance + room * body_.length);
      find_from(obstacles, false);
      if (both) find_from(obstacles, true);
      if (count_ > 0) return;
    }
  }
}

void PullOuts::find_from(const Obstacles& obstacles, bool opposite) {
  looks_ = kMostLooks;
  const Pose& pose = poses_[opposite ? 1 : 0];
  for (const bool back : kGears) {
    Way way{};
    way.opposite = opposite;
    way.straight_back = back;
    way.moves = 1;
    const Move straight = move_of(way, pose, 0);
    const int most = free_steps(obstacles, straight, kStraights[sizeof kStraights - 1]);
    for (const std::uint8_t wanted : kStraights) {
      way.steps[0] = static_cast<std::uint8_t>(wanted < most ? wanted : most);
      for (const std::int8_t side : kSides) {
        way.side = side;
        for (const bool arc_back : kGears) {
          way.arc_back = arc_back;
          follow(obstacles, way, straight.at(metres(way.steps[0])));
        }
      }
      if (wanted > most) break;
    }
  }
}

void PullOuts::follow(const Obstacles& obstacles, Way way, Pose inner) {
  way.cost = static_cast<float>(way.steps[0]);
  if (way.steps[0] > 0 && way.straight_back != way.arc_back) way.cost += kGearCost;
  const float whole = kMostTurn * body_.radius / metres(1);
  const int most = whole < static_cast<float>(kMostMoveSteps) ? static_cast<int>(whole) : kMostMoveSteps;
  int turned = 0;
  while (way.moves < kMostMoves && turned < most && pays(way.cost)) {
    const int number = way.moves++;
    const Move arc = move_of(way, inner, number);
    const int steps = free_steps(obstacles, arc, most - turned);
    if (steps == 0 && number > 1) return;
    for (const int out : kOut) {
      if (out >= steps) break;
      way.steps[number] = static_cast<std::uint8_t>(out);
      come_out(obstacles, way, arc, turned + out);
    }
    way.steps[number] = static_cast<std::uint8_t>(steps);
    turned += steps;
    if (steps >= kOut[0]) come_out(obstacles, way, arc, turned);
    way.cost += static_cast<float>(steps) + kGearCost;
    inner = arc.at(metres(steps));
  }
}

void PullOuts::come_out(const Obstacles& obstacles, Way way, const Move& last, int turned) {
  const int number = way.moves;
  const int out = way.steps[number - 1];
  const float missing = static_cast<float>(kFarOut > out ? kFarOut - out : 0);
  way.cost += static_cast<float>(out) + body_.short_cost * missing;
  way.end = last.at(metres(out));
  keep(way);
  if (number == kMostMoves || !pays(way.cost)) return;
  way.counters = true;
  ++way.moves;
  const Move counter = move_of(way, way.end, number);
  if (free_steps(obstacles, counter, turned) < turned) return;
  way.steps[number] = static_cast<std::uint8_t>(turned);
  way.end = counter.at(metres(turned));
  keep(way);
}

void PullOuts::keep(const Way& way) {
  if (!pays(way.cost)) return;
  int at = count_ == kMost ? kMost - 1 : count_++;
  for (; at > 0 && ways_[at - 1].cost > way.cost; --at) ways_[at] = ways_[at - 1];
  ways_[at] = way;
}

float PullOuts::metres(int steps) const { return static_cast<float>(steps) * kStep * body_.length; }

int PullOuts::free_steps(const Obstacles& obstacles, const Move& move, int most) {
  int steps = 0;
  for (const int stride : kStrides) {
    while (steps + stride <= most && free(obstacles, move.at(metres(steps + stride)))) steps += stride;
  }
  return steps;
}

bool PullOuts::free(const Obstacles& obstacles, const Pose& at) {
  if (looks_ == 0) return false;
  --looks_;
  PlacedBody placed;
  placed.at = at.position;
  placed.count = body_.outline.count;
  for (int i = 0; i < placed.count; ++i) placed.vertices[i] = turned(at.heading, body_.outline[i]);
  return obstacles.room(placed, Obstacles::kLookBeyond) > 0.0F;
}

Move PullOuts::move_of(const Way& way, const Pose& inner, int number) const {
  const bool odd = number % 2 == 1;  // as the first arc is
  const bool counters = way.counters && number == way.moves - 1;
  const int turn = number == 0 ? 0 : (odd ? way.side : -way.side);
  const bool backward = number == 0 ? way.straight_back : (odd != counters) == way.arc_back;
  return {inner, body_.radius, metres(way.steps[number]), turn, backward};
}

Move PullOuts::move(int way, int number) const {
  Move move = move_of(ways_[way], poses_[ways_[way].opposite ? 1 : 0], 0);
  for (int i = 1; i <= number; ++i) move = move_of(ways_[way], move.outer(), i);
  return move;
}

}  // namespace krait::detail
