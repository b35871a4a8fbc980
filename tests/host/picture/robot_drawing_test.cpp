// SPDX-License-Identifier: Apache-2.0
// The drawing of a robot is to scale: bodies stand where their axles are, and its sizes span what they are of.
#include "host/picture/robot_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pixels.hpp"

namespace krait::host {
namespace {

constexpr Color kSize = {0x1f, 0x4e, 0x8c};

bool is_near(Color a, Color b, int most) {
  const auto near = [most](int x, int y) { return std::abs(x - y) <= most; };
  return near(a.red, b.red) && near(a.green, b.green) && near(a.blue, b.blue);
}

// What paper shows of it through a colour that covers a share.
Color on_paper(Color color, double share) {
  const auto mixed = [share](int part, int paper) {
    return static_cast<std::uint8_t>(std::lround(share * part + (1 - share) * paper));
  };
  return {mixed(color.red, kPaper.red), mixed(color.green, kPaper.green), mixed(color.blue, kPaper.blue)};
}

// The columns from the first to the last pixel of a colour.
struct Span {
  unsigned first = std::numeric_limits<unsigned>::max();
  unsigned last = 0;

  double width() const { return last - first; }
  double middle() const { return 0.5 * (first + last); }
};

Span span_of(const Pixels& pixels, Color color) {
  Span span;
  for (unsigned i = 0; i < pixels.width * pixels.height; ++i) {
    if (!is_near({pixels.rgb[3 * i], pixels.rgb[3 * i + 1], pixels.rgb[3 * i + 2]}, color, 2)) continue;
    span.first = std::min(span.first, i % pixels.width);
    span.last = std::max(span.last, i % pixels.width);
  }
  return span;
}

// By row, the longest run of pixels in the colour of sizes.
std::vector<unsigned> longest_runs(const Pixels& pixels) {
  std::vector<unsigned> runs;
  for (unsigned row = 0; row < pixels.height; ++row) {
    unsigned longest = 0, run = 0;
    for (unsigned column = 0; column < pixels.width; ++column) {
      const std::size_t i = 3 * (std::size_t{row} * pixels.width + column);
      run = is_near({pixels.rgb[i], pixels.rgb[i + 1], pixels.rgb[i + 2]}, kSize, 70) ? run + 1 : 0;
      longest = std::max(longest, run);
    }
    runs.push_back(longest);
  }
  return runs;
}

// Two rows of pixels or more apart.
int lines_of_sizes(const Pixels& pixels, unsigned least) {
  int lines = 0;
  bool within = false;
  for (const unsigned run : longest_runs(pixels)) {
    lines += run >= least && !within ? 1 : 0;
    within = run >= least;
  }
  return lines;
}

Pixels drawn(const std::string& name) {
  RobotPicture picture;
  picture.title = name;
  picture.robot = parse_robot(name);
  picture.turn = {0, 0, 1, {}};
  return decode(draw_robot_png(picture));
}

TEST(RobotDrawing, ATrailerStandsBehindByItsHitch) {
  const Pixels pixels = drawn("truck:1");
  const Span body = span_of(pixels, on_paper(kRobotStart, 0.75));
  const Span trailer = span_of(pixels, on_paper(kFree, 0.8));
  ASSERT_GT(body.width(), 100);
  const RobotSpec robot = parse_robot("truck:1");
  const double length = robot.parameters.at("body_length"), hitch = robot.parameters.at("hitch_length");
  EXPECT_NEAR((body.middle() - trailer.middle()) / body.width(), hitch / length, 0.02);
  EXPECT_NEAR(trailer.width() / body.width(), 1, 0.02);
}

TEST(RobotDrawing, TheLongestSizeIsThatOfTheWholeRobot) {
  const Pixels pixels = drawn("truck:2");
  const RobotSpec robot = parse_robot("truck:2");
  const double length = robot.parameters.at("body_length"), hitch = robot.parameters.at("hitch_length");
  const double whole = robot.parameters.at("wheelbase") + 2 * hitch + length / 2;
  const std::vector<unsigned> runs = longest_runs(pixels);
  const double metre = span_of(pixels, on_paper(kRobotStart, 0.75)).width() / length;
  EXPECT_NEAR(*std::max_element(runs.begin(), runs.end()) / metre, whole, 0.02 * whole);
}

// Sizes of the whole, of body 0, of the wheelbase and of a trailer lie over one another.
TEST(RobotDrawing, SizesThatMeetHaveALineEach) { EXPECT_GE(lines_of_sizes(drawn("truck:1"), 200), 3); }

}  // namespace
}  // namespace krait::host
