// SPDX-License-Identifier: Apache-2.0
#include "krait/robots/chain.hpp"

#include <algorithm>

#include "base/lanes/angles.hpp"
#include "robot/front_wheels.hpp"
#include "robot/limits.hpp"
#include "robot/shape.hpp"
#include "robot/tracking.hpp"
#include "robot/trailers.hpp"

namespace krait {

using detail::deviation;
using detail::farthest;
using detail::inside;
using detail::kInside;
using detail::kSteeringGains;
using detail::positive;
using detail::recoverable_tangent;
using detail::rest_trailers;
using detail::steady_tangent;
using detail::straightenable;
using detail::trailer_rates;
using detail::wheel_correction;
using detail::WheelCorrection;
using detail::wheels_error;
using detail::within_lock;

namespace {

// m/s^2 per m/s of speed error. Found by driving, and part of the models: lib/robot/SNAKE.md, "Steering".
constexpr PidGains kSpeedGains{10.0F, 0.1F, 0.1F};

// Radians: how far below their limit the tree's hitch angles stay, several times what a step is off by, so that a plan,
// which is driven a little beside the tree, keeps the limit: keeps_reserve of RobotModel.
constexpr float kHitchReserve = 2e-3F;
// Radians: more than a Runge-Kutta step of the tree is off by; lemma 6 of CHAIN.md. And what that is for as many angles
// as there may be trailers, in the Euclidean norm; lemma 11.
constexpr float kHitchError = 3e-4F;
constexpr float kNormError = 5.0F * kHitchError;
static_assert(5 * 5 >= kMaxTrailers);
// Times 1 + |heading|: what the float of a heading and its sine are taken to be off by; lib/DESIGN.md, "Integration",
// on pushed trailers.
constexpr float kRounding = 4e-8F;
// Lemmas 10 to 13 of CHAIN.md hold for r below this, where 2 - 2 r is far from 0. Longer steps are bounded by travel.
constexpr float kMostReach = 0.9F;
// How much the steering rate counts among the rates of the dynamics; lib/DESIGN.md, "Integration".
constexpr float kSteeringShare = 0.75F;

// Largest |x| on the way from x at `rate` for dt.
float largest(float x, float rate, float dt) {
  const float before = math::absolute(x);
  const float after = math::absolute(x + rate * dt);
  return std::max(after, before);
}

// Returns at most the cosine of x, which lies between 0 and pi; 0 where the cosine could be negative.
float least_cosine(float x) {
  const float z = x * x;
  const float cosine = 1.0F - z * (0.5F - z * (1.0F / 24.0F - z * (1.0F / 720.0F)));
  return x < 1.57F && cosine > 0.0F ? cosine : 0.0F;
}

// How many bodies a state has, or its leading part.
int bodies_of(const StateView& s) { return static_cast<int>(s.size()) + 1 - Chain::kCarState; }

// e^x to a hundredth for x from -4 to 4.
float exponential(float x) {
  const float part = x / 32.0F;
  float power = 1.0F + part + 0.5F * part * part;
  for (int squaring = 0; squaring < 5; ++squaring) power = power * power;
  return power;
}

// Rarely wanted, so not inlined.
[[gnu::noinline]] SinCos any_sin_cos(float angle) { return math::sin_cos(angle); }

constexpr int kStages = Chain::Lead::kStages;

// How far into a step of dt the rates of a stage hold, and what all of them add.
float until(int stage, float dt) { return stage == kStages - 1 ? dt : 0.5F * dt; }
float increment(float first, float second, float third, float fourth, float dt) {
  return dt / 6.0F * ((first + fourth) + 2.0F * (second + third));
}

[[gnu::always_inline]] inline SinCos known_hitch(const Pose* poses, int k) {
  return poses[k].heading - poses[k + 1].heading;
}

// How trailers turn, all stages of one before the next: each depends on what is ahead of it only. `little` is ahead's.
template <bool little>
void integrate_by_bodies(const float* headings, int trailers, const Pose* poses, float dt, Chain::Lead ahead,
                         float* turns) {
  for (int k = 0; k < trailers; ++k) {
    const SinCos known = known_hitch(poses, k);
    const float heading = headings[k];
    const float first = ahead.pull[0] * known.sin;
    ahead.pull[0] = ahead.pull[0] * known.cos;
    // Returns the trailer's rate, and makes it what is ahead of the next.
    const auto stage = [&](int i, float rate) __attribute__((always_inline)) {
      const float own = (heading + until(i, dt) * rate) - heading;
      const float change = ahead.turn[i] - own;
      const SinCos hitch = known + (little ? math::small_sin_cos(change) : any_sin_cos(change));
      ahead.turn[i] = own;
      const float pull = ahead.pull[i];
      ahead.pull[i] = pull * hitch.cos;
      return pull * hitch.sin;
    };
    const float second = stage(1, first);
    const float third = stage(2, second);
    turns[k] = increment(first, second, third, stage(3, third), dt);
  }
}

#ifdef KRAIT_LANES
struct Hitches {
  float sines[kMaxTrailers];
  float cosines[kMaxTrailers];
  SinCos operator()(int k) const { return {sines[k], cosines[k]}; }
};

// The same bits, several trailers at a time, all of them before the next stage. For little changes.
void integrate_by_stages(const float* headings, int trailers, const Pose* poses, float dt, const Chain::Lead& lead,
                         float* turns) {
  Hitches known;
  for (int k = 0; k < trailers; ++k) {
    const SinCos hitch = known_hitch(poses, k);
    known.sines[k] = hitch.sin;
    known.cosines[k] = hitch.cos;
  }
  float rates[kStages][kMaxTrailers];
  trailer_rates(lead.pull[0], trailers, known, rates[0]);
  for (int stage = 1; stage < kStages; ++stage) {
    float turned[1 + kMaxTrailers];
    turned[0] = lead.turn[stage];
    for (int k = 0; k < trailers; ++k) {
      turned[1 + k] = (headings[k] + until(stage, dt) * rates[stage - 1][k]) - headings[k];
    }
    Hitches hitches;
    detail::lanes::turn_hitches({trailers, turned, known.sines, known.cosines}, hitches.sines, hitches.cosines);
    trailer_rates(lead.pull[stage], trailers, hitches, rates[stage]);
  }
  for (int k = 0; k < trailers; ++k) turns[k] = increment(rates[0][k], rates[1][k], rates[2][k], rates[3][k], dt);
}
#endif

}  // namespace

Chain::Chain(const ChainParameters& parameters, bool slip)
    : parameters_(parameters), least_hitch_cosine_(math::sin_cos(parameters.max_hitch_angle).cos), slip_(slip) {
  if (parameters.trailers < 0 || parameters.trailers > kMaxTrailers) parameters_.trailers = -1;
  for (int k = 0; k < kMaxBodies; ++k) {
    Vec2 corners[4];
    rectangle(parameters.body_length, parameters.body_width, k == 0 ? parameters.body_offset : 0.0F, corners);
    set_body(k, {corners, 4});
  }
}

void Chain::set_body(int k, Polygon polygon) {
  KRAIT_ASSERT(k >= 0 && k < kMaxBodies);
  Body& body = bodies_[k];
  body.count = polygon.count <= kMaxVertices ? polygon.count : 0;
  for (int i = 0; i < body.count; ++i) body.vertices[i] = polygon[i];
}

bool Chain::sound() const {
  const ChainParameters& p = parameters_;
  return p.trailers >= 0 && p.trailers <= kMaxTrailers && positive(p.body_length) && positive(p.body_width) &&
         finite(p.body_offset) && positive(p.wheelbase) && positive(p.hitch_length) && positive(p.max_speed) &&
         finite(p.min_speed) && p.min_speed <= 0.0F && p.max_steering > 0.0F &&
         p.max_steering <= ChainParameters::kMostSteering && positive(p.max_acceleration) &&
         positive(p.max_steering_rate) && p.self_collision_gap >= 1 && p.max_hitch_angle > 0.0F &&
         p.max_hitch_angle <= ChainParameters::kMostHitch;
}

void Chain::rest(Vec2 position, float heading, const float* angles, float* state) const {
  state[0] = position.x;
  state[1] = position.y;
  state[2] = heading;
  state[3] = 0.0F;
  state[4] = 0.0F;
  rest_trailers(heading, angles, parameters_.trailers, state + kCarState);
}

// The largest |psi| toward the side of `heading_error`. A snake's tail pulls straight by itself. A truck's folds when
// the turn is tighter than R = d sqrt(N), or when the first hitch closes in on its bound faster than it can recover.
float Chain::steering_limit(StateView s, float heading_error, float speed) const {
  const ChainParameters& p = parameters_;
  if (slip_ || p.trailers == 0) return p.max_steering;
  float tangent = steady_tangent(p);
  const float side = heading_error < 0.0F ? -1.0F : 1.0F;
  const float by_hitch = recoverable_tangent(p, side * (s[2] - s[5]), speed);
  if (by_hitch < tangent) tangent = by_hitch;
  const float limit = math::atan2(tangent, 1.0F);
  return std::min(p.max_steering, limit);
}

void Chain::steer(StateView s, const Target& target, Steering& steering, ControlRef u) const {
  const Pose at{position(s), math::sin_cos(s[2])};
  steer(s, &at, target, steering, u);
}

void Chain::steer(StateView s, const Pose* poses, const Target& target, Steering& steering, ControlRef u) const {
  const ChainParameters& p = parameters_;
  const float error = wheels_error(s, poses[0].heading, target.point, backs(s, target));
  const float asked = steering.heading(kSteeringGains, error, target.dt);
  const float wanted = straightenable(asked, error, {s[4], s[3], p.wheelbase, p.max_steering_rate, target.dt});
  const float lock = p.max_steering * kInside * target.turn;
  turn_and_drive(s, within_lock(wanted, steering_limit(s, wanted, s[3]), lock), target, steering, u);
}

void Chain::turn_and_drive(StateView s, float psi, const Target& target, Steering& steering, ControlRef u) const {
  const ChainParameters& p = parameters_;
  const float lock = p.max_steering * kInside * target.turn;
  const float set_point = target.speed * (target.speed < 0.0F ? -p.min_speed : p.max_speed);
  const float push = steering.speed(kSpeedGains, set_point - s[3], target.dt);
  const float gain = math::clamp(push, -p.max_acceleration, p.max_acceleration);
  const float speed = target.speed == 0.0F ? 0.0F : s[3] + gain * target.dt;
  approach(s, speed, math::clamp(psi, -lock, lock), target.dt, u);
}

float Chain::turning_radius() const {
  const ChainParameters& p = parameters_;
  const SinCos lock = math::sin_cos(p.max_steering);
  const float steered = p.wheelbase * lock.cos / lock.sin;
  if (p.trailers == 0) return steered;
  const float followed =
      slip_ ? p.hitch_length : kTurnReserve * p.hitch_length * std::sqrt(static_cast<float>(p.trailers));
  return std::max(followed, steered);
}

// The rear axle's, with the steering angle held.
float Chain::stopping_way(StateView s) const {
  return 0.5F * s[3] * math::absolute(s[3]) / parameters_.max_acceleration * math::sin_cos(s[4]).cos;
}

void Chain::approach(StateView s, float speed, float psi, float dt, ControlRef u) const {
  const ChainParameters& p = parameters_;
  const float lock = p.max_steering * kInside;
  u[0] = math::clamp((inside(speed, p.min_speed, p.max_speed) - s[3]) / dt, -p.max_acceleration, p.max_acceleration);
  u[1] = math::clamp((math::clamp(psi, -lock, lock) - s[4]) / dt, -p.max_steering_rate, p.max_steering_rate);
}

void Chain::track(StateView s, StateView reference, float dt, ControlRef u) const {
  const ChainParameters& p = parameters_;
  const float speed = reference[3];
  const WheelCorrection change = wheel_correction(deviation(s, reference), speed, p.wheelbase, dt);
  approach(s, speed + u[0] * dt + change.speed, reference[4] + u[1] * dt + change.steering, dt, u);
}

// Carries errors on to first order, with the rates of the step's middle speed. With phi the hitch angle before trailer
// k and p the pull on it, its heading's error e changes at p cos phi (ahead - e) + sin phi dp, where `ahead` is the
// error of the heading before it, and dp that of the pull, the speed times the cosines of the hitch angles ahead. What
// a step rounds is added on the side where the error is.
float Chain::carry_errors(StateView s, const Pose* poses, ControlView u, float dt, float* errors) const {
  const float d = parameters_.hitch_length;
  const float speed = (s[3] + 0.5F * u[0] * dt) / d;
  const float worst = (math::absolute(s[3]) + math::absolute(u[0]) * dt) / d;
  float share = 1.0F;  // of the speed, that pulls
  float share_error = 0.0F;
  float ahead = kRounding * (1.0F + math::absolute(s[2]));
  float shifted = 0.0F;  // metres, of the hitch
  float off = 0.0F;
  for (int k = 0; k < parameters_.trailers; ++k) {
    const SinCos hitch = known_hitch(poses, k);
    float& error = errors[kCarState + k];
    const float before = error;
    const float fading = speed * share * hitch.cos;
    const float growth = exponential(-fading * dt);
    const float time = math::absolute(fading * dt) < 1e-3F ? dt : (1.0F - growth) / fading;
    const float rounded = kRounding * (1.0F + math::absolute(s[kCarState + k])) * math::absolute(share) * worst * dt;
    error = before * growth + (fading * ahead + speed * hitch.sin * share_error) * time;
    error = error < 0.0F ? error - rounded : error + rounded;
    const float middle = 0.5F * (before + error);
    share_error = hitch.cos * share_error - share * hitch.sin * (ahead - middle);
    share = share * hitch.cos;
    ahead = middle;
    const Body& body = bodies_[1 + k];
    shifted = shifted + d * math::absolute(error);
    const float corner = shifted + farthest(body.vertices, body.count) * math::absolute(error);
    off = std::max(off, corner);
  }
  return off;
}

bool Chain::within_limits(StateView s) const { return within(s, parameters_.max_hitch_angle); }

bool Chain::keeps_reserve(StateView s) const { return within(s, parameters_.max_hitch_angle - kHitchReserve); }

[[gnu::flatten]] bool Chain::within(StateView s, float most_hitch) const {
  const ChainParameters& p = parameters_;
  if (!(s[3] >= p.min_speed && s[3] <= p.max_speed)) return false;
  if (!(s[4] >= -p.max_steering && s[4] <= p.max_steering)) return false;
  if (!hitches_within(s, most_hitch)) return false;
  constexpr float kMaxHeading = kMaxAngle - kPi * static_cast<float>(1 + kMaxTrailers);
  return finite(position(s)) && math::absolute(s[2]) <= kMaxHeading;
}

bool Chain::hitches_within(StateView s, float most) const {
  const int size = state_size();
  float ahead = s[2];
  for (int i = kCarState; i < size; ++i) {
    if (!(math::absolute(ahead - s[i]) <= most)) return false;
    ahead = s[i];
  }
  return true;
}

float Chain::fastest_rate(float dt) const {
  const ChainParameters& p = parameters_;
  const float arm = p.trailers > 0 ? std::min(p.wheelbase, p.hitch_length) : p.wheelbase;
  const float speed = detail::fastest(p);
  const float acceleration = std::min(p.max_acceleration, (p.max_speed - p.min_speed) / dt);
  const float steering = std::min(p.max_steering_rate, 2.0F * p.max_steering / dt);
  const float rates[] = {speed / arm, std::sqrt(acceleration / arm), kSteeringShare * steering};
  float most = 0.0F;
  for (const float rate : rates) most = std::max(most, rate);
  return most;
}

void Chain::place(StateView s, Pose* poses) const {
  const int bodies = bodies_of(s);
  const float d = parameters_.hitch_length;
  poses[0] = {position(s), math::sin_cos(s[2])};
  turn_to(s.data() + 5, bodies - 1, poses + 1);
  Vec2 hitch = poses[0].position;
  for (int i = 1; i < bodies; ++i) {
    const SinCos heading = poses[i].heading;
    hitch = {hitch.x - d * heading.cos, hitch.y - d * heading.sin};
    poses[i].position = hitch;
  }
}

Chain::CarRates Chain::car_rates(float speed, SinCos steering) const {
  const float axle_speed = speed * steering.cos;
  return {axle_speed, speed * steering.sin / parameters_.wheelbase,
          (slip_ ? speed : axle_speed) / parameters_.hitch_length};
}

void Chain::derivative(StateView s, ControlView u, StateRef ds) const {
  const CarRates car = car_rates(s[3], math::sin_cos(s[4]));
  const SinCos heading = math::sin_cos(s[2]);
  ds[0] = car.speed * heading.cos;
  ds[1] = car.speed * heading.sin;
  ds[2] = car.turn;
  ds[3] = u[0];
  ds[4] = u[1];
  const auto hitch = [s](int k) { return math::sin_cos((k == 0 ? s[2] : s[4 + k]) - s[5 + k]); };
  trailer_rates(car.pull, bodies_of(s) - 1, hitch, ds.data() + kCarState);
}

// Whether no angle of the dynamics changes by more than kSmallAngle. A hitch angle does at most at
// (s / d) |sin a - cos a sin b| <= sqrt(2) s / d, a and b two in a row; the first, ahead of which the car turns, at
// most as fast as that turns and s / d.
bool Chain::changes_little(const float* s, const float* u, float dt) const {
  const float way = dt * largest(s[3], u[0], dt);
  const float steering = largest(s[4], u[1], dt);
  const float turn = way * std::min(1.0F, steering) / parameters_.wheelbase;
  const float reach = way / parameters_.hitch_length;
  return 1.42F * reach <= kSmallAngle && turn + reach <= kSmallAngle && dt * math::absolute(u[1]) <= kSmallAngle;
}

// The frames of `s` are known: turning a known sine and cosine by the little that the angle changes costs less than
// finding new ones. Speed and steering angle change at constant rates, and are the same in both stages in the middle.
[[gnu::flatten]] void Chain::integrate_lead(StateView s, const Pose* poses, ControlView u, float dt, Lead& lead,
                                            float* d) const {
  const SinCos heading = poses[0].heading;
  const SinCos steering = math::sin_cos(s[4]);
  const bool little = changes_little(s.data(), u.data(), dt);
  const auto turn = [little](float angle) { return little ? math::small_sin_cos(angle) : any_sin_cos(angle); };
  const auto after = [&](float time) {
    return car_rates(s[3] + time * u[0], steering + turn((s[4] + time * u[1]) - s[4]));
  };
  const float half = 0.5F * dt;
  const CarRates first = car_rates(s[3], steering);
  const CarRates middle = after(half);
  const CarRates last = after(dt);
  lead = {
      {0.0F, (s[2] + half * first.turn) - s[2], (s[2] + half * middle.turn) - s[2], (s[2] + dt * middle.turn) - s[2]},
      {first.pull, middle.pull, middle.pull, last.pull},
      little};
  const SinCos second = heading + turn(lead.turn[1]);
  const SinCos third = heading + turn(lead.turn[2]);
  const SinCos fourth = heading + turn(lead.turn[3]);
  const float speed = middle.speed;
  d[0] = increment(first.speed * heading.cos, speed * second.cos, speed * third.cos, last.speed * fourth.cos, dt);
  d[1] = increment(first.speed * heading.sin, speed * second.sin, speed * third.sin, last.speed * fourth.sin, dt);
  d[2] = increment(first.turn, middle.turn, middle.turn, last.turn, dt);
  d[3] = increment(u[0], u[0], u[0], u[0], dt);
  d[4] = increment(u[1], u[1], u[1], u[1], dt);
}

[[gnu::flatten]] void Chain::integrate_rest(StateView s, const Pose* poses, float dt, const Lead& lead,
                                            float* d) const {
  const int trailers = bodies_of(s) - 1;
  const float* const headings = s.data() + kCarState;
  float* const turns = d + kCarState;
#ifdef KRAIT_LANES
  if (lead.little && trailers >= detail::lanes::kLeastAngles) {
    return integrate_by_stages(headings, trailers, poses, dt, lead, turns);
  }
#endif
  lead.little ? integrate_by_bodies<true>(headings, trailers, poses, dt, lead, turns)
              : integrate_by_bodies<false>(headings, trailers, poses, dt, lead, turns);
}

// The lemmas are those of CHAIN.md; the factor 0.125 is lemma 1's.
bool Chain::travel(StateView s, ControlView u, float dt, StateView next, Travel* travel) const {
  const ChainParameters& p = parameters_;
  const float way = dt * largest(s[3], u[0], dt);
  const float steering = largest(s[4], u[1], dt);
  const float slip = slip_ ? 0.5F * steering * steering : 0.0F;
  const float speeding = dt * dt * math::absolute(u[0]);       // |dv| dt
  const float veering = steering * dt * math::absolute(u[1]);  // |d cos psi|
  const float pulled = speeding + way * veering;               // of s
  const float turn = way * steering / p.wheelbase;             // lemma 2
  const float turning = (speeding * steering + way * dt * math::absolute(u[1])) / p.wheelbase;
  // Lemmas 2 and 3.
  travel[0] = {way, turn, 0.125F * (pulled + way * turn), 0.125F * (turning + turn * turn)};
  // Lemma 4.
  const float dragged = way + way * slip;
  const float slipping = speeding * slip + way * slip * turn;
  const float reach = way / p.hitch_length;  // how far a trailer turns that is pulled sideways
  float folding = 0.0F;                      // |dP|
  bool kept = true;
  for (int i = 1; i < body_count(); ++i) {
    const int ahead = i == 1 ? 2 : 3 + i;
    const float turn_ahead = travel[i - 1].turn;
    const float ends = math::absolute(s[ahead] - s[4 + i]) + math::absolute(next[ahead] - next[4 + i]) + turn_ahead;
    float hitch = 0.5F * (ends + reach);  // lemma 5, and in the next lines
    if (hitch < 1.0F) hitch = ends / (2.0F - reach);
    kept = kept && hitch <= p.max_hitch_angle;
    const float sine = std::min(1.0F, hitch + kHitchError);
    const float own_turn = reach * sine;  // lemma 6
    // Lemma 8, with the sum of lemma 7 as far as the trailer ahead.
    const float twisting = ((pulled + way * folding) * sine + way * (turn_ahead + own_turn)) / p.hitch_length;
    folding = folding + sine * (turn_ahead + own_turn);                    // lemma 7
    const float bending = pulled + way * (folding + own_turn) + slipping;  // lemma 9
    travel[i] = {dragged, own_turn, 0.125F * bending, 0.125F * (twisting + own_turn * own_turn)};
  }
  return kept;
}

// The bounds of travel for all bodies alike, by the lemmas of CHAIN.md.
[[gnu::flatten]] QuickBound Chain::quick_bound(StateView s, ControlView u, float dt, StateView next) const {
  const ChainParameters& p = parameters_;
  const float way = dt * largest(s[3], u[0], dt);
  const float steering = largest(s[4], u[1], dt);
  const float car_turn = way * steering / p.wheelbase;
  const float reach = way / p.hitch_length;
  if (!(reach < kMostReach)) return {};
  float most = 0.0F;
  float squares = 0.0F;
  float high = s[2] + next[2];
  float low = high;
  float before = s[2];
  float after = next[2];
  const int size = state_size();
  for (int i = 5; i < size; ++i) {
    const float ends = math::absolute(before - s[i]) + math::absolute(after - next[i]);
    before = s[i];
    after = next[i];
    const float sum = before + after;
    most = std::max(most, ends);
    squares = squares + ends * ends;
    high = std::max(high, sum);
    low = std::min(low, sum);
  }
  const float first = (most + car_turn) / (2.0F - reach);  // lemma 10: of the first hitch, and of the others
  const float rest = most / (2.0F - 2.0F * reach);
  const float hitch = std::max(rest, first) + kHitchError;
  const float sine = std::min(1.0F, hitch);
  const float turn = std::max(reach * sine, car_turn);
  // Lemma 11.
  const float norm = (std::sqrt(squares) + car_turn) / (2.0F - 2.0F * reach) + kNormError;

  const float slip = slip_ ? 0.5F * steering * steering : 0.0F;
  const float speeding = dt * dt * math::absolute(u[0]);
  const float pulled = speeding + way * steering * dt * math::absolute(u[1]);
  const float turning = (speeding * steering + way * dt * math::absolute(u[1])) / p.wheelbase;
  // Lemma 12 bounds the folding of lemmas 8 and 9.
  const float swaying = pulled + way * norm * (2.0F * reach * norm + car_turn);
  const float twisting = (swaying * sine + 2.0F * way * turn) / p.hitch_length;
  const float bending = swaying + way * turn + slip * (speeding + way * turn);
  return {hitch <= p.max_hitch_angle,
          separation(hitch, 0.5F * (high - low) + turn),
          {way + way * slip, turn, 0.125F * bending, 0.125F * (std::max(turning, twisting) + turn * turn)}};
}

// Lemma 13 of CHAIN.md.
float Chain::separation(float hitch, float spread) const {
  const auto gap = static_cast<float>(parameters_.self_collision_gap);
  const float near = least_cosine(0.5F * std::min(spread, gap * hitch)) * gap;
  const float far = least_cosine(0.5F * spread) * (gap * hitch < spread ? spread / hitch : gap);
  return parameters_.hitch_length * std::min(far, near);
}

}  // namespace krait
