// SPDX-License-Identifier: Apache-2.0
// Cases of the TPCAP parking benchmark: one row of numbers with commas between. The start's x, y and heading, the
// goal's x, y and heading, the number of obstacles, how many vertices each has, then their vertices, x before y.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "host/import/format.hpp"
#include "host/import/shapes.hpp"
#include "host/input/json.hpp"

namespace krait::host {
namespace {

constexpr double kMargin = 10;  // m; the file has no bounds, they lie this far around all its points
constexpr std::string_view kSpace = " \t\r\n";
constexpr std::ptrdiff_t kLeastCommas = 6;  // up to the number of obstacles

// By a first line of numbers and commas alone.
bool recognise(const Source& source) {
  const std::string_view content = source.content;
  const std::string_view line = content.substr(0, std::min(content.find('\n'), content.size()));
  return line.find_first_not_of("0123456789+-.eE, \t\r") == std::string_view::npos &&
         std::count(line.begin(), line.end(), ',') >= kLeastCommas;
}

// The values one after the other.
class Values {
 public:
  explicit Values(const Source& source)
      : file_(source.path),
        rest_(source.content),
        left_(static_cast<std::size_t>(std::count(rest_.begin(), rest_.end(), ',')) + 1) {}

  double number(const std::string& what, double most, const std::string& unit = {}) {
    const std::string_view text = next(what);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    if (!whole || !(std::abs(value) <= most)) {
      fail(what + " must be a number from " + shown(-most) + " to " + shown(most) + (unit.empty() ? "" : " ") + unit +
           ", is \"" + cleaned_name(std::string(text.substr(0, 40))) + "\"");
    }
    return value;
  }

  Point point(const std::string& what) {
    const double x = number("the x of " + what, kMaxFarCoordinate, "metres");
    return {x, number("the y of " + what, kMaxFarCoordinate, "metres")};
  }

  // A whole number of things that need `values_each` values of those that are left.
  std::size_t count(const std::string& what, std::size_t least, std::size_t values_each) {
    const double value = number(what, kMaxCoordinate);
    const std::size_t most = left_ / values_each;
    if (value != std::floor(value) || value < static_cast<double>(least)) {
      fail(what + " must be a whole number, at least " + std::to_string(least) + ", is " + shown(value));
    }
    if (value > static_cast<double>(most)) {
      fail(what + " is " + shown(value) + ", but the values that are left suffice for " + std::to_string(most));
    }
    return static_cast<std::size_t>(value);
  }

  void require_end() const {
    if (left_ > 0) fail("is followed by " + std::to_string(left_) + " values more than its counts say");
  }

 private:
  std::string_view next(const std::string& what) {
    number_ += 1;
    if (left_ == 0) fail(what + " is missing: the file ends early");
    left_ -= 1;
    const std::size_t end = std::min(rest_.find(','), rest_.size());
    std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(left_ == 0 ? rest_.size() : end + 1);
    text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
    return text.substr(0, text.find_last_not_of(kSpace) + 1);
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file_ + ": value " + std::to_string(number_) + ": " + what);
  }

  const std::string& file_;
  std::string_view rest_;
  std::size_t left_;        // values that are not read yet
  std::size_t number_ = 0;  // of the value that was read last, from 1
};

std::vector<Obstacle> read_obstacles(Values& values) {
  std::vector<std::size_t> counts(values.count("the number of obstacles", 0, 1));
  for (std::size_t i = 0; i < counts.size(); ++i) {
    counts[i] = values.count("the number of vertices of obstacle " + std::to_string(i + 1), 3, 2);
  }
  std::vector<Obstacle> obstacles;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    Obstacle obstacle{"obstacle " + std::to_string(i + 1), {}, {}};
    for (std::size_t k = 0; k < counts[i]; ++k) {
      obstacle.outer.push_back(values.point("vertex " + std::to_string(k + 1) + " of " + obstacle.label));
    }
    obstacles.push_back(std::move(obstacle));
  }
  return obstacles;
}

void include(const Point& p, Workspace& workspace) {
  workspace.min = {std::min(workspace.min.x, p.x - kMargin), std::min(workspace.min.y, p.y - kMargin)};
  workspace.max = {std::max(workspace.max.x, p.x + kMargin), std::max(workspace.max.y, p.y + kMargin)};
}

void set_bounds(const Point& goal, Workspace& workspace) {
  workspace.min = workspace.max = goal;
  include(goal, workspace);
  include(workspace.starts[0].position, workspace);
  for (const Obstacle& obstacle : workspace.obstacles) {
    for (const Point& p : obstacle.outer) include(p, workspace);
  }
}

Workspace read(const Source& source, const ImportOptions&) {
  Values values(source);
  Workspace workspace;
  const Point start = values.point("the start");
  workspace.starts.push_back({"start", start, values.number("the start's heading", kMaxAngle, "radians"), {}});
  const Point goal = values.point("the goal");
  const double heading = values.number("the goal's heading", kMaxAngle, "radians");
  workspace.goals.push_back(pose_goal("goal", {goal, kStateGoalRadius, {heading}}));
  workspace.obstacles = read_obstacles(values);
  values.require_end();
  set_bounds(goal, workspace);
  workspace.warnings = {source.path + ": the file has no bounds; they lie " + shown(kMargin) +
                        " m around all its points"};
  return workspace;
}

}  // namespace

const Format kTpcap = {"TPCAP case (.csv)", ".csv", recognise, read};

}  // namespace krait::host
