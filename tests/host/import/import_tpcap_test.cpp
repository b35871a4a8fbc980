// SPDX-License-Identifier: Apache-2.0
// Parking cases of the TPCAP benchmark, sound and spoiled.
#include <gmock/gmock.h>

#include <cmath>

#include "../scratch.hpp"
#include "host/import/import.hpp"

namespace krait::host::import_tpcap_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kPoses = "1,2,0.5,3,4,-0.25,";
const std::string kSquareAndTriangle = "2,4,3,10,0,12,0,12,3,10,3,-7,-8,-6,-8,-6,-7.5";

class TpcapTest : public ScratchTest {
 protected:
  Workspace read(const std::string& content, const std::string& name = "case.csv") const {
    return import_workspace(write(name, content), {});
  }
  std::string error(const std::string& content) const {
    return error_of([&] { read(content); });
  }
};

TEST_F(TpcapTest, ReadsStartGoalAndObstacles) {
  const Workspace w = read(kPoses + kSquareAndTriangle + "\n");
  EXPECT_EQ(w.name, "case");
  ASSERT_EQ(w.starts.size(), 1U);
  EXPECT_EQ(w.starts[0].name, "start");
  EXPECT_EQ(w.starts[0].position.x, 1);
  EXPECT_EQ(w.starts[0].position.y, 2);
  EXPECT_EQ(w.starts[0].heading, 0.5);
  ASSERT_EQ(w.goals.size(), 1U);
  for (const Point& p : w.goals[0].polygon) EXPECT_NEAR(std::hypot(p.x - 3, p.y - 4), 0.1, 1e-6);
  ASSERT_EQ(w.obstacles.size(), 2U);
  EXPECT_EQ(w.obstacles[0].outer.size(), 4U);
  EXPECT_EQ(w.obstacles[0].outer[2].x, 12);
  EXPECT_EQ(w.obstacles[0].outer[2].y, 3);
  EXPECT_EQ(w.obstacles[1].label, "obstacle 2");
  EXPECT_EQ(w.obstacles[1].outer[2].y, -7.5);
}

TEST_F(TpcapTest, ItsBoundsReachTenMetresAroundAllPoints) {
  const Workspace w = read(kPoses + kSquareAndTriangle);
  EXPECT_EQ(w.min.x, -17);
  EXPECT_EQ(w.min.y, -18);
  EXPECT_EQ(w.max.x, 22);
  EXPECT_EQ(w.max.y, 14);
}

TEST_F(TpcapTest, TheGoalHasItsHeading) {
  const Workspace w = read(kPoses + "0");
  EXPECT_THAT(w.warnings, ElementsAre(HasSubstr("has no bounds")));
  ASSERT_TRUE(w.goals[0].pose);
  EXPECT_EQ(w.goals[0].pose->position.x, 3);
  EXPECT_EQ(w.goals[0].pose->position.y, 4);
  EXPECT_EQ(w.goals[0].pose->radius, 0.1);
  EXPECT_EQ(w.goals[0].pose->facing.heading, -0.25);
  EXPECT_EQ(w.goals[0].pose->facing.tolerance, 0.1);
  EXPECT_FALSE(w.goals[0].pose->facing.either_way);
}

TEST_F(TpcapTest, IsRecognisedByContentToo) {
  EXPECT_EQ(read(kPoses + kSquareAndTriangle, "case").obstacles.size(), 2U);
  EXPECT_EQ(read(" 1, 2 ,0.5,3,4 ,-2.5e-1,\r\n0\r\n", "case").starts[0].position.y, 2);
  EXPECT_THAT(read(kPoses + "0").obstacles, IsEmpty());
}

TEST_F(TpcapTest, EveryTruncationIsRefused) {
  const std::string whole = kPoses + kSquareAndTriangle;
  for (std::size_t length = 1; length + 4 < whole.size(); ++length) EXPECT_NE(error(whole.substr(0, length)), "");
  EXPECT_EQ(error("1,2,0.5"), path("case.csv") + ": value 4: the x of the goal is missing: the file ends early");
}

TEST_F(TpcapTest, WrongValuesAreNamed) {
  EXPECT_EQ(error("1,2,x,3,4,5,0"),
            path("case.csv") + ": value 3: the start's heading must be a number from -1000 to 1000 radians, is \"x\"");
  EXPECT_THAT(error("nan,2,0,3,4,5,0"), HasSubstr("value 1: the x of the start must be a number"));
  EXPECT_THAT(error("1,inf,0,3,4,5,0"), HasSubstr("value 2: the y of the start must be a number"));
  EXPECT_THAT(error(kPoses + "1,3,0,0,1,0,1,1e300"), HasSubstr("value 14: the y of vertex 3 of obstacle 1 must be"));
  EXPECT_THAT(error(kPoses + "1.5,3,0,0,1,0,1,1"), HasSubstr("the number of obstacles must be a whole number"));
  EXPECT_THAT(error(kPoses + "-1"), HasSubstr("must be a whole number, at least 0, is -1"));
  EXPECT_THAT(error(kPoses + "1,2,0,0,1,0"), HasSubstr("vertices of obstacle 1 must be a whole number, at least 3"));
  EXPECT_THAT(error("x, y, theta\n1,2,3"), HasSubstr("value 1: the x of the start must be a number"));
  EXPECT_THAT(error(std::string(1000, ',')), HasSubstr("value 1: the x of the start must be a number"));
}

TEST_F(TpcapTest, CountsThatLieAreRefused) {
  EXPECT_THAT(error(kPoses + "9999999,3"), HasSubstr("value 7: the number of obstacles is 9999999, but the values "
                                                     "that are left suffice for 1"));
  EXPECT_THAT(error(kPoses + "1,9999999,0,0,1,0,1,1"), HasSubstr("obstacle 1 is 9999999, but"));
  EXPECT_THAT(error(kPoses + "2,3,3,0,0,1,0,1,1"), HasSubstr("the x of vertex 1 of obstacle 2 is missing"));
  EXPECT_THAT(error(kPoses + "1,3,0,0,1,0,1,1,7"), HasSubstr("is followed by 1 values more than its counts say"));
}

}  // namespace
}  // namespace krait::host::import_tpcap_test
