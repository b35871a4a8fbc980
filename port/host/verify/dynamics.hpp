// The verifier's own equations of motion, in double precision: DESIGN section 5, "Eqn 1 as printed is wrong".
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/robot/robot.hpp"

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

// A quantity that has limits, and its value.
struct Limited {
  std::string name;
  double value = 0;
  double min = 0;
  double max = 0;
};

class Dynamics {
 public:
  // Throws InputError if the model is unknown, or a parameter is missing or not a number in its range.
  explicit Dynamics(const RobotSpec& robot);

  std::size_t state_size() const { return state_names_.size(); }
  std::size_t control_size() const { return 2; }
  const std::vector<std::string>& state_names() const { return state_names_; }

  // The state of a robot at rest with this pose; `trailers` are headings, all equal to `heading` if empty.
  State at_rest(const Point& position, double heading, const std::vector<double>& trailers) const;

  // Component `index` of a state is an angle of a body in the plane, where 2 pi makes no difference.
  bool is_heading(std::size_t index) const { return index == 2 || index >= 5; }

  State derivative(const State& state, const Control& control) const;

  // The states after each of `count` equal steps of RK4 over `time` seconds, `state` itself first.
  std::vector<State> integrate(const State& state, const Control& control, double time, std::size_t count) const;

  // One frame a body.
  std::vector<Frame> frames(const State& state) const;

  std::vector<Limited> limited(const State& state) const;
  std::vector<Limited> limited_controls(const Control& control) const;

  // Bodies whose indices differ by at least this many must not meet.
  std::size_t self_collision_gap() const { return self_collision_gap_; }

 private:
  enum class Model { snake, truck, car, unicycle, diff_drive };

  static Model model_of(const std::string& name);
  bool is_car_like() const { return model_ == Model::snake || model_ == Model::truck || model_ == Model::car; }
  void read_car_like(const RobotSpec& robot);
  void read_unicycle(const RobotSpec& robot);
  void read_diff_drive(const RobotSpec& robot);

  Model model_;
  std::size_t trailers_ = 0;
  std::vector<std::string> state_names_;
  std::size_t self_collision_gap_ = 0;

  // Of these, those that the model has.
  double wheelbase_ = 0;
  double hitch_length_ = 0;
  double wheel_radius_ = 0;
  double track_width_ = 0;
  double min_speed_ = 0;
  double max_speed_ = 0;
  double max_steering_ = 0;
  double max_acceleration_ = 0;
  double max_steering_rate_ = 0;
  double max_hitch_angle_ = 0;
  double max_turn_rate_ = 0;
  double max_wheel_speed_ = 0;
  double max_wheel_acceleration_ = 0;
};

}  // namespace krait::host
