// SPDX-License-Identifier: Apache-2.0
// The verifier's own equations of motion, in double precision: lib/DESIGN.md, "Eqn 1 as printed is wrong".
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "host/robot_file/robot_file.hpp"

namespace krait::host {

// Components in the plan's order: metres, radians, seconds.
using State = std::vector<double>;
using Control = std::vector<double>;

// Where a body's own frame lies: its axle and the direction of its x axis.
struct Frame {
  Point origin;
  double cos = 1;
  double sin = 0;

  Point place(const Point& body_point) const {
    return {origin.x + cos * body_point.x - sin * body_point.y, origin.y + sin * body_point.x + cos * body_point.y};
  }
  Point inverse(const Point& point) const {
    const double dx = point.x - origin.x;
    const double dy = point.y - origin.y;
    return {cos * dx + sin * dy, cos * dy - sin * dx};
  }
};

// What a quantity must not leave.
struct Limit {
  std::string name;
  double min = 0;
  double max = 0;
};

// What differs between models: the limits, and the equations of a robot with its parameters.
struct Equations {
  std::vector<std::string> state_names;  // but the trailers' headings
  std::vector<Limit> state_limits;
  std::vector<Limit> control_limits;  // one for each component of a control, in their order
  std::vector<std::size_t> angles;    // components that are angles but no headings, as that of front wheels
  double hitch_length = 0;            // metres; only with trailers
  std::size_t self_collision_gap = 0;
  // Writes how fast all but the position changes, and returns the speed of body 0's axle along its x axis.
  std::function<double(const State&, const Control&, State& rate)> motion;
  std::function<double(const State&)> speed;                // m/s, as Dynamics::speed says
  std::function<std::vector<double>(const State&)> values;  // those that state_limits hold for, in their order
};

class Dynamics {
 public:
  // Throws InputError if the model is unknown, or a parameter is missing or not a number in its range.
  explicit Dynamics(const RobotSpec& robot);

  std::size_t state_size() const { return equations_.state_names.size(); }
  std::size_t control_size() const { return equations_.control_limits.size(); }
  std::size_t body_count() const { return trailers_ + 1; }
  const std::vector<std::string>& state_names() const { return equations_.state_names; }

  // The state of a robot at rest with this pose; `trailers` are headings, all equal to `heading` if empty.
  State at_rest(const Point& position, double heading, const std::vector<double>& trailers) const;

  // Component `index` of a state is an angle of a body in the plane, where 2 pi makes no difference.
  bool is_heading(std::size_t index) const { return index == 2 || index >= front_size_; }

  // Component `index` is an angle: a heading, or the steering of a car.
  bool is_angle(std::size_t index) const;

  // m/s, at least 0: of the front wheels, or of the faster wheel; 0 of a robot whose states have no speed.
  double speed(const State& state) const { return equations_.speed(state); }

  State derivative(const State& state, const Control& control) const;

  // The states after each of `count` equal steps over `time` seconds, `state` itself first, by Fehlberg's Runge-Kutta
  // method of order eight.
  std::vector<State> integrate(const State& state, const Control& control, double time, std::size_t count) const;

  // One frame a body.
  std::vector<Frame> frames(const State& state) const;

  // Limits of what a state says, and the values that they hold for, in the same order.
  const std::vector<Limit>& state_limits() const { return equations_.state_limits; }
  std::vector<double> limited_values(const State& state) const { return equations_.values(state); }

  // Limits of each control.
  const std::vector<Limit>& control_limits() const { return equations_.control_limits; }

  // Bodies whose indices differ by at least this many must not meet.
  std::size_t self_collision_gap() const { return equations_.self_collision_gap; }

 private:
  void set_rate(const State& state, const Control& control, State& rate) const;

  std::size_t trailers_ = 0;
  std::size_t front_size_ = 0;  // components of a state that are no trailers' headings
  Equations equations_;
};

}  // namespace krait::host
