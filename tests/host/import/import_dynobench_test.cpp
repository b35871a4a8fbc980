// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>

#include "../scratch.hpp"
#include "host/import/import.hpp"

namespace krait::host::import_dynobench_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const std::string kBounds = "environment:\n  min: [0, 0]\n  max: [6.5, 5]\n";
const std::string kRobot = "robots:\n  - type: unicycle1_v0\n    start: [1, 2, 0.5]\n    goal: [4, 3, 0]\n";

class DynobenchTest : public ScratchTest {
 protected:
  Workspace read(const std::string& yaml) const { return import_workspace(write("d.yaml", yaml), {}); }
  std::string error(const std::string& yaml) const {
    return error_of([&] { read(yaml); });
  }
};

TEST_F(DynobenchTest, ItsNameHasNoControlCharacters) {
  EXPECT_EQ(error("name: \"a\\x9Bb\"\n" + kBounds),
            path("d.yaml") + ": name: must be a name of 1 to 200 bytes without control characters, is \"a\\u009bb\"");
  EXPECT_EQ(error("name: a\xE2\x80\x8F\n" + kBounds),
            path("d.yaml") + ": name: must be a name of 1 to 200 bytes without control characters, is \"a\\u200f\"");
}

TEST_F(DynobenchTest, AFileNameIsEscapedInWarnings) {
  const Workspace w = import_workspace(write("a\x1B[m.yaml", kBounds + kRobot + "  - start: [1]\n"), {});
  ASSERT_EQ(w.warnings.size(), 1U);
  EXPECT_THAT(w.warnings[0], HasSubstr("/a\\u001B[m.yaml: robots: only the first one's"));
}

TEST_F(DynobenchTest, ReadsBoxesStartAndGoal) {
  const Workspace w = read("name: park\n" + kBounds +
                           "  obstacles:\n    - {type: box, center: [2, 3], size: [1, 0.5]}\n"
                           "    - {type: box, center: [2, 3], size: [1, 0.5], angle: 1.5707963267948966}\n" +
                           kRobot);
  EXPECT_EQ(w.name, "park");
  EXPECT_EQ(w.max.x, 6.5);
  ASSERT_EQ(w.obstacles.size(), 2U);
  EXPECT_EQ(w.obstacles[0].label, "environment.obstacles[0]");
  EXPECT_EQ(w.obstacles[0].outer[0].x, 1.5);
  EXPECT_EQ(w.obstacles[0].outer[0].y, 2.75);
  EXPECT_NEAR(w.obstacles[1].outer[0].x, 2.25, 1e-12);
  EXPECT_NEAR(w.obstacles[1].outer[0].y, 2.5, 1e-12);
  ASSERT_EQ(w.starts.size(), 1U);
  EXPECT_EQ(w.starts[0].name, "start");
  EXPECT_EQ(w.starts[0].heading, 0.5);
  ASSERT_EQ(w.goals.size(), 1U);
  EXPECT_EQ(w.goals[0].name, "goal");
  for (const Point& p : w.goals[0].polygon) EXPECT_NEAR(std::hypot(p.x - 4, p.y - 3), 0.1, 1e-6);
}

TEST_F(DynobenchTest, TheGoalHasItsHeading) {
  const Workspace w = read(kBounds + "robots:\n  - start: [1, 2, 0]\n    goal: [4, 3, -2.5]\n");
  ASSERT_EQ(w.goals.size(), 1U);
  ASSERT_TRUE(w.goals[0].pose);
  EXPECT_EQ(w.goals[0].pose->position.x, 4);
  EXPECT_EQ(w.goals[0].pose->radius, 0.1);
  EXPECT_EQ(w.goals[0].pose->facing.heading, -2.5);
  EXPECT_EQ(w.goals[0].pose->facing.tolerance, 0.1);
}

TEST_F(DynobenchTest, NeitherObstaclesNorRobotsAreNeeded) {
  EXPECT_THAT(read(kBounds + "  obstacles: []\n").obstacles, IsEmpty());
  EXPECT_THAT(read(kBounds + "  obstacles:\n").starts, IsEmpty());
  EXPECT_THAT(read(kBounds).goals, IsEmpty());
}

TEST_F(DynobenchTest, SaysWhatItDoesNotUse) {
  EXPECT_THAT(read(kBounds + kRobot).warnings, IsEmpty());
  const Workspace w = read(kBounds + "robots:\n - start: [1, 2, 0, 3]\n   goal: [1, 2, 0]\n - start: [1]\n");
  EXPECT_THAT(w.warnings, testing::Contains(HasSubstr("only the first one")));
  EXPECT_THAT(w.warnings, testing::Contains(HasSubstr("robots[0].start: only x, y and theta")));
}

TEST_F(DynobenchTest, ACarsTrailersStandWhereTheStartSays) {
  const auto car = [&](const std::string& start, const std::string& goal) {
    return read(kBounds + "robots:\n - type: car1_v0\n   start: [1, 2, 0.5" + start + "]\n   goal: [4, 3, 1" + goal +
                "]\n");
  };
  const Workspace bent = car(", 0.25, -0.5", ", 1, 1");
  ASSERT_EQ(bent.starts.size(), 1U);
  EXPECT_THAT(bent.starts[0].angles, testing::ElementsAre(0.25, -0.5));
  EXPECT_THAT(bent.warnings, IsEmpty());
  const Workspace straight = car(", 0.5", ", 1");  // for a robot with any number of trailers
  EXPECT_THAT(straight.starts[0].angles, IsEmpty());
  EXPECT_THAT(straight.warnings, IsEmpty());
  EXPECT_THAT(car(", 0.5", ", 0.5").warnings,
              testing::ElementsAre(HasSubstr("robots[0].goal: its trailers' headings are not used")));
  EXPECT_THAT(error(kBounds + "robots:\n - type: car1_v0\n   start: [1, 2, 0, 1e9]\n   goal: [1, 2, 0]\n"),
              HasSubstr("robots[0].start[3]: must be"));
}

TEST_F(DynobenchTest, WrongFieldsAreNamed) {
  EXPECT_THAT(error(kBounds + "  obstacles:\n    - {type: sphere, center: [2, 3], size: [1]}\n"),
              HasSubstr("environment.obstacles[0].type: only obstacles of type box are known, this is a sphere"));
  EXPECT_THAT(error(kBounds + "  obstacles:\n    - {type: box, center: [2, 3, 4], size: [1, 1]}\n"),
              HasSubstr("center: must be [x, y]"));
  EXPECT_THAT(error(kBounds + "  obstacles:\n    - {type: box, center: [2, 3], size: [1, 0]}\n"),
              HasSubstr("size[1]: must be"));
  EXPECT_THAT(error(kBounds + "robots:\n  - start: [1, 2]\n"),
              HasSubstr("robots[0].start: must be a list of at least 3"));
  EXPECT_THAT(error(kBounds + "robots:\n  - start: [1, 2, 0]\n"), HasSubstr("robots[0].goal: is missing"));
  EXPECT_THAT(error("environment:\n  min: [0, 0]\n  max: [0, 5]\n"), HasSubstr("environment: max must be greater"));
  EXPECT_THAT(error("environment:\n  min: [0, 0]\n"), HasSubstr("environment.max: is missing"));
  EXPECT_THAT(error("environment: 3\n"), HasSubstr("environment: must be an object"));
}

}  // namespace
}  // namespace krait::host::import_dynobench_test
