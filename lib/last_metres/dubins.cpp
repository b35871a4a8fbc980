// SPDX-License-Identifier: Apache-2.0
#include "last_metres/dubins.hpp"

#include <algorithm>

#include "krait/status.hpp"
#include "last_metres/arc.hpp"

namespace krait::detail {
namespace {

// Radians: a circle less than so much is no turn at all, but for rounding, some 1e-5 where places are a radius apart.
// Of nearer ones a line may get a circle too many: it is longer then, and others are driven.
constexpr float kNoTurn = 1e-3F;

// Radians, 0 … 2 pi, by which `from` must turn left (1) or right (-1) to become `to`.
float turn_between(Vec2 from, Vec2 to, int turn) {
  const float angle = static_cast<float>(turn) * math::atan2(cross(from, to), dot(from, to));
  const float positive = angle < 0.0F ? angle + 2.0F * kPi : angle;
  return positive > 2.0F * kPi - kNoTurn ? 0.0F : positive;
}

// `from` and so much of what lies left of `along`.
Vec2 moved_left(Vec2 from, float by, Vec2 along) {
  return {from.x - math::product(by, along.y), from.y + math::product(by, along.x)};
}

Vec2 circle_center(const Pose& pose, float radius, int turn) {
  return moved_left(pose.position, static_cast<float>(turn) * radius, direction(pose.heading));
}

// Two turns and the straight line that touches both circles.
bool turn_straight_turn(int first, int second, const Pose& from, const Pose& to, float radius, DubinsPieces& pieces) {
  const Vec2 apart = circle_center(to, radius, second) - circle_center(from, radius, first);
  const float squared = dot(apart, apart);
  const float sideways = first == second ? 0.0F : 2.0F * radius;
  if (squared < sideways * sideways) return false;
  const float straight = std::sqrt(squared - sideways * sideways);
  const bool same_circle = squared < 1e-8F * radius * radius;
  const float side = static_cast<float>(first) * sideways;
  const Vec2 along =
      same_circle ? direction(from.heading) : (1.0F / squared) * moved_left(straight * apart, side, apart);
  pieces = {{first, 0, second},
            {radius * turn_between(direction(from.heading), along, first), straight,
             radius * turn_between(along, direction(to.heading), second)}};
  return true;
}

// Three turns; of the two circles that touch both others, the one that makes the middle turn the longer one.
bool three_turns(int first, const Pose& from, const Pose& to, float radius, DubinsPieces& pieces) {
  const Vec2 begin = circle_center(from, radius, first);
  const Vec2 end = circle_center(to, radius, first);
  const Vec2 half = 0.5F * (end - begin);
  const float squared = dot(half, half);
  const float apart = 2.0F * radius;
  if (squared > apart * apart || squared < 1e-8F * radius * radius) return false;
  const float sideways = static_cast<float>(first) * std::sqrt((apart * apart - squared) / squared);
  const Vec2 middle = moved_left(begin + half, sideways, half);
  const auto side = static_cast<float>(first);
  const Vec2 into = side * left_of(middle - begin);  // directions where the circles touch
  const Vec2 out = side * left_of(end - middle);
  pieces = {
      {first, -first, first},
      {radius * turn_between(direction(from.heading), into, first), radius * turn_between(into, -1.0F * out, -first),
       radius * turn_between(-1.0F * out, direction(to.heading), first)}};
  return true;
}

}  // namespace

void CurvedLine::add(int turn, float length) {
  KRAIT_ASSERT(count_ < kMostPieces);
  pieces_[count_++] = {end_, length, turn};
  end_ = along(end_, turn, radius_, length);
  length_ += length;
}

void CurvedLine::face(SinCos heading) {
  turned_ += angle_between(end_.heading, heading);
  end_.heading = heading;
}

Pose CurvedLine::at(float arc) const {
  if (arc < 0.0F || count_ == 0) return along(count_ == 0 ? end_ : pieces_[0].from, 0, radius_, arc);
  for (int i = 0; i < count_; ++i) {
    const Piece& piece = pieces_[i];
    if (arc <= piece.length) return along(piece.from, piece.turn, radius_, arc);
    arc -= piece.length;
  }
  return along(end_, 0, radius_, arc);
}

float CurvedLine::curve_from(float arc) const {
  float curved = 0.0F;
  for (int i = 0; i < count_; ++i) {
    const Piece& piece = pieces_[i];
    if (piece.turn != 0 && arc < piece.length) curved += piece.length - std::max(arc, 0.0F);
    arc -= piece.length;
  }
  return curved / radius_;
}

bool dubins(int word, const Pose& from, const Pose& to, float radius, DubinsPieces& pieces) {
  const int first = word % 2 == 0 ? 1 : -1;
  if (word >= 4) return three_turns(first, from, to, radius, pieces);
  return turn_straight_turn(first, word < 2 ? first : -first, from, to, radius, pieces);
}

}  // namespace krait::detail
