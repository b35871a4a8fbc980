#include "host/verify/dynamics.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
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
  max_speed_ = number(robot, "max_speed");
  min_speed_ = minimum_speed(robot, 0);
  max_steering_ = number(robot, "max_steering");
  max_acceleration_ = number(robot, "max_acceleration");
  max_steering_rate_ = number(robot, "max_steering_rate");
  if (trailers_ == 0) return;
  hitch_length_ = positive(robot, "hitch_length");
  max_hitch_angle_ = number(robot, "max_hitch_angle");
  self_collision_gap_ = static_cast<std::size_t>(std::clamp(number(robot, "self_collision_gap"), 1.0, 1e6));
}

void Dynamics::read_unicycle(const RobotSpec& robot) {
  state_names_ = {"x", "y", "theta"};
  max_speed_ = number(robot, "max_speed");
  min_speed_ = minimum_speed(robot, -max_speed_);
  max_turn_rate_ = number(robot, "max_turn_rate");
}

void Dynamics::read_diff_drive(const RobotSpec& robot) {
  state_names_ = {"x", "y", "theta", "left wheel speed", "right wheel speed"};
  wheel_radius_ = positive(robot, "wheel_radius");
  track_width_ = positive(robot, "track_width");
  max_wheel_speed_ = number(robot, "max_wheel_speed");
  max_wheel_acceleration_ = number(robot, "max_wheel_acceleration");
  max_speed_ = wheel_radius_ * max_wheel_speed_;
  min_speed_ = minimum_speed(robot, -max_speed_);
}

State Dynamics::at_rest(const Point& position, double heading, const std::vector<double>& trailers) const {
  State state(state_size(), 0.0);
  state[0] = position.x;
  state[1] = position.y;
  state[2] = heading;
  for (std::size_t i = 0; i < trailers_; ++i) state[5 + i] = i < trailers.size() ? trailers[i] : heading;
  return state;
}

State Dynamics::derivative(const State& state, const Control& control) const {
  State rate(state.size(), 0.0);
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
      rate[i] = pull * std::sin(ahead - state[i]);
      pull *= std::cos(ahead - state[i]);
      ahead = state[i];
    }
  }
  rate[0] = speed * std::cos(state[2]);
  rate[1] = speed * std::sin(state[2]);
  return rate;
}

std::vector<State> Dynamics::integrate(const State& state, const Control& control, double time,
                                       std::size_t count) const {
  boost::numeric::odeint::runge_kutta4<State> stepper;
  const auto system = [&](const State& at, State& rate, double) { rate = derivative(at, control); };
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

std::vector<Limited> Dynamics::limited(const State& state) const {
  if (model_ == Model::unicycle) return {};
  if (model_ == Model::diff_drive) {
    return {{"left wheel speed", state[3], -max_wheel_speed_, max_wheel_speed_},
            {"right wheel speed", state[4], -max_wheel_speed_, max_wheel_speed_},
            {"speed", wheel_radius_ * (state[3] + state[4]) / 2, min_speed_, max_speed_}};
  }
  std::vector<Limited> all{{"speed", state[3], min_speed_, max_speed_},
                           {"steering", state[4], -max_steering_, max_steering_}};
  double ahead = state[2];
  for (std::size_t i = 1; i <= trailers_; ++i) {
    const double heading = state[4 + i];
    all.push_back({"hitch angle " + std::to_string(i), std::remainder(ahead - heading, 2 * std::numbers::pi),
                   -max_hitch_angle_, max_hitch_angle_});
    ahead = heading;
  }
  return all;
}

std::vector<Limited> Dynamics::limited_controls(const Control& control) const {
  switch (model_) {
    case Model::unicycle:
      return {{"speed", control[0], min_speed_, max_speed_},
              {"turn rate", control[1], -max_turn_rate_, max_turn_rate_}};
    case Model::diff_drive:
      return {{"left wheel acceleration", control[0], -max_wheel_acceleration_, max_wheel_acceleration_},
              {"right wheel acceleration", control[1], -max_wheel_acceleration_, max_wheel_acceleration_}};
    default:
      return {{"acceleration", control[0], -max_acceleration_, max_acceleration_},
              {"steering rate", control[1], -max_steering_rate_, max_steering_rate_}};
  }
}

}  // namespace krait::host
