// SPDX-License-Identifier: Apache-2.0
// SVG by hand: shapes, paths, transforms, units, fills, roles and copies, and drawings made to hurt.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "../scratch.hpp"
#include "host/import/import.hpp"

namespace krait::host::import_svg_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// 1 unit is 1 m: the page is 20 m x 10 m, from (0, -10) to (20, 0) in the map.
const std::string kPage =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="20000mm" height="10000mm" viewBox="0 0 20 10")";

std::string drawing(const std::string& shapes) { return kPage + ">" + shapes + "</svg>"; }

std::string repeated(const std::string& one, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += one;
  return all;
}

class SvgTest : public ScratchTest {
 protected:
  Workspace read(const std::string& content, const ImportOptions& options = {}) const {
    return import_workspace(write("map.svg", content), options);
  }
  Workspace shapes(const std::string& content) const { return read(drawing(content)); }
  std::string error(const std::string& content) const {
    return error_of([&] { read(content); });
  }
  std::string shape_error(const std::string& content) const { return error(drawing(content)); }
  Ring outline(const std::string& shape) const {
    const Workspace w = shapes(shape);
    return w.obstacles.size() == 1 ? w.obstacles[0].outer : Ring{};
  }
};

void expect_ring(const Ring& ring, const Ring& expected) {
  ASSERT_EQ(ring.size(), expected.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    EXPECT_NEAR(ring[i].x, expected[i].x, 1e-9) << i;
    EXPECT_NEAR(ring[i].y, expected[i].y, 1e-9) << i;
  }
}

const Ring kSquare = {{1, -1}, {3, -1}, {3, -3}, {1, -3}};

TEST_F(SvgTest, ThePageBoundsTheMapAndYPointsUp) {
  const Workspace w = shapes(R"(<title>yard</title><rect id="hut" x="1" y="1" width="2" height="2"/>)");
  EXPECT_EQ(w.name, "yard");
  EXPECT_NEAR(w.min.x, 0, 1e-9);
  EXPECT_NEAR(w.min.y, -10, 1e-9);
  EXPECT_NEAR(w.max.x, 20, 1e-9);
  EXPECT_NEAR(w.max.y, 0, 1e-9);
  ASSERT_EQ(w.obstacles.size(), 1U);
  EXPECT_EQ(w.obstacles[0].label, "hut");
  expect_ring(w.obstacles[0].outer, kSquare);
  EXPECT_THAT(w.warnings, IsEmpty());
}

TEST_F(SvgTest, EveryFormOfALineInAPathIsTheSameSquare) {
  for (const char* d : {"M1 1 L3 1 L3 3 L1 3 Z", "M1,1 3,1 3,3 1,3", "m1 1 2 0 0 2 -2 0z", "M1 1H3V3H1Z",
                        "m1 1h2v2h-2v-2", "M 1 1 l 2 0 l 0 2 l -2 0 L 1 1 z", "M1 1L3.0e0 1L.3e1+3L1 3"}) {
    SCOPED_TRACE(d);
    expect_ring(outline(std::string("<path d=\"") + d + "\"/>"), kSquare);
  }
  expect_ring(outline(R"(<polygon points="1,1 3,1 3,3 1,3"/>)"), kSquare);
  expect_ring(outline(R"(<polyline points="1 1 3 1 3-1 3 3 1 3"/>)"), {{1, -1}, {3, -1}, {3, 1}, {3, -3}, {1, -3}});
}

// A curve's polygon has corners on the curve, and edges that are off it by at most a millimetre.
void expect_on_circle(const Ring& ring, const Point& center, double radius) {
  ASSERT_GE(ring.size(), 8U);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    EXPECT_NEAR(std::hypot(a.x - center.x, a.y - center.y), radius, 1e-9);
    EXPECT_GE(std::hypot((a.x + b.x) / 2 - center.x, (a.y + b.y) / 2 - center.y), radius - 0.00101);
  }
}

TEST_F(SvgTest, ArcsLieOnTheirCircle) {
  expect_on_circle(outline(R"(<path d="M3 5A2 2 0 0 1 7 5A2 2 0 0 1 3 5Z"/>)"), {5, -5}, 2);
  expect_on_circle(outline(R"(<path d="M3 5a2 2 0 104 0a2 2 0 10-4 0"/>)"), {5, -5}, 2);
  const Ring small = outline(R"(<path d="M5 3A2 2 0 0 1 7 5L5 5Z"/>)");
  const Ring large = outline(R"(<path d="M5 3A2 2 0 1 0 7 5L5 5Z"/>)");
  const auto lowest = [](const Ring& ring) {
    double y = 0;
    for (const Point& p : ring) y = std::min(y, p.y);
    return y;
  };
  EXPECT_NEAR(lowest(small), -5, 1e-9);
  EXPECT_NEAR(lowest(large), -7, 1e-3);
  expect_on_circle(outline(R"(<path d="M3 5A1 1 0 0 1 7 5A.1 .1 0 0 1 3 5Z"/>)"), {5, -5}, 2);  // radii that grow
  EXPECT_EQ(outline(R"(<path d="M3 5A0 2 0 0 1 7 5L5 7"/>)").size(), 3U) << "a radius of 0 is a line";
}

TEST_F(SvgTest, ATurnedArcHasItsEnds) {
  const Ring ring = outline(R"(<path d="M4 5A3 1 90 0 1 6 5A3 1 90 0 1 4 5"/>)");
  double low = 0, high = -100;
  for (const Point& p : ring) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
    EXPECT_NEAR(std::pow(p.x - 5, 2) + std::pow((p.y + 5) / 3, 2), 1, 1e-9);
  }
  EXPECT_NEAR(low, -8, 2e-3);
  EXPECT_NEAR(high, -2, 2e-3);
}

TEST_F(SvgTest, BezierCurvesLieOnTheirCurves) {
  for (const char* d : {"M0 0Q2 4 4 0", "m0 0q2 4 4 0",
                        "M0 0C1.33333333333333 2.66666666666667 2.66666666666667 "
                        "2.66666666666667 4 0"}) {
    const Ring ring = outline(std::string("<path d=\"") + d + "\"/>");
    ASSERT_GE(ring.size(), 10U) << d;
    for (const Point& p : ring) EXPECT_NEAR(-p.y, p.x * (4 - p.x) / 2, 1e-9) << d;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
      const double x = (ring[i].x + ring[i + 1].x) / 2;
      EXPECT_NEAR(-(ring[i].y + ring[i + 1].y) / 2, x * (4 - x) / 2, 0.001) << d;
    }
  }
}

TEST_F(SvgTest, SmoothCurvesMirrorTheControlPointBefore) {
  const Ring t = outline(R"(<path d="M0 4Q2 8 4 4T8 4"/>)");
  double highest = -100;
  for (const Point& p : t) highest = std::max(highest, p.y);
  EXPECT_NEAR(highest, -2, 1e-3);
  const Ring s = outline(R"(<path d="M0 4C0 6 4 6 4 4S8 2 8 4"/>)");
  const Ring c = outline(R"(<path d="M0 4C0 6 4 6 4 4C4 2 8 2 8 4"/>)");
  expect_ring(s, c);
  expect_ring(outline(R"(<path d="M0 4L4 4S8 2 8 4"/>)"), outline(R"(<path d="M0 4L4 4C4 4 8 2 8 4"/>)"));
}

TEST_F(SvgTest, CirclesAndEllipsesAreContainedAsObstaclesAndContainAsGoals) {
  for (const Point& p : outline(R"(<circle cx="5" cy="5" r="2"/>)")) EXPECT_GE(std::hypot(p.x - 5, p.y + 5), 2);
  for (const Point& p : outline(R"(<ellipse cx="5" cy="5" rx="4" ry="1"/>)")) {
    EXPECT_GE(std::hypot((p.x - 5) / 4, p.y + 5), 1);
    EXPECT_LE(std::hypot((p.x - 5) / 4, p.y + 5), 1.01);
  }
  const Workspace w = shapes(R"(<circle class="goal" cx="5" cy="5" r="2"/>)");
  ASSERT_EQ(w.goals.size(), 1U);
  for (const Point& p : w.goals[0].polygon) EXPECT_LE(std::hypot(p.x - 5, p.y + 5), 2);
}

TEST_F(SvgTest, RoundCornersStayOnObstaclesAndGoOffGoals) {
  const std::string rect = R"( x="1" y="1" width="2" height="2" rx="0.5"/>)";
  expect_ring(outline("<rect" + rect), kSquare);
  const Workspace w = shapes("<rect class=\"goal\"" + rect);
  expect_ring(w.goals.at(0).polygon,
              {{1.5, -1}, {2.5, -1}, {3, -1.5}, {3, -2.5}, {2.5, -3}, {1.5, -3}, {1, -2.5}, {1, -1.5}});
}

TEST_F(SvgTest, TransformsNest) {
  const auto placed = [&](const std::string& transform, const std::string& shape) {
    return outline("<g transform=\"" + transform + "\">" + shape + "</g>");
  };
  const std::string unit = R"(<path d="M0 0H1V1Z"/>)";
  expect_ring(placed("translate(2,3)", unit), {{2, -3}, {3, -3}, {3, -4}});
  expect_ring(placed("translate(2)", unit), {{2, 0}, {3, 0}, {3, -1}});
  expect_ring(placed("scale(2 3)", unit), {{0, 0}, {2, 0}, {2, -3}});
  expect_ring(placed("rotate(90)", unit), {{0, 0}, {0, -1}, {-1, -1}});
  expect_ring(placed("rotate(90 1 0)", unit), {{1, 1}, {1, 0}, {0, 0}});
  expect_ring(placed("skewX(45)", unit), {{0, 0}, {1, 0}, {2, -1}});
  expect_ring(placed("skewY(45)", unit), {{0, 0}, {1, -1}, {1, -2}});
  expect_ring(placed("matrix(1 2 3 4 5 6)", unit), {{5, -6}, {6, -8}, {9, -12}});
  expect_ring(placed("translate(2 3), scale(2)", unit), {{2, -3}, {4, -3}, {4, -5}});
  expect_ring(placed("translate(2 3)", R"~(<path transform="scale(2)" d="M0 0H1V1Z"/>)~"), {{2, -3}, {4, -3}, {4, -5}});
}

TEST_F(SvgTest, UnitsOfLengthsAndOfThePage) {
  const auto right = [&](const std::string& svg, const ImportOptions& options = {}) {
    return read(svg + "><rect x=\"0\" y=\"0\" width=\"1\" height=\"1\"/></svg>", options).max.x;
  };
  EXPECT_NEAR(right(R"(<svg width="50cm" height="2cm" viewBox="0 0 10 10")"), 0.02, 1e-12)
      << "the page fits as a whole";
  EXPECT_NEAR(right(R"(<svg width="100in" height="100in" viewBox="0 0 10 10")"), 2.54, 1e-12);
  EXPECT_NEAR(right(R"(<svg width="960" height="960px")"), 0.254, 1e-12) << "96 pixels an inch";
  EXPECT_NEAR(right(R"(<svg width="1000mm" height="1000mm")"), 1, 1e-12);
  EXPECT_NEAR(right(R"(<svg width="50cm" height="2cm" viewBox="0 0 10 10")", {.unit = 0.5}), 5, 1e-12);
  EXPECT_NEAR(right(R"(<svg width="100%" viewBox="0 0 10 10")", {.unit = 1}), 10, 1e-12);
  expect_ring(read("<svg viewBox=\"0 0 960 960\"><rect width=\"1in\" height=\"25.4mm\"/></svg>", {.unit = 1})
                  .obstacles.at(0)
                  .outer,
              {{0, 0}, {96, 0}, {96, -96}, {0, -96}});
}

TEST_F(SvgTest, APageOfUnclearOrTinySizeIsTold) {
  EXPECT_THAT(read(R"(<svg width="18mm" height="14mm" viewBox="0 0 18 14"/>)").warnings,
              ElementsAre(path("map.svg") +
                          ": the page measures 0.018 m x 0.014 m; --unit 1 makes one unit of the drawing a metre"));
  EXPECT_THAT(read(R"(<svg width="9600" height="9600"/>)").warnings,
              ElementsAre(HasSubstr("measures 2.54 m x 2.54 m")));
  EXPECT_THAT(read(R"(<svg width="9600" height="9600"/>)", {.unit = 1}).warnings, IsEmpty());
}

TEST_F(SvgTest, RolesComeFromClassesIdsAndLabels) {
  const Workspace w = shapes(R"(<rect class="bounds" x="1" y="1" width="8" height="8" fill="none"/>
    <rect class="big goal" id="dock" x="1" y="1" width="2" height="2"/>
    <rect id="goal2" x="1" y="1" width="2" height="2"/>
    <rect inkscape:label="goal" x="1" y="1" width="2" height="2"><title>bay</title></rect>
    <rect id="goalkeeper" x="1" y="1" width="2" height="2"/>
    <g class="none"><rect x="1" y="1" width="2" height="2"/></g>)");
  EXPECT_NEAR(w.min.x, 1, 1e-9);
  EXPECT_NEAR(w.max.y, -1, 1e-9);
  ASSERT_EQ(w.goals.size(), 3U);
  EXPECT_EQ(w.goals[0].name, "dock");
  EXPECT_EQ(w.goals[1].name, "goal2");
  EXPECT_EQ(w.goals[2].name, "bay");
  ASSERT_EQ(w.obstacles.size(), 1U);
  EXPECT_EQ(w.obstacles[0].label, "goalkeeper");
}

TEST_F(SvgTest, AClassMayBeginWithTheRole) {
  const Workspace w = shapes(R"(<rect class="bounds2" x="1" y="1" width="8" height="8" fill="none"/>
    <rect class="wide goal2" x="1" y="1" width="2" height="2"/>
    <rect class="goal_b" id="bay" x="1" y="1" width="2" height="2"/>
    <g class="goals"><rect id="dock" x="1" y="1" width="2" height="2"/></g>
    <line class="start-left" x1="2" y1="7" x2="2" y2="5"/>
    <rect class="goalkeeper" x="1" y="1" width="2" height="2"/>)");
  EXPECT_NEAR(w.min.x, 1, 1e-9);
  ASSERT_EQ(w.goals.size(), 3U);
  EXPECT_EQ(w.goals[1].name, "bay");
  EXPECT_EQ(w.goals[2].name, "dock");
  EXPECT_EQ(w.starts.size(), 1U);
  EXPECT_EQ(w.obstacles.size(), 1U);
}

TEST_F(SvgTest, AStartIsALineToWhereTheRobotLooks) {
  const Workspace w = shapes(R"(<line class="start" x1="2" y1="7" x2="2" y2="5"/>
    <polyline class="start" points="1,4 1,5 2,5 3,5" fill="none"/>)");
  ASSERT_EQ(w.starts.size(), 2U);
  EXPECT_EQ(w.starts[0].name, "start");
  EXPECT_NEAR(w.starts[0].position.y, -7, 1e-9);
  EXPECT_NEAR(w.starts[0].heading, std::numbers::pi / 2, 1e-9);
  EXPECT_THAT(w.starts[0].angles, IsEmpty());
  EXPECT_EQ(w.starts[1].name, "start 2");
  EXPECT_NEAR(w.starts[1].position.x, 2, 1e-9);
  EXPECT_NEAR(w.starts[1].heading, 0, 1e-9);
  ASSERT_EQ(w.starts[1].angles.size(), 2U);
  EXPECT_NEAR(w.starts[1].angles[0], 0, 1e-9);
  EXPECT_NEAR(w.starts[1].angles[1], -std::numbers::pi / 2, 1e-9);
}

TEST_F(SvgTest, AGoalThatIsALineHasItsHeading) {
  const Workspace w = shapes(R"(<line class="goal" x1="2" y1="7" x2="2" y2="5"/>
    <path class="goal" d="M1,4 L2,4"/><circle class="goal" cx="8" cy="8" r="1"/>)");
  ASSERT_EQ(w.goals.size(), 3U);
  ASSERT_TRUE(w.goals[0].pose && w.goals[1].pose);
  EXPECT_EQ(w.goals[0].name, "goal");
  EXPECT_NEAR(w.goals[0].pose->position.y, -7, 1e-9);
  EXPECT_EQ(w.goals[0].pose->radius, 0.1);
  EXPECT_NEAR(w.goals[0].pose->facing.heading, std::numbers::pi / 2, 1e-9);
  EXPECT_EQ(w.goals[0].pose->facing.tolerance, 0.1);
  EXPECT_NEAR(w.goals[1].pose->position.x, 1, 1e-9);
  EXPECT_FALSE(w.goals[2].pose);
}

TEST_F(SvgTest, OnlyWhatIsFilledAndSeenIsAnObstacle) {
  const Workspace w = shapes(R"(<g style="fill:none"><rect width="1" height="1"/>
    <rect width="1" height="1" fill="red"/></g>
    <rect width="1" height="1" fill="red" style=" stroke:#000; fill : none "/>
    <rect width="1" height="1" display="none"/><g visibility="hidden"><rect width="1" height="1"/></g>
    <defs><rect width="1" height="1"/></defs><text>a</text><rect width="0" height="1"/><circle r="0"/>)");
  EXPECT_EQ(w.obstacles.size(), 1U);
  EXPECT_THAT(
      w.warnings,
      ElementsAre(HasSubstr("2 shapes without a fill or an area are no obstacles, also where they have a stroke"),
                  HasSubstr("1 texts and images are not read")));
  EXPECT_THAT(shapes("<style>rect{fill:none}</style>").warnings, ElementsAre(HasSubstr("style sheets are not read")));
}

TEST_F(SvgTest, WallsThatAreLinesAreCounted) {
  const Workspace w = shapes(R"(<path d="M1 1H5" stroke="black"/><polyline points="1,1 3,1" stroke="black"/>
    <line x2="1" stroke="black"/><path d=""/><rect width="0" height="1"/>)");
  EXPECT_THAT(w.obstacles, IsEmpty());
  EXPECT_THAT(w.warnings, ElementsAre(HasSubstr("3 shapes without a fill or an area are no obstacles")));
}

TEST_F(SvgTest, HolesThatAreFilledSinceTheyTouchAreCounted) {
  const auto warned = [&](const std::string& hole, const std::string& rule = "evenodd") {
    return shapes("<path fill-rule=\"" + rule + "\" d=\"M1 1H9V9H1Z " + hole + "\"/>").warnings;
  };
  const std::string filled =
      ": 1 shapes have holes that touch or cross another outline, and are filled: keep the holes";
  EXPECT_THAT(warned("M1 3V7H6V3Z"), ElementsAre(HasSubstr(filled))) << "along the outline";
  EXPECT_THAT(warned("M1 3V7H6V3Z", "nonzero"), ElementsAre(HasSubstr(filled)));
  EXPECT_THAT(warned("M1 3H6V7H1Z", "nonzero"), IsEmpty()) << "filled by its rule";
  EXPECT_THAT(warned("M9 3V7H14V3Z"), IsEmpty()) << "beside the outline";
  EXPECT_THAT(warned("M2 3V7H6V3Z"), IsEmpty()) << "apart from it";
}

TEST_F(SvgTest, WhatSaysThatItIsVisibleIsSeenInAHiddenGroup) {
  const std::string square = "<path d=\"M1 1H3V3H1Z\"";
  const std::string hidden = "<g visibility=\"hidden\">" + square + "/>";
  expect_ring(outline(hidden + square + " visibility=\"visible\"/></g>"), kSquare);
  expect_ring(outline(hidden + square + " style=\"visibility: visible\"/></g>"), kSquare);
  EXPECT_THAT(shapes(hidden + square + " visibility=\"inherit\"/></g>").obstacles, IsEmpty());
  EXPECT_THAT(shapes("<g display=\"none\">" + square + " visibility=\"visible\"/></g>").obstacles, IsEmpty());
}

TEST_F(SvgTest, InnerOutlinesAreHolesByTheFillRule) {
  const std::string outer = "M0 0H8V8H0Z";
  const std::string same = "M2 2H6V6H2Z";
  const std::string opposite = "M2 2V6H6V2Z";
  const auto read_path = [&](const std::string& d, const std::string& rule) {
    return shapes("<path d=\"" + d + "\" fill-rule=\"" + rule + "\"/>").obstacles;
  };
  for (const std::vector<Obstacle>& ring : {read_path(outer + opposite, "nonzero"), read_path(outer + same, "evenodd"),
                                            read_path(same + outer, "evenodd")}) {
    ASSERT_EQ(ring.size(), 1U);
    expect_ring(ring[0].outer, {{0, 0}, {8, 0}, {8, -8}, {0, -8}});
    ASSERT_EQ(ring[0].holes.size(), 1U);
    EXPECT_EQ(ring[0].holes[0].size(), 4U);
  }
  const std::vector<Obstacle> solid = read_path(outer + same, "nonzero");
  ASSERT_EQ(solid.size(), 1U);
  EXPECT_THAT(solid[0].holes, IsEmpty());
  const std::vector<Obstacle> island = read_path(outer + "M1 1H7V7H1Z" + same, "evenodd");
  ASSERT_EQ(island.size(), 2U);
  EXPECT_EQ(island[0].holes.size(), 1U);
  EXPECT_THAT(island[1].holes, IsEmpty());
}

TEST_F(SvgTest, OutlinesThatCrossAreObstaclesOfTheirOwn) {
  for (const char* inner : {"M6 6H10V10H6Z", "M0 0V8H8V0Z", "M2 2L6 6L6 2L2 6Z"}) {
    const Workspace w = shapes(std::string("<path fill-rule=\"evenodd\" d=\"M0 0H8V8H0Z") + inner + "\"/>");
    ASSERT_EQ(w.obstacles.size(), 2U) << inner;
    EXPECT_THAT(w.obstacles[0].holes, IsEmpty()) << inner;
  }
}

TEST_F(SvgTest, CopiesStandWhereTheyAreUsed) {
  const Workspace w =
      shapes(R"~(<defs><path id="t" d="M0 0H1V1Z"/><symbol id="s"><rect width="1" height="1"/></symbol></defs>
    <use href="#t" x="3" y="2"/><use xlink:href="#s" transform="scale(2)"/>)~");
  ASSERT_EQ(w.obstacles.size(), 2U);
  expect_ring(w.obstacles[0].outer, {{3, -2}, {4, -2}, {4, -3}});
  expect_ring(w.obstacles[1].outer, {{0, 0}, {2, 0}, {2, -2}, {0, -2}});
}

TEST_F(SvgTest, WhatMovesOrStretchesShapesIsReadOrRefused) {
  const auto placed = [&](const std::string& attributes) {
    return shape_error("<path d=\"M1 1H3V3H1Z\" " + attributes + "/>");
  };
  EXPECT_THAT(placed("style=\"fill:red;transform:translate(5px)\""),
              HasSubstr("<path>: style: transform is not read there: give it as an attribute of its own"));
  EXPECT_THAT(shape_error("<rect style=\"width:2px;height:1px\"/>"), HasSubstr("style: width is not read there"));
  EXPECT_THAT(placed("transform=\"rotate(90)\" transform-origin=\"2 2\""),
              HasSubstr("transform-origin is not read: put it into the transform"));
  EXPECT_THAT(placed("transform=\"rotate(90)\" style=\"transform-box: fill-box\""), HasSubstr("transform-box is not"));
  expect_ring(outline("<path d=\"M1 1H3V3H1Z\" transform-origin=\"2 2\" style=\"transform:none\"/>"), kSquare);
  EXPECT_THAT(shape_error("<g style=\"transform:scale(2)\"><path d=\"M1 1H3V3H1Z\"/></g>"), HasSubstr("<g>: style: "));
  expect_ring(outline("<image style=\"width:2px\"/><g display=\"none\" style=\"scale:2\"/><path d=\"M1 1H3V3H1Z\"/>"),
              kSquare);
  EXPECT_THAT(shape_error("<symbol id=\"s\" viewBox=\"0 0 1 1\"/><use href=\"#s\" width=\"4\" height=\"4\"/>"),
              HasSubstr("<symbol id=\"s\">: a symbol with a viewBox is not read: make it a group"));
}

TEST_F(SvgTest, ADrawingWithoutAPageSaysHowLargeItIs) {
  const std::string drawn = "<svg width=\"100%\"><rect width=\"200\" height=\"100\"/></svg>";
  EXPECT_THAT(read(drawn).warnings,
              ElementsAre(HasSubstr("has no bounds"),
                          HasSubstr("the drawing measures 0.052916667 m x 0.026458333 m; --unit 1 makes one unit")));
  EXPECT_THAT(read(drawn, {.unit = 1}).warnings, ElementsAre(HasSubstr("has no bounds")));
}

TEST_F(SvgTest, AStartWithoutLengthIsRefused) {
  EXPECT_THAT(shape_error("<line class=\"start\" x1=\"1\" x2=\"1\" y1=\"2\" y2=\"2\"/>"),
              HasSubstr("<line>: a start's line has a part without length, which says no heading"));
  EXPECT_THAT(shape_error("<polyline class=\"start\" points=\"1,1 1,1 2,1\"/>"), HasSubstr("a part without length"));
}

TEST_F(SvgTest, AStretchedPageIsRefused) {
  const auto page = [](const std::string& height, const std::string& ratio) {
    return "<svg width=\"20000mm\" height=\"" + height + "mm\" viewBox=\"0 0 20 10\" preserveAspectRatio=\"" + ratio +
           "\"><path d=\"M1 1H3V3H1Z\"/></svg>";
  };
  for (const char* ratio : {"none", "xMidYMid slice"}) {
    EXPECT_THAT(error(page("20000", ratio)),
                HasSubstr("<svg>: preserveAspectRatio: none and slice are read only where"));
    expect_ring(read(page("10000.3", ratio)).obstacles.at(0).outer, kSquare);
  }
  expect_ring(read(page("20000", "xMidYMid meet")).obstacles.at(0).outer, kSquare);
}

TEST_F(SvgTest, WrongAttributesAreNamedWithTheirLine) {
  EXPECT_EQ(shape_error("\n<path id=\"p\" d=\"M1 1 L2 x\"/>"),
            path("map.svg") + ": line 2: <path id=\"p\">: d: a number must stand here, not \"x\"");
  EXPECT_THAT(shape_error(R"(<path d="L1 1"/>)"), HasSubstr("a path must begin with M"));
  EXPECT_THAT(shape_error(R"(<path d="M1 1R2 2"/>)"), HasSubstr("unknown command; known are M, L,"));
  EXPECT_THAT(shape_error(R"(<path d="M1 1A1 1 0 2 0 3 3"/>)"), HasSubstr("a flag, 0 or 1, must stand here"));
  EXPECT_THAT(shape_error(R"(<path d="M1 1 5"/>)"), HasSubstr("a number must stand here, not the end"));
  EXPECT_THAT(shape_error(R"(<path d="M1 1 ,;"/>)"), HasSubstr("must stand here, not \";\""));
  EXPECT_THAT(shape_error(R"(<path d="MNaN inf"/>)"), HasSubstr("a number must stand here, not \"NaN inf\""));
  EXPECT_THAT(shape_error(R"(<path d="M1e400 1"/>)"), HasSubstr("a number must stand here"));
  EXPECT_THAT(shape_error(R"(<rect width="1em" height="1"/>)"), HasSubstr("width: must be a number with one of"));
  EXPECT_THAT(shape_error(R"(<rect width="50%" height="1"/>)"), HasSubstr("width: must be a number with one of"));
  EXPECT_THAT(shape_error(R"(<rect width="-1" height="1"/>)"), HasSubstr("width and height must be 0 or more"));
  EXPECT_THAT(shape_error(R"(<circle r="-1"/>)"), HasSubstr("has no sound radius"));
  EXPECT_THAT(shape_error(R"~(<g transform="turn(3)"/>)~"), HasSubstr("transform: \"turn\" with 1 numbers is unknown"));
  EXPECT_THAT(shape_error(R"(<g transform="scale 3"/>)"), HasSubstr("'(' must stand here"));
  EXPECT_THAT(shape_error(R"~(<g transform="matrix(1 2 3 4 5 6 7 8 9)"/>)~"), HasSubstr("')' must stand here"));
  EXPECT_THAT(shape_error(R"(<rect width="1e14" height="1"/>)"), HasSubstr("lies further than 1e+10 m"));
  EXPECT_THAT(shape_error(R"(<path class="goal" d="M0 0H1V1ZM3 3H4V4Z"/>)"), HasSubstr("must be one closed outline"));
  EXPECT_THAT(shape_error(R"(<circle class="start" r="1"/>)"), HasSubstr("a start must be a line from its position"));
  EXPECT_THAT(shape_error(R"(<g class="bounds"><rect width="1" height="1"/><rect width="1" height="1"/></g>)"),
              HasSubstr("there are bounds already"));
  EXPECT_THAT(shape_error("<svg/>"), HasSubstr("a drawing in the drawing is not read: ungroup it"));
  EXPECT_THAT(error(R"(<svg viewBox="0 0 0 1"/>)"), HasSubstr("viewBox: must be x, y, width and height, above 0"));
  EXPECT_THAT(error(R"(<svg width="-1" height="2"/>)"), HasSubstr("width and height must be above 0"));
  EXPECT_THAT(error(R"(<svg width="1" height="1" viewBox="0 0 1e12 1"/>)"), HasSubstr("give --unit METRES"));
  EXPECT_THAT(error("<svg/>"), HasSubstr("is empty: it has no shape"));
}

TEST_F(SvgTest, BrokenXmlEndsInALine) {
  const std::string whole = drawing(R"(<g><path d="M0 0H1V1Z"/></g>)");
  for (std::size_t length = kPage.size(); length < whole.size(); ++length) {
    EXPECT_THAT(error(whole.substr(0, length)), HasSubstr("map.svg: is not valid XML: ")) << length;
  }
  EXPECT_THAT(error("<page><svg/></page>"), HasSubstr("is XML, but no SVG"));
  EXPECT_NE(error("<"), "");
}

TEST_F(SvgTest, CopiesOfThemselvesEndInALine) {
  EXPECT_THAT(shape_error(R"(<use id="a" href="#a"/>)"), HasSubstr("copies are nested deeper than 64"));
  EXPECT_THAT(shape_error(R"(<g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g>)"),
              HasSubstr("nested deeper"));
  EXPECT_THAT(shape_error(R"(<use href="#none"/>)"), HasSubstr("href: there is no element #none"));
  EXPECT_THAT(shape_error(R"(<use href="other.svg#a"/>)"), HasSubstr("href: must name an element of this file"));
  std::string bomb = R"(<rect id="g0" width="1" height="1"/>)";
  for (int i = 1; i < 30; ++i) {
    const std::string copy = "<use href=\"#g" + std::to_string(i - 1) + "\"/>";
    bomb += "<g id=\"g" + std::to_string(i) + "\">" + repeated(copy, 10) + "</g>";
  }
  EXPECT_THAT(shape_error(bomb), HasSubstr("more than 1000000 elements, copies counted"));
}

TEST_F(SvgTest, CornersOfCopiesAreCounted) {
  const auto copied = [](const std::string& shape, int copies) {
    return "<g id=\"a\">" + shape + "</g>" + repeated("<use href=\"#a\"/>", copies);
  };
  const std::string polygon = "<polygon points=\"" + repeated("1,1 2,1 2,2 ", 10'000) + "\"/>";
  EXPECT_THAT(shape_error(copied(polygon, 200)), HasSubstr("more than 4000000 corners, copies counted"));
  EXPECT_THAT(shape_error(copied("<circle r=\"1000\"/>", 200'000)), HasSubstr("corners, copies counted"));
}

TEST_F(SvgTest, AttributesAreReadForEachCopyAndSoBounded) {
  const std::string large = "<rect id=\"a\" width=\"1\" height=\"1\" note=\"" + std::string(1'000'000, '.') + "\"/>";
  EXPECT_EQ(shapes(large + repeated("<use href=\"#a\"/>", 100)).obstacles.size(), 101U);
  EXPECT_THAT(shape_error(large + repeated("<use href=\"#a\"/>", 130)), HasSubstr("copies are too many and too large"));
  const std::string symbol = "<symbol id=\"a\" note=\"" + std::string(1'000'000, '.') + "\"/>";
  EXPECT_THAT(shape_error(symbol + repeated("<use href=\"#a\"/>", 130)),
              HasSubstr("copies are too many and too large"));
}

TEST_F(SvgTest, EntitiesDoNotMultiply) {
  std::string bomb = "<!DOCTYPE svg [<!ENTITY a0 \"M0 0\">";
  for (int i = 1; i < 30; ++i) {
    bomb += "<!ENTITY a" + std::to_string(i) + " \"" + repeated("&a" + std::to_string(i - 1) + ";", 10) + "\">";
  }
  EXPECT_THAT(error(bomb + "]>" + drawing("<path d=\"&a29;\"/>")),
              HasSubstr("d: a command must stand here, not \"&a29"));
}

TEST_F(SvgTest, DeepAndHugeDrawingsEndInALine) {
  for (const int depth : {65, 1000, 300000}) {
    EXPECT_THAT(shape_error(repeated("<g>", depth) + repeated("</g>", depth)), HasSubstr("nested deeper than 64"));
  }
  EXPECT_THAT(shape_error(R"(<path d="M0 0Q1e14 1e14 1 1"/>)"), HasSubstr("curves need too many corners"));
  EXPECT_THAT(shape_error("<path d=\"M0 0" + repeated("Q1e8 1e8 1 1", 100) + "\"/>"), HasSubstr("too many corners"));
}

// Too many to nest: each is filled, and nothing waits for a hundred million comparisons.
TEST_F(SvgTest, ManyInnerOutlinesAreFilledInTime) {
  std::string d = "M0 0H10V10H0Z";
  char inner[64];
  for (int i = 0; i < 10000; ++i) {
    std::snprintf(inner, sizeof inner, "M%.2f %.2fh.02v.02z", 0.01 + 0.05 * (i % 100), 0.01 + 0.05 * (i / 100));
    d.append(inner);
  }
  EXPECT_EQ(shapes("<path fill-rule=\"evenodd\" d=\"" + d + "\"/>").obstacles.size(), 10001U);
}

TEST_F(SvgTest, ManyOutlinesAreReadInTime) {
  const Workspace w = shapes("<path d=\"" + repeated("M1 1H2V2Z", 100000) + "\"/>");
  EXPECT_EQ(w.obstacles.size(), 100000U);
}

}  // namespace
}  // namespace krait::host::import_svg_test
