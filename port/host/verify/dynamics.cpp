// SPDX-License-Identifier: Apache-2.0
#include "host/verify/dynamics.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <numbers>

namespace krait::host {
namespace {

constexpr int kMostTrailers = 25;

double number(const RobotSpec& robot, const std::string& name) {
  const auto found = robot.parameters.find(name);
  if (found == robot.parameters.end()) throw InputError("robot: parameter \"" + name + "\" is missing");
  if (!std::isfinite(found->second)) throw InputError("robot: parameter \"" + name + "\" is not a finite number");
  return found->second;
}

double positive(const RobotSpec& robot, const std::string& name) {
  const double value = number(robot, name);
  if (value <= 0) throw InputError("robot: parameter \"" + name + "\" must be greater than 0");
  return value;
}

double minimum_speed(const RobotSpec& robot, double otherwise) {
  return robot.parameters.contains("min_speed") ? number(robot, "min_speed") : otherwise;
}

Limit within(const std::string& name, double most) { return {name, -most, most}; }

void check_body(const Ring& body, std::size_t index) {
  const bool finite =
      std::all_of(body.begin(), body.end(), [](const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
  if (body.size() < 3) throw InputError("robot: body " + std::to_string(index) + " has fewer than 3 corners");
  if (!finite) throw InputError("robot: body " + std::to_string(index) + " has a corner that is not finite");
}

// How fast the headings of trailers change, which begin with component `first`, and are pulled at `pull` radians a
// second.
void follow(const State& state, std::size_t first, double pull, State& rate) {
  double ahead = state[2];
  for (std::size_t i = first; i < state.size(); ++i) {
    const double bend = ahead - state[i];
    ahead = state[i];
    rate[i] = pull * std::sin(bend);
    pull *= std::cos(bend);
  }
}

// The hitch angles, from the front, behind `values`; trailers' headings begin with component `first`.
std::vector<double> with_hitches(std::vector<double> values, const State& state, std::size_t first) {
  double ahead = state[2];
  for (std::size_t i = first; i < state.size(); ++i) {
    values.push_back(std::remainder(ahead - state[i], 2 * std::numbers::pi));
    ahead = state[i];
  }
  return values;
}

void add_trailers(const RobotSpec& robot, Equations& e) {
  if (robot.links == 0) return;
  e.hitch_length = positive(robot, "hitch_length");
  const double most = number(robot, "max_hitch_angle");
  for (int i = 1; i <= robot.links; ++i) e.state_limits.push_back(within("hitch angle " + std::to_string(i), most));
  e.self_collision_gap = static_cast<std::size_t>(std::clamp(number(robot, "self_collision_gap"), 1.0, 1e6));
}

// Trailers that slip are pulled at the front wheels' speed, others at the rear axle's.
Equations chain(const RobotSpec& robot, bool slip) {
  Equations e;
  e.state_names = {"x", "y", "theta0", "v", "psi"};
  e.state_limits = {{"speed", minimum_speed(robot, 0), number(robot, "max_speed")},
                    within("steering", number(robot, "max_steering"))};
  e.control_limits = {within("acceleration", number(robot, "max_acceleration")),
                      within("steering rate", number(robot, "max_steering_rate"))};
  e.angles = {4};
  add_trailers(robot, e);
  e.motion = [slip, wheelbase = positive(robot, "wheelbase"), hitch_length = e.hitch_length](
                 const State& state, const Control& control, State& rate) {
    const double front_speed = state[3];
    const double speed = front_speed * std::cos(state[4]);
    rate[2] = front_speed * std::sin(state[4]) / wheelbase;
    rate[3] = control[0];
    rate[4] = control[1];
    if (state.size() > 5) follow(state, 5, (slip ? front_speed : speed) / hitch_length, rate);
    return speed;
  };
  e.speed = [](const State& state) { return std::abs(state[3]); };
  e.values = [](const State& state) { return with_hitches({state[3], state[4]}, state, 5); };
  return e;
}

Equations snake(const RobotSpec& robot) { return chain(robot, true); }
Equations truck(const RobotSpec& robot) { return chain(robot, false); }

Equations kinematic_truck(const RobotSpec& robot) {
  Equations e;
  e.state_names = {"x", "y", "theta0"};
  e.control_limits = {{"speed", minimum_speed(robot, 0), number(robot, "max_speed")},
                      within("steering", number(robot, "max_steering"))};
  add_trailers(robot, e);
  e.motion = [wheelbase = positive(robot, "wheelbase"), hitch_length = e.hitch_length](
                 const State& state, const Control& control, State& rate) {
    rate[2] = control[0] * std::tan(control[1]) / wheelbase;
    if (state.size() > 3) follow(state, 3, control[0] / hitch_length, rate);
    return control[0];
  };
  e.speed = [](const State&) { return 0.0; };
  e.values = [](const State& state) { return with_hitches({}, state, 3); };
  return e;
}

Equations unicycle(const RobotSpec& robot) {
  Equations e;
  e.state_names = {"x", "y", "theta"};
  const double max_speed = number(robot, "max_speed");
  e.control_limits = {{"speed", minimum_speed(robot, -max_speed), max_speed},
                      within("turn rate", number(robot, "max_turn_rate"))};
  e.motion = [](const State&, const Control& control, State& rate) {
    rate[2] = control[1];
    return control[0];
  };
  e.speed = [](const State&) { return 0.0; };
  e.values = [](const State&) { return std::vector<double>{}; };
  return e;
}

Equations unicycle2(const RobotSpec& robot) {
  Equations e;
  e.state_names = {"x", "y", "theta", "v", "omega"};
  const double max_speed = number(robot, "max_speed");
  e.state_limits = {{"speed", minimum_speed(robot, -max_speed), max_speed},
                    within("turn rate", number(robot, "max_turn_rate"))};
  e.control_limits = {within("acceleration", number(robot, "max_acceleration")),
                      within("turn acceleration", number(robot, "max_turn_acceleration"))};
  e.motion = [](const State& state, const Control& control, State& rate) {
    rate[2] = state[4];
    rate[3] = control[0];
    rate[4] = control[1];
    return state[3];
  };
  e.speed = [reach = positive(robot, "body_length") / 2](const State& state) {
    return std::max(std::abs(state[3]), reach * std::abs(state[4]));
  };
  e.values = [](const State& state) { return std::vector<double>{state[3], state[4]}; };
  return e;
}

Equations diff_drive(const RobotSpec& robot) {
  Equations e;
  e.state_names = {"x", "y", "theta", "left wheel speed", "right wheel speed"};
  const double radius = positive(robot, "wheel_radius");
  const double max_wheel_speed = number(robot, "max_wheel_speed");
  const double max_speed = radius * max_wheel_speed;
  e.state_limits = {within("left wheel speed", max_wheel_speed),
                    within("right wheel speed", max_wheel_speed),
                    {"speed", minimum_speed(robot, -max_speed), max_speed}};
  const double max_acceleration = number(robot, "max_wheel_acceleration");
  e.control_limits = {within("left wheel acceleration", max_acceleration),
                      within("right wheel acceleration", max_acceleration)};
  e.motion = [radius, track_width = positive(robot, "track_width")](const State& state, const Control& control,
                                                                    State& rate) {
    rate[2] = radius * (state[4] - state[3]) / track_width;
    rate[3] = control[0];
    rate[4] = control[1];
    return radius * (state[3] + state[4]) / 2;
  };
  e.speed = [radius](const State& state) { return radius * std::max(std::abs(state[3]), std::abs(state[4])); };
  e.values = [radius](const State& state) {
    return std::vector<double>{state[3], state[4], radius * (state[3] + state[4]) / 2};
  };
  return e;
}

struct Model {
  const char* name;
  int most_trailers;
  Equations (*equations)(const RobotSpec& robot);
};
constexpr Model kModels[] = {{"snake", kMostTrailers, snake},
                             {"truck", kMostTrailers, truck},
                             {"kinematic_truck", kMostTrailers, kinematic_truck},
                             {"car", 0, truck},
                             {"unicycle", 0, unicycle},
                             {"unicycle2", 0, unicycle2},
                             {"diff_drive", 0, diff_drive}};

const Model& model_of(const std::string& name) {
  std::string names;
  for (const Model& model : kModels) {
    if (name == model.name) return model;
    names += (names.empty() ? "" : ", ") + std::string(model.name);
  }
  throw InputError("robot: model \"" + name + "\" is none of " + names);
}

}  // namespace

Dynamics::Dynamics(const RobotSpec& robot) {
  const Model& model = model_of(robot.model);
  if (robot.links < 0 || robot.links > model.most_trailers) {
    throw InputError("robot: " + std::to_string(robot.links) + " links are out of range for " + robot.model);
  }
  trailers_ = static_cast<std::size_t>(robot.links);
  if (robot.bodies.size() != trailers_ + 1) throw InputError("robot: needs one body more than links");
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) check_body(robot.bodies[i], i);
  equations_ = model.equations(robot);
  front_size_ = equations_.state_names.size();
  for (std::size_t i = 1; i <= trailers_; ++i) equations_.state_names.push_back("theta" + std::to_string(i));
}

State Dynamics::at_rest(const Point& position, double heading, const std::vector<double>& trailers) const {
  State state(state_size(), 0.0);
  state[0] = position.x;
  state[1] = position.y;
  state[2] = heading;
  for (std::size_t i = 0; i < trailers_; ++i) state[front_size_ + i] = i < trailers.size() ? trailers[i] : heading;
  return state;
}

bool Dynamics::is_angle(std::size_t index) const {
  const std::vector<std::size_t>& angles = equations_.angles;
  return is_heading(index) || std::find(angles.begin(), angles.end(), index) != angles.end();
}

State Dynamics::derivative(const State& state, const Control& control) const {
  State rate(state.size(), 0.0);
  set_rate(state, control, rate);
  return rate;
}

void Dynamics::set_rate(const State& state, const Control& control, State& rate) const {
  const double speed = equations_.motion(state, control, rate);
  rate[0] = speed * std::cos(state[2]);
  rate[1] = speed * std::sin(state[2]);
}

std::vector<State> Dynamics::integrate(const State& state, const Control& control, double time,
                                       std::size_t count) const {
  boost::numeric::odeint::runge_kutta_fehlberg78<State> stepper;
  const auto system = [&](const State& at, State& rate, double) { set_rate(at, control, rate); };
  const double step = time / static_cast<double>(count);
  std::vector<State> states{state};
  for (std::size_t i = 0; i < count; ++i) {
    State next(state.size());
    stepper.do_step(system, states.back(), 0.0, next, step);
    states.push_back(std::move(next));
  }
  return states;
}

std::vector<Frame> Dynamics::frames(const State& state) const {
  std::vector<Frame> frames{{{state[0], state[1]}, std::cos(state[2]), std::sin(state[2])}};
  for (std::size_t i = 0; i < trailers_; ++i) {
    const double cos = std::cos(state[front_size_ + i]);
    const double sin = std::sin(state[front_size_ + i]);
    const Point hitch = frames.back().origin;
    frames.push_back({{hitch.x - equations_.hitch_length * cos, hitch.y - equations_.hitch_length * sin}, cos, sin});
  }
  return frames;
}

}  // namespace krait::host
