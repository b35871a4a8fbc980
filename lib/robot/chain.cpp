#include "krait/robot/chain.hpp"

#include "krait/robot/box.hpp"

namespace krait {
namespace {

constexpr PidGains kHeadingGains{4.0F, 0.05F, 0.05F};  // radians of steering per radian of heading error
constexpr PidGains kSpeedGains{10.0F, 0.1F, 0.1F};     // m/s^2 per m/s
constexpr float kInside = 1.0F - 1e-5F;                // keeps rounding from carrying a state across its limit
constexpr float kTurnReserve = 1.1F;                   // truck: how much wider than the tightest steady turn
constexpr float kUnfoldRate = 2.0F;                    // truck, 1/s: how fast a hitch may close in on its bound
constexpr float kFoldBound = 1.2F;                     // truck, radians: the hitch angle that steering keeps clear of

float absolute(float x) { return x < 0.0F ? -x : x; }

// Largest |x| on the way from x at `rate` for dt.
float largest(float x, float rate, float dt) {
  const float before = absolute(x);
  const float after = absolute(x + rate * dt);
  return before > after ? before : after;
}

bool positive(float x) { return x > 0.0F && finite(x); }

}  // namespace

Chain::Chain(const ChainParameters& parameters, bool slip) : parameters_(parameters), slip_(slip) {
  for (int k = 0; k < kMaxBodies; ++k) {
    Vec2 corners[4];
    box(parameters.body_length, parameters.body_width, k == 0 ? parameters.body_offset : 0.0F, corners);
    set_body(k, {corners, 4});
  }
}

void Chain::set_body(int k, Polygon polygon) {
  Body& body = bodies_[k];
  body.count = polygon.count <= format::kMaxPieceVertices ? polygon.count : 0;
  for (int i = 0; i < body.count; ++i) body.vertices[i] = polygon[i];
  farthest_[k] = krait::farthest(body.vertices, body.count);
}

bool Chain::sound() const {
  const ChainParameters& p = parameters_;
  return p.trailers >= 0 && p.trailers <= kMaxTrailers && positive(p.body_length) && positive(p.body_width) &&
         finite(p.body_offset) && positive(p.wheelbase) && positive(p.hitch_length) && positive(p.max_speed) &&
         finite(p.min_speed) && p.min_speed <= 0.0F && positive(p.max_steering) && p.max_steering < 0.5F * kPi &&
         positive(p.max_acceleration) && positive(p.max_steering_rate) && p.self_collision_gap >= 1 &&
         positive(p.max_hitch_angle) && p.max_hitch_angle <= kPi;
}

void Chain::rest(Vec2 position, float heading, const float* angles, float* state) const {
  state[0] = position.x;
  state[1] = position.y;
  state[2] = heading;
  state[3] = 0.0F;
  state[4] = 0.0F;
  for (int i = 0; i < parameters_.trailers; ++i) state[5 + i] = angles != nullptr ? angles[i] : heading;
}

// The largest |psi| toward the side of `heading_error`. A snake's tail pulls straight by itself. A truck's folds when
// the turn is tighter than R = d sqrt(N), or when the first hitch closes in on its bound faster than it can recover.
float Chain::steering_limit(StateView s, float heading_error, float speed) const {
  const ChainParameters& p = parameters_;
  if (slip_ || p.trailers == 0) return p.max_steering;
  const auto trailers = static_cast<float>(p.trailers);
  float tangent = p.wheelbase / (kTurnReserve * p.hitch_length * std::sqrt(trailers));
  const float side = heading_error < 0.0F ? -1.0F : 1.0F;
  const float hitch = side * (s[2] - s[5]);
  const float bound = p.max_hitch_angle < kFoldBound ? p.max_hitch_angle : kFoldBound;
  const float recovery = kUnfoldRate * (bound - hitch) / (absolute(speed) > 0.1F ? absolute(speed) : 0.1F);
  const float by_hitch = p.wheelbase * (sin_cos(hitch).sin / p.hitch_length + recovery);
  if (by_hitch < tangent) tangent = by_hitch;
  const float limit = atan2(tangent, 1.0F);
  return limit < p.max_steering ? limit : p.max_steering;
}

void Chain::steer(StateView s, const Target& target, Steering& steering, ControlRef u) const {
  const ChainParameters& p = parameters_;
  const SinCos heading = sin_cos(s[2]);
  const Vec2 to{target.point.x - s[0], target.point.y - s[1]};
  const Vec2 along{heading.cos, heading.sin};
  const bool backward = target.speed < 0.0F;
  const float error = backward ? -atan2(-cross(along, to), -dot(along, to)) : atan2(cross(along, to), dot(along, to));
  const float wanted = steering.heading(kHeadingGains, error, target.dt);
  const float lock = p.max_steering * kInside;
  const float side = steering_limit(s, wanted, s[3]);
  const float psi =
      wanted < 0.0F ? clamp(wanted, -clamp(side, -lock, lock), lock) : clamp(wanted, -lock, clamp(side, -lock, lock));
  u[1] = clamp((clamp(psi, -lock, lock) - s[4]) / target.dt, -p.max_steering_rate, p.max_steering_rate);

  const float set_point = target.speed * (backward ? -p.min_speed : p.max_speed);
  const float push = steering.speed(kSpeedGains, set_point - s[3], target.dt);
  const float gain = clamp(push, -p.max_acceleration, p.max_acceleration);
  const float inset = (1.0F - kInside) * (p.max_speed - p.min_speed);
  const float speed = clamp(s[3] + gain * target.dt, p.min_speed + inset, p.max_speed - inset);
  u[0] = clamp((speed - s[3]) / target.dt, -p.max_acceleration, p.max_acceleration);
}

bool Chain::within_limits(StateView s) const {
  const ChainParameters& p = parameters_;
  if (!(s[3] >= p.min_speed && s[3] <= p.max_speed)) return false;
  if (!(s[4] >= -p.max_steering && s[4] <= p.max_steering)) return false;
  float ahead = s[2];
  for (int i = 5; i < state_size(); ++i) {
    if (!(absolute(ahead - s[i]) <= p.max_hitch_angle && absolute(s[i]) <= kMaxAngle)) return false;
    ahead = s[i];
  }
  return finite(position(s)) && absolute(s[2]) <= kMaxAngle;
}

// Speed and steering are linear in time. A hitch angle that goes from a to b in dt at a rate of at most D reaches at
// most (|a| + |b| + D dt) / 2. The car turns at most at v |psi| / L, the first trailer at v / d; for all others
// |theta(i-1)' - theta(i)'| is at most (v / d) (|sin| + |cos|) of the hitch angle before, so at most sqrt(2) v / d.
bool Chain::keeps_limits(StateView s, ControlView u, float dt, StateView next) const {
  const ChainParameters& p = parameters_;
  const float way = dt * largest(s[3], u[0], dt);
  float change = way * (largest(s[4], u[1], dt) / p.wheelbase + 1.0F / p.hitch_length);
  for (int i = 5; i < state_size(); ++i) {
    const int ahead = i == 5 ? 2 : i - 1;
    const float ends = absolute(s[ahead] - s[i]) + absolute(next[ahead] - next[i]);
    if (!(ends + change <= 2.0F * p.max_hitch_angle)) return false;
    change = 1.4142136F * way / p.hitch_length;
  }
  return true;
}

void Chain::place(StateView s, Pose* poses) const {
  poses[0] = {position(s), sin_cos(s[2])};
  for (int i = 1; i <= parameters_.trailers; ++i) {
    const SinCos own = sin_cos(s[4 + i]);
    const Vec2 hitch = poses[i - 1].position;
    poses[i] = {{hitch.x - parameters_.hitch_length * own.cos, hitch.y - parameters_.hitch_length * own.sin}, own};
  }
}

// With v and psi at most |v|^ and |psi|^ during the step, the rear axle moves at most at v^, the car turns at most at
// v^ |psi|^ / L. Every trailer turns at most at v^ / d. A truck's axles move at most at v^. A snake's axle moves with
// v P e_i - v (1 - cos psi) e_0, where |P| <= 1 and e are unit vectors: the second term is its slip.
float Chain::travel(StateView s, ControlView u, float dt, int k) const {
  const ChainParameters& p = parameters_;
  const float speed = largest(s[3], u[0], dt);
  const float steering = largest(s[4], u[1], dt);
  const float slip = slip_ && k > 0 ? 0.5F * steering * steering : 0.0F;
  const float turn = k == 0 ? steering / p.wheelbase : 1.0F / p.hitch_length;
  return dt * speed * (1.0F + slip + farthest(k) * turn);
}

}  // namespace krait
