// SPDX-License-Identifier: Apache-2.0
#include "robot_check/bounds.hpp"

#include <algorithm>
#include <cmath>

#include "robot_check/answers.hpp"

namespace krait::detail::checking {
namespace {

// How a body moved over the step.
struct Moved {
  double path = 0;  // metres, of the origin
  double turn = 0;  // radians, to and fro
  double bend = 0;  // metres, of the origin from the line between its places
};

double strayed(const std::vector<Point>& way) {
  double most = 0;
  for (const Point& p : way) most = std::max(most, distance_to_line(p, way.front(), way.back()));
  return most;
}

// Looks at every other of the frames, since each adds a rounding to the path.
Moved moved_of(const Case& c, std::size_t body) {
  Moved result;
  std::vector<Point> origins;
  for (const auto& at : c.frames) origins.push_back(origin(at[body]));
  for (std::size_t i = 2; i < c.frames.size(); i += 2) {
    result.path += distance(origins[i], origins[i - 2]);
    result.turn += angle_between(c.frames[i - 2][body], c.frames[i][body]);
  }
  result.bend = strayed(origins);
  return result;
}

// How far a vertex of the body strays from the line between its places.
double strayed_of_vertex(const Case& c, std::size_t body, Vec2 vertex) {
  std::vector<Point> way;
  for (const auto& at : c.frames) way.push_back(placed(at[body], vertex));
  return strayed(way);
}

struct Bound {
  const char* function;
  Travel travel;
  std::size_t body;
};

void check_part(const Case& c, const Bound& bound, const char* part, double motion, float allowed, const char* unit,
                const char* remedy) {
  const double tolerance = rounding_at(c.motion.end()) + 1e-4 * static_cast<double>(allowed);
  const double over = motion - static_cast<double>(allowed);
  if (!(over > tolerance)) return;
  const std::string said = std::string(part) + " is " + number(static_cast<double>(allowed)) + unit;
  c.fault(bound.function, part, over,
          said + " where " + body_number(bound.body) + " moved by " + number(motion) + unit + ", " + number(over) +
              unit + " more",
          remedy);
}

// What floats leave of a twist over the length of a body is no fault of it.
void check_twist(const Case& c, const Bound& bound) {
  const Polygon body = c.robot.body(static_cast<int>(bound.body));
  for (int i = 0; i < body.count; ++i) {
    const float allowed = bound.travel.bend + length(body[i]) * bound.travel.twist;
    const double strays = strayed_of_vertex(c, bound.body, body[i]);
    check_part(
        c, bound, "twist", strays, allowed, " m (bend, and twist times the vertex's distance)",
        "Raise twist: bend + r twist must be no less than how far a point r metres from the body's origin is from "
        "the line between its places.");
  }
}

bool usable(const Travel& t) { return t.path >= 0 && t.turn >= 0 && t.bend >= 0 && t.twist >= 0; }

void check_bound(const Case& c, const Bound& bound) {
  if (!usable(bound.travel)) {
    c.fault(
        bound.function, "number", kInfinite,
        "the bound of " + body_number(bound.body) + " is " + list(numbers_of(bound.travel)) +
            " (path, turn, bend, twist)",
        "None may be NaN or negative: the library treats such a step as a collision. Infinity means that no bound is "
        "known.");
    return;
  }
  const Moved moved = moved_of(c, bound.body);
  check_part(c, bound, "path", moved.path, bound.travel.path, " m",
             "Raise path: it must be no less than the way of the body's origin.");
  check_part(c, bound, "turn", moved.turn, bound.travel.turn, " rad",
             "Raise turn: it must be no less than what the body turns, to and fro.");
  check_part(
      c, bound, "bend", moved.bend, bound.travel.bend, " m",
      "Raise bend: it must be no less than how far the body's origin is from the line between its places, at most "
      "A dt^2 / 8 for an acceleration of A.");
  if (moved.bend <= static_cast<double>(bound.travel.bend) + rounding_at(c.motion.end())) check_twist(c, bound);
}

void check_limits_hold(const Case& c, const char* function) {
  const int beyond = beyond_limits(c.robot, c.motion);
  if (beyond < 0) return;
  const double time = static_cast<double>(c.sample.dt) * beyond / Motion33::kParts;
  c.fault(function, "limits", kInfinite,
          "the limits are said to hold all the way, and " + number(time) + " s into it the state " +
              list(rounded(c.motion.states[static_cast<std::size_t>(beyond)])) + " is beyond them",
          "Answer false unless it is proven that within_limits is true at every time in between.");
}

QuickBound quick_bound_of(const Robot& robot, const Sample& sample, const std::vector<float>& next) {
  return robot.quick_bound(sample.state.data(), sample.control.data(), sample.dt, next.data());
}

// The least distance, over the step, of two origins whose bodies are tested against each other.
double least_separation(const Case& c) {
  double least = kInfinite;
  const auto gap = static_cast<std::size_t>(c.robot.self_collision_gap());
  for (const auto& at : c.frames) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      for (std::size_t j = i + gap; j < at.size(); ++j) least = std::min(least, distance(origin(at[i]), origin(at[j])));
    }
  }
  return least;
}

// Where no two bodies are tested against each other, any separation is true, an infinite one, too.
void check_separation(const Case& c, double separation) {
  constexpr const char* kRemedy =
      "Lower separation: it must be no more than the least distance of two origins of bodies that are tested against "
      "each other; 0 is always right.";
  if (std::isnan(separation)) c.fault("quick_bound", "separation", kInfinite, "separation is NaN", kRemedy);
  const double least = least_separation(c);
  if (!(separation > least + rounding_at(c.motion.end()))) return;
  const double over = separation - least;
  c.fault(
      "quick_bound", "separation", over,
      "separation is " + number(separation) + " m, where two origins came " + number(over) + " m nearer to each other",
      kRemedy);
}

// How far a body's frame moves from one time to the next, a radian counting as a metre.
double leap(const Frame& a, const Frame& b) { return distance(origin(a), origin(b)) + angle_between(a, b); }

}  // namespace

void check_travel(const Case& c) {
  check_repeats(c, "travel", [&](const std::vector<float>& state, float fill) {
    return numbers_of(travel_of(c.robot, {state, c.sample.control, c.sample.dt}, c.next, fill));
  });
  const TravelAnswer answer = travel_of(c.robot, c.sample, c.next, kFills[0]);
  for (std::size_t k = 0; k < answer.bodies.size(); ++k) check_bound(c, Bound{"travel", answer.bodies[k], k});
  if (answer.limits_kept) check_limits_hold(c, "travel");
}

void check_quick_bound(const Case& c) {
  check_repeats(c, "quick_bound", [&](const std::vector<float>& state, float) {
    const QuickBound quick = quick_bound_of(c.robot, {state, c.sample.control, c.sample.dt}, c.next);
    std::vector<float> numbers = numbers_of(quick.most);
    numbers.push_back(quick.limits_kept ? 1.0F : 0.0F);
    numbers.push_back(quick.separation);
    return numbers;
  });
  const QuickBound quick = quick_bound_of(c.robot, c.sample, c.next);
  if (!quick.limits_kept) return;
  for (std::size_t k = 0; k < c.frames[0].size(); ++k) check_bound(c, Bound{"quick_bound", quick.most, k});
  check_limits_hold(c, "quick_bound");
  check_separation(c, static_cast<double>(quick.separation));
}

void check_place_follows(const Case& c) {
  constexpr double kLeast = 1e-3;
  for (std::size_t k = 0; k < c.frames[0].size(); ++k) {
    std::size_t at = 0;
    for (std::size_t i = 0; i + 1 < c.frames.size(); ++i) {
      if (leap(c.frames[i][k], c.frames[i + 1][k]) > leap(c.frames[at][k], c.frames[at + 1][k])) at = i;
    }
    const double coarse = leap(c.frames[at][k], c.frames[at + 1][k]);
    if (coarse < kLeast) continue;
    Sample part{rounded(c.motion.states[at]), c.sample.control, c.sample.dt / Motion33::kParts};
    double fine = 0;
    Frame before = c.frames[at][k];
    for (const Numbers& state : integrated(c.robot, part, static_cast<double>(part.dt), 1)) {
      const Frame after = frames_of(c.robot, rounded(state))[k];
      fine = std::max(fine, leap(before, after));
      before = after;
    }
    if (fine < 0.5 * coarse) continue;
    c.fault("place", "continuous", fine,
            "the frame of " + body_number(k) + " leaps by " + number(fine) + " (metres and radians) on the way",
            "Frames must move with the state that derivative leads to, without leaps.");
  }
}

}  // namespace krait::detail::checking
