// SPDX-License-Identifier: Apache-2.0
#include "robot_check/motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace krait::detail::checking {

std::vector<float> rounded(const Numbers& numbers) {
  std::vector<float> result;
  for (const double x : numbers) result.push_back(static_cast<float>(x));
  return result;
}

std::vector<float> derivative_of(const Robot& robot, const std::vector<float>& state, const std::vector<float>& control,
                                 float fill) {
  std::vector<float> rates(state.size(), fill);
  robot.derivative(state.data(), control.data(), rates.data());
  return rates;
}

Numbers runge_kutta_step(const Robot& robot, const Numbers& state, const std::vector<float>& control, double dt) {
  const auto rates = [&](const std::vector<float>& slope, double after) {
    Numbers at = state;
    for (std::size_t i = 0; i < slope.size(); ++i) at[i] += after * static_cast<double>(slope[i]);
    return derivative_of(robot, rounded(at), control);
  };
  const std::vector<float> k1 = rates({}, 0.0);
  const std::vector<float> k2 = rates(k1, dt / 2);
  const std::vector<float> k3 = rates(k2, dt / 2);
  const std::vector<float> k4 = rates(k3, dt);
  Numbers next = state;
  for (std::size_t i = 0; i < next.size(); ++i) {
    const double middle = static_cast<double>(k2[i]) + static_cast<double>(k3[i]);
    next[i] += dt / 6 * (static_cast<double>(k1[i]) + 2 * middle + static_cast<double>(k4[i]));
  }
  return next;
}

double difference(const Numbers& a, const Numbers& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

std::vector<Numbers> integrated(const Robot& robot, const Sample& sample, double dt, int steps_a_part) {
  std::vector<Numbers> states{Numbers(sample.state.begin(), sample.state.end())};
  for (int part = 0; part < Motion33::kParts; ++part) {
    Numbers at = states.back();
    const double step = dt / Motion33::kParts / steps_a_part;
    for (int i = 0; i < steps_a_part; ++i) at = runge_kutta_step(robot, at, sample.control, step);
    states.push_back(at);
  }
  return states;
}

Motion33 fine_motion(const Robot& robot, const Sample& sample, double dt) {
  constexpr double kSame = 2e-6;
  constexpr int kMostSteps = 64;  // a part
  Motion33 motion;
  motion.states = integrated(robot, sample, dt, 1);
  for (int steps = 2; steps <= kMostSteps && !motion.resolved; steps *= 2) {
    std::vector<Numbers> finer = integrated(robot, sample, dt, steps);
    double size = 1;
    for (const double x : finer.back()) size = std::max(size, std::abs(x));
    motion.resolved = difference(finer.back(), motion.end()) <= kSame * size;
    motion.states = std::move(finer);
  }
  return motion;
}

std::vector<Pose> poses_of(const Robot& robot, const std::vector<float>& state, float fill) {
  std::vector<Pose> poses(static_cast<std::size_t>(robot.body_count()), Pose{{fill, fill}, {fill, fill}});
  robot.place(state.data(), poses.data());
  return poses;
}

std::vector<Frame> frames_of(const Robot& robot, const std::vector<float>& state) {
  std::vector<Frame> frames;
  for (const Pose& pose : poses_of(robot, state)) {
    frames.push_back({static_cast<double>(pose.position.x), static_cast<double>(pose.position.y),
                      static_cast<double>(pose.heading.sin), static_cast<double>(pose.heading.cos)});
  }
  return frames;
}

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

Point placed(const Frame& frame, Vec2 p) {
  const auto x = static_cast<double>(p.x);
  const auto y = static_cast<double>(p.y);
  return {frame.x + frame.cos * x - frame.sin * y, frame.y + frame.sin * x + frame.cos * y};
}

double angle_between(const Frame& a, const Frame& b) {
  return std::abs(std::atan2(a.cos * b.sin - a.sin * b.cos, a.cos * b.cos + a.sin * b.sin));
}

double distance_to_line(Point p, Point a, Point b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double along = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return distance(p, {a.x + along * dx, a.y + along * dy});
}

double rounding_at(const Numbers& state) { return 3e-6 * (1 + std::max(std::abs(state[0]), std::abs(state[1]))); }

}  // namespace krait::detail::checking
