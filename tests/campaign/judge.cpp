// SPDX-License-Identifier: Apache-2.0
#include "judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <limits>

#include "sweep.hpp"

namespace krait::campaign {
namespace {

std::string text(const char* form, ...) __attribute__((format(printf, 1, 2)));
std::string text(const char* form, ...) {
  char line[200];
  va_list arguments;
  va_start(arguments, form);
  std::vsnprintf(line, sizeof line, form, arguments);
  va_end(arguments);
  return line;
}

double to_segment(host::Point a, host::Point b, double x, double y) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double along = std::clamp(((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(a.x + along * dx - x, a.y + along * dy - y);
}

// How deep in the goal; negative outside.
double depth_in(const Region& goal, double x, double y) {
  if (const Disc* disc = std::get_if<Disc>(&goal)) return disc->radius - std::hypot(x - disc->x, y - disc->y);
  const host::Ring& ring = std::get<host::Ring>(goal);
  bool odd = false;
  double border = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const host::Point a = ring[j], b = ring[i];
    border = std::min(border, to_segment(a, b, x, y));
    if ((a.y > y) != (b.y > y) && x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x)) odd = !odd;
  }
  return odd ? border : -border;
}

bool all_finite(const std::vector<float>& values) {
  return std::all_of(values.begin(), values.end(), [](float x) { return std::isfinite(x); });
}

class Judge {
 public:
  Judge(const Robot& robot, const Field& field, const Region& goal, const PlanRecord& plan)
      : equations_(robot), drive_(equations_), sweep_(equations_, bodies_of(robot), field), goal_(goal), plan_(plan) {
    size_ = static_cast<std::size_t>(equations_.state_size());
    const Convex first = bodies_of(robot).front();
    for (int i = 0; i < first.count; ++i) radius_ = std::max(radius_, std::hypot(first.x[i], first.y[i]));
  }

  Verdict verdict() {
    if (plan_.states.size() < size_ || plan_.states.size() / size_ * 2 != plan_.controls.size() + 2 ||
        !all_finite(plan_.states) || !all_finite(plan_.controls)) {
      verdict_.others.push_back("the plan is no row of finite states and controls");
      return verdict_;
    }
    State state = stored(0);
    sweep_.begin(state);
    for (std::size_t step = 0; step < plan_.controls.size() / 2; ++step) {
      if (!take(step, state)) return verdict_;
      compare(step + 1, state);
    }
    finish(state);
    return verdict_;
  }

 private:
  State stored(std::size_t step) const {
    State state{};
    for (std::size_t i = 0; i < size_; ++i) state[i] = static_cast<double>(plan_.states[step * size_ + i]);
    return state;
  }

  bool take(std::size_t step, State& state) {
    const double u[2] = {static_cast<double>(plan_.controls[2 * step]),
                         static_cast<double>(plan_.controls[2 * step + 1])};
    const double dt = static_cast<double>(plan_.dt);
    look_at_limits(step, state, u);
    const std::vector<State>& way = drive_.hold(state, u, dt);
    if (way.empty()) {
      verdict_.others.push_back(text("step %zu: not accurate in %d parts", step, Drive::kMostParts));
      return false;
    }
    const auto parts = static_cast<double>(way.size() - 1);
    verdict_.most_parts = std::max(verdict_.most_parts, static_cast<int>(way.size() - 1));
    for (std::size_t i = 1; i < way.size(); ++i) {
      sweep_.go(way[i], u, dt / parts, (static_cast<double>(step) + static_cast<double>(i - 1) / parts));
    }
    state = way.back();
    look_at_limits(step, state, u);
    return true;
  }

  void look_at_limits(std::size_t step, const State& state, const double* u) {
    const double excess = equations_.excess(state, u);
    if (excess > kLimitShare && verdict_.off_limits.empty()) {
      verdict_.off_limits.push_back(text("step %zu: %.3g of its limit beyond it", step, excess));
    }
    verdict_.excess = std::max(verdict_.excess, excess);
  }

  void compare(std::size_t step, const State& driven) {
    const State said = stored(step);
    const double position = std::hypot(said[0] - driven[0], said[1] - driven[1]);
    double angle = 0;
    for (std::size_t i = 2; i < size_; ++i) {
      if (equations_.is_angle(i)) angle = std::max(angle, std::abs(said[i] - driven[i]));
    }
    if (step > 0) {
      const State before = stored(step - 1);
      way_ += std::hypot(said[0] - before[0], said[1] - before[1]) + radius_ * std::abs(said[2] - before[2]);
    }
    const double astray = kPositionError + (kPositionShare + kHeadingShare * std::abs(said[2])) * way_;
    if ((position > astray || angle > kAngleError) && verdict_.others.empty()) {
      verdict_.others.push_back(
          text("state %zu: %.3g m and %.3g rad from where the controls lead", step, position, angle));
    }
    verdict_.position_error = std::max(verdict_.position_error, position);
    verdict_.angle_error = std::max(verdict_.angle_error, angle);
  }

  void finish(const State& end) {
    verdict_.depth = depth_in(goal_, end[0], end[1]);
    if (!(verdict_.depth >= 0)) verdict_.misses.push_back(text("ends %.3g m outside the goal", -verdict_.depth));
    verdict_.clearance = sweep_.clearance();
    for (const Contact& contact : sweep_.contacts()) {
      const std::string with =
          contact.other < 0 ? "an obstacle or the bounds" : "body " + std::to_string(contact.other);
      verdict_.collisions.push_back(text("step %.3f: body %d meets %s, at most %.3g m deep", contact.step, contact.body,
                                         with.c_str(), contact.depth));
    }
    verdict_.excess = std::max(verdict_.excess, sweep_.hitch_excess());
    if (sweep_.hitch_excess() > kLimitShare) {
      verdict_.off_limits.push_back(text("a hitch angle %.3g of its limit beyond it", sweep_.hitch_excess()));
    }
  }

  const Equations equations_;
  Drive drive_;
  Sweep sweep_;
  const Region& goal_;
  const PlanRecord& plan_;
  std::size_t size_;
  Verdict verdict_;
  double radius_ = 0;  // m, of body 0 around its frame's origin
  double way_ = 0;     // m, of body 0's ends, up to the last state that was compared
};

}  // namespace

Verdict judge(const Robot& robot, const Field& field, const Region& goal, const PlanRecord& plan) {
  return Judge(robot, field, goal, plan).verdict();
}

}  // namespace krait::campaign
