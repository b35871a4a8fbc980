// SPDX-License-Identifier: Apache-2.0
#include "robot/pushing.hpp"

#include <algorithm>
#include <cmath>

namespace krait::detail {
namespace {

// What is off in a hitch fades by e to this in a hitch length. Measured: bench/ABLATIONS.md, "Trucks dock".
constexpr float kFading = 3.0F;
// The others were found by driving, and are part of the models: lib/robot/TRUCK.md, "Reverse".
constexpr float kNear = 0.75F;       // hitch lengths a body: a point that is nearer counts as if it were so far away
constexpr float kSharpest = 1.5F;    // hitch lengths: radius of the last trailer's sharpest turn
constexpr float kLockShare = 0.75F;  // of the lock and of the hitches' bound, that a steady turn takes
constexpr float kShortest = 0.02F;   // hitch lengths of a step: gains are those of one that is at least so long
constexpr float kLongest = 1.0F;     // and no longer
constexpr float kBack = 8.0F;        // hitch lengths within which the last trailer comes back to a line

float square(float x) { return x * x; }

float hitch_sine(const Pose* poses, int k) { return (poses[k - 1].heading - poses[k].heading).sin; }

// 1/m: the sharpest that the last trailer may turn for long, so that wheels and hitches keep a share to correct
// it.
float sharpest_turn(const Train& train) {
  const SinCos lock = math::sin_cos(train.most_steering);
  const SinCos hitch = math::sin_cos(kLockShare * train.most_hitch);
  const float d = train.hitch_length;
  float squared = square(kSharpest * d);
  const float by_wheels =
      square(train.wheelbase * lock.cos / (kLockShare * lock.sin)) - static_cast<float>(train.trailers) * d * d;
  if (by_wheels > squared) squared = by_wheels;
  const float by_hitch = hitch.cos > 0.0F ? square(d * hitch.cos / hitch.sin) : 0.0F;
  if (by_hitch > squared) squared = by_hitch;
  return 1.0F / std::sqrt(squared);
}

// 1/m: turns the last trailer away from the point, at a rate by the sine of the angle that remains; at the sharpest
// where the point is not behind. Where the point is `near` metres away it is the circle through axle and point.
float wanted_turn(const Train& train, const Pose& tail, Vec2 point) {
  const float sharpest = sharpest_turn(train);
  const Vec2 to = point - tail.position;
  const Vec2 along{tail.heading.cos, tail.heading.sin};
  const float aside = cross(along, to);
  if (dot(along, to) > 0.0F) return aside < 0.0F ? -sharpest : sharpest;
  const float near = kNear * static_cast<float>(1 + train.trailers) * train.hitch_length;
  const float far = length(to);
  return math::clamp(2.0F * aside / (near * std::max(near, far)), -sharpest, sharpest);
}

// 1/m: by how much the turn may differ from that of now. Where all hitches are off by as much, the wheels answer with
// 1 - (-kFading)^N times that (find_gains, for short steps), and take it back within a hitch length by kFading N. They
// have their lock for it, and what they can swing.
float agility(const Train& train, const Wheels& wheels) {
  const SinCos lock = math::sin_cos(train.most_steering);
  const float most = lock.sin / lock.cos;
  const float swing = wheels.swing * train.hitch_length / (kFading * static_cast<float>(train.trailers));
  float answer = 1.0F;
  for (int i = 0; i < train.trailers; ++i) answer = -kFading * answer;
  return std::min(most, swing) / (train.wheelbase * math::absolute(1.0F - answer));
}

// 1/m: what the last trailer shall turn by now, on the way to what is wanted.
float next_turn(const Train& train, const Pose* poses, const Wheels& wheels, Vec2 point) {
  const float now = hitch_sine(poses, train.trailers) / train.hitch_length;
  const float most = agility(train, wheels);
  return math::clamp(wanted_turn(train, poses[train.trailers], point), now - most, now + most);
}

// A power series in a shift, as far as three hitches need it.
struct Series {
  float terms[kMostPushed];
};

Series operator*(const Series& a, const Series& b) {
  Series product{};
  for (int i = 0; i < kMostPushed; ++i) {
    for (int j = 0; i + j < kMostPushed; ++j) product.terms[i + j] = product.terms[i + j] + a.terms[i] * b.terms[j];
  }
  return product;
}

Series operator/(Series a, const Series& b) {
  for (int i = 0; i < kMostPushed; ++i) {
    a.terms[i] = a.terms[i] / b.terms[0];
    for (int j = 1; i + j < kMostPushed; ++j) a.terms[i + j] = a.terms[i + j] - a.terms[i] * b.terms[j];
  }
  return a;
}

// e^x - 1, of x from -3 to 1, to a millionth of it.
float growth(float x) {
  float sum = 1.0F;
  for (int k = 16; k > 1; --k) sum = 1.0F + x / static_cast<float>(k) * sum;
  return x * sum;
}

// The gains by which the wheels answer to each hitch, so that in a step of h hitch lengths all of them fade alike. A
// hitch length backwards changes the first hitch x(1) by itself less the change of the wheels, and x(k) by itself less
// x(k - 1), to first order. With S the shift from a hitch to the next and a = e^h, a step takes them to a e^(-hS) x,
// and the wheels add -(a e^(-hS) - 1) / (1 - S) of their change to the first. So Ackermann's formula for N poles at
// p = e^(-h kFading) has the coefficients of (1 - S) (a e^(-hS) - p)^N / (a e^(-hS) - 1), times 1 + hS / 2 where N is
// 3, divided by (-a h)^(N - 1), that of the last hitch first. With one trailer it is (a - p) / (a - 1).
void find_gains(int trailers, float h, float* gains) {
  const float e = growth(h);
  const float a = 1.0F + e;
  const Series grown{{e, -a * h, 0.5F * a * h * h}};
  Series factor = grown;
  factor.terms[0] = e - growth(-kFading * h);
  Series all{{1.0F, -1.0F, 0.0F}};
  for (int i = 0; i < trailers; ++i) all = all * factor;
  if (trailers == 3) all = all * Series{{1.0F, 0.5F * h, 0.0F}};
  all = all / grown;
  float scale = 1.0F;
  for (int i = 1; i < trailers; ++i) scale = scale / (-a * h);
  for (int i = 0; i < trailers; ++i) gains[trailers - 1 - i] = scale * all.terms[i];
}

// The change of the wheels' tangent, in wheelbases by hitch length, for hitches whose sines are off by off[0], off[1],
// … from those of a motion, from which the tangent is off by `change`.
float fading_change(const Train& train, const Wheels& wheels, float change, const float* off) {
  const float d = train.hitch_length;
  float gains[kMostPushed];
  find_gains(train.trailers, math::clamp(wheels.way / d, kShortest, kLongest), gains);
  const float soon = wheels.lag / d;
  float before = change;
  float sum = 0.0F;
  for (int k = 0; k < train.trailers; ++k) {
    sum = sum + gains[k] * (off[k] + soon * (off[k] - before));
    before = off[k];
  }
  return sum;
}

}  // namespace

// All axles of a steady turn go round one point, so that with the last trailer's curvature K the one that is j hitches
// ahead of it has the squared radius 1 / K^2 + j d^2, and the sine of the hitch behind it is d by that radius.
float pushing_tangent(const Train& train, const Pose* poses, const Wheels& wheels, Vec2 point) {
  const int n = train.trailers;
  const float scale = train.wheelbase / train.hitch_length;
  const float turn = train.hitch_length * next_turn(train, poses, wheels, point);
  const auto steady = [turn](int ahead) { return turn / std::sqrt(1.0F + static_cast<float>(ahead) * turn * turn); };
  float off[kMostPushed];
  for (int k = 1; k <= n; ++k) off[k - 1] = hitch_sine(poses, k) - steady(n - k + 1);
  return scale * (steady(n) + fading_change(train, wheels, wheels.tangent / scale - steady(n), off));
}

// The last trailer turns to the reference's line, and toward it where it is beside it; its hitches follow that turn.
float pushing_correction(const Train& train, const Pose* poses, const Pose* reference, const Wheels& wheels) {
  const int n = train.trailers;
  const float d = train.hitch_length;
  const float scale = train.wheelbase / d;
  const Pose& line = reference[n];
  const float sideways = cross({line.heading.cos, line.heading.sin}, poses[n].position - line.position);
  const float wanted = sideways / (kBack * d) - (poses[n].heading - line.heading).sin;
  const float turn = -4.0F * wanted / kBack;
  float off[kMostPushed];
  for (int k = 1; k <= n; ++k) off[k - 1] = hitch_sine(poses, k) - hitch_sine(reference, k) - turn;
  return scale * (turn + fading_change(train, wheels, wheels.tangent / scale - turn, off));
}

}  // namespace krait::detail
