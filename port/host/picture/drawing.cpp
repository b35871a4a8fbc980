// SPDX-License-Identifier: Apache-2.0
// The still pictures: one painting for Cairo, on an SVG or an image surface.
#include <algorithm>
#include <array>
#include <cmath>

#include "host/picture/colors.hpp"
#include "host/picture/figure.hpp"
#include "host/picture/pen.hpp"
#include "host/picture/picture.hpp"
#include "host/picture/poses.hpp"
#include "host/picture/sheet.hpp"
#include "host/workspace/ring.hpp"

namespace krait::host {

namespace {

constexpr double kBarWidth = 250;  // points: the colour bar
constexpr double kBarHeight = 11;
constexpr double kLongestScaleBar = 150;

// A pen on one sheet.
class Painter : private Pen {
 public:
  Painter(cairo_t* context, const Picture& picture) : Pen(context), picture_(picture), figure_(layout(picture)) {}

  void paint() {
    source(kPaper);
    cairo_paint(cr_);
    head();
    cairo_save(cr_);
    map_rectangle();
    cairo_clip(cr_);
    regions();
    obstacles();
    goal();
    tree();
    path();
    bodies();
    goal_outline();
    heading();
    marks();
    cairo_restore(cr_);
    map_rectangle();
    stroke(kInk, 1.2);
    places();
    color_bar();
    scale_bar();
    key();
  }

 private:
  // ---- in the map
  void ring(const Ring& corners) {
    cairo_new_sub_path(cr_);
    for (const Point& corner : corners) line_to(figure_.at(corner));
    cairo_close_path(cr_);
  }
  void map_rectangle() { cairo_rectangle(cr_, figure_.left, figure_.top, figure_.map_width, figure_.map_height); }
  // A word so far beside a mark, kept inside the map, legible on any colour.
  void label(const std::string& text, Point mark, double aside = 10) {
    font(12.5, true);
    const double width = text_width(text);
    const double right = figure_.left + figure_.map_width;
    const double x = mark.x + aside + width > right - 4 ? mark.x - aside - width : mark.x + aside;
    const double y = std::clamp(mark.y - 8, figure_.top + 14, std::max(figure_.top + 14, bottom() - 6));
    cairo_move_to(cr_, x, y);
    cairo_text_path(cr_, text.c_str());
    cairo_set_line_join(cr_, CAIRO_LINE_JOIN_ROUND);
    source(kPaper, 0.92);
    cairo_set_line_width(cr_, 3.5);
    cairo_stroke_preserve(cr_);
    fill(kInk);
  }

  double bottom() const { return figure_.top + figure_.map_height; }
  double content_left() const { return kContentMargin; }
  double content_right() const { return figure_.width - kContentMargin; }

  // ---- the sheet from the top down
  void head() {
    const double width = content_right() - content_left();
    font(19, true);
    const std::string title = printable(picture_.title);
    write(fitted(title.empty() ? "krait" : title, width), {content_left(), 29}, Align::left, kInk);
    std::string line;
    for (const std::string& fact : facts(picture_)) line += (line.empty() ? "" : "  ·  ") + fact;
    font(12.5);
    write(fitted(line, width), {content_left(), 49}, Align::left, kFaint);
  }

  // Triangles of one colour are one path; their thin outlines close the seams between neighbours.
  void regions() {
    map_rectangle();
    fill(kFree);
    std::array<std::vector<const Triangle*>, kLevels + 1> by_level;
    const double top = picture_.frames.empty() ? 0 : top_cost(picture_.frames.front().costs);
    for (std::size_t i = 0; i < picture_.triangles.size(); ++i) {
      const auto level = picture_.frames.empty() ? std::uint8_t{0} : cost_level(picture_.frames.front().costs[i], top);
      by_level[level].push_back(&picture_.triangles[i]);
    }
    cairo_set_line_join(cr_, CAIRO_LINE_JOIN_ROUND);
    for (std::size_t level = 0; level < by_level.size(); ++level) {
      if (by_level[level].empty()) continue;
      for (const Triangle* triangle : by_level[level])
        ring({std::begin(triangle->corners), std::end(triangle->corners)});
      const Color color = picture_.frames.empty() ? kFree : level_color(static_cast<std::uint8_t>(level));
      fill_and_stroke(color, color, 0.7);
    }
    for (const Triangle& triangle : picture_.triangles)
      ring({std::begin(triangle.corners), std::end(triangle.corners)});
    stroke(kInk, 0.35, 0.22);
  }

  void obstacles() {
    for (const Ring& piece : picture_.obstacle_pieces) ring(piece);
    fill_and_stroke(kObstacle, kObstacle, 0.6);
  }

  void goal() {
    if (picture_.plan.goal_polygon.empty()) return;
    ring(picture_.plan.goal_polygon);
    cairo_set_line_join(cr_, CAIRO_LINE_JOIN_ROUND);
    fill_and_stroke(kGoal, kInk, 1.6);
  }

  // Over the bodies, which may cover all of it.
  void goal_outline() {
    if (picture_.plan.goal_polygon.empty()) return;
    ring(picture_.plan.goal_polygon);
    stroke(kInk, 3);
    ring(picture_.plan.goal_polygon);
    stroke(kGoal, 1.4);
  }

  void tree() {
    cairo_set_line_cap(cr_, CAIRO_LINE_CAP_ROUND);
    for (const TreeVertex& vertex : picture_.tree) {
      const TreeVertex& parent = picture_.tree[vertex.parent];
      move_to(figure_.at({parent.x, parent.y}));
      line_to(figure_.at({vertex.x, vertex.y}));
    }
    stroke(kInk, 0.55, 0.6);
  }

  void path() {
    for (const std::vector<float>& state : picture_.plan.states) line_to(figure_.at({state[0], state[1]}));
    cairo_set_line_join(cr_, CAIRO_LINE_JOIN_ROUND);
    cairo_path_t* const line = cairo_copy_path(cr_);
    stroke(kPaper, 4.2, 0.95);
    cairo_append_path(cr_, line);
    cairo_path_destroy(line);
    stroke(kInk, 1.9);
  }

  void robot(const std::vector<float>& state, Color inside, Color line, double width) {
    const std::vector<Pose> poses = body_poses(picture_.plan.robot, state);
    cairo_set_line_join(cr_, CAIRO_LINE_JOIN_ROUND);
    for (std::size_t k = poses.size(); k-- > 0;) {
      ring(placed(picture_.plan.robot.bodies[k], {poses[k].x, poses[k].y}, poses[k].heading));
      fill_and_stroke(inside, line, width);
    }
    draw_front(poses.front(), line, width);
  }

  void draw_front(const Pose& pose, Color line, double width) {
    cairo_new_sub_path(cr_);
    const Ring mark = placed(front_mark(picture_.plan.robot), {pose.x, pose.y}, pose.heading);
    for (const Point& corner : mark) line_to(figure_.at(corner));
    stroke(line, width);
  }

  // From the first body's front to the last one's end, metres, when the robot is straight.
  double robot_length() const {
    const RobotSpec& spec = picture_.plan.robot;
    double length = 0;
    for (const Point& corner : spec.bodies.front()) length = std::max(length, 2 * std::hypot(corner.x, corner.y));
    const auto hitch = spec.parameters.find("hitch_length");
    return hitch == spec.parameters.end() ? length : length + spec.links * std::abs(hitch->second);
  }

  // Between the first state and the last, the robot appears again whenever it has gone once its own length and a
  // bit, so that its images do not overlap, and at most some 60 times.
  void bodies() {
    const std::vector<std::vector<float>>& states = picture_.plan.states;
    if (stands()) robot(picture_.start, kRobotStart, kInk, 1.1);
    if (states.empty()) return;
    std::vector<double> gone = {0};
    for (std::size_t i = 1; i < states.size(); ++i) {
      gone.push_back(gone.back() +
                     std::hypot(static_cast<double>(states[i][0]) - static_cast<double>(states[i - 1][0]),
                                static_cast<double>(states[i][1]) - static_cast<double>(states[i - 1][1])));
    }
    const double step = image_step(gone.back());
    double next = step;
    for (std::size_t i = 1; i < states.size() && next < gone.back() - 0.5 * step; ++i) {
      if (gone[i] < next) continue;
      robot(states[i], kRobot, kInk, 0.8);
      on_its_way_ = true;
      next += step;
    }
    robot(states.front(), kRobotStart, kInk, 1.1);
    robot(states.back(), kRobotEnd, kPaper, 1.1);
  }

  // Metres between two images of the robot on a way of that length.
  double image_step(double length) const {
    const double least = std::max({1.3 * robot_length(), 16 / figure_.scale, length / 60});
    return length / std::max(1.0, std::floor(length / least));
  }

  bool has_start() const { return !picture_.plan.states.empty() || !picture_.tree.empty(); }
  Point start() const {
    if (picture_.plan.states.empty()) return figure_.at({picture_.tree.front().x, picture_.tree.front().y});
    return figure_.at({picture_.plan.states.front()[0], picture_.plan.states.front()[1]});
  }
  void start_mark(Point at) {
    disc(at, 5.5);
    fill_and_stroke(kRobotStart, kInk, 1.8);
  }

  // Without a plan the robot stands there alone, and is seen: where it is small, a ring around it leads the eye to it.
  bool stands() const { return picture_.plan.states.empty() && !picture_.start.empty(); }
  void mark_standing() {
    constexpr double kSmall = 12, kGap = 3, kFarthestLabel = 60;  // points
    double reach = 0;
    for (const Point& corner : picture_.plan.robot.bodies.front()) {
      reach = std::max(reach, figure_.scale * std::hypot(corner.x, corner.y));
    }
    const Point at = figure_.at({picture_.start[0], picture_.start[1]});
    if (reach < kSmall) {
      disc(at, reach + kGap);
      stroke(kInk, 1.4);
    }
    label("start", at, std::min(reach + 2 * kGap, kFarthestLabel));
  }

  // Numbered as in the line of facts; one beyond the map is drawn at its border.
  void places() {
    font(10.5, true);
    for (std::size_t i = 0; i < picture_.marks.size(); ++i) {
      Point at = figure_.at(picture_.marks[i].at);
      at.x = std::clamp(at.x, figure_.left, figure_.left + figure_.map_width);
      at.y = std::clamp(at.y, figure_.top, bottom());
      disc(at, 7.5);
      fill_and_stroke(kInk, kPaper, 1.5);
      write(std::to_string(i + 1), {at.x, at.y + 3.8}, Align::center, kPaper);
    }
  }

  void heading() {
    for (const Ring& arrow : goal_arrows(picture_.plan)) {
      cairo_new_sub_path(cr_);
      for (const Point& point : arrow) line_to(figure_.at(point));
    }
    cairo_set_line_cap(cr_, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cr_, CAIRO_LINE_JOIN_ROUND);
    stroke(kInk, 1.9);
  }

  void marks() {
    if (stands()) {
      mark_standing();
    } else if (has_start()) {
      start_mark(start());
      label("start", start());
    }
    if (picture_.plan.goal_polygon.empty()) return;
    Point top = figure_.at(picture_.plan.goal_polygon.front());
    for (const Point& corner : picture_.plan.goal_polygon) {
      const Point at = figure_.at(corner);
      if (at.y < top.y || (at.y <= top.y && at.x > top.x)) top = at;
    }
    label("goal", top);
  }

  // ---- the legend: first row colour bar and scale bar, second row the key
  void color_bar() {
    if (picture_.frames.empty()) return;
    const std::vector<float>& costs = picture_.frames.front().costs;
    const auto finite = [](float cost) { return std::isfinite(cost); };
    const double y = bottom() + 18;
    double x = content_left();
    font(11);
    if (std::any_of(costs.begin(), costs.end(), finite)) x = cost_scale(top_cost(costs), x, y);
    if (std::all_of(costs.begin(), costs.end(), finite)) return;
    cairo_rectangle(cr_, x, y, 16, kBarHeight);
    fill_and_stroke(kCutOff, kInk, 0.7);
    write("cut off", {x + 22, y + kBarHeight - 1.5}, Align::left, kInk);
  }

  // Returns where the next key may begin.
  double cost_scale(double top, double x, double y) {
    for (int i = 0; i < kLevels; ++i) {
      cairo_rectangle(cr_, x + i * kBarWidth / kLevels, y, kBarWidth / kLevels + (i + 1 < kLevels ? 0.5 : 0),
                      kBarHeight);
      fill(level_color(static_cast<std::uint8_t>(i)));
    }
    cairo_rectangle(cr_, x, y, kBarWidth, kBarHeight);
    stroke(kInk, 0.7);
    if (top > 0) cost_ticks(x, y + kBarHeight, top);
    write("cost to the goal (m)", {x + kBarWidth + 16, y + kBarHeight - 1.5}, Align::left, kInk);
    return x + kBarWidth + 34 + text_width("cost to the goal (m)");
  }

  void cost_ticks(double x, double y, double top) {
    const double step = round_length(top / 3);
    const int ticks = static_cast<int>(top / step);
    for (int i = 0; i <= ticks; ++i) {
      const double cost = i * step;
      const double at = x + kBarWidth * cost / top;
      cairo_move_to(cr_, at, y);
      cairo_line_to(cr_, at, y + 4);
      stroke(kInk, 0.7);
      write(short_number(cost), {at, y + 15}, cost > 0 ? Align::center : Align::left, kFaint);
    }
  }

  void scale_bar() {
    const double length = round_length(kLongestScaleBar / figure_.scale);
    const double right = content_right();
    const double left = right - length * figure_.scale;
    const double y = bottom() + 18 + kBarHeight;
    cairo_move_to(cr_, left, y - 6);
    cairo_line_to(cr_, left, y);
    cairo_line_to(cr_, right, y);
    cairo_line_to(cr_, right, y - 6);
    cairo_set_line_cap(cr_, CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(cr_, CAIRO_LINE_JOIN_MITER);
    stroke(kInk, 1.6);
    font(11);
    write(short_number(length) + " m", {(left + right) / 2, y + 15}, Align::center, kFaint);
  }

  void key() {
    const double y = bottom() + 80;
    double x = content_left();
    font(11.5);
    const auto entry = [&](const char* text, double symbol_width) {
      write(text, {x + symbol_width + 7, y + 4}, Align::left, kInk);
      x += symbol_width + 7 + text_width(text) + 20;
    };
    const auto box = [&](Color inside, Color line, double width) {
      cairo_rectangle(cr_, x, y - 4.5, 16, 9);
      fill_and_stroke(inside, line, width);
    };
    if (!picture_.obstacle_pieces.empty()) {
      box(kObstacle, kObstacle, 0.6);
      entry("obstacle", 16);
    }
    if (has_start() && !stands()) {
      start_mark({x + 5.5, y});
      entry("start", 11);
    }
    if (!picture_.plan.goal_polygon.empty()) {
      box(kGoal, kInk, 1.6);
      entry("goal", 16);
    }
    if (picture_.tree.size() > 1) {
      cairo_move_to(cr_, x, y);
      cairo_line_to(cr_, x + 18, y);
      stroke(kInk, 0.55, 0.6);
      entry("motion tree", 18);
    }
    if (stands()) {
      box(kRobotStart, kInk, 1.1);
      entry("robot at the start", 16);
    }
    if (picture_.plan.states.empty()) return;
    if (picture_.plan.states.size() > 1) {
      cairo_move_to(cr_, x, y);
      cairo_line_to(cr_, x + 18, y);
      stroke(kInk, 1.9);
      entry("plan", 18);
    }
    box(kRobotStart, kInk, 1.1);
    entry("robot at the start", 16);
    if (on_its_way_) {
      box(kRobot, kInk, 0.8);
      entry("on its way", 16);
    }
    box(kRobotEnd, kRobotEnd, 1.1);
    entry("at the end", 16);
  }

  static constexpr double kContentMargin = 28;

  const Picture& picture_;
  Figure figure_;
  bool on_its_way_ = false;  // the robot was drawn between start and end
};

}  // namespace

std::string draw_svg(const Picture& picture) {
  check(picture);
  const Figure figure = layout(picture);
  return svg_sheet(figure.width, figure.height, printable(picture.title),
                   [&](cairo_t* context) { Painter(context, picture).paint(); });
}

std::string draw_png(const Picture& picture) {
  check(picture);
  const Figure figure = layout(picture);
  return png_sheet(figure.width, figure.height, [&](cairo_t* context) { Painter(context, picture).paint(); });
}

}  // namespace krait::host
