// SPDX-License-Identifier: Apache-2.0
#include "improve/corners.hpp"

#include <algorithm>

namespace krait::detail {
namespace {

struct Span {
  float low, high;
};

// Measured: bench/ABLATIONS.md, "Constants" and "Plans are improved". A unit is Turns::unit; a number is drawn from a
// span, each as likely.
constexpr Span kLooks = {0.8F, 2.8F};          // units: how far ahead the robot looks where no corner is rounded
constexpr Span kCornerLooks = {0.8F, 4.5F};    // units: how far ahead it looks toward a rounded corner: least and most
constexpr Span kCircleLooks = {0.6F, 1.4F};    // times what the circle takes of a side: the first part of that look
constexpr Span kLooksBefore = {0.25F, 0.95F};  // units: the second part, which is added
constexpr Span kOutward = {-0.2F, 1.1F};       // times what the circle cuts off: how far outward a corner moves
constexpr float kMostCut = 1.8F;               // units: the most that counts as cut off
constexpr float kTrailerCut = 0.5F;    // times Turns::trail: how far outward a corner of 60 degrees moves at most
constexpr float kSharpest = 0.5F;      // share of the turns at random that are the sharpest
constexpr Span kTurns = {0.2F, 1.0F};  // times the sharpest turn: the other turns at random
constexpr float kLeaveOut = 0.06F;     // share of the changes that remove a via
constexpr float kInsert = 0.16F;       // share of the changes that remove or add a via; the others change one
constexpr float kRound = 0.3F;         // share of the changed vias whose corner is rounded
constexpr float kVary = 0.5F;          // share of those that are rounded or driven to otherwise; the others move
constexpr float kWithNext = 0.5F;      // share of rounded corners whose next via is driven to in the same way
constexpr float kBeside = 0.35F;       // units: standard deviation of an added via from the line, in x and y
constexpr float kLittle = 0.15F;       // units: standard deviation of half of the moved vias, in x and y
constexpr float kMuch = 0.5F;          // units: standard deviation of the other half, in x and y
constexpr float kVaryMoved = 0.5F;     // share of the moved vias that are driven to otherwise, too

float between(Span span, Random& random) { return span.low + (span.high - span.low) * random.unit(); }

Vec2 normal_vector(float deviation, Random& random) {
  const float x = normal(random);
  const float y = normal(random);
  return deviation * Vec2{x, y};
}

void drive_likewise(Via& via, const Via& as) {
  via.look = as.look;
  via.turn = as.turn;
}

}  // namespace

// The sum of six uniform numbers (Irwin and Hall's distribution), less its mean, by its standard deviation.
float normal(Random& random) {
  float sum = -3.0F;
  for (int i = 0; i < 6; ++i) sum += random.unit();
  return 1.4142135F * sum;
}

void vary(Via& via, const Turns& turns, Random& random) {
  via.look = between(kLooks, random) * turns.unit;
  via.turn = random.unit() < kSharpest ? 1.0F : between(kTurns, random);
}

void round_corner(Vec2 before, Via& via, Vec2 after, const Turns& turns, Random& random) {
  const std::uint32_t share = random.below(Turns::kShares);
  const float radius = turns.radius[share];
  const Vec2 in = via.at - before;
  const Vec2 out = after - via.at;
  const float lengths = length(in) * length(out);
  // The next two are the tangent of half the corner's angle, at most 69 degrees, and one over its cosine less 1.
  const float cosine = lengths > 0.0F ? math::clamp(dot(in, out) / lengths, -0.74F, 1.0F) : 1.0F;
  const float tangent = std::sqrt((1.0F - cosine) / (1.0F + cosine));
  const float excess = std::sqrt(2.0F / (1.0F + cosine)) - 1.0F;
  const float look = radius * tangent * between(kCircleLooks, random) + between(kLooksBefore, random) * turns.unit;
  via.turn = Turns::kShare[share];
  via.look = math::clamp(look, kCornerLooks.low * turns.unit, kCornerLooks.high * turns.unit);
  if (!(lengths > 0.0F)) return;
  const Vec2 outward = (1.0F / length(in)) * in - (1.0F / length(out)) * out;
  const float scale = length(outward);
  const float most = kMostCut * turns.unit;
  const float cut = std::min(most, radius * excess);
  if (!(scale > 1e-3F)) return;
  const float by_circle = cut * between(kOutward, random) / scale;
  const float by_trailers = turns.trail > 0.0F ? kTrailerCut * turns.trail * random.unit() : 0.0F;
  via.at = via.at + (by_circle + by_trailers) * outward;
}

void change_via(Route& route, std::uint32_t i, const Turns& turns, Random& random) {
  const bool last = i + 1 == route.count();
  const float kind = random.unit();
  if (kind < kRound && !last) {
    round_corner(route[i - 1].at, route[i], route[i + 1].at, turns, random);
    if (random.unit() < kWithNext) drive_likewise(route[i + 1], route[i]);
  } else if (kind < kVary) {
    vary(route[i], turns, random);
    if (!last) drive_likewise(route[i + 1], route[i]);
  } else {
    const float deviation = (random.unit() < 0.5F ? kLittle : kMuch) * turns.unit;
    route[i].at = route[i].at + normal_vector(deviation, random);
    if (random.unit() < kVaryMoved) vary(route[i], turns, random);
  }
}

void change(Route& route, std::uint32_t i, const Turns& turns, Random& random) {
  const std::uint32_t count = route.count();
  const float kind = random.unit();
  if (kind < kLeaveOut && count > 3 && i + 1 < count) {
    route.remove(i);
  } else if (kind < kInsert && !route.full()) {
    Via via = route[i];
    via.at = route[i - 1].at + random.unit() * (route[i].at - route[i - 1].at);
    via.at = via.at + normal_vector(kBeside * turns.unit, random);
    route.insert(i, via);
  } else {
    change_via(route, i, turns, random);
  }
}

}  // namespace krait::detail
