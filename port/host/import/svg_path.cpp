// SPDX-License-Identifier: Apache-2.0
#include "host/import/svg_path.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

namespace krait::host {
namespace {

Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
Point operator*(double s, const Point& p) { return {s * p.x, s * p.y}; }
double length(const Point& p) { return std::hypot(p.x, p.y); }

// The ellipse through two points, as SVG's appendix "elliptical arc implementation notes" (F.6) has it.
struct Arc {
  Point center;
  double rx = 0, ry = 0;
  double cos_turn = 1, sin_turn = 0;  // of the x axis
  double first = 0, sweep = 0;        // angles on the unit circle

  Point at(double share) const {
    const double angle = first + share * sweep;
    const Point p = {rx * std::cos(angle), ry * std::sin(angle)};
    return center + Point{cos_turn * p.x - sin_turn * p.y, sin_turn * p.x + cos_turn * p.y};
  }
};

struct ArcFlags {
  bool large;
  bool positive;  // towards growing angles
};

Arc arc_between(const Point& from, const Point& to, double rx, double ry, double turn, ArcFlags flags) {
  Arc arc;
  arc.cos_turn = std::cos(turn);
  arc.sin_turn = std::sin(turn);
  const Point half = 0.5 * (from - to);
  const Point p = {arc.cos_turn * half.x + arc.sin_turn * half.y, arc.cos_turn * half.y - arc.sin_turn * half.x};
  const double needed = std::hypot(p.x / rx, p.y / ry);  // above 1 the radii are too small and grow
  arc.rx = rx * std::max(1.0, needed);
  arc.ry = ry * std::max(1.0, needed);
  const Point unit = {p.x / arc.rx, p.y / arc.ry};
  const double along = length(unit);
  const double across = std::sqrt(std::max(0.0, 1 - along * along)) / along;
  const double side = flags.large == flags.positive ? -across : across;
  const Point c = {side * unit.y, -side * unit.x};  // the centre, on the unit circle's scale
  const Point scaled = {arc.rx * c.x, arc.ry * c.y};
  arc.center = 0.5 * (from + to) + Point{arc.cos_turn * scaled.x - arc.sin_turn * scaled.y,
                                         arc.sin_turn * scaled.x + arc.cos_turn * scaled.y};
  arc.first = std::atan2(unit.y - c.y, unit.x - c.x);
  arc.sweep = std::atan2(-unit.y - c.y, -unit.x - c.x) - arc.first;
  if (flags.positive && arc.sweep < 0) arc.sweep += 2 * std::numbers::pi;
  if (!flags.positive && arc.sweep > 0) arc.sweep -= 2 * std::numbers::pi;
  return arc;
}

class PathReader {
 public:
  PathReader(SvgScanner& data, const Flatness& flatness) : data_(data), flatness_(flatness) {}

  std::vector<Ring> read() {
    while (!data_.done()) {
      const char letter = data_.letter();
      const char command = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
      relative_ = letter != command;
      if (!begun_ && command != 'M') data_.fail("a path must begin with M");
      begun_ = true;
      read_command(command);
    }
    finish();
    return std::move(rings_);
  }

 private:
  void read_command(char command) {
    if (command == 'Z') return close();
    if (command == 'M') {
      move();
      command = 'L';  // what further pairs mean
      if (!data_.at_number()) return;
    }
    do {
      read_segment(command);
    } while (data_.at_number());
  }

  void read_segment(char command) {
    switch (command) {
      case 'L':
        return line(point());
      case 'H':
        return line({data_.number() + (relative_ ? at_.x : 0), at_.y});
      case 'V':
        return line({at_.x, data_.number() + (relative_ ? at_.y : 0)});
      case 'C': {
        const Point first = point();
        return read_cubic(first);
      }
      case 'S':
        return read_cubic(last_ == 'C' ? 2 * at_ - control_ : at_);
      case 'Q':
        return quadratic(point());
      case 'T':
        return quadratic(last_ == 'Q' ? 2 * at_ - control_ : at_);
      case 'A':
        return read_arc();
      default:
        data_.fail("unknown command; known are M, L, H, V, C, S, Q, T, A and Z");
    }
  }

  Point point() {
    const double x = data_.number();
    const Point p = {x, data_.number()};
    return relative_ ? at_ + p : p;
  }

  void move() {
    const Point p = point();
    finish();
    begin_ = at_ = p;
    last_ = 'M';
  }

  void close() {
    at_ = begin_;
    finish();
    last_ = 'Z';
  }

  void line(const Point& to) {
    add(to);
    last_ = 'L';
  }

  // Between n equal steps of its parameter a curve is off its chord by at most |second derivative| / (8 n^2).
  void read_cubic(const Point& first) {
    const Point p0 = at_;
    const Point second = point();
    const Point end = point();
    const double bend = 6 * std::max(length(p0 - 2 * first + second), length(first - 2 * second + end));
    const std::size_t steps = steps_for(std::sqrt(bend / 8 / flatness_.tolerance));
    for (std::size_t i = 1; i < steps; ++i) {
      const double t = share(i, steps);
      const double s = 1 - t;
      add((s * s * s) * p0 + (3 * s * s * t) * first + (3 * s * t * t) * second + (t * t * t) * end);
    }
    add(end);
    control_ = second;
    last_ = 'C';
  }

  void quadratic(const Point& control) {
    const Point p0 = at_;
    const Point end = point();
    const std::size_t steps = steps_for(std::sqrt(2 * length(p0 - 2 * control + end) / 8 / flatness_.tolerance));
    for (std::size_t i = 1; i < steps; ++i) {
      const double t = share(i, steps);
      add(((1 - t) * (1 - t)) * p0 + (2 * t * (1 - t)) * control + (t * t) * end);
    }
    add(end);
    control_ = control;
    last_ = 'Q';
  }

  void read_arc() {
    const double rx = std::abs(data_.number());
    const double ry = std::abs(data_.number());
    const double turn = data_.number() * std::numbers::pi / 180;
    const bool large = data_.flag();
    const bool positive = data_.flag();
    const Point end = point();
    if (rx > 0 && ry > 0 && length(end - at_) > 0) {
      const Arc arc = arc_between(at_, end, rx, ry, turn, {large, positive});
      // Over an angle of 2 h a chord is off its circle by r (1 - cos h), at most r h^2 / 2.
      const double radius = std::max(arc.rx, arc.ry);
      const std::size_t steps =
          std::max<std::size_t>(4, steps_for(std::abs(arc.sweep) * std::sqrt(radius / 8 / flatness_.tolerance)));
      for (std::size_t i = 1; i < steps; ++i) add(arc.at(share(i, steps)));
    }
    add(end);
    last_ = 'A';
  }

  static double share(std::size_t i, std::size_t steps) { return static_cast<double>(i) / static_cast<double>(steps); }

  std::size_t steps_for(double wanted) const {
    if (!(wanted <= static_cast<double>(flatness_.corners))) fail_corners();
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(wanted)));
  }

  void add(const Point& p) {
    if (flatness_.corners == 0) fail_corners();
    if (ring_.empty()) ring_.push_back(at_);
    flatness_.corners -= 1;
    ring_.push_back(p);
    at_ = p;
  }

  [[noreturn]] void fail_corners() const {
    data_.fail("the drawing's curves need too many corners: is its unit right? (see --unit)");
  }

  void finish() {
    if (ring_.size() > 1 && length(ring_.front() - ring_.back()) == 0) ring_.pop_back();
    if (!ring_.empty()) rings_.push_back(std::move(ring_));
    ring_.clear();
  }

  SvgScanner& data_;
  Flatness flatness_;
  std::vector<Ring> rings_;
  Ring ring_;        // the subpath that is being read; empty where it has only begun
  Point begin_;      // of the subpath
  Point at_;         // the current point
  Point control_;    // the last control point of a C or Q before
  char last_ = 'M';  // which command that was, upper case, C for S and Q for T
  bool relative_ = false;
  bool begun_ = false;
};

}  // namespace

std::vector<Ring> read_path(SvgScanner& data, const Flatness& flatness) { return PathReader(data, flatness).read(); }

}  // namespace krait::host
