// SPDX-License-Identifier: Apache-2.0
#include "host/picture/robot_drawing.hpp"

#include <algorithm>
#include <cmath>

#include "host/picture/figure.hpp"
#include "host/picture/pen.hpp"
#include "host/picture/sheet.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {

namespace {

constexpr double kSheetWidth = 900;  // points
constexpr double kSide = 62;         // beside the robot, for the sizes across it
constexpr double kMostHeight = 260;
constexpr double kFirstLine = 50;
constexpr double kLine = 17;
constexpr double kRow = 27;  // of sizes
constexpr double kTurnSide = 250;
constexpr Color kSize = {0x1f, 0x4e, 0x8c};  // sizes: lines and numbers
constexpr Color kSwept = {0xfb, 0xe9, 0xc4};

// A size along the robot: from x to x, metres.
struct Size {
  double from;
  double to;
  std::string text;
  std::size_t row = 0;
};

std::string metres(double value) { return printed("%.4g m", value); }

bool has(const RobotSpec& robot, const char* parameter) { return robot.parameters.count(parameter) > 0; }

double parameter(const RobotSpec& robot, const char* name) { return robot.parameters.at(name); }

struct Extent {
  Point min{1e9, 1e9};
  Point max{-1e9, -1e9};

  void add(double x, double y) {
    min = {std::min(min.x, x), std::min(min.y, y)};
    max = {std::max(max.x, x), std::max(max.y, y)};
  }
  void add(const Ring& ring, double x) {
    for (const Point& corner : ring) add(corner.x + x, corner.y);
  }
  double length() const { return max.x - min.x; }
  double width() const { return max.y - min.y; }
};

Extent extent_of(const Ring& body) {
  Extent extent;
  extent.add(body, 0);
  return extent;
}

class RobotPainter : private Pen {
 public:
  RobotPainter(cairo_t* context, const RobotPicture& picture)
      : Pen(context), picture_(picture), robot_(picture.robot), body0_(extent_of(robot_.bodies[0])) {
    for (std::size_t k = 0; k < robot_.bodies.size(); ++k) whole_.add(robot_.bodies[k], axle(k));
    whole_.add(axle(robot_.bodies.size() - 1), 0);
    if (has(robot_, "wheelbase")) whole_.add(parameter(robot_, "wheelbase"), 0);
    if (has(robot_, "track_width")) {
      for (const double side : {-0.5, 0.5}) whole_.add(0, side * parameter(robot_, "track_width"));
    }
    scale_ = std::min((kSheetWidth - 2 * kMargin - 2 * kSide) / whole_.length(), kMostHeight / whole_.width());
    left_ = 0.5 * kSheetWidth - 0.5 * scale_ * whole_.length();
    top_ = kFirstLine + kLine * static_cast<double>(picture_.lines.size()) + 22;
    sizes();
    place_sizes();
  }

  double height() const { return std::ceil(key_top() + 40 + kTurnSide + kMargin); }

  void paint() {
    source(kPaper);
    cairo_paint(cr_);
    head();
    for (std::size_t k = robot_.bodies.size(); k-- > 0;) body(k);
    for (std::size_t k = robot_.bodies.size(); k-- > 1;) drawbar(k);
    for (std::size_t k = robot_.bodies.size(); k-- > 0;) own_axle(k);
    if (has(robot_, "wheelbase")) steered_axle();
    const double ahead = std::max(body0_.max.x, has(robot_, "wheelbase") ? parameter(robot_, "wheelbase") : 0);
    reference_point(at({0, 0}), std::clamp(ahead * scale_ / 50, 0.4, 1.0));
    for (const Size& size : sizes_) lead_down(size);
    for (const Size& size : sizes_) draw(size);
    across();
    key();
    turn();
  }

 private:
  // Of body k's axle, the robot standing straight with body 0's at 0.
  double axle(std::size_t k) const { return k == 0 ? 0 : -static_cast<double>(k) * parameter(robot_, "hitch_length"); }

  Point at(Point local) const {
    return {left_ + (local.x - whole_.min.x) * scale_, top_ + (whole_.max.y - local.y) * scale_};
  }
  double bottom() const { return top_ + whole_.width() * scale_; }
  double key_top() const { return bottom() + 14 + kRow * static_cast<double>(rows_) + 22; }

  void head() {
    const double width = kSheetWidth - 2 * kMargin;
    font(19, true);
    write(fitted(printable(picture_.title), width), {kMargin, 29}, Align::left, kInk);
    font(12);
    double y = kFirstLine;
    for (const std::string& line : picture_.lines) {
      write(fitted(printable(line), width), {kMargin, y}, Align::left, kFaint);
      y += kLine;
    }
  }

  void body(std::size_t k) {
    cairo_new_path(cr_);
    for (const Point& corner : robot_.bodies[k]) line_to(at({corner.x + axle(k), corner.y}));
    cairo_close_path(cr_);
    cairo_set_line_join(cr_, CAIRO_LINE_JOIN_ROUND);
    source(k == 0 ? kRobotStart : kFree, k == 0 ? 0.75 : 0.8);
    cairo_fill_preserve(cr_);
    stroke(kInk, 1.1);
  }

  // The line from a trailer's axle to its hitch, and the hitch.
  void drawbar(std::size_t k) {
    move_to(at({axle(k), 0}));
    line_to(at({axle(k - 1), 0}));
    stroke(kInk, 1.6);
    hitch(at({axle(k - 1), 0}));
  }
  void hitch(Point middle) {
    disc(middle, std::clamp(0.16 * parameter(robot_, "hitch_length") * scale_, 3.5, 6.5));
    fill_and_stroke(kGoal, kInk, 1.2);
  }

  void wheel(Point middle, double length, double thickness, double angle) {
    cairo_save(cr_);
    cairo_translate(cr_, middle.x, middle.y);
    cairo_rotate(cr_, -angle);
    cairo_rectangle(cr_, -0.5 * length, -0.5 * thickness, length, thickness);
    cairo_restore(cr_);
    fill(kInk);
  }
  // An axle with two wheels, `half` metres from its middle, turned by `angle`.
  void axle_with_wheels(double x, double half, double wheel_points, double angle) {
    const Point right = at({x, -half});
    const Point left = at({x, half});
    move_to(right);
    line_to(left);
    stroke(kInk, 1.6);
    const double length = std::max(8.0, wheel_points);
    for (const Point& end : {right, left}) wheel(end, length, std::max(3.0, 0.3 * length), angle);
  }
  // The wheels' places and sizes are not parameters of a steered robot: they are drawn inside the body.
  double symbolic_half(std::size_t k) const { return 0.38 * extent_of(robot_.bodies[k]).width(); }
  double symbolic_wheel(std::size_t k) const {
    return std::min(0.22 * extent_of(robot_.bodies[k]).width() * scale_, 26.0);
  }
  void own_axle(std::size_t k) {
    if (has(robot_, "track_width")) {
      axle_with_wheels(0, 0.5 * parameter(robot_, "track_width"), 2 * parameter(robot_, "wheel_radius") * scale_, 0);
    } else {
      axle_with_wheels(axle(k), symbolic_half(k), symbolic_wheel(k), 0);
    }
    if (k + 1 < robot_.bodies.size()) hitch(at({axle(k), 0}));
  }
  void steered_axle() {
    move_to(at({0, 0}));
    line_to(at({parameter(robot_, "wheelbase"), 0}));
    stroke(kInk, 1, 0.4);
    axle_with_wheels(parameter(robot_, "wheelbase"), symbolic_half(0), symbolic_wheel(0),
                     parameter(robot_, "max_steering"));
  }

  // The point that x, y and the heading are of, with the heading's arrow.
  void reference_point(Point point, double share) {
    move_to(point);
    line_to({point.x + 34 * share, point.y});
    move_to({point.x + 28 * share, point.y - 4});
    line_to({point.x + 34 * share, point.y});
    line_to({point.x + 28 * share, point.y + 4});
    stroke(kRobotEnd, 2);
    disc(point, 3.6);
    fill_and_stroke(kPaper, kRobotEnd, 2);
  }

  // ---- sizes
  void add_size(double from, double to, const std::string& what) {
    if (to - from < 1e-9) return;
    sizes_.push_back({from, to, (what.empty() ? "" : what + ": ") + metres(to - from)});
  }
  void sizes() {
    const std::size_t last = robot_.bodies.size() - 1;
    const double front = has(robot_, "wheelbase") ? parameter(robot_, "wheelbase") : 0;
    if (front > 0) add_size(0, front, "wheelbase");
    add_size(front, body0_.max.x, "");
    add_size(body0_.min.x, 0, "");
    if (last > 0) {
      const Extent tail = extent_of(robot_.bodies[last]);
      add_size(axle(1), 0, last > 1 ? "each hitch" : "hitch");
      add_size(axle(last) + tail.min.x, axle(last), "");
      const Extent first = extent_of(robot_.bodies[1]);
      add_size(axle(1) + first.min.x, axle(1) + first.max.x, "trailer");
    }
    add_size(body0_.min.x, body0_.max.x, last > 0 ? "body 0" : "");
    if (last > 0) add_size(whole_.min.x, whole_.max.x, "all");
  }

  // How far the line and the number of a size reach, points.
  std::pair<double, double> reach(const Size& size) {
    const double from = at({size.from, 0}).x;
    const double to = at({size.to, 0}).x;
    const double half = 0.5 * text_width(size.text) + 5;
    const double middle = std::clamp(0.5 * (from + to), kMargin + half, kSheetWidth - kMargin - half);
    return {std::min(from, middle - half), std::max(to, middle + half)};
  }
  // Every size goes to the first row where neither its line nor its number meets another's.
  void place_sizes() {
    font(11.5);
    for (std::size_t i = 0; i < sizes_.size(); ++i) {
      const auto meets = [&](const Size& other) {
        const auto a = reach(sizes_[i]);
        const auto b = reach(other);
        const bool joined = sizes_[i].from == other.to || sizes_[i].to == other.from;
        const double gap = joined ? -0.5 : 8;
        return other.row == sizes_[i].row && a.first < b.second + gap && b.first < a.second + gap;
      };
      while (std::any_of(sizes_.begin(), sizes_.begin() + static_cast<std::ptrdiff_t>(i), meets)) ++sizes_[i].row;
      rows_ = std::max(rows_, sizes_[i].row + 1);
    }
  }

  void arrow(Point tip, double dx, double dy) {
    move_to({tip.x + dx - dy * 0.45, tip.y + dy + dx * 0.45});
    line_to(tip);
    line_to({tip.x + dx + dy * 0.45, tip.y + dy - dx * 0.45});
    stroke(kSize, 1);
  }
  double level(const Size& size) const { return bottom() + 32 + kRow * static_cast<double>(size.row); }
  // Thin lines from the robot.
  void lead_down(const Size& size) {
    for (const double end : {size.from, size.to}) {
      move_to({at({end, 0}).x, bottom()});
      line_to({at({end, 0}).x, level(size) + 4});
      stroke(kSize, 0.5, 0.35);
    }
  }
  void draw(const Size& size) {
    const double from = at({size.from, 0}).x;
    const double to = at({size.to, 0}).x;
    const double y = level(size);
    move_to({from, y});
    line_to({to, y});
    stroke(kSize, 1);
    if (to - from > 12) {
      arrow({from, y}, 6, 0);
      arrow({to, y}, -6, 0);
    }
    font(11.5);
    const double half = 0.5 * text_width(size.text);
    const double middle = std::clamp(0.5 * (from + to), kMargin + half, kSheetWidth - kMargin - half);
    cairo_rectangle(cr_, middle - half - 2, y - 15, 2 * half + 4, 13.5);
    fill(kPaper);
    write(size.text, {middle, y - 4}, Align::center, kSize);
  }

  // A size across the robot, beside it.
  void across(double x, double low, double high, const std::string& what) {
    const Point up = at({0, high});
    const Point down = at({0, low});
    move_to({x, up.y});
    line_to({x, down.y});
    stroke(kSize, 1);
    for (const Point& end : {up, down}) {
      move_to({x - 4, end.y});
      line_to({x + 4, end.y});
      stroke(kSize, 1);
    }
    cairo_save(cr_);
    cairo_translate(cr_, x + (x < 0.5 * kSheetWidth ? -6 : 15), 0.5 * (up.y + down.y));
    cairo_rotate(cr_, -std::numbers::pi / 2);
    font(11.5);
    write(what + metres(high - low), {0, 0}, Align::center, kSize);
    cairo_restore(cr_);
  }
  void across() {
    const double right = at(whole_.max).x + 20;
    const double left = at(whole_.min).x - 20;
    across(right, body0_.min.y, body0_.max.y, "");
    const Extent last = extent_of(robot_.bodies.back());
    if (has(robot_, "track_width")) {
      const double half = 0.5 * parameter(robot_, "track_width");
      across(left, -half, half, "track ");
    } else if (robot_.links > 0) {
      across(left, last.min.y, last.max.y, "");
    }
  }

  void key() {
    double x = kMargin;
    const double y = key_top();
    font(11.5);
    const auto entry = [&](const std::string& text, double symbol) {
      write(text, {x + symbol + 8, y + 4}, Align::left, kInk);
      x += symbol + 8 + text_width(text) + 26;
    };
    reference_point({x + 4, y}, 0.7);
    entry("x, y and the heading of a state", 30);
    wheel({x + 9, y}, 18, 6, 0);
    entry(has(robot_, "wheelbase") ? "axle" : "wheels", 18);
    if (has(robot_, "wheelbase")) {
      wheel({x + 9, y}, 18, 6, 0.5);
      entry("steered axle, at full lock", 18);
    }
    if (robot_.links > 0) {
      hitch({x + 7, y});
      entry("hitch, over the axle ahead", 14);
    }
  }

  // The tightest steady turn, seen from above.
  void turn() {
    const TurnPicture& turn = picture_.turn;
    const double y = key_top() + 40;
    const double scale = 0.5 * kTurnSide / turn.outer;
    const Point center{kMargin + 0.5 * kTurnSide + 4, y + 0.5 * kTurnSide};
    const auto seen = [&](const Point& local) {
      return Point{center.x + local.x * scale, center.y - (local.y - turn.radius) * scale};
    };
    disc(center, turn.outer * scale);
    fill_and_stroke(kSwept, kSize, 1);
    if (turn.inner > 0) {
      disc(center, turn.inner * scale);
      fill_and_stroke(kPaper, kSize, 1);
    }
    if (turn.radius > 0) {
      const double dashes[] = {4, 4};
      cairo_set_dash(cr_, dashes, 2, 0);
      disc(center, turn.radius * scale);
      stroke(kRobotEnd, 1.2);
      cairo_set_dash(cr_, nullptr, 0, 0);
    }
    for (std::size_t k = turn.bodies.size(); k-- > 0;) {
      cairo_new_path(cr_);
      for (const Point& corner : turn.bodies[k]) line_to(seen(corner));
      cairo_close_path(cr_);
      source(k == 0 ? kRobotStart : kFree, 0.85);
      cairo_fill_preserve(cr_);
      stroke(kInk, 0.9);
    }
    disc(center, 2.5);
    fill(kInk);
    turn_text(y);
  }
  void turn_text(double y) {
    const TurnPicture& turn = picture_.turn;
    const double x = kMargin + kTurnSide + 44;
    font(13, true);
    write(turn.radius > 0 ? "The tightest steady turn" : "A turn on the spot", {x, y + 40}, Align::left, kInk);
    font(12);
    double row = y + 40;
    const auto line = [&](const std::string& text) { write(text, {x, row += 22}, Align::left, kFaint); };
    if (turn.radius > 0) line("radius of the path of x, y (dashed): " + metres(turn.radius));
    line("outer radius of what it sweeps: " + metres(turn.outer));
    if (turn.inner > 0) line("inner radius of what it sweeps: " + metres(turn.inner));
    line("width of what it sweeps: " + metres(turn.radius > 0 ? turn.outer - turn.inner : 2 * turn.outer));
  }

  const RobotPicture& picture_;
  const RobotSpec& robot_;
  Extent body0_;
  Extent whole_;
  double scale_ = 1;  // points a metre
  double left_ = 0;
  double top_ = 0;
  std::vector<Size> sizes_;
  std::size_t rows_ = 0;
};

// The sheet is as high as its sizes need, which fonts decide.
double height_of(const RobotPicture& picture) {
  double height = 0;
  png_sheet(1, 1, [&](cairo_t* context) { height = RobotPainter(context, picture).height(); });
  return height;
}

}  // namespace

std::string draw_robot_svg(const RobotPicture& picture) {
  return svg_sheet(kSheetWidth, height_of(picture), printable(picture.title),
                   [&](cairo_t* context) { RobotPainter(context, picture).paint(); });
}

std::string draw_robot_png(const RobotPicture& picture) {
  return png_sheet(kSheetWidth, height_of(picture), [&](cairo_t* context) { RobotPainter(context, picture).paint(); });
}

}  // namespace krait::host
