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

}  // namespace

Dynamics::Model Dynamics::model_of(const std::string& name) {
  if (name == "snake") return Model::snake;
  if (name == "truck") return Model::truck;
  if (name == "car") return Model::car;
  if (name == "unicycle") return Model::unicycle;
  if (name == "diff_drive") return Model::diff_drive;
  throw InputError("robot: model \"" + name + "\" is none of snake, truck, car, unicycle, diff_drive");
}

Dynamics::Dynamics(const RobotSpec& robot) : model_(model_of(robot.model)) {
  const bool may_have_trailers = model_ == Model::snake || model_ == Model::truck;
  if (robot.links < 0 || robot.links > (may_have_trailers ? kMostTrailers : 0)) {
    throw InputError("robot: " + std::to_string(robot.links) + " links are out of range for " + robot.model);
  }
  trailers_ = static_cast<std::size_t>(robot.links);
  if (robot.bodies.size() != trailers_ + 1) throw InputError("robot: needs one body more than links");
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) check_body(robot.bodies[i], i);
  if (is_car_like()) {
    read_car_like(robot);
  } else if (model_ == Model::unicycle) {
    read_unicycle(robot);
  } else {
    read_diff_drive(robot);
  }
}

void Dynamics::read_car_like(const RobotSpec& robot) {
  state_names_ = {"x", "y", "theta0", "v", "psi"};
  for (std::size_t i = 1; i <= trailers_; ++i) state_names_.push_back("theta" + std::to_string(i));
  wheelbase_ = positive(robot, "wheelbase");
  state_limits_ = {{"speed", minimum_speed(robot, 0), number(robot, "max_speed")},
                   within("steering", number(robot, "max_steering"))};
  control_limits_ = {within("acceleration", number(robot, "max_acceleration")),
                     within("steering rate", number(robot, "max_steering_rate"))};
  if (trailers_ == 0) return;
  hitch_length_ = positive(robot, "hitch_length");
  const double most = number(robot, "max_hitch_angle");
  for (std::size_t i = 1; i <= trailers_; ++i)
    state_limits_.push_back(within("hitch angle " + std::to_string(i), most));
  self_collision_gap_ = static_cast<std::size_t>(std::clamp(number(robot, "self_collision_gap"), 1.0, 1e6));
}

void Dynamics::read_unicycle(const RobotSpec& robot) {
  state_names_ = {"x", "y", "theta"};
  const double max_speed = number(robot, "max_speed");
  control_limits_ = {{"speed", minimum_speed(robot, -max_speed), max_speed},
                     within("turn rate", number(robot, "max_turn_rate"))};
}

void Dynamics::read_diff_drive(const RobotSpec& robot) {
  state_names_ = {"x", "y", "theta", "left wheel speed", "right wheel speed"};
  wheel_radius_ = positive(robot, "wheel_radius");
  track_width_ = positive(robot, "track_width");
  const double max_wheel_speed = number(robot, "max_wheel_speed");
  const double max_speed = wheel_radius_ * max_wheel_speed;
  state_limits_ = {within("left wheel speed", max_wheel_speed),
                   within("right wheel speed", max_wheel_speed),
                   {"speed", minimum_speed(robot, -max_speed), max_speed}};
  const double max_acceleration = number(robot, "max_wheel_acceleration");
  control_limits_ = {within("left wheel acceleration", max_acceleration),
                     within("right wheel acceleration", max_acceleration)};
}

State Dynamics::at_rest(const Point& position, double heading, const std::vector<double>& trailers) const {
  State state(state_size(), 0.0);
  state[0] = position.x;
  state[1] = position.y;
  state[2] = heading;
  for (std::size_t i = 0; i < trailers_; ++i) state[5 + i] = i < trailers.size() ? trailers[i] : heading;
  return state;
}

double Dynamics::speed(const State& state) const {
  if (model_ == Model::unicycle) return 0;
  if (model_ == Model::diff_drive) return wheel_radius_ * std::max(std::abs(state[3]), std::abs(state[4]));
  return std::abs(state[3]);
}

State Dynamics::derivative(const State& state, const Control& control) const {
  State rate(state.size(), 0.0);
  set_rate(state, control, rate);
  return rate;
}

void Dynamics::set_rate(const State& state, const Control& control, State& rate) const {
  double speed = 0;  // of the axle in the middle of frame 0
  if (model_ == Model::unicycle) {
    speed = control[0];
    rate[2] = control[1];
  } else if (model_ == Model::diff_drive) {
    speed = wheel_radius_ * (state[3] + state[4]) / 2;
    rate[2] = wheel_radius_ * (state[4] - state[3]) / track_width_;
    rate[3] = control[0];
    rate[4] = control[1];
  } else {
    const double front_speed = state[3];
    speed = front_speed * std::cos(state[4]);
    rate[2] = front_speed * std::sin(state[4]) / wheelbase_;
    rate[3] = control[0];
    rate[4] = control[1];
    double pull = (model_ == Model::snake ? front_speed : speed) / hitch_length_;
    double ahead = state[2];
    for (std::size_t i = 5; i < state.size(); ++i) {
      const double bend = ahead - state[i];
      ahead = state[i];
      rate[i] = pull * std::sin(bend);
      pull *= std::cos(bend);
    }
  }
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
    const double cos = std::cos(state[5 + i]);
    const double sin = std::sin(state[5 + i]);
    const Point hitch = frames.back().origin;
    frames.push_back({{hitch.x - hitch_length_ * cos, hitch.y - hitch_length_ * sin}, cos, sin});
  }
  return frames;
}

std::vector<double> Dynamics::limited_values(const State& state) const {
  if (model_ == Model::unicycle) return {};
  if (model_ == Model::diff_drive) return {state[3], state[4], wheel_radius_ * (state[3] + state[4]) / 2};
  std::vector<double> values{state[3], state[4]};
  for (std::size_t i = 5; i < state.size(); ++i) {
    const double ahead = i == 5 ? state[2] : state[i - 1];
    values.push_back(std::remainder(ahead - state[i], 2 * std::numbers::pi));
  }
  return values;
}

}  // namespace krait::host
