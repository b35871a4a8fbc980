// SPDX-License-Identifier: Apache-2.0
#include "host/picture/poses.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace krait::host {
namespace {

constexpr double kHitch = 0.8;

RobotSpec robot(const std::string& model, int links = 0) {
  RobotSpec spec;
  spec.model = model;
  spec.links = links;
  if (links > 0) spec.parameters["hitch_length"] = kHitch;
  return spec;
}

TEST(Poses, StateSizesAreTheDesigns) {
  EXPECT_EQ(state_size(robot("unicycle")), 3U);
  EXPECT_EQ(state_size(robot("diff_drive")), 5U);
  EXPECT_EQ(state_size(robot("car")), 5U);
  EXPECT_EQ(state_size(robot("snake", 15)), 20U);
  EXPECT_EQ(state_size(robot("truck", 2)), 7U);
  EXPECT_EQ(state_size(robot("kinematic_truck", 2)), 5U);
}

TEST(Poses, RobotsWithoutTrailersStandWhereTheirStateSays) {
  for (const char* model : {"unicycle", "diff_drive", "car"}) {
    const RobotSpec spec = robot(model);
    std::vector<float> state(state_size(spec), 9.0F);
    state[0] = 1;
    state[1] = 2;
    state[2] = 0.5;
    const std::vector<Pose> poses = body_poses(spec, state);
    ASSERT_EQ(poses.size(), 1U) << model;
    EXPECT_EQ(poses[0].x, 1);
    EXPECT_EQ(poses[0].y, 2);
    EXPECT_EQ(poses[0].heading, 0.5);
  }
}

// Oracle: the position of axle k as a sum of complex numbers.
TEST(Poses, TrailersHangBehindOneAnother) {
  const RobotSpec spec = robot("snake", 3);
  const std::vector<float> state = {1, 2, 0.3F, 1.5F, -0.2F, 0.1F, -0.7F, 2.5F};
  const std::vector<Pose> poses = body_poses(spec, state);
  ASSERT_EQ(poses.size(), 4U);
  std::complex<double> axle(1, 2);
  for (std::size_t k = 1; k < 4; ++k) {
    axle -= std::polar(kHitch, static_cast<double>(state[4 + k]));
    EXPECT_NEAR(poses[k].x, axle.real(), 1e-12);
    EXPECT_NEAR(poses[k].y, axle.imag(), 1e-12);
    EXPECT_EQ(poses[k].heading, static_cast<double>(state[4 + k]));
  }
}

TEST(Poses, TrailersOfAKinematicTruckFollowItsHeading) {
  const std::vector<float> state = {1, 2, 0.3F, 0.1F, -0.7F};
  const std::vector<Pose> poses = body_poses(robot("kinematic_truck", 2), state);
  ASSERT_EQ(poses.size(), 3U);
  const std::complex<double> axle = std::complex<double>(1, 2) - std::polar(kHitch, static_cast<double>(state[3])) -
                                    std::polar(kHitch, static_cast<double>(state[4]));
  EXPECT_NEAR(poses[2].x, axle.real(), 1e-12);
  EXPECT_NEAR(poses[2].y, axle.imag(), 1e-12);
  EXPECT_EQ(poses[2].heading, static_cast<double>(state[4]));
}

TEST(Poses, UnknownModelIsNamed) {
  EXPECT_THAT([] { state_size(robot("hovercraft")); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("hovercraft")));
}

TEST(Poses, TrailersNeedAHitchLength) {
  RobotSpec spec = robot("truck", 2);
  spec.parameters.clear();
  const std::vector<float> state(7, 0.0F);
  EXPECT_THAT([&] { body_poses(spec, state); }, testing::ThrowsMessage<InputError>(testing::HasSubstr("hitch_length")));
}

}  // namespace
}  // namespace krait::host
