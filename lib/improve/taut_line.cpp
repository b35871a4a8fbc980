// SPDX-License-Identifier: Apache-2.0
#include "improve/taut_line.hpp"

namespace krait::detail {

void TautLine::allocate(Arena& arena, std::uint32_t points) {
  for (Vec2*& line : lines_) line = arena.allocate<Vec2>(Pool::improvement, points);
  capacity_ = points;
}

void TautLine::clear(float spacing) {
  count_ = 0;
  spacing_ = spacing;
}

void TautLine::add(Vec2 point) {
  Vec2* const line = lines_[here_];
  if (count_ > 0 && length(point - line[count_ - 1]) < spacing_) return;
  if (count_ == capacity_) {
    count_ = (capacity_ + 1) / 2;
    for (std::uint32_t i = 0; i < count_; ++i) line[i] = line[2 * i];
    spacing_ = 2.0F * spacing_;
  }
  line[count_++] = point;
}

void TautLine::end(Vec2 point) {
  const bool replaces = count_ > 1 && (count_ == capacity_ || length(point - lines_[here_][count_ - 1]) < spacing_);
  lines_[here_][replaces ? count_ - 1 : count_++] = point;
}

void TautLine::pull(const Sight& widest, float least) {
  widest_ = widest;
  least_ = least;
  pass_ = 0;
  begin_pass();
}

// A pass goes from the line's end to its begin, so that the next pass goes the other way.
void TautLine::begin_pass() {
  at_ = count_ - 1;
  lines_[1 - here_][0] = lines_[here_][at_];
  pulled_ = 1;
}

bool TautLine::step() {
  if (at_ > 0) {
    at_ = farthest_in(widest_that_goes_on());
    lines_[1 - here_][pulled_++] = lines_[here_][at_];
    return true;
  }
  here_ = 1 - here_;
  count_ = pulled_;
  if (++pass_ == kPasses) return false;
  refine();
  begin_pass();
  return true;
}

// Between the widest disc and the least there are others, whose radii are as far apart.
Sight TautLine::widest_that_goes_on() const {
  const Vec2* const line = lines_[here_];
  const float more = (widest_.radius() - least_) / static_cast<float>(kNarrower);
  const Vec2 next = line[at_ - 1];
  Sight sight = widest_;
  for (int k = kNarrower - 1; k >= 0; --k) {
    if (!(sight.slack(next) < 0.0F) && sight.line_free(line[at_], next)) break;
    sight = widest_.of_radius(least_ + static_cast<float>(k) * more);
  }
  return sight;
}

// Doubles the distance until a vertex is hidden, then halves the interval between the two.
std::uint32_t TautLine::farthest_in(const Sight& sight) const {
  const Vec2* const line = lines_[here_];
  const auto sees = [&](std::uint32_t i) { return sight.line_free(line[at_], line[i]); };
  std::uint32_t seen = at_ - 1;
  std::uint32_t hidden = 0;
  bool all = true;
  for (std::uint32_t jump = 1; seen > 0; jump *= 2) {
    const std::uint32_t next = jump < seen ? seen - jump : 0;
    if (!sees(next)) {
      hidden = next;
      all = false;
      break;
    }
    seen = next;
  }
  if (all) return 0;
  while (seen - hidden > 1) {
    const std::uint32_t middle = hidden + (seen - hidden) / 2;
    (sees(middle) ? seen : hidden) = middle;
  }
  return seen;
}

// Puts points on the line again, so that its corners can move.
void TautLine::refine() {
  const Vec2* const from = lines_[here_];
  Vec2* const to = lines_[1 - here_];
  float whole = 0.0F;
  for (std::uint32_t i = 1; i < count_; ++i) whole += length(from[i] - from[i - 1]);
  const auto room = static_cast<float>(capacity_ - count_);
  const float spacing = spacing_ * room > whole ? spacing_ : whole / room;
  std::uint32_t count = 0;
  to[count++] = from[0];
  for (std::uint32_t i = 1; i < count_; ++i) {
    const Vec2 along = from[i] - from[i - 1];
    const auto parts = static_cast<std::uint32_t>(length(along) / spacing) + 1;
    for (std::uint32_t part = 1; part < parts && count + (count_ - i) < capacity_; ++part) {
      to[count++] = from[i - 1] + (static_cast<float>(part) / static_cast<float>(parts)) * along;
    }
    to[count++] = from[i];
  }
  here_ = 1 - here_;
  count_ = count;
}

}  // namespace krait::detail
