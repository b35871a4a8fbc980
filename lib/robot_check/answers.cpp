// SPDX-License-Identifier: Apache-2.0
#include "robot_check/answers.hpp"

#include <cmath>
#include <cstring>
#include <limits>

namespace krait::detail::checking {
namespace {

bool check_finite(const Case& c, const char* function, const std::vector<float>& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (finite(numbers[i])) continue;
    c.fault(function, "finite", kInfinite,
            "number " + std::to_string(i) + " of its result is " + number(static_cast<double>(numbers[i])),
            "It must be finite at every state within the limits.");
    return false;
  }
  return true;
}

bool check_headings(const Case& c, const std::vector<Pose>& poses) {
  constexpr double kUnit = 1e-5;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const auto sin = static_cast<double>(poses[k].heading.sin);
    const auto cos = static_cast<double>(poses[k].heading.cos);
    const bool has_pose = finite(poses[k].position) && finite(poses[k].heading.sin) && finite(poses[k].heading.cos);
    const double length = std::hypot(sin, cos);
    const double off = std::abs(length - 1);
    if (!has_pose) {
      c.fault("place", "finite", kInfinite,
              "the frame of " + body_number(k) + " has the heading (sin " + number(sin) + ", cos " + number(cos) +
                  ") at (" + number(static_cast<double>(poses[k].position.x)) + ", " +
                  number(static_cast<double>(poses[k].position.y)) + ")",
              "Every frame must be finite: the library refuses such a state.");
      return false;
    }
    if (off > kUnit) {
      c.fault("place", "unit", off, "the heading of " + body_number(k) + " has the length " + number(length, 7),
              "Sine and cosine must be those of one angle, or the body is placed larger or smaller than it is.");
    }
  }
  return true;
}

bool same_polygon(Polygon a, Polygon b) {
  bool same = a.count == b.count;
  for (int i = 0; same && i < a.count; ++i) same = a[i].x == b[i].x && a[i].y == b[i].y;
  return same;
}

}  // namespace

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}

std::vector<float> numbers_of(const std::vector<Pose>& poses) {
  std::vector<float> numbers;
  for (const Pose& p : poses) {
    for (const float number : {p.position.x, p.position.y, p.heading.sin, p.heading.cos}) numbers.push_back(number);
  }
  return numbers;
}

std::vector<float> numbers_of(const Travel& t) { return {t.path, t.turn, t.bend, t.twist}; }

TravelAnswer travel_of(const Robot& robot, const Sample& sample, const std::vector<float>& next, float fill) {
  TravelAnswer answer;
  answer.bodies.assign(static_cast<std::size_t>(robot.body_count()), Travel{fill, fill, fill, fill});
  answer.limits_kept =
      robot.travel(sample.state.data(), sample.control.data(), sample.dt, next.data(), answer.bodies.data());
  return answer;
}

std::vector<float> numbers_of(const TravelAnswer& answer) {
  std::vector<float> numbers{answer.limits_kept ? 1.0F : 0.0F};
  for (const Travel& t : answer.bodies) {
    for (const float x : numbers_of(t)) numbers.push_back(x);
  }
  return numbers;
}

void check_repeats(const Case& c, const char* function, const Ask& ask) {
  const std::vector<float> first = ask(c.sample.state, kFills[0]);
  ask(c.other, kFills[0]);
  const std::vector<float> second = ask(c.sample.state, kFills[1]);
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == kFills[0] && second[i] == kFills[1]) {
      c.fault(function, "complete", kInfinite,
              std::string(function) + " leaves number " + std::to_string(i) + " of its result unwritten",
              "It must write all of them.");
      return;
    }
  }
  if (same_bits(first, second)) return;
  c.fault(function, "pure", kInfinite, std::string(function) + " returns " + list(first) + " and then " + list(second),
          "It must depend on nothing but its arguments: no counter, no clock, no memory that was not written.");
}

bool check_number(const Case& c, const char* function, bool holds, float value, const char* unit, const char* rule) {
  if (holds) return true;
  c.fault(function, "number", kInfinite,
          std::string(function) + " is " + number(static_cast<double>(value)) + " " + unit, rule);
  return false;
}

bool check_derivative(const Case& c) {
  check_repeats(c, "derivative", [&](const std::vector<float>& state, float fill) {
    return derivative_of(c.robot, state, c.sample.control, fill);
  });
  return check_finite(c, "derivative", derivative_of(c.robot, c.sample.state, c.sample.control, kFills[0]));
}

void check_within_limits(const Case& c) {
  check_repeats(c, "within_limits", [&](const std::vector<float>& state, float) {
    return std::vector<float>{c.robot.within_limits(state.data()) ? 1.0F : 0.0F};
  });
  if (!c.robot.answers_proven()) return;
  for (std::size_t i = 0; i < c.sample.state.size(); ++i) {
    for (const float none : {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity}) {
      std::vector<float> state = c.sample.state;
      state[i] = none;
      if (!c.robot.within_limits(state.data())) continue;
      c.fault("within_limits", "finite", kInfinite,
              "component " + std::to_string(i) + " may be " + number(static_cast<double>(none)),
              "kAnswersProven promises that no such state is within the limits.");
    }
  }
}

bool check_place(const Case& c) {
  check_repeats(c, "place", [&](const std::vector<float>& state, float fill) {
    return numbers_of(poses_of(c.robot, state, fill));
  });
  const std::vector<Pose> poses = poses_of(c.robot, c.sample.state);
  if (!check_headings(c, poses)) return false;
  const auto dx = static_cast<double>(poses[0].position.x) - static_cast<double>(c.sample.state[0]);
  const auto dy = static_cast<double>(poses[0].position.y) - static_cast<double>(c.sample.state[1]);
  const double off = std::hypot(dx, dy);
  const Numbers at(c.sample.state.begin(), c.sample.state.end());
  if (off > rounding_at(at)) {
    c.fault("place", "origin", off, "the origin of body 0 is " + number(off) + " m away from the state's position",
            "Move the origin there, and the body's vertices the other way.");
  }
  return true;
}

void check_bodies(const Case& c) {
  for (int k = 0; k < c.robot.body_count(); ++k) {
    const Polygon body = c.robot.body(k);
    const std::vector<Vec2> first(body.vertices, body.vertices + body.count);
    if (same_polygon(c.robot.body(k), {first.data(), body.count})) continue;
    c.fault("body", "pure", kInfinite,
            body_number(static_cast<std::size_t>(k)) + " has another shape when called again",
            "A body's shape must not change.");
  }
}

}  // namespace krait::detail::checking
