// SPDX-License-Identifier: Apache-2.0
#include "improve/corners.hpp"

namespace krait::detail {
namespace {

float between(float low, float high, Random& random) { return low + (high - low) * random.unit(); }

Vec2 normal_vector(float deviation, Random& random) {
  const float x = normal(random);
  const float y = normal(random);
  return deviation * Vec2{x, y};
}

constexpr float kNearest = 0.8F;  // of look-aheads, in units
constexpr float kFarthest = 4.5F;

}  // namespace

float normal(Random& random) {
  float sum = -3.0F;
  for (int i = 0; i < 6; ++i) sum += random.unit();
  return 1.4142135F * sum;
}

void vary(Via& via, const Turns& turns, Random& random) {
  via.look = between(kNearest, 2.8F, random) * turns.unit;
  via.turn = random.unit() < 0.5F ? 1.0F : between(0.2F, 1.0F, random);
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
  const float look = radius * tangent * between(0.6F, 1.4F, random) + between(0.25F, 0.95F, random) * turns.unit;
  via.turn = Turns::kShare[share];
  via.look = math::clamp(look, kNearest * turns.unit, kFarthest * turns.unit);
  if (!(lengths > 0.0F)) return;
  const Vec2 outward = (1.0F / length(in)) * in - (1.0F / length(out)) * out;
  const float scale = length(outward);
  const float most = 1.8F * turns.unit;
  const float cut = radius * excess < most ? radius * excess : most;
  if (scale > 1e-3F) via.at = via.at + (cut * between(-0.2F, 1.1F, random) / scale) * outward;
}

void change(Route& route, std::uint32_t i, const Turns& turns, Random& random) {
  const std::uint32_t count = route.count();
  const bool last = i + 1 == count;
  const float kind = random.unit();
  if (kind < 0.35F && !last) {
    round_corner(route[i - 1].at, route[i], route[i + 1].at, turns, random);
    if (random.unit() < 0.5F) {
      route[i + 1].look = route[i].look;
      route[i + 1].turn = route[i].turn;
    }
  } else if (kind < 0.48F) {
    vary(route[i], turns, random);
    if (!last) {
      route[i + 1].look = route[i].look;
      route[i + 1].turn = route[i].turn;
    }
  } else if (kind < 0.54F && count > 3 && !last) {
    route.remove(i);
  } else if (kind < 0.64F && !route.full()) {
    Via via = route[i];
    via.at = route[i - 1].at + random.unit() * (route[i].at - route[i - 1].at);
    via.at = via.at + normal_vector(0.35F * turns.unit, random);
    route.insert(i, via);
  } else {
    const float deviation = (random.unit() < 0.5F ? 0.15F : 0.5F) * turns.unit;
    const Vec2 move = normal_vector(deviation, random);
    route[i].at = route[i].at + move;
    if (random.unit() < 0.3F && i + 2 < count) route[i + 1].at = route[i + 1].at + move;
    if (random.unit() < 0.2F) vary(route[i], turns, random);
  }
}

}  // namespace krait::detail
