// SPDX-License-Identifier: GPL-3.0-or-later
// Robots and steps whose plans once ran into walls: every plan must hold as it is driven.
#include <gtest/gtest.h>

#include <cstring>

#include "host/compiler/compiler.hpp"
#include "host/scenes/scenes.hpp"
#include "krait/robots/car.hpp"
#include "planning.hpp"

namespace krait::campaign {
namespace {

class Known : public ::testing::Test {
 protected:
  void open(const char* name, double scale) {
    workspace_ = host::make_scene(name, scale).workspace;
    const host::CompiledScene compiled = host::compile(workspace_, {});
    bytes_.resize((compiled.bytes.size() + 7) / 8);
    std::memcpy(bytes_.data(), compiled.bytes.data(), compiled.bytes.size());
    ASSERT_TRUE(Scene::open(bytes_.data(), compiled.bytes.size(), scene_).ok());
  }

  // Plans from the scene's start to its goal with so many seeds from query.seed on; all that is found must hold, and
  // half must be.
  void expect_sound(Query query, int seeds) {
    const Field field(workspace_, {0, 0});
    const ScenePose pose = scene_.start(0);
    query.start.assign(static_cast<std::size_t>(Equations(query.robot).state_size()), pose.heading);
    query.start[0] = pose.position.x;
    query.start[1] = pose.position.y;
    for (std::size_t i = 3; i < query.start.size() && i < 5; ++i) query.start[i] = 0;
    query.iterations = 200'000;
    int solved = 0;
    for (const std::uint64_t end = query.seed + static_cast<std::uint64_t>(seeds); query.seed < end; ++query.seed) {
      const Planned planned = plan(scene_, query);
      EXPECT_NE(planned.end, "internal") << "seed " << query.seed;
      if (planned.end.starts_with("bad_")) GTEST_SKIP() << "refused: " << planned.end;
      if (!planned.solved) continue;
      ++solved;
      const Verdict verdict = judge(query.robot, field, workspace_.goals[0].polygon, planned.plan);
      for (const auto* lines : {&verdict.collisions, &verdict.off_limits, &verdict.misses, &verdict.others}) {
        for (const std::string& line : *lines) ADD_FAILURE() << "seed " << query.seed << ": " << line;
      }
    }
    EXPECT_GE(2 * solved, seeds);
  }

  host::Workspace workspace_;
  std::vector<std::uint64_t> bytes_;
  Scene scene_;
};

Query default_car(float dt) {
  Query query;
  query.robot.model = Model::car;
  query.robot.chain = Car::defaults();
  query.parameters.dt = dt;
  return query;
}

TEST_F(Known, CarWithStepsOfHalfASecond) {
  open("openings", 1);
  expect_sound(default_car(0.5F), 16);
}

TEST_F(Known, CarWithStepsOfASecond) {
  open("openings", 1);
  expect_sound(default_car(1), 16);
}

TEST_F(Known, TruckWithStepsOfHalfASecond) {
  open("openings", 1);
  Query query;
  query.robot.model = Model::truck;
  query.robot.chain.trailers = 2;
  query.parameters.dt = 0.5F;
  expect_sound(query, 24);
}

TEST_F(Known, TruckWithHitchesOf15Centimetres) {
  open("rooms", 1);
  Query query;
  query.robot.model = Model::truck;
  ChainParameters& p = query.robot.chain;
  p.trailers = 3;
  p.hitch_length = 0.15F;
  p.body_length = 0.12F;
  p.body_width = 0.1F;
  p.wheelbase = 0.1F;
  expect_sound(query, 12);
}

TEST_F(Known, FastSnakeWithShortHitches) {
  open("rooms", 1);
  Query query;
  query.robot.model = Model::snake;
  ChainParameters& p = query.robot.chain;
  p.trailers = 2;
  p.hitch_length = 0.3F;
  p.body_length = 0.28F;
  p.body_width = 0.15F;
  p.wheelbase = 0.3F;
  p.max_speed = 5;
  expect_sound(query, 12);
}

TEST_F(Known, LongSnakeInAHallFourTimesAsLarge) {
  open("rooms", 4);
  Query query;
  query.robot.model = Model::snake;
  query.robot.chain.trailers = 15;
  query.bytes = 8U << 20U;
  query.seed = 20;
  expect_sound(query, 4);
}

}  // namespace
}  // namespace krait::campaign
