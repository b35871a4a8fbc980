// SPDX-License-Identifier: Apache-2.0
// Pulls a line taut: from one of its points it goes straight to the farthest that a disc can go to, again and again,
// and to and fro. Its corners remain. Where the disc is too wide for the line as it is, a narrower one goes on. This is
// string pulling by lines of sight, not the funnel algorithm: the way need not lead through a row of triangles.
#pragma once

#include "base/arena.hpp"
#include "collision/sight.hpp"

namespace krait::detail {

class TautLine {
 public:
  // Room for two lines of `points` points, 2 at least, 8 bytes each.
  void allocate(Arena& arena, std::uint32_t points);

  // An empty line. Points nearer than `spacing` metres, above 0, to the last one are not added; when it is full, every
  // second point goes and the spacing doubles.
  void clear(float spacing);
  void add(Vec2 point);
  // Ends the line with this point exactly.
  void end(Vec2 point);

  // Begins to pull the line, of one point at least, for the disc that `widest` looks for, and where that cannot go to
  // the line's next point for narrower ones of `least` metres or more.
  void pull(const Sight& widest, float least);
  // Continues by one stretch, which is O(log points) lines of sight, or by a new pass, O(points). False when the line
  // is taut.
  bool step();

  std::uint32_t count() const { return count_; }
  Vec2 operator[](std::uint32_t i) const { return lines_[here_][i]; }

 private:
  // An even number: the line ends in its own direction. Measured: bench/ABLATIONS.md, "Constants".
  static constexpr int kPasses = 4;
  static constexpr int kNarrower = 2;  // discs that are narrower than the widest; measured, too

  void begin_pass();
  void refine();
  Sight widest_that_goes_on() const;
  std::uint32_t farthest_in(const Sight& sight) const;

  Vec2* lines_[2] = {};
  std::uint32_t capacity_ = 0;
  int here_ = 0;
  std::uint32_t count_ = 0;   // of the line
  std::uint32_t pulled_ = 0;  // of what it becomes in this pass
  std::uint32_t at_ = 0;      // the line's point that the pass has come to; 0 when it is over
  int pass_ = 0;
  float spacing_ = 1.0F;
  Sight widest_;
  float least_ = 0.0F;  // metres: the least disc's radius
};

}  // namespace krait::detail
