// SPDX-License-Identifier: GPL-3.0-or-later
// Robots of a TurtleBot's size and speed cross maps of half a kilometre: no plan is refused by its own check, and each
// that is found holds as it is driven. Skipped where the maps are absent.
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>

#include "host/compiler/compiler.hpp"
#include "host/import/import.hpp"
#include "paths.hpp"
#include "planning.hpp"

namespace krait::campaign {
namespace {

constexpr double kGoalRadius = 0.25;  // m

struct Crossing {
  const char* map;
  double start[3];  // m, m, rad
  double goal[2];   // m
};

constexpr Crossing kCrossings[] = {{"maze512-32-0", {300.5, 1.5, 0}, {71.5, 480.5}},
                                   {"maze512-32-0", {377.5, 447.5, 2.356}, {232.5, 43.5}},
                                   {"brc202d", {247.5, 344.5, 0}, {271.5, 248.5}},
                                   {"brc202d", {114.5, 247.5, -3.1412}, {466.5, 294.5}}};

class TurtleBot : public ::testing::TestWithParam<Crossing> {
 protected:
  void SetUp() override {
    const std::string path = test::source_path("../shared/samples/movingai/") + GetParam().map + ".map";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no map " << path;
    workspace_ = host::import_workspace(path, {});
    const host::CompiledScene compiled = host::compile(workspace_, {});
    bytes_.resize((compiled.bytes.size() + 7) / 8);
    std::memcpy(bytes_.data(), compiled.bytes.data(), compiled.bytes.size());
    ASSERT_TRUE(Scene::open(bytes_.data(), compiled.bytes.size(), scene_).ok());
  }

  void cross(const Robot& robot) {
    const host::Point origin{scene_.header().origin_x, scene_.header().origin_y};
    const Field field(workspace_, origin);
    const Vec2 center{static_cast<float>(GetParam().goal[0] - origin.x),
                      static_cast<float>(GetParam().goal[1] - origin.y)};
    Query query;
    query.robot = robot;
    query.start.assign(static_cast<std::size_t>(Equations(robot).state_size()), 0);
    query.start[0] = static_cast<float>(GetParam().start[0] - origin.x);
    query.start[1] = static_cast<float>(GetParam().start[1] - origin.y);
    query.start[2] = static_cast<float>(GetParam().start[2]);
    query.goal = Goal::disc(center, static_cast<float>(kGoalRadius));
    query.iterations = 20'000;
    const Disc disc{static_cast<double>(center.x), static_cast<double>(center.y), kGoalRadius};
    for (query.seed = 1; query.seed <= 3; ++query.seed) {
      const Planned planned = plan(scene_, query);
      EXPECT_NE(planned.end, "internal") << "seed " << query.seed;
      std::printf("seed %d: %s, %zu steps\n", static_cast<int>(query.seed), planned.end.c_str(),
                  planned.plan.controls.size() / 2);
      if (!planned.solved) continue;
      const Verdict verdict = judge(robot, field, disc, planned.plan);
      for (const auto* lines : {&verdict.collisions, &verdict.off_limits, &verdict.misses, &verdict.others}) {
        for (const std::string& line : *lines) ADD_FAILURE() << "seed " << query.seed << ": " << line;
      }
    }
  }

  host::Workspace workspace_;
  std::vector<std::uint64_t> bytes_;
  Scene scene_;
};

TEST_P(TurtleBot, DifferentialDriveCrosses) {
  Robot robot;
  robot.model = Model::diff_drive;
  cross(robot);
}

TEST_P(TurtleBot, UnicycleCrosses) {
  Robot robot;
  robot.model = Model::unicycle;
  cross(robot);
}

TEST_P(TurtleBot, SlowUnicycleCrosses) {
  Robot robot;
  robot.model = Model::unicycle;
  robot.unicycle.max_speed = 0.26F;
  robot.unicycle.min_speed = -0.26F;
  robot.unicycle.max_turn_rate = 1.82F;
  cross(robot);
}

INSTANTIATE_TEST_SUITE_P(Maps, TurtleBot, ::testing::ValuesIn(kCrossings));

}  // namespace
}  // namespace krait::campaign
