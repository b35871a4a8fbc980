// SPDX-License-Identifier: Apache-2.0
// The shortest ways between two poses for something that drives forwards and turns on circles of one radius: L. E.
// Dubins, On Curves of Minimal Length with a Constraint on Average Curvature, 1957.
#pragma once

#include "krait/geometry.hpp"

namespace krait::detail {

// The pieces of a word's line: to which side each turns, as CurvedLine::add has it, and its metres.
struct DubinsPieces {
  int turns[3];
  float lengths[3];

  float length() const { return lengths[0] + lengths[1] + lengths[2]; }
};

inline constexpr int kDubinsWords = 6;  // LSL, RSR, LSR, RSL, LRL, RLR

// Finds the pieces of the word's line from one pose to another, all turns of `radius` metres, above 0. False where the
// word has none: the poses are too near to each other, or for the last two words too far apart.
bool dubins(int word, const Pose& from, const Pose& to, float radius, DubinsPieces& pieces);

// A line of arcs and straight pieces, each of which begins where the one before it ends, in its direction but for turns
// on the spot between them.
class CurvedLine {
 public:
  static constexpr int kMostPieces = 4;

  // From a pose on, with arcs of `radius` metres, above 0.
  CurvedLine() = default;
  CurvedLine(const Pose& from, float radius) : end_(from), radius_(radius) {}

  // Adds a piece of `length` metres, at least 0, that turns left (1), right (-1) or not (0). Not to kMostPieces.
  void add(int turn, float length);
  void add(const DubinsPieces& pieces) {
    for (int i = 0; i < 3; ++i) add(pieces.turns[i], pieces.lengths[i]);
  }

  // Turns the line's end on the spot, the shorter way around.
  void face(SinCos heading);

  float length() const { return length_; }  // metres
  float turned() const { return turned_; }  // radians, on the spot
  float curve_from(float arc) const;        // radians of its arcs from the place `arc` metres along it on
  const Pose& end() const { return end_; }

  // The pose `arc` metres along the line; beyond its ends on the straight lines that it ends with.
  Pose at(float arc) const;

 private:
  struct Piece {
    Pose from;
    float length;
    int turn;
  };

  Piece pieces_[kMostPieces];
  int count_ = 0;
  Pose end_{};
  float radius_ = 1.0F;
  float length_ = 0.0F;
  float turned_ = 0.0F;
};

}  // namespace krait::detail
