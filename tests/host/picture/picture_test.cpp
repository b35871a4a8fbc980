// SPDX-License-Identifier: Apache-2.0
#include "host/picture/picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <ostream>
#include <pugixml.hpp>

#include "host/picture/colors.hpp"
#include "host/picture/figure.hpp"
#include "host/picture/poses.hpp"
#include "pixels.hpp"
#include "synthetic.hpp"

namespace krait::host {
namespace {

using test::bare_picture;
using test::scaled;
using test::synthetic_picture;
using testing::HasSubstr;
using testing::Not;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// ---- reading back what was drawn, with other libraries

Color color_at(const Picture& picture, Point local) { return decode(draw_png(picture)).at(layout(picture).at(local)); }

MATCHER_P(IsColor, wanted, "") {
  *result_listener << int{arg.red} << " " << int{arg.green} << " " << int{arg.blue};
  const auto near = [](int a, int b) { return std::abs(a - b) <= 2; };
  return near(arg.red, wanted.red) && near(arg.green, wanted.green) && near(arg.blue, wanted.blue);
}

bool is_svg(const std::string& svg) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(svg.data(), svg.size());
  return parsed && document.child("svg") && document.child("svg").attribute("width").as_double() > 0;
}

std::string data_text(const std::string& html) {
  const std::string opening = R"(<script type="application/json" id="data">)";
  const std::size_t begin = html.find(opening) + opening.size();
  return html.substr(begin, html.find("</script>", begin) - begin);
}

nlohmann::json data_of(const std::string& html) { return nlohmann::json::parse(data_text(html)); }

std::vector<std::uint8_t> bytes_of(const nlohmann::json& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : base64.get<std::string>()) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> count & 0xFFU));
  }
  return bytes;
}

std::int32_t millimetres(const std::vector<std::uint8_t>& bytes, std::size_t index) {
  std::uint32_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = value << 8 | bytes.at(4 * index + k);
  return static_cast<std::int32_t>(value);
}

Picture without_plan() {
  Picture picture = synthetic_picture();
  picture.plan.states.clear();
  picture.plan.controls.clear();
  picture.plan.status = "no_route";
  return picture;
}

// ---- still pictures

TEST(Svg, IsWellFormed) { EXPECT_TRUE(is_svg(draw_svg(synthetic_picture()))); }

TEST(Svg, CarriesTheTitleForScreenReaders) {
  pugi::xml_document document;
  document.load_string(draw_svg(synthetic_picture()).c_str());
  EXPECT_STREQ(document.child("svg").child_value("title"), "synthetic S");
}

TEST(Png, HasTheSizeOfItsLayout) {
  const Picture picture = synthetic_picture();
  const Pixels pixels = decode(draw_png(picture));
  EXPECT_EQ(pixels.width, kPixelsPerPoint * static_cast<unsigned>(layout(picture).width));
  EXPECT_EQ(pixels.height, kPixelsPerPoint * static_cast<unsigned>(layout(picture).height));
}

TEST(Png, ObstacleGoalAndSheetHaveTheirColors) {
  const Picture picture = synthetic_picture();
  EXPECT_THAT(color_at(picture, {25, 17}), IsColor(kObstacle));
  EXPECT_THAT(color_at(picture, {43, 42.5}), IsColor(kGoal));
  EXPECT_THAT(decode(draw_png(picture)).at({3, 3}), IsColor(kPaper));
}

TEST(Png, NearTheGoalIsRedFarIsBlueCutOffIsGrey) {
  Picture picture = synthetic_picture();
  picture.tree.clear();
  const Color near = color_at(picture, {42.7, 44.4});
  EXPECT_GT(near.red, 2 * near.blue);
  std::size_t farthest = 0;
  const std::vector<float>& costs = picture.frames.front().costs;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    if (std::isfinite(costs[i]) && costs[i] > costs[farthest]) farthest = i;
  }
  const Point* corners = picture.triangles[farthest].corners;
  const Color far = color_at(
      picture, {(corners[0].x + corners[1].x + corners[2].x) / 3, (corners[0].y + corners[1].y + corners[2].y) / 3});
  EXPECT_GT(far.blue, 2 * far.red);
  EXPECT_THAT(color_at(picture, {48.7, 2.4}), IsColor(kCutOff));
}

TEST(Png, FreeSpaceWithoutCostsIsPlain) {
  Picture picture = without_plan();
  picture.frames.clear();
  picture.tree.clear();
  EXPECT_THAT(color_at(picture, {2.7, 28.4}), IsColor(kFree));
}

// Raised costs would hide where the goal is.
TEST(Png, ColorsAreOfTheBeginOfTheSearch) {
  Picture picture = bare_picture(10, 10);
  picture.triangles = {{{{0, 0}, {10, 0}, {0, 10}}}, {{{10, 0}, {10, 10}, {0, 10}}}};
  picture.frames = {{0, {0, 10}}, {5, {20, 0}}};
  EXPECT_THAT(color_at(picture, {2, 2}), IsColor(level_color(0)));
  EXPECT_THAT(color_at(picture, {8, 8}), IsColor(level_color(kLevels - 1)));
}

TEST(Png, WithoutAPlanTheRobotStandsAtItsStart) {
  Picture picture = bare_picture(20, 20);
  picture.plan.robot.model = "truck";
  picture.plan.robot.links = 1;
  picture.plan.robot.parameters["hitch_length"] = 0.8;
  picture.plan.robot.bodies = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}};
  picture.plan.dt = 0.1;
  EXPECT_THAT(color_at(picture, {8, 12}), IsColor(kFree));
  picture.start = {10, 10, 0, 0, 0, 0};
  EXPECT_THAT(color_at(picture, {8, 12}), IsColor(kRobotStart));
}

// A square of 4 m, alike in front and behind.
Picture standing(double heading) {
  Picture picture = bare_picture(20, 20);
  picture.plan.robot.model = "car";
  picture.plan.robot.bodies = {{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}};
  picture.plan.dt = 0.1;
  picture.start = {10, 10, static_cast<float>(heading), 0, 0};
  return picture;
}

TEST(Png, TheFrontOfTheFirstBodyIsMarked) {
  const Point tip{10 + 1.4, 10};
  EXPECT_THAT(color_at(standing(0), tip), Not(IsColor(kRobotStart)));
  EXPECT_THAT(color_at(standing(std::acos(-1.0)), tip), IsColor(kRobotStart));
}

// A robot of 4 m by 0.5 m is a line of 9 points.
TEST(Png, WithoutAPlanASmallRobotAtItsStartIsSeenInARing) {
  Picture picture = standing(0);
  picture.max = {400, 400};
  picture.plan.robot.bodies = {{{-2, -0.25}, {2, -0.25}, {2, 0.25}, {-2, 0.25}}};
  picture.start = {200, 200, 0, 0, 0};
  picture.tree = {{200, 200, 0, 0}};
  EXPECT_THAT(color_at(picture, {200, 201.2}), IsColor(kFree)) << "no disc lies over it";
  const Figure figure = layout(picture);
  const Point at = figure.at({200, 200});
  const double ring = figure.scale * std::hypot(2, 0.25) + 3;
  EXPECT_THAT(decode(draw_png(picture)).at({at.x, at.y + ring}), IsColor(kInk));
  picture.plan.robot.bodies = {{{-20, -2.5}, {20, -2.5}, {20, 2.5}, {-20, 2.5}}};
  EXPECT_THAT(decode(draw_png(picture)).at({at.x, at.y + 10 * (ring - 3) + 3}), IsColor(kFree)) << "it needs no ring";
}

TEST(Png, AGoalUnderTheRobotKeepsItsOutline) {
  Picture picture = standing(0);
  picture.plan.goal_polygon = {{9, 9}, {10.5, 9}, {10.5, 11}, {9, 11}};
  EXPECT_THAT(color_at(picture, {9, 10.5}), IsColor(kGoal));
}

TEST(Png, APlaceBeyondTheMapIsDrawnAtItsBorder) {
  Picture picture = bare_picture(20, 20);
  picture.marks = {{{12, -1}, "stops it"}};
  const Figure figure = layout(picture);
  const Point border = figure.at({12, 0});
  EXPECT_THAT(decode(draw_png(picture)).at({border.x - 5, border.y + 3}), IsColor(kInk));
}

// The pixels of the legend's last row.
std::vector<std::uint8_t> key_of(const Picture& picture) {
  const Figure figure = layout(picture);
  const Pixels pixels = decode(draw_png(picture));
  const auto row = static_cast<std::size_t>((figure.top + figure.map_height + 65) * kPixelsPerPoint);
  return {pixels.rgb.begin() + static_cast<std::ptrdiff_t>(3 * row * pixels.width), pixels.rgb.end()};
}

// A plan straight ahead by `steps` steps of 0.1 m.
Picture going(int steps) {
  Picture picture = standing(0);
  picture.plan.status = "solved";
  for (int i = 0; i <= steps; ++i) picture.plan.states.push_back({2 + 0.1F * static_cast<float>(i), 10, 0, 0, 0});
  picture.plan.controls.assign(static_cast<std::size_t>(steps), {0, 0});
  return picture;
}

TEST(Png, TheLegendHasWhatIsDrawnOnly) {
  Picture rooted = going(5);
  rooted.tree = {{2, 10, 0, 0}};
  EXPECT_EQ(key_of(rooted), key_of(going(5)));
  rooted.tree.push_back({3, 10, 0, 1});
  EXPECT_NE(key_of(rooted), key_of(going(5)));
  EXPECT_NE(key_of(going(0)), key_of(going(5))) << "the plan's line";
  EXPECT_EQ(key_of(going(1)), key_of(going(5)));
  EXPECT_NE(key_of(going(5)), key_of(going(160))) << "on its way";
}

TEST(Png, PlacesThatHaveNoWayAreNumberedAndNamed) {
  Picture picture = bare_picture(20, 20);
  EXPECT_THAT(color_at(picture, {8.1, 12}), IsColor(kFree));
  picture.marks = {{{12, 4}, "tried most"}, {{8, 12}, "stops body 1"}};
  EXPECT_THAT(color_at(picture, {8.1, 12}), IsColor(kInk));
  EXPECT_THAT(draw_html(picture), HasSubstr(" · 1 tried most · 2 stops body 1"));
}

TEST(Png, RobotStandsWhereItEnds) {
  const Picture picture = synthetic_picture();
  const std::vector<float>& last = picture.plan.states.back();
  const Pose tail = body_poses(picture.plan.robot, last).back();
  EXPECT_THAT(color_at(picture, {tail.x, tail.y}), IsColor(kRobotEnd));
}

TEST(Png, TheWayUpIsY) {
  Picture picture = bare_picture(10, 10);
  picture.obstacle_pieces = {{{0, 8}, {10, 8}, {10, 10}, {0, 10}}};
  EXPECT_THAT(color_at(picture, {5, 9}), IsColor(kObstacle));
  EXPECT_THAT(color_at(picture, {5, 1}), IsColor(kFree));
}

// ---- every form, on unusual pictures

struct Unusual {
  const char* name;
  std::function<Picture()> make;
};

void PrintTo(const Unusual& picture, std::ostream* out) { *out << picture.name; }

class UnusualPicture : public testing::TestWithParam<Unusual> {};

TEST_P(UnusualPicture, IsDrawnInEveryForm) {
  const Picture picture = GetParam().make();
  EXPECT_TRUE(is_svg(draw_svg(picture)));
  EXPECT_GT(decode(draw_png(picture)).width, 0U);
  EXPECT_TRUE(data_of(draw_html(picture)).is_object());
}

TEST_P(UnusualPicture, GivesTheSameBytesTwice) {
  const Picture picture = GetParam().make();
  EXPECT_EQ(draw_svg(picture), draw_svg(picture));
  EXPECT_EQ(draw_png(picture), draw_png(picture));
  EXPECT_EQ(draw_html(picture), draw_html(picture));
}

Picture with(const std::function<void(Picture&)>& change) {
  Picture picture = synthetic_picture();
  change(picture);
  return picture;
}

INSTANTIATE_TEST_SUITE_P(
    Picture, UnusualPicture,
    testing::Values(Unusual{"usual", synthetic_picture}, Unusual{"without_plan", without_plan},
                    Unusual{"bare", [] { return bare_picture(3, 3); }},
                    Unusual{"without_tree", [] { return with([](Picture& p) { p.tree.clear(); }); }},
                    Unusual{"without_costs", [] { return with([](Picture& p) { p.frames.clear(); }); }},
                    Unusual{"car", [] { return test::driven_by("car"); }},
                    Unusual{"unicycle", [] { return test::driven_by("unicycle"); }},
                    Unusual{"diff_drive", [] { return test::driven_by("diff_drive"); }},
                    Unusual{"one_state", [] { return with([](Picture& p) { p.plan.states.resize(1); }); }},
                    Unusual{"standing_still",
                            [] { return with([](Picture& p) { p.plan.states.assign(50, p.plan.states[0]); }); }},
                    Unusual{"all_cut_off",
                            [] {
                              return with([](Picture& p) {
                                for (CostFrame& frame : p.frames) frame.costs.assign(frame.costs.size(), kInfinity);
                              });
                            }},
                    Unusual{"costs_all_zero",
                            [] {
                              return with([](Picture& p) {
                                for (CostFrame& frame : p.frames) frame.costs.assign(frame.costs.size(), 0.0F);
                              });
                            }},
                    Unusual{"costs_huge", [] { return with([](Picture& p) { p.frames.back().costs[0] = 3e38F; }); }},
                    Unusual{"coordinates_huge",
                            [] {
                              return with([](Picture& p) {
                                p.obstacle_pieces[0][0] = {1e300, -1e300};
                                p.tree[1].x = 3e38F;
                                p.plan.states[5][0] = -3e38F;
                              });
                            }},
                    Unusual{"room_of_3_m", [] { return scaled(synthetic_picture(), 0.06); }},
                    Unusual{"site_of_400_m", [] { return scaled(synthetic_picture(), 8); }},
                    Unusual{"corridor", [] { return bare_picture(400, 0.5); }},
                    Unusual{"tower", [] { return bare_picture(0.5, 400); }},
                    Unusual{"speck", [] { return bare_picture(1e-6, 1e-6); }},
                    Unusual{"hostile_text",
                            [] {
                              return with([](Picture& p) {
                                p.title = std::string("</script>]]>{{data}}\xff\xc3\x01\0\xEF\xBF\xBF\n", 26) +
                                          std::string(5000, 'W');
                                p.plan.status = "\xed\xa0\x80<b>";
                                p.plan.planner = "<svg onload=x>";
                              });
                            }}),
    [](const auto& chosen) { return std::string(chosen.param.name); });

// ---- bad pictures

struct Bad {
  const char* name;
  std::function<void(Picture&)> spoil;
  const char* complaint;
};

void PrintTo(const Bad& picture, std::ostream* out) { *out << picture.name; }

class BadPicture : public testing::TestWithParam<Bad> {};

TEST_P(BadPicture, IsRefusedWithItsReason) {
  Picture picture = synthetic_picture();
  GetParam().spoil(picture);
  const auto refused = testing::ThrowsMessage<InputError>(HasSubstr(GetParam().complaint));
  EXPECT_THAT([&] { draw_svg(picture); }, refused);
  EXPECT_THAT([&] { draw_png(picture); }, refused);
  EXPECT_THAT([&] { draw_html(picture); }, refused);
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    Picture, BadPicture,
    testing::Values(Bad{"bounds_empty", [](Picture& p) { p.max = p.min; }, "bounds"},
                    Bad{"bounds_turned", [](Picture& p) { p.max.x = -1; }, "bounds"},
                    Bad{"bounds_nan", [](Picture& p) { p.max.y = kNan; }, "bounds"},
                    Bad{"bounds_huge", [](Picture& p) { p.max.y = 1e300; }, "bounds"},
                    Bad{"obstacle_nan", [](Picture& p) { p.obstacle_pieces[2][1].x = kNan; }, "obstacle_pieces[2]"},
                    Bad{"triangle_nan", [](Picture& p) { p.triangles[3].corners[1].x = kNan; }, "triangles[3]"},
                    Bad{"goal_nan", [](Picture& p) { p.plan.goal_polygon[0].x = kNan; }, "plan.goal"},
                    Bad{"frame_short", [](Picture& p) { p.frames[1].costs.pop_back(); }, "frames[1]"},
                    Bad{"cost_nan", [](Picture& p) { p.frames[1].costs[0] = static_cast<float>(kNan); }, "frames[1]"},
                    Bad{"frames_disordered", [](Picture& p) { p.frames[1].iteration = 99999; }, "ascending"},
                    Bad{"tree_disordered", [](Picture& p) { p.tree[1].iteration = 99999; }, "ascending"},
                    Bad{"tree_parent", [](Picture& p) { p.tree[7].parent = 8; }, "tree[7]"},
                    Bad{"tree_nan", [](Picture& p) { p.tree[7].x = static_cast<float>(kNan); }, "tree[7]"},
                    Bad{"mark_nan",
                        [](Picture& p) {
                          p.marks = {{{1, kNan}, "nowhere"}};
                        },
                        "marks[0]"},
                    Bad{"start_short",
                        [](Picture& p) {
                          p.start = {1, 2};
                        },
                        "start has 2 values"},
                    Bad{"start_nan",
                        [](Picture& p) {
                          p.start = p.plan.states[0];
                          p.start[1] = static_cast<float>(kNan);
                        },
                        "start"},
                    Bad{"state_short", [](Picture& p) { p.plan.states[4].pop_back(); }, "plan.states[4]"},
                    Bad{"state_infinite", [](Picture& p) { p.plan.states[4][1] = kInfinity; }, "plan.states[4]"},
                    Bad{"bodies_missing", [](Picture& p) { p.plan.robot.bodies.pop_back(); }, "robot.bodies"},
                    Bad{"hitch_missing", [](Picture& p) { p.plan.robot.parameters.clear(); }, "hitch_length"},
                    Bad{"model_unknown", [](Picture& p) { p.plan.robot.model = "hovercraft"; }, "hovercraft"},
                    Bad{"dt_zero", [](Picture& p) { p.plan.dt = 0; }, "plan.dt"}),
    [](const auto& chosen) { return std::string(chosen.param.name); });

// ---- the page

TEST(Page, FetchesNothing) {
  const std::string html = draw_html(synthetic_picture());
  for (const char* reference : {"http:", "https:", "src=", "@import", "fetch(", "XMLHttpRequest", "url("}) {
    EXPECT_THAT(html, Not(HasSubstr(reference)));
  }
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
}

TEST(Page, HostileNamesStayText) {
  Picture picture = synthetic_picture();
  picture.title = "</script><script>alert(1)</script>{{data}}";
  picture.plan.state_names[0] = "</script><script>alert(1)</script>";
  picture.plan.state_names[1] = "&lt;/script &";
  const std::string html = draw_html(picture);
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(html, HasSubstr("<h1>&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;{{data}}</h1>"));
  EXPECT_EQ(data_of(html)["names"][0], "</script><script>alert(1)</script>");
  for (const char* sign : {"<", ">", "&"}) EXPECT_THAT(data_text(html), Not(HasSubstr(sign)));
}

TEST(Page, PosesReadBackToTheMillimetre) {
  const Picture picture = synthetic_picture();
  const std::vector<std::uint8_t> points = bytes_of(data_of(draw_html(picture))["motion"]["points"]);
  const std::size_t bodies = picture.plan.robot.bodies.size();
  ASSERT_EQ(points.size(), picture.plan.states.size() * bodies * 8);
  for (const std::size_t state : {std::size_t{0}, std::size_t{100}, picture.plan.states.size() - 1}) {
    const std::vector<Pose> poses = body_poses(picture.plan.robot, picture.plan.states[state]);
    for (std::size_t k = 0; k < bodies; ++k) {
      EXPECT_NEAR(millimetres(points, 2 * (state * bodies + k)), poses[k].x * 1000, 0.501);
      EXPECT_NEAR(millimetres(points, 2 * (state * bodies + k) + 1), poses[k].y * 1000, 0.501);
    }
  }
}

TEST(Page, HeadingsReadBack) {
  const Picture picture = synthetic_picture();
  const std::vector<std::uint8_t> headings = bytes_of(data_of(draw_html(picture))["motion"]["headings"]);
  const std::vector<Pose> poses = body_poses(picture.plan.robot, picture.plan.states[100]);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const std::size_t at = 2 * (100 * poses.size() + k);
    const auto turns = static_cast<std::int16_t>(headings.at(at) | headings.at(at + 1) << 8);
    EXPECT_NEAR(std::remainder(turns * std::numbers::pi / 32768 - poses[k].heading, 2 * std::numbers::pi), 0, 1e-4);
  }
}

TEST(Page, CostsReadBackToHalfALevel) {
  const Picture picture = synthetic_picture();
  const nlohmann::json frames = data_of(draw_html(picture))["frames"];
  const std::vector<std::uint8_t> levels = bytes_of(frames["levels"]);
  ASSERT_EQ(levels.size(), picture.frames.size() * picture.triangles.size());
  const double top = frames["top"];
  for (std::size_t i = 0; i < picture.triangles.size(); ++i) {
    const float cost = picture.frames.front().costs[i];
    const std::uint8_t level = levels[i];
    if (std::isinf(cost)) {
      EXPECT_EQ(level, kInfiniteLevel);
    } else if (static_cast<double>(cost) <= top) {
      EXPECT_NEAR(level * top / (kLevels - 1), static_cast<double>(cost), 0.51 * top / (kLevels - 1));
    }
  }
}

TEST(Page, LargestUsualSearchStaysBelowThreeMegabytes) {
  Picture picture = bare_picture(400, 400);
  picture.triangles.resize(1000, {{{1, 1}, {2, 1}, {1, 2}}});
  for (unsigned i = 0; i < 60; ++i) picture.frames.push_back({i, std::vector<float>(1000, 1.0F)});
  for (std::uint32_t i = 0; i < 20000; ++i) picture.tree.push_back({1, 1, i == 0 ? 0 : i - 1, i});
  picture.plan = synthetic_picture().plan;
  picture.plan.robot.links = 35;
  picture.plan.robot.bodies.resize(36, picture.plan.robot.bodies[0]);
  picture.plan.states.assign(2000, std::vector<float>(40, 0.123F));
  EXPECT_LT(draw_html(picture).size(), 3'000'000U);
}

TEST(Page, ManyFramesAreThinnedToAMegabyteWithFirstAndLast) {
  Picture picture = bare_picture(10, 10);
  picture.triangles.resize(20000, {{{1, 1}, {2, 1}, {1, 2}}});
  for (unsigned i = 0; i < 200; ++i) picture.frames.push_back({i, std::vector<float>(20000, 1.0F)});
  const nlohmann::json frames = data_of(draw_html(picture))["frames"];
  EXPECT_LE(frames["iterations"].size(), 51U);
  EXPECT_EQ(frames["iterations"].front(), 0);
  EXPECT_EQ(frames["iterations"].back(), 199);
  for (CostFrame& frame : picture.frames) frame.costs.resize(2000);
  picture.triangles.resize(2000);
  for (const std::size_t count : {200U, 375U, 376U, 500U}) {
    picture.frames.resize(count, picture.frames.back());
    const std::string levels = data_of(draw_html(picture))["frames"]["levels"];
    EXPECT_LE(levels.size(), 1'000'000U);
    EXPECT_GE(levels.size(), 1'000'000U / 2) << count;
  }
}

TEST(Page, ManyStatesAreThinnedWithTheLast) {
  Picture picture = synthetic_picture();
  picture.plan.states.resize(50'000, picture.plan.states.back());
  const std::vector<std::uint8_t> times = bytes_of(data_of(draw_html(picture))["motion"]["times"]);
  EXPECT_LE(times.size(), 4U * 6000U);
  float last = 0;
  std::memcpy(&last, &times[times.size() - 4], 4);
  EXPECT_NEAR(last, 4999.9, 1e-3);
}

TEST(Page, MarksTheFrontOfTheFirstBody) {
  const std::vector<std::uint8_t> bytes = bytes_of(data_of(draw_html(standing(0)))["front"]["points"]);
  std::vector<std::int32_t> millimetres(bytes.size() / 4);
  std::memcpy(millimetres.data(), bytes.data(), bytes.size());
  EXPECT_THAT(millimetres, testing::ElementsAre(200, 1200, 1400, 0, 200, -1200));
}

// ---- colours and captions

TEST(Colors, RunFromRedToBlueAndGreyIsApart) {
  EXPECT_GT(level_color(0).red, 3 * level_color(0).blue);
  EXPECT_GT(level_color(kLevels - 1).blue, 2 * level_color(kLevels - 1).red);
  const Color grey = level_color(kInfiniteLevel);
  EXPECT_LT(std::abs(grey.red - grey.blue), 16);
}

TEST(Colors, FewOutliersDoNotSetTheScale) {
  std::vector<float> costs(200, 10.0F);
  costs[3] = 1e6F;
  costs[4] = kInfinity;
  EXPECT_EQ(top_cost(costs), 10);
  EXPECT_EQ(cost_level(1e6F, 10), kLevels - 1);
}

TEST(Colors, LargestCostSetsTheScaleOtherwise) {
  EXPECT_EQ(top_cost({1, 2, 3, 4}), 4);
  EXPECT_EQ(top_cost({}), 0);
  EXPECT_EQ(top_cost({kInfinity}), 0);
}

TEST(Colors, RunWithoutLeaps) {
  const auto apart = [](std::uint8_t a, std::uint8_t b) { return std::abs(int{a} - int{b}); };
  for (int level = 1; level < kLevels; ++level) {
    const Color a = level_color(static_cast<std::uint8_t>(level - 1)),
                b = level_color(static_cast<std::uint8_t>(level));
    EXPECT_LE(std::max({apart(a.red, b.red), apart(a.green, b.green), apart(a.blue, b.blue)}), 4) << level;
  }
}

TEST(Colors, CostsThatRiseSteadilyAllHaveTheirColour) {
  std::vector<float> costs;
  for (int cost = 1; cost <= 100; ++cost) costs.push_back(static_cast<float>(cost));
  EXPECT_EQ(top_cost(costs), 100);
}

// ---- where things lie

TEST(Layout, HoldsMapsOfAnyShape) {
  for (const Point size : {Point{400, 10}, Point{10, 400}, Point{100, 100}, Point{0.01, 0.02}}) {
    const Figure figure = layout(bare_picture(size.x, size.y));
    const Point low = figure.at({0, 0}), high = figure.at(size);
    EXPECT_GE(low.x, 0);
    EXPECT_LE(high.x, figure.width);
    EXPECT_GE(high.y, 0);
    EXPECT_LE(low.y, figure.height);
    EXPECT_NEAR((high.x - low.x) * size.y, (low.y - high.y) * size.x, 1e-6) << "a metre is as long in either direction";
    EXPECT_LE(figure.width, 1200);
    EXPECT_LE(figure.height, 1100);
  }
}

TEST(GoalArrows, PointWhereTheRobotMayLook) {
  PlanFile plan = synthetic_picture().plan;
  plan.goal_polygon = {{2, 2}, {4, 2}, {4, 4}, {2, 4}};
  EXPECT_TRUE(goal_arrows(plan).empty());
  plan.goal_facing.emplace().heading = 1.5;
  ASSERT_EQ(goal_arrows(plan).size(), 1U);
  const Point middle = goal_arrows(plan)[0][0], tip = goal_arrows(plan)[0][1];
  EXPECT_NEAR(middle.x, 3, 1e-12);
  EXPECT_NEAR(middle.y, 3, 1e-12);
  EXPECT_NEAR(std::atan2(tip.y - 3, tip.x - 3), 1.5, 1e-9);
  plan.goal_facing->either_way = true;
  ASSERT_EQ(goal_arrows(plan).size(), 2U);
  const Point back = goal_arrows(plan)[1][1];
  EXPECT_NEAR(tip.x + back.x, 6, 1e-9);
  EXPECT_NEAR(tip.y + back.y, 6, 1e-9);
}

TEST(Captions, SayWhatWasPlanned) {
  EXPECT_THAT(facts(synthetic_picture()), testing::ElementsAre("snake with 15 trailers", "adaptive", "seed 1", "solved",
                                                               HasSubstr(" s"), HasSubstr(" m")));
}

TEST(Captions, TheDurationIsOfTheStepsAndTheLengthOfTheWholeWay) {
  Picture picture = bare_picture(20, 20);
  picture.plan.dt = 0.75;
  picture.plan.states = {{1, 1, 0}, {4, 5, 0}, {4, 9, 0}};
  EXPECT_THAT(facts(picture), testing::IsSupersetOf({"1.5 s", "9.0 m"}));
}

TEST(Captions, LongTextsEndWithAWholeCharacter) {
  std::string text, whole;
  for (int i = 0; i < 300; ++i) text += "\xC3\xA9";
  for (int i = 0; i < 200; ++i) whole += "\xC3\xA9";
  EXPECT_EQ(printable(text), whole);
}

TEST(Captions, SayWhyThereIsNoPlan) { EXPECT_THAT(facts(without_plan()).back(), "no plan: no_route"); }

TEST(Captions, RoundLengthsAreOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(round_length(7), 5);
  EXPECT_DOUBLE_EQ(round_length(49), 20);
  EXPECT_DOUBLE_EQ(round_length(0.13), 0.1);
}

}  // namespace
}  // namespace krait::host
