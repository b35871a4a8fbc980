// SPDX-License-Identifier: Apache-2.0
// What is exported reads back as what it was, in each format.
#include "host/export/export.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "../ring_area.hpp"
#include "../scratch.hpp"
#include "host/import/import.hpp"
#include "host/import/shapes.hpp"

namespace krait::host {
namespace {

using testing::IsEmpty;

struct Writer {
  const char* file;
  std::string (*write)(const Workspace&);
  double tolerance;  // of a coordinate, metres
};

const std::vector<Writer> kWriters = {
    {"copy.json", native_json, 0}, {"copy.geojson", geojson, 0}, {"copy.svg", svg, 1e-9}};

class ExportTest : public ScratchTest {
 protected:
  Workspace copy(const Workspace& workspace, const Writer& writer) const {
    return import_workspace(write(writer.file, writer.write(workspace)), {});
  }
};

void expect_near(const Point& one, const Point& other, double tolerance) {
  EXPECT_NEAR(one.x, other.x, tolerance);
  EXPECT_NEAR(one.y, other.y, tolerance);
}

void expect_near(const Ring& one, const Ring& other, double tolerance) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) expect_near(one[i], other[i], tolerance);
}

void expect_near(const GoalPose& one, const GoalPose& other, double tolerance) {
  expect_near(one.position, other.position, tolerance);
  EXPECT_EQ(one.radius, other.radius);
  EXPECT_NEAR(one.facing.heading, other.facing.heading, tolerance);
  EXPECT_EQ(one.facing.tolerance, other.facing.tolerance);
  EXPECT_EQ(one.facing.either_way, other.facing.either_way);
  EXPECT_EQ(one.facing.hitches, other.facing.hitches);
}

void expect_same(const Workspace& one, const Workspace& other, double tolerance) {
  EXPECT_EQ(one.name, other.name);
  expect_near(one.shift, other.shift, 0);
  expect_near(one.min, other.min, tolerance);
  expect_near(one.max, other.max, tolerance);
  ASSERT_EQ(one.obstacles.size(), other.obstacles.size());
  for (std::size_t i = 0; i < one.obstacles.size(); ++i) {
    expect_near(one.obstacles[i].outer, other.obstacles[i].outer, tolerance);
    ASSERT_EQ(one.obstacles[i].holes.size(), other.obstacles[i].holes.size());
    for (std::size_t k = 0; k < one.obstacles[i].holes.size(); ++k) {
      expect_near(one.obstacles[i].holes[k], other.obstacles[i].holes[k], tolerance);
    }
  }
  ASSERT_EQ(one.goals.size(), other.goals.size());
  for (std::size_t i = 0; i < one.goals.size(); ++i) {
    EXPECT_EQ(one.goals[i].name, other.goals[i].name);
    expect_near(one.goals[i].polygon, other.goals[i].polygon, tolerance);
    ASSERT_EQ(one.goals[i].pose.has_value(), other.goals[i].pose.has_value());
    if (one.goals[i].pose) expect_near(*one.goals[i].pose, *other.goals[i].pose, tolerance);
  }
  ASSERT_EQ(one.starts.size(), other.starts.size());
  for (std::size_t i = 0; i < one.starts.size(); ++i) {
    EXPECT_EQ(one.starts[i].name, other.starts[i].name);
    expect_near(one.starts[i].position, other.starts[i].position, tolerance);
    EXPECT_NEAR(one.starts[i].heading, other.starts[i].heading, tolerance);
    ASSERT_EQ(one.starts[i].angles.size(), other.starts[i].angles.size());
    for (std::size_t k = 0; k < one.starts[i].angles.size(); ++k) {
      EXPECT_NEAR(one.starts[i].angles[k], other.starts[i].angles[k], tolerance);
    }
  }
}

// Names that XML and JSON have to escape, a hole, an island, trailers.
Workspace yard() {
  Workspace w;
  w.name = "<yard> & \"co\"";
  w.min = {-3.1, 0.2};
  w.max = {20.3, 10.7};
  w.obstacles = {{"", {{1, 1}, {9.1, 1}, {9.1, 9}, {1, 9}}, {{{2, 2}, {2, 8}, {8, 8}, {8, 2}}}},
                 {"", {{4, 4}, {5, 4}, {5, 5}}, {}}};
  w.goals = {{"dock <1>", {{15, 1}, {17.3, 1}, {16, 3}}}, {"b & c", {{1, 1}, {2, 1}, {2, 2}}}};
  w.starts = {{"home", {12.25, 4.1}, 0.7, {0.3, -2.9}}, {"away", {13, 5}, -1.1, {}}};
  return w;
}

TEST_F(ExportTest, AMapReadsBackAsItWas) {
  for (const Writer& writer : kWriters) {
    SCOPED_TRACE(writer.file);
    const Workspace back = copy(yard(), writer);
    expect_same(back, yard(), writer.tolerance);
    EXPECT_THAT(back.warnings, IsEmpty());
  }
}

TEST_F(ExportTest, AGoalKeepsItsHeadingAndTolerances) {
  Workspace w = yard();
  w.goals.push_back(pose_goal("bay", {{4.3, 5}, 0.1, {-2.25}}));
  for (const Writer& writer : kWriters) {
    SCOPED_TRACE(writer.file);
    expect_same(copy(w, writer), w, writer.tolerance);
  }
  w.goals.push_back(pose_goal("ramp", {{14.5, 5}, 0.75, {900.5, 0.3, true, 0.2}}));
  for (const Writer& writer : {kWriters[0], kWriters[1]}) {
    SCOPED_TRACE(writer.file);
    expect_same(copy(w, writer), w, writer.tolerance);
  }
}

TEST_F(ExportTest, AFarMapKeepsItsCoordinates) {
  Workspace far = yard();
  far.goals.push_back(pose_goal("bay", {{4.25, 5}, 0.1, {1.5}}));
  far.shift = {5000000009, -4999999995};  // what reading it will shift it by again
  far.min = {-12, -6};
  far.max = {12, 6};
  for (const Writer& writer : {kWriters[0], kWriters[1]}) {
    SCOPED_TRACE(writer.file);
    expect_same(copy(far, writer), far, 1e-6);
    EXPECT_THAT(writer.write(far), testing::HasSubstr("4999999997.0"));
  }
}

bool covers(const Workspace& w, const Point& p) {
  for (const Obstacle& obstacle : w.obstacles) {
    bool in = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point& a = obstacle.outer.at(i);
      const Point& b = obstacle.outer.at((i + 1) % 4);
      in = in && (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0;
    }
    if (in) return true;
  }
  return false;
}

TEST_F(ExportTest, CellsBecomeRectanglesThatCoverThemOnce) {
  Workspace w;
  w.min = {-20, -20};
  w.max = {20, 20};
  w.cells = CellMap{5, 4, 0.5, {1, 2}, 0.3, {1, 1, 0, 1, 1,  //
                                             1, 1, 1, 0, 1,  //
                                             0, 1, 1, 0, 1,  //
                                             1, 1, 1, 0, 0}};
  for (const Writer& writer : kWriters) {
    SCOPED_TRACE(writer.file);
    const Workspace back = copy(w, writer);
    double sum = 0;
    for (const Obstacle& obstacle : back.obstacles) sum += std::abs(area(obstacle.outer));
    EXPECT_NEAR(sum, 14 * 0.25, 1e-9);
    EXPECT_EQ(back.obstacles.size(), 6U);
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 5; ++column) {
        const double x = 0.5 * column + 0.25, y = 0.5 * row + 0.25;
        const Point center = {1 + std::cos(0.3) * x - std::sin(0.3) * y, 2 + std::sin(0.3) * x + std::cos(0.3) * y};
        EXPECT_EQ(covers(back, center), w.cells->at(column, row)) << column << " " << row;
      }
    }
  }
}

}  // namespace
}  // namespace krait::host
