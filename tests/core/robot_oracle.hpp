// SPDX-License-Identifier: Apache-2.0
// The robots' dynamics and placement in double precision, written from the formulas of lib/DESIGN.md, and all that
// typed tests need of every model: instances, random states and controls.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "draws.hpp"
#include "krait/krait.hpp"
#include "motion/rk4.hpp"

namespace krait::test {

using Numbers = std::vector<double>;

struct Frame {
  double x, y, angle;
};

inline double wide(float x) { return static_cast<double>(x); }

// A car of rear axle (x, y) with front wheels `wheelbase` ahead that roll at v, and trailers whose turn is
// (s/d) sin(hitch) times the cosines of the hitches before; s is v (slip) or the rear axle's speed.
inline Numbers chain_rate(const ChainParameters& p, bool slip, const Numbers& s, const Numbers& u) {
  const double v = s[3], psi = s[4];
  Numbers rate = {v * std::cos(s[2]) * std::cos(psi), v * std::sin(s[2]) * std::cos(psi),
                  v * std::sin(psi) / wide(p.wheelbase), u[0], u[1]};
  for (std::size_t i = 5; i < s.size(); ++i) {
    double product = (slip ? v : v * std::cos(psi)) / wide(p.hitch_length);
    for (std::size_t j = 5; j < i; ++j) product *= std::cos((j == 5 ? s[2] : s[j - 1]) - s[j]);
    rate.push_back(product * std::sin((i == 5 ? s[2] : s[i - 1]) - s[i]));
  }
  return rate;
}

inline Numbers rate(const Snake& r, const Numbers& s, const Numbers& u) {
  return chain_rate(r.parameters(), true, s, u);
}
inline Numbers rate(const Truck& r, const Numbers& s, const Numbers& u) {
  return chain_rate(r.parameters(), false, s, u);
}
inline Numbers rate(const KinematicTruck& r, const Numbers& s, const Numbers& u) {
  const KinematicTruckParameters& p = r.parameters();
  Numbers rate = {u[0] * std::cos(s[2]), u[0] * std::sin(s[2]), u[0] * std::tan(u[1]) / wide(p.wheelbase)};
  double pull = u[0] / wide(p.hitch_length);
  for (std::size_t i = 3; i < s.size(); ++i) {
    rate.push_back(pull * std::sin(s[i - 1] - s[i]));
    pull *= std::cos(s[i - 1] - s[i]);
  }
  return rate;
}
inline Numbers rate(const Unicycle&, const Numbers& s, const Numbers& u) {
  return {u[0] * std::cos(s[2]), u[0] * std::sin(s[2]), u[1]};
}
inline Numbers rate(const Unicycle2&, const Numbers& s, const Numbers& u) {
  return {s[3] * std::cos(s[2]), s[3] * std::sin(s[2]), s[4], u[0], u[1]};
}
inline Numbers rate(const DifferentialDrive& r, const Numbers& s, const Numbers& u) {
  const double radius = wide(r.parameters().wheel_radius), track = wide(r.parameters().track_width);
  const double left = radius * s[3], right = radius * s[4];  // rim speeds
  return {(left + right) / 2 * std::cos(s[2]), (left + right) / 2 * std::sin(s[2]), (right - left) / track, u[0], u[1]};
}

// Whether a robot of that class may have trailers, whose headings follow the kCarState floats of its car.
template <class R>
inline constexpr bool kTows = std::is_base_of_v<Chain, R> || std::is_same_v<R, KinematicTruck>;

// Axles of a chain, each hitched `hitch_length` behind the one before.
template <class R>
requires kTows<R> std::vector<Frame> frames(const R& r, const Numbers& s) {
  std::vector<Frame> result = {{s[0], s[1], s[2]}};
  for (std::size_t i = R::kCarState; i < s.size(); ++i) {
    const double d = wide(r.parameters().hitch_length);
    result.push_back({result.back().x - d * std::cos(s[i]), result.back().y - d * std::sin(s[i]), s[i]});
  }
  return result;
}
inline std::vector<Frame> frames(const PlanarBody&, const Numbers& s) { return {{s[0], s[1], s[2]}}; }

template <class R>
Numbers rk4(const R& robot, const Numbers& s, const Numbers& u, double dt) {
  const auto ahead = [&](const Numbers& slope, double t) {
    Numbers result = s;
    for (std::size_t i = 0; i < s.size(); ++i) result[i] += t * slope[i];
    return result;
  };
  const Numbers k1 = rate(robot, s, u), k2 = rate(robot, ahead(k1, dt / 2), u), k3 = rate(robot, ahead(k2, dt / 2), u),
                k4 = rate(robot, ahead(k3, dt), u);
  Numbers result = s;
  for (std::size_t i = 0; i < s.size(); ++i) result[i] += dt / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  return result;
}

// A body's vertices in the workspace.
inline std::vector<Numbers> vertices(Polygon body, const Frame& frame) {
  std::vector<Numbers> result;
  const double c = std::cos(frame.angle), s = std::sin(frame.angle);
  for (int i = 0; i < body.count; ++i) {
    const double x = wide(body[i].x), y = wide(body[i].y);
    result.push_back({frame.x + c * x - s * y, frame.y + s * x + c * y});
  }
  return result;
}

template <class R>
std::vector<R> instances();

// Snakes, trucks and the like; every second one has other dimensions, and turns its wheels by less.
template <class R>
std::vector<R> chains(std::initializer_list<int> trailers, float max_steering = 0.6F) {
  std::vector<R> result;
  for (const int n : trailers) {
    typename R::Parameters p;
    p.trailers = n;
    result.emplace_back(p);
    p.body_length = 1.5F;
    p.body_width = 0.9F;
    p.body_offset = 0.4F;
    p.wheelbase = 1.1F;
    p.hitch_length = 1.7F;
    p.min_speed = -1.5F;
    p.max_steering = max_steering;
    result.emplace_back(p);
  }
  return result;
}
template <>
inline std::vector<Snake> instances<Snake>() {
  return chains<Snake>({0, 1, 4, 15, 25});
}
template <>
inline std::vector<Truck> instances<Truck>() {
  return chains<Truck>({0, 1, 2, 5, 25});
}
template <>
inline std::vector<Car> instances<Car>() {
  return chains<Car>({0, 3});  // a car has no trailers whatever it is given
}
template <>
inline std::vector<KinematicTruck> instances<KinematicTruck>() {
  return chains<KinematicTruck>({0, 1, 2, 5, 25}, 1.1F);
}
template <>
inline std::vector<Unicycle> instances<Unicycle>() {
  UnicycleParameters slow;
  slow.max_speed = 0.25F;
  slow.min_speed = 0.0F;
  return {Unicycle({}), Unicycle(slow)};
}
// dynobench's machine, which takes two seconds to its top speed and to its largest turn rate.
inline Unicycle2Parameters sluggish() {
  Unicycle2Parameters p;
  p.max_speed = 0.5F;
  p.min_speed = -0.5F;
  p.max_turn_rate = 0.5F;
  p.max_acceleration = 0.25F;
  p.max_turn_acceleration = 0.25F;
  return p;
}
template <>
inline std::vector<Unicycle2> instances<Unicycle2>() {
  Unicycle2Parameters slow = sluggish();
  slow.min_speed = 0.0F;
  return {Unicycle2({}), Unicycle2(slow)};
}
template <>
inline std::vector<DifferentialDrive> instances<DifferentialDrive>() {
  DifferentialDriveParameters wide_track;
  wide_track.track_width = 1.2F;
  wide_track.wheel_radius = 0.2F;
  return {DifferentialDrive({}), DifferentialDrive(wide_track)};
}

// With its defaults, and so many trailers where its class may have any.
template <class R>
R default_robot([[maybe_unused]] int trailers) {
  typename R::Parameters p = defaults_of<R>();
  if constexpr (kTows<R>) p.trailers = trailers;
  return R(p);
}

// AllRobots<Each>::call(visit) calls visit.operator()<R>() for the class R of every model.
template <class... Robots>
struct Each {
  template <class Visit>
  static void call(const Visit& visit) {
    (visit.template operator()<Robots>(), ...);
  }
};

// Chains, or the like, that fit through a door of 2 m.
template <class P = ChainParameters>
P small_chain(int trailers) {
  P p;
  p.trailers = trailers;
  p.body_length = 0.4F;
  p.body_width = 0.3F;
  p.wheelbase = 0.4F;
  p.hitch_length = 0.45F;
  return p;
}

// A robot that does.
template <class R>
R small_robot();
template <>
inline Snake small_robot<Snake>() {
  return Snake(small_chain(3));
}
template <>
inline Truck small_robot<Truck>() {
  ChainParameters p = small_chain(1);
  p.min_speed = -0.5F;
  return Truck(p);
}
template <>
inline Car small_robot<Car>() {
  ChainParameters p = small_chain(0);
  p.body_length = 0.6F;
  return Car(p);
}
template <>
inline KinematicTruck small_robot<KinematicTruck>() {
  auto p = small_chain<KinematicTruckParameters>(1);
  p.min_speed = -0.5F;
  return KinematicTruck(p);
}
template <>
inline Unicycle small_robot<Unicycle>() {
  return Unicycle({});
}
template <>
inline Unicycle2 small_robot<Unicycle2>() {
  return Unicycle2({});
}
template <>
inline DifferentialDrive small_robot<DifferentialDrive>() {
  return DifferentialDrive({});
}

inline float log_uniform(std::mt19937& random, double low, double high) {
  return static_cast<float>(std::exp(wide(uniform_float(random, std::log(low), std::log(high)))));
}

// A robot of any parameters that matter to its motion.
template <class R>
R random_robot(std::mt19937& random) {
  if constexpr (kTows<R>) {
    constexpr bool kAccelerates = std::is_base_of_v<Chain, R>;
    typename R::Parameters p;
    p.trailers = static_cast<int>(below(random, 26));
    p.wheelbase = log_uniform(random, 0.05, 5);
    p.hitch_length = log_uniform(random, 0.05, 5);
    p.max_speed = log_uniform(random, 0.05, 20);
    p.min_speed = below(random, 2) == 0 ? 0.0F : -p.max_speed;
    if constexpr (kAccelerates) p.max_acceleration = log_uniform(random, 0.05, 50);
    p.max_steering = log_uniform(random, 0.05, 1.5);
    if constexpr (kAccelerates) p.max_steering_rate = log_uniform(random, 0.05, 50);
    return R(p);
  } else if constexpr (std::is_same_v<R, Unicycle>) {
    UnicycleParameters p;
    p.max_speed = log_uniform(random, 0.05, 20);
    p.min_speed = uniform_float(random, -1, 1) * p.max_speed;
    p.max_turn_rate = log_uniform(random, 0.05, 50);
    return R(p);
  } else if constexpr (std::is_same_v<R, Unicycle2>) {
    Unicycle2Parameters p;
    p.max_speed = log_uniform(random, 0.05, 20);
    p.min_speed = below(random, 2) == 0 ? 0.0F : -p.max_speed;
    p.max_turn_rate = log_uniform(random, 0.05, 50);
    p.max_acceleration = log_uniform(random, 0.05, 50);
    p.max_turn_acceleration = log_uniform(random, 0.05, 500);
    return R(p);
  } else {
    static_assert(std::is_same_v<R, DifferentialDrive>);
    DifferentialDriveParameters p;
    p.wheel_radius = log_uniform(random, 0.01, 1);
    p.track_width = log_uniform(random, 0.05, 3);
    p.max_wheel_speed = log_uniform(random, 0.5, 200);
    p.max_wheel_acceleration = log_uniform(random, 0.5, 2000);
    return R(p);
  }
}

// Metres a second, of the position.
inline double largest_speed(const Chain& robot) { return wide(robot.parameters().max_speed); }
inline double largest_speed(const KinematicTruck& robot) { return wide(robot.parameters().max_speed); }
inline double largest_speed(const Unicycle& robot) { return wide(robot.parameters().max_speed); }
inline double largest_speed(const Unicycle2& robot) { return wide(robot.parameters().max_speed); }
inline double largest_speed(const DifferentialDrive& robot) {
  return wide(robot.parameters().wheel_radius) * wide(robot.parameters().max_wheel_speed);
}

using Models = AllRobots<::testing::Types>;

struct ModelNames {
  template <class R>
  static std::string GetName(int) {
#define KRAIT_NAME(name, Class, file, trailers) \
  if (std::is_same_v<R, Class>) return #name;
    KRAIT_MODELS(KRAIT_NAME)
#undef KRAIT_NAME
    return "";
  }
};

// A state inside its limits, sometimes at their very ends; the position within `area` of the origin.
template <class R>
requires kTows<R> std::vector<float> random_state(const R& r, std::mt19937& random, double area = 10) {
  const auto& p = r.parameters();
  const auto limited = [&](float low, float high) {
    const std::uint32_t kind = below(random, 8);
    return kind == 0 ? low : kind == 1 ? high : std::clamp(uniform_float(random, wide(low), wide(high)), low, high);
  };
  std::vector<float> s = {uniform_float(random, -area, area), uniform_float(random, -area, area),
                          uniform_float(random, -4, 4)};
  if constexpr (std::is_base_of_v<Chain, R>) {
    s.push_back(limited(p.min_speed, p.max_speed));
    s.push_back(limited(-p.max_steering, p.max_steering));
  }
  for (int i = 0; i < p.trailers; ++i) {
    const float ahead = i == 0 ? s[2] : s.back();
    s.push_back(ahead + 0.999F * limited(-p.max_hitch_angle, p.max_hitch_angle));
  }
  return s;
}

struct Range {
  float low, high;
};

// Of what a state has behind position and heading.
inline std::vector<Range> motion_limits(const Unicycle&) { return {}; }
inline std::vector<Range> motion_limits(const Unicycle2& r) {
  const Unicycle2Parameters& p = r.parameters();
  return {{p.min_speed, p.max_speed}, {-p.max_turn_rate, p.max_turn_rate}};
}
inline std::vector<Range> motion_limits(const DifferentialDrive& r) {
  const float most = r.parameters().max_wheel_speed;
  return {{-most, most}, {-most, most}};
}

template <class R>
requires std::derived_from<R, PlanarBody> std::vector<float> random_state(const R& r, std::mt19937& random,
                                                                          double area = 10) {
  std::vector<float> s = {uniform_float(random, -area, area), uniform_float(random, -area, area),
                          uniform_float(random, -4, 4)};
  for (const Range range : motion_limits(r)) s.push_back(uniform_float(random, wide(range.low), wide(range.high)));
  return s;
}

inline std::vector<Range> control_limits(const Chain& r) {
  const ChainParameters& p = r.parameters();
  return {{-p.max_acceleration, p.max_acceleration}, {-p.max_steering_rate, p.max_steering_rate}};
}
inline std::vector<Range> control_limits(const KinematicTruck& r) {
  const KinematicTruckParameters& p = r.parameters();
  return {{p.min_speed, p.max_speed}, {-p.max_steering, p.max_steering}};
}
inline std::vector<Range> control_limits(const Unicycle& r) {
  const UnicycleParameters& p = r.parameters();
  return {{p.min_speed, p.max_speed}, {-p.max_turn_rate, p.max_turn_rate}};
}
inline std::vector<Range> control_limits(const Unicycle2& r) {
  const Unicycle2Parameters& p = r.parameters();
  return {{-p.max_acceleration, p.max_acceleration}, {-p.max_turn_acceleration, p.max_turn_acceleration}};
}
inline std::vector<Range> control_limits(const DifferentialDrive& r) {
  const float most = r.parameters().max_wheel_acceleration;
  return {{-most, most}, {-most, most}};
}

// A control inside its limits such that a step of dt seconds keeps the state inside its own.
template <class R>
std::vector<float> random_control(const R& robot, const std::vector<float>& state, float dt, std::mt19937& random) {
  std::vector<float> u;
  for (const Range range : control_limits(robot)) u.push_back(uniform_float(random, wide(range.low), wide(range.high)));
  if constexpr (std::is_base_of_v<Chain, R>) {
    const ChainParameters& p = robot.parameters();
    u[0] = math::clamp(u[0], (p.min_speed - state[3]) / dt, (p.max_speed - state[3]) / dt);
    u[1] = math::clamp(u[1], (-p.max_steering - state[4]) / dt, (p.max_steering - state[4]) / dt);
  }
  if constexpr (std::is_same_v<R, Unicycle2>) {
    const std::vector<Range> limits = motion_limits(robot);
    for (std::size_t i = 0; i < 2; ++i)
      u[i] = math::clamp(u[i], (limits[i].low - state[3 + i]) / dt, (limits[i].high - state[3 + i]) / dt);
  }
  if constexpr (std::is_same_v<R, DifferentialDrive>) {
    const float most = robot.parameters().max_wheel_speed;
    for (std::size_t i = 0; i < 2; ++i)
      u[i] = math::clamp(u[i], (-most - state[3 + i]) / dt, (most - state[3 + i]) / dt);
  }
  return u;
}

inline Numbers doubles(const std::vector<float>& values) { return Numbers(values.begin(), values.end()); }

template <class R>
std::vector<float> derivative(const R& robot, const std::vector<float>& s, const std::vector<float>& u) {
  std::vector<float> ds(s.size());
  robot.derivative(StateView(s.data(), robot.state_size()), ControlView(u.data(), robot.control_size()),
                   StateRef(ds.data(), robot.state_size()));
  return ds;
}

// The robot's own bounds on a step, and whether it proves that the limits hold in it.
struct Bounds {
  bool limits_kept;
  std::vector<Travel> bodies;
};

template <class R>
Bounds bounds_of(const R& robot, const std::vector<float>& s, const std::vector<float>& u, float dt,
                 const std::vector<float>& next) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Bounds bounds{false, std::vector<Travel>(static_cast<std::size_t>(robot.body_count()), Travel{nan, nan, nan, nan})};
  bounds.limits_kept =
      robot.travel(StateView(s.data(), robot.state_size()), ControlView(u.data(), robot.control_size()), dt,
                   StateView(next.data(), robot.state_size()), bounds.bodies.data());
  return bounds;
}

template <class R>
std::vector<float> step(const R& robot, const std::vector<float>& s, const std::vector<float>& u, float dt) {
  std::vector<float> next(s.size());
  detail::propagate(robot, s.data(), u.data(), dt, next.data());
  return next;
}

}  // namespace krait::test
