// SPDX-License-Identifier: Apache-2.0
// Rough steps against Runge-Kutta's, and how far they find a way free.

#include "in_own_memory.hpp"
#include "krait/robots/detail/defaults.hpp"
#include "planner_fixture.hpp"
#include "robot_oracle.hpp"
#include "search/sketcher.hpp"

namespace krait::test::sketch_test {
namespace {

constexpr float kStep = 0.2F;

// How many components of a state steering looks at: those of the car and the first trailer's heading.
template <class R>
constexpr std::size_t seen_by_steering() {
  if constexpr (kTows<R>) return R::kCarState + 1;
  return R::kMaxState;
}

template <class R>
class SketchStep : public ::testing::Test {};
TYPED_TEST_SUITE(SketchStep, Models, ModelNames);

// Along random controls: frames are where small Runge-Kutta steps lead, up to some centimetres and degrees a step, and
// so is what steering looks at.
TYPED_TEST(SketchStep, LeadsAboutWhereTheDynamicsDo) {
  for (const TypeParam& robot : instances<TypeParam>()) {
    std::mt19937 random(1);
    for (int i = 0; i < 300; ++i) {
      std::vector<float> state = random_state(robot, random);
      if constexpr (kTows<TypeParam>) {
        for (std::size_t k = TypeParam::kCarState; k < state.size(); ++k)
          state[k] = state[k == TypeParam::kCarState ? 2 : k - 1] + uniform_float(random, -0.5, 0.5);
      }
      std::vector<float> u = random_control(robot, state, kStep, random);
      for (float& control : u) control *= 0.99F;  // rounding does not carry the state across its limits
      std::vector<Pose> poses(static_cast<std::size_t>(robot.body_count()));
      robot.place(StateView(state.data(), robot.state_size()), poses.data());
      std::vector<float> rough = state;
      ASSERT_TRUE(detail::sketch(robot, StateRef(rough.data(), robot.state_size()), poses.data(),
                                 ControlView(u.data(), robot.control_size()), kStep));
      std::vector<float> exact = state;
      for (int part = 0; part < 20; ++part) exact = step(robot, exact, u, kStep / 20);
      std::vector<Pose> expected(poses.size());
      robot.place(StateView(exact.data(), robot.state_size()), expected.data());
      for (std::size_t k = 0; k < poses.size(); ++k) {
        const auto trailers = static_cast<float>(k);
        ASSERT_LE(length(poses[k].position - expected[k].position), 0.04F + 0.01F * trailers) << i << " " << k;
        ASSERT_LE(math::absolute((poses[k].heading - expected[k].heading).sin), 0.04F) << i << " " << k;
      }
      const std::size_t seen = std::min<std::size_t>(rough.size(), seen_by_steering<TypeParam>());
      for (std::size_t k = 0; k < seen; ++k) ASSERT_NEAR(rough[k], exact[k], 0.04) << i << " " << k;
    }
  }
}

TEST(SketchOfAChain, EndsWhereAHitchFoldsTooFar) {
  ChainParameters p;
  p.trailers = 3;
  p.max_hitch_angle = 0.6F;
  const Truck robot(p);
  const float angles[] = {0, 0, -0.58F};
  std::vector<float> state(8);
  robot.rest({0, 0}, 0, angles, state.data());
  for (const float speed : {1.0F, -1.0F}) {  // forwards it unfolds
    std::vector<float> s = state;
    s[3] = speed;
    Pose poses[4];
    robot.place(StateView(s.data(), 8), poses);
    const float u[] = {0, 0};
    EXPECT_EQ(detail::sketch(robot, StateRef(s.data(), 8), poses, ControlView(u, 2), kStep), speed > 0.0F);
  }
}

// Headings stay unit vectors however many steps are made.
TEST(SketchOfAChain, KeepsItsFramesTurned) {
  ChainParameters p;
  p.trailers = 25;
  const Snake robot(p);
  std::vector<float> state(static_cast<std::size_t>(robot.state_size()));
  robot.rest({0, 0}, 1, nullptr, state.data());
  std::vector<Pose> poses(26);
  robot.place(StateView(state.data(), robot.state_size()), poses.data());
  Steering steering;
  for (int i = 0; i < 200; ++i) {
    float u[2];
    const Target target{{i % 40 < 20 ? 50.0F : -50.0F, 20}, 1.0F, kStep, 1.0F};
    robot.steer(StateView(state.data(), robot.state_size()), poses.data(), target, steering, ControlRef(u, 2));
    detail::sketch(robot, StateRef(state.data(), robot.state_size()), poses.data(), ControlView(u, 2), kStep);
  }
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const SinCos h = poses[k].heading;
    EXPECT_NEAR(h.sin * h.sin + h.cos * h.cos, 1, 1e-3) << k;
    if (k == 0) continue;
    EXPECT_NEAR(length(poses[k].position - poses[k - 1].position), 0.8, 1e-3) << k;
  }
  EXPECT_GT(length(poses[0].position), 5.0F);
}

template <class R>
std::uint32_t free_steps(const Room& room, const R& robot, const std::vector<float>& state, const Target& target) {
  const OpenScene open(room);
  InOwnMemory<detail::Sketcher> sketcher;
  sketcher.assign(robot, open.scene, kStep, 0.5F);
  return sketcher.free_steps(state.data(), target);
}

Room hall() {
  Room room;
  room.bounds = {0, 0, 40, 20};
  room.spacing = 5;
  return room;
}

template <class R>
class SketcherOf : public ::testing::Test {};
TYPED_TEST_SUITE(SketcherOf, Models, ModelNames);

TYPED_TEST(SketcherOf, FindsAWayFreeUpToTheWall) {
  const TypeParam robot = instances<TypeParam>().front();
  std::vector<float> state(static_cast<std::size_t>(robot.state_size()), 0.0F);
  state[0] = 20;
  state[1] = 10;
  Room walled = hall();
  walled.boxes = {{21.5, 0, 22, 20}};
  const Target ahead{{30, 10}, 1.0F, 0.1F, 1.0F};
  EXPECT_EQ(free_steps(hall(), robot, state, ahead), detail::Sketcher::kSteps);
  const std::uint32_t steps = free_steps(walled, robot, state, ahead);
  EXPECT_GE(steps, 2U);
  EXPECT_LT(steps, 10U);
  // What is reached before the wall is free.
  EXPECT_EQ(free_steps(walled, robot, state, {{20.7F, 10}, 1.0F, 0.1F, 1.0F}), detail::Sketcher::kSteps);
}

TEST(SketcherOfATrain, SeesThatATrailerHits) {
  ChainParameters p;
  p.trailers = 4;
  const Snake robot(p);
  std::vector<float> state(9);
  robot.rest({20, 10}, 0, nullptr, state.data());
  Room room = hall();
  room.boxes = {{16.6, 10.4, 18.9, 13}};  // beside the last trailers: a turn away from it drags them into it
  EXPECT_EQ(free_steps(room, robot, state, {{30, 10}, 1.0F, 0.1F, 1.0F}), detail::Sketcher::kSteps);
  EXPECT_LT(free_steps(room, robot, state, {{20, 3}, 1.0F, 0.1F, 1.0F}), detail::Sketcher::kSteps);
  EXPECT_EQ(free_steps(room, robot, state, {{20, 17}, 1.0F, 0.1F, 1.0F}), detail::Sketcher::kSteps);
}

// Its trailer comes near the target, and would be in the wall before the truck did.
TEST(SketcherOfATrain, ThatBacksUpIsThereWhenItsEndIs) {
  ChainParameters p;
  p.trailers = 1;
  p.min_speed = -1;
  const Truck robot(p);
  std::vector<float> state(6);
  robot.rest({20, 10}, 0, nullptr, state.data());
  Room room = hall();
  room.boxes = {{17, 0, 18.2, 20}};
  EXPECT_EQ(free_steps(room, robot, state, {{18.6F, 10}, -1.0F, 0.1F, 1.0F}), detail::Sketcher::kSteps);
  EXPECT_LT(free_steps(room, robot, state, {{17.5F, 10}, -1.0F, 0.1F, 1.0F}), detail::Sketcher::kSteps);
}

// Room for the narrowest body is all that is looked for: what a narrow tractor can reach is free.
TEST(SketcherOfATrain, OfANarrowTractorReachesItsPlaceBeforeAWall) {
  ChainParameters p;
  p.trailers = 1;
  p.hitch_length = 2;
  Truck robot(p);
  const auto square = [&](int body, float half) {
    const Vec2 corners[] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
    robot.set_body(body, {corners, 4});
  };
  square(0, 0.2F);
  square(1, 1.2F);
  std::vector<float> state(6);
  robot.rest({20, 10}, 0, nullptr, state.data());
  Room room = hall();
  room.boxes = {{22, 0, 22.5, 20}};
  EXPECT_EQ(free_steps(room, robot, state, {{21.7F, 10}, 1.0F, 0.1F, 1.0F}), detail::Sketcher::kSteps);
}

TEST(SketcherOfAUsersRobot, GoesByItsDerivative) {
  const Slider robot(0.5F, 1.5F);
  Room room = hall();
  room.boxes = {{22, 0, 22.5, 20}};
  EXPECT_EQ(free_steps(room, robot, {20, 10}, {{20, 16}, 1.0F, 0.1F, 1.0F}), detail::Sketcher::kSteps);
  const std::uint32_t steps = free_steps(room, robot, {20, 10}, {{30, 10}, 1.0F, 0.1F, 1.0F});
  EXPECT_EQ(steps, 5U);  // 0.3 m each, until 0.27 m before the wall
}

// Discs are around the bodies' middles, not their origins.
TEST(SketcherOfABodyAhead, SeesThatItHits) {
  Unicycle robot(UnicycleParameters{});
  const Vec2 body[] = {{0.6F, -0.2F}, {1, -0.2F}, {1, 0.2F}, {0.6F, 0.2F}};
  robot.set_body(0, {body, 4});
  Room room = hall();
  room.boxes = {{22, 0, 22.5, 20}};
  EXPECT_EQ(free_steps(room, robot, {20, 10, 0}, {{30, 10}, 1.0F, 0.1F, 1.0F}), 4U);  // 20.8 + 0.216 + 0.2 n <= 22
}

TEST(Sketcher, StatesThatAreNotFiniteAreNotFree) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(free_steps(hall(), Unicycle(UnicycleParameters{}), {20, 10, nan}, {{30, 10}, 1.0F, 0.1F, 1.0F}), 0U);
  EXPECT_EQ(free_steps(hall(), Unicycle(UnicycleParameters{}), {nan, 10, 0}, {{30, 10}, 1.0F, 0.1F, 1.0F}), 0U);
}

}  // namespace
}  // namespace krait::test::sketch_test
