// SPDX-License-Identifier: Apache-2.0
// Maps far from the world's origin, in every format that has coordinates.
#include <gmock/gmock.h>

#include "../scratch.hpp"
#include "host/import/import.hpp"

namespace krait::host::import_shift_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ShiftTest : public ScratchTest {
 protected:
  Workspace read(const std::string& name, const std::string& content) const {
    return import_workspace(write(name, content), {});
  }
};

void expect_point(const Point& p, double x, double y) {
  EXPECT_EQ(p.x, x);
  EXPECT_EQ(p.y, y);
}

TEST_F(ShiftTest, AFarMapIsMovedByWholeMetres) {
  const Workspace w = read("far.json", R"({
    "bounds": {"min": [5000000000, -5000000010], "max": [5000000020.75, -5000000000]},
    "obstacles": [{"polygon": [[5000000001.25, -5000000009], [5000000004, -5000000009], [5000000004, -5000000005]],
                   "holes": [[[5000000002, -5000000008], [5000000003, -5000000008], [5000000003, -5000000007.5]]]}],
    "goals": [{"name": "g", "polygon": [[5000000010, -5000000005], [5000000011, -5000000005], [5000000011, -5e9]]}],
    "starts": [{"name": "s", "position": [5000000012.5, -5000000003.5], "heading": 0}]})");
  expect_point(w.shift, 5000000010, -5000000005);
  expect_point(w.min, -10, -5);
  expect_point(w.max, 10.75, 5);
  expect_point(w.obstacles[0].outer[0], -8.75, -4);
  expect_point(w.obstacles[0].holes[0][2], -7, -2.5);
  expect_point(w.goals[0].polygon[2], 1, 5);
  expect_point(w.starts[0].position, 2.5, 1.5);
  EXPECT_THAT(w.warnings, ElementsAre(HasSubstr("far.json: lies far from 0: x less 5000000010 m and y less "
                                                "-5000000005 m are the coordinates from here on")));
}

TEST_F(ShiftTest, AMapOnANationalGridStaysWhereItIs) {
  const Workspace w = read("utm.json", R"({"bounds": {"min": [691000, 5334000], "max": [691100, 5334100]}})");
  expect_point(w.shift, 0, 0);
  expect_point(w.min, 691000, 5334000);
  EXPECT_THAT(w.warnings, IsEmpty());
}

TEST_F(ShiftTest, CellMapsAndProblemsAreMovedToo) {
  write("m.pgm", std::string("P5 2 2 255\n\0\xFF\xFF\xFF", 15));
  const Workspace map = read("m.yaml",
                             "image: m.pgm\nresolution: 0.5\norigin: [5000000000, 3, 0]\nnegate: 0\n"
                             "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  expect_point(map.shift, 5000000001, 4);
  expect_point(map.cells->origin, -1, -1);
  const Workspace problem =
      read("d.yaml", "environment:\n  min: [5000000000, 0]\n  max: [5000000006, 5]\n  obstacles: []\n");
  expect_point(problem.min, -3, -3);
  expect_point(read("t.csv", "5e9,5e9,0,5000000002,5e9,0,0").starts[0].position, -1, 0);
}

TEST_F(ShiftTest, WhatLiesFarFromTheMapIsRefused) {
  const auto error = [&](const std::string& member) {
    return error_of([&] { read("s.json", R"({"bounds": {"min": [0, 0], "max": [9, 9]}, )" + member + "}"); });
  };
  EXPECT_EQ(
      error(R"("obstacles": [{"circle": {"center": [5e9, 0], "radius": 1}}])"),
      path("s.json") + ": obstacles[0]: lies more than 40000000 m from the centre of the map: correct its coordinates");
  EXPECT_EQ(error_of([&] { read("s.json", R"({"bounds": {"min": [-1e8, -1], "max": [1e8, 1]}})"); }),
            path("s.json") +
                ": the lower left corner of the bounds: lies more than 40000000 m from the centre of the "
                "map: correct its coordinates");
  EXPECT_THAT(error(R"("starts": [{"name": "home", "position": [0, -5e9], "heading": 0}])"),
              HasSubstr("start home: lies more than"));
  EXPECT_THAT(error(R"("obstacles": [{"circle": {"center": [1e11, 0], "radius": 1}}])"),
              HasSubstr("obstacles[0].circle.center[0]: must be a number from"));
}

}  // namespace
}  // namespace krait::host::import_shift_test
