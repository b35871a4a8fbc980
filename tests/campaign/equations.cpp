// SPDX-License-Identifier: Apache-2.0
#include "equations.hpp"

#include <cmath>

namespace krait::campaign {
namespace {

// How far x lies beyond [low, high], as a share of `size`.
double beyond(double x, double low, double high, double size) { return std::max(low - x, x - high) / size; }

double largest(double a, double b) { return std::max(std::abs(a), std::abs(b)); }

}  // namespace

Equations::Equations(const Robot& robot) : model_(robot.model), state_size_(3), bodies_(robot.bodies()) {
  const auto number = [](float x) { return static_cast<double>(x); };
  if (model_ == Model::unicycle) {
    max_speed_ = number(robot.unicycle.max_speed);
    min_speed_ = number(robot.unicycle.min_speed);
    max_second_ = number(robot.unicycle.max_turn_rate);
  } else if (model_ == Model::unicycle2) {
    state_size_ = 5;
    max_speed_ = number(robot.unicycle2.max_speed);
    min_speed_ = number(robot.unicycle2.min_speed);
    max_turn_rate_ = number(robot.unicycle2.max_turn_rate);
    max_first_ = number(robot.unicycle2.max_acceleration);
    max_second_ = number(robot.unicycle2.max_turn_acceleration);
  } else if (model_ == Model::kinematic_truck) {
    const KinematicTruckParameters& p = robot.kinematic;
    state_size_ = 3 + robot.trailers();
    gap_ = p.self_collision_gap;
    max_hitch_ = number(p.max_hitch_angle);
    wheelbase_ = number(p.wheelbase);
    hitch_length_ = number(p.hitch_length);
    max_speed_ = number(p.max_speed);
    min_speed_ = number(p.min_speed);
    max_second_ = number(p.max_steering);
  } else if (model_ == Model::diff_drive) {
    state_size_ = 5;
    radius_ = number(robot.drive.wheel_radius);
    track_ = number(robot.drive.track_width);
    max_speed_ = number(robot.drive.max_wheel_speed);
    max_first_ = max_second_ = number(robot.drive.max_wheel_acceleration);
  } else {
    state_size_ = 5 + robot.trailers();
    gap_ = robot.chain.self_collision_gap;
    max_hitch_ = number(robot.chain.max_hitch_angle);
    wheelbase_ = number(robot.chain.wheelbase);
    hitch_length_ = number(robot.chain.hitch_length);
    max_speed_ = number(robot.chain.max_speed);
    min_speed_ = number(robot.chain.min_speed);
    max_steering_ = number(robot.chain.max_steering);
    max_first_ = number(robot.chain.max_acceleration);
    max_second_ = number(robot.chain.max_steering_rate);
  }
}

bool Equations::is_angle(std::size_t i) const {
  const bool steering = i == 4 && max_steering_ > 0;
  return i == 2 || i >= static_cast<std::size_t>(state_size_ - bodies_ + 1) || steering;
}

void Equations::rates(const State& s, const double* u, State& ds) const {
  if (model_ == Model::unicycle) {
    ds[0] = u[0] * std::cos(s[2]);
    ds[1] = u[0] * std::sin(s[2]);
    ds[2] = u[1];
  } else if (model_ == Model::unicycle2) {
    ds[0] = s[3] * std::cos(s[2]);
    ds[1] = s[3] * std::sin(s[2]);
    ds[2] = s[4];
    ds[3] = u[0];
    ds[4] = u[1];
  } else if (model_ == Model::kinematic_truck) {
    kinematic_rates(s, u, ds);
  } else if (model_ == Model::diff_drive) {
    const double speed = radius_ * (s[3] + s[4]) / 2;
    ds[0] = speed * std::cos(s[2]);
    ds[1] = speed * std::sin(s[2]);
    ds[2] = radius_ * (s[4] - s[3]) / track_;
    ds[3] = u[0];
    ds[4] = u[1];
  } else {
    chain_rates(s, u, ds);
  }
}

// A bicycle that rolls at u[0] with its front wheel turned by u[1]. Each axle is pulled along the one before it.
void Equations::kinematic_rates(const State& s, const double* u, State& ds) const {
  ds[0] = u[0] * std::cos(s[2]);
  ds[1] = u[0] * std::sin(s[2]);
  ds[2] = u[0] * std::tan(u[1]) / wheelbase_;
  double speed = u[0];
  for (std::size_t i = 3; i < static_cast<std::size_t>(state_size_); ++i) {
    const double bend = s[i - 1] - s[i];
    ds[i] = speed * std::sin(bend) / hitch_length_;
    speed *= std::cos(bend);
  }
}

// The paper's Eqn 1 with the hitch angle in the sine (LaValle 13.1.2.3). v is the front wheel's speed; the snake's
// trailers are pulled at v, those of a truck at its rear axle's v cos psi.
void Equations::chain_rates(const State& s, const double* u, State& ds) const {
  double cosine = std::cos(s[2]), sine = std::sin(s[2]);
  const double rear = s[3] * std::cos(s[4]);
  ds[0] = rear * cosine;
  ds[1] = rear * sine;
  ds[2] = s[3] * std::sin(s[4]) / wheelbase_;
  ds[3] = u[0];
  ds[4] = u[1];
  double pull = (model_ == Model::snake ? s[3] : rear) / hitch_length_;
  for (std::size_t i = 5; i < static_cast<std::size_t>(state_size_); ++i) {
    const double c = std::cos(s[i]), n = std::sin(s[i]);
    ds[i] = pull * (sine * c - cosine * n);
    pull *= cosine * c + sine * n;
    cosine = c;
    sine = n;
  }
}

void Equations::place(const State& s, Frames& frames) const {
  frames[0] = {s[0], s[1], std::cos(s[2]), std::sin(s[2])};
  for (int k = 1; k < bodies_; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double heading = s[heading_of(k)], c = std::cos(heading), n = std::sin(heading);
    frames[i] = {frames[i - 1].x - hitch_length_ * c, frames[i - 1].y - hitch_length_ * n, c, n};
  }
}

void Equations::reach(const State& a, const Frames& at_a, const State& b, const Frames& at_b, const double* u,
                      double time, Reaches& reaches) const {
  if (model_ == Model::unicycle) {
    reaches[0] = {time * std::abs(u[0]), time * std::abs(u[1])};
  } else if (model_ == Model::unicycle2) {
    reaches[0] = {time * largest(a[3], b[3]), time * largest(a[4], b[4])};
  } else if (model_ == Model::kinematic_truck) {
    const double way = time * std::abs(u[0]);
    reaches[0] = {way, way * std::abs(std::tan(u[1])) / wheelbase_};
    trailer_reach(at_a, at_b, way, way, reaches);
  } else if (model_ == Model::diff_drive) {
    reaches[0] = {time * radius_ * largest(a[3] + a[4], b[3] + b[4]) / 2,
                  time * radius_ * largest(a[4] - a[3], b[4] - b[3]) / track_};
  } else {
    chain_reach(a, at_a, b, at_b, time, reaches);
  }
}

// v and psi are linear in time. With phi the hitch angle before it, a trailer's heading changes at most at
// (|v| / d) |sin phi|. The way that phi goes from a to b is at most T, the turn of the body ahead, and the trailer's
// own; so |sin phi| exceeds the larger of those at a and b by at most half of that:
// turn <= r (sine + (T + turn) / 2), r = |v| time / d.
// A truck's axles move along themselves, at most at |v|. A snake's trailer i, e the unit vectors along the bodies and P
// the product of the hitch angles' cosines, moves with v P e_i - v (1 - cos psi) e_0: by induction, since its hitch
// moves with the like of i - 1, whose part along e_(i-1) is v P_(i-1), and it turns by what of that is across e_i.
void Equations::chain_reach(const State& a, const Frames& at_a, const State& b, const Frames& at_b, double time,
                            Reaches& reaches) const {
  const double way = time * largest(a[3], b[3]);
  const double steering = largest(a[4], b[4]);
  const double slip = model_ == Model::snake ? 1 - std::cos(steering) : 0;
  reaches[0] = {way, way * std::min(steering, 1.0) / wheelbase_};
  trailer_reach(at_a, at_b, way, way * (1 + slip), reaches);
}

// Of trailers that are pulled `way` metres and go `path` metres at most.
void Equations::trailer_reach(const Frames& at_a, const Frames& at_b, double way, double path, Reaches& reaches) const {
  const double r = way / hitch_length_;
  const auto sine = [](const Frames& f, std::size_t i) {
    return std::abs(f[i - 1].sin * f[i].cos - f[i - 1].cos * f[i].sin);
  };
  for (std::size_t i = 1; i < static_cast<std::size_t>(bodies_); ++i) {
    double turn = r;
    if (r < 1) {
      const double ends = std::max(sine(at_a, i), sine(at_b, i));
      turn = std::min(r, r * (ends + reaches[i - 1].turn / 2) / (1 - r / 2));
    }
    reaches[i] = {path, turn};
  }
}

double Equations::excess(const State& s, const double* u) const {
  if (model_ == Model::unicycle || model_ == Model::kinematic_truck) {
    return std::max(beyond(u[0], min_speed_, max_speed_, max_speed_),
                    beyond(u[1], -max_second_, max_second_, max_second_));
  }
  const double controls =
      std::max(beyond(u[0], -max_first_, max_first_, max_first_), beyond(u[1], -max_second_, max_second_, max_second_));
  if (model_ == Model::unicycle2) {
    return std::max({controls, beyond(s[3], min_speed_, max_speed_, max_speed_),
                     beyond(s[4], -max_turn_rate_, max_turn_rate_, max_turn_rate_)});
  }
  if (model_ == Model::diff_drive) {
    return std::max({controls, beyond(s[3], -max_speed_, max_speed_, max_speed_),
                     beyond(s[4], -max_speed_, max_speed_, max_speed_)});
  }
  return std::max({controls, beyond(s[3], min_speed_, max_speed_, max_speed_),
                   beyond(s[4], -max_steering_, max_steering_, max_steering_)});
}

}  // namespace krait::campaign
