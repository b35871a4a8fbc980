// SPDX-License-Identifier: Apache-2.0
// The motion that a robot's derivative means, integrated far more finely than the library does.
#pragma once

#include <vector>

#include "robot_check/report.hpp"

namespace krait::detail::checking {

using Numbers = std::vector<double>;

std::vector<float> rounded(const Numbers& numbers);

// `fill` is there before.
std::vector<float> derivative_of(const Robot& robot, const std::vector<float>& state, const std::vector<float>& control,
                                 float fill = 0.0F);

// One Runge-Kutta step of the derivative, summed in double precision.
Numbers runge_kutta_step(const Robot& robot, const Numbers& state, const std::vector<float>& control, double dt);

// The largest difference of two components.
double difference(const Numbers& a, const Numbers& b);

// The states at 33 even times from the sample's on, each as the derivative's own.
struct Motion33 {
  static constexpr int kParts = 32;
  std::vector<Numbers> states;
  bool resolved = false;  // whether finer steps lead to the same end

  const Numbers& end() const { return states.back(); }
};

// The same states by `steps_a_part` Runge-Kutta steps between each and the next.
std::vector<Numbers> integrated(const Robot& robot, const Sample& sample, double dt, int steps_a_part);

// Halves the steps until it makes no difference.
Motion33 fine_motion(const Robot& robot, const Sample& sample, double dt);

struct Frame {
  double x, y, sin, cos;
};

// `fill` is there before.
std::vector<Pose> poses_of(const Robot& robot, const std::vector<float>& state, float fill = 0.0F);
std::vector<Frame> frames_of(const Robot& robot, const std::vector<float>& state);

struct Point {
  double x, y;
};

double distance(Point a, Point b);
inline Point origin(const Frame& frame) { return {frame.x, frame.y}; }

// A point of the body.
Point placed(const Frame& frame, Vec2 p);

double angle_between(const Frame& a, const Frame& b);

// Distance of p from the line that ends at a and b.
double distance_to_line(Point p, Point a, Point b);

// What floats may make of positions: of the order of a step of theirs at the sample's place.
double rounding_at(const Numbers& state);

}  // namespace krait::detail::checking
