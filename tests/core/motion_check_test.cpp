// SPDX-License-Identifier: Apache-2.0
// What step_free accepts is free in between as well: shown by simulating accepted steps densely in double precision.
#include "collision/motion_check.hpp"

#include <gtest/gtest.h>

#include "convex.hpp"
#include "in_own_memory.hpp"
#include "krait/robots/detail/defaults.hpp"
#include "robot_oracle.hpp"
#include "step_oracle.hpp"
#include "user_robot.hpp"

namespace krait::test::motion_check_test {
namespace {

Room crowded(unsigned seed, double shift = 0) {
  std::mt19937 random(seed);
  Room room = random_room(seed, 12, 4);
  room.clearance_cell = 0.25;
  for (int i = 0; i < 4; ++i) {
    room.loose_pieces.push_back(random_convex(random, {uniform(random, 1, 11), uniform(random, 1, 11)}, 0.7));
  }
  const auto move = [&](Rect& r) { r = {r.x0 + shift, r.y0 + shift, r.x1 + shift, r.y1 + shift}; };
  move(room.bounds);
  for (Rect& box : room.boxes) move(box);
  for (Rect& goal : room.goals) move(goal);
  for (auto& piece : room.loose_pieces) {
    for (Vec2& v : piece) v = {snap(point(v).x + shift), snap(point(v).y + shift)};
  }
  return room;
}

// A state somewhere in the scene, moderately bent.
template <class R>
std::vector<float> somewhere(const R& robot, const Scene& scene, std::mt19937& random) {
  auto s = random_state(robot, random);
  s[0] = uniform_float(random, wide(scene.bounds().min.x), wide(scene.bounds().max.x));
  s[1] = uniform_float(random, wide(scene.bounds().min.y), wide(scene.bounds().max.y));
  if constexpr (kTows<R>) {
    const double curl = uniform(random, -0.6, 0.6);
    for (std::size_t i = R::kCarState; i < s.size(); ++i)
      s[i] = (i == R::kCarState ? s[2] : s[i - 1]) + uniform_float(random, curl - 0.3, curl + 0.3);
  }
  return s;
}

struct Tally {
  Tally& operator+=(const Tally& other) {
    accepted += other.accepted;
    rejected += other.rejected;
    return *this;
  }

  int accepted = 0;
  int rejected = 0;
};

// Walks of random controls from random free states: no accepted step may come to touch anything.
template <class R>
Tally expect_sound(const R& robot, const Scene& scene, float clearance, float dt, int walks, unsigned seed,
                   bool shortcuts = true) {
  std::mt19937 random(seed);
  InOwnMemory<detail::MotionCheck> check;
  check.assign(robot, scene, clearance, 16, shortcuts);
  Tally tally;
  while (walks > 0) {
    auto s = somewhere(robot, scene, random);
    if (!check.free(s.data())) continue;
    --walks;
    for (int i = 0; i < 12; ++i) {
      const auto u = random_control(robot, s, dt, random);
      const auto next = step(robot, s, u, dt);
      if (!robot.within_limits(StateView(next.data(), robot.state_size()))) break;
      if (!check.step_free(s.data(), u.data(), dt, next.data())) {
        ++tally.rejected;
        break;
      }
      ++tally.accepted;
      const double least = separation_of_step(robot, scene, s, u, dt, 200);
      EXPECT_GT(least, 0) << "seed " << seed << " step " << i << " dt " << dt;
      s = next;
    }
  }
  return tally;
}

template <class R>
class MotionCheckSound : public ::testing::Test {};
TYPED_TEST_SUITE(MotionCheckSound, Models, ModelNames);

// With shortcuts and, in half as many walks, without.
TYPED_TEST(MotionCheckSound, AcceptedStepsTouchNothingInBetween) {
  std::vector<TypeParam> robots = instances<TypeParam>();
  if constexpr (std::is_same_v<TypeParam, Snake> || std::is_same_v<TypeParam, Truck>) {
    ChainParameters p;
    p.trailers = 4;
    robots = {TypeParam(p)};
  }
  if constexpr (std::is_same_v<TypeParam, KinematicTruck>) {
    KinematicTruckParameters p;
    p.trailers = 4;
    p.min_speed = -1.0F;
    robots = {TypeParam(p)};
  }
  Tally all;
  for (const TypeParam& robot : robots) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
      const OpenScene open(crowded(seed));
      const int walks = robot.body_count() == 1 ? 24 : 14;
      for (const bool shortcuts : {true, false}) {
        all += expect_sound(robot, open.scene, 1e-3F, 0.1F, shortcuts ? walks : walks / 2, seed, shortcuts);
      }
    }
  }
  EXPECT_GT(all.accepted, 100);
  EXPECT_GT(all.rejected, 20);
}

// The verdict on body 0 alone refuses only what the whole step's would, and is none too rare; asking for it changes
// nothing else.
TYPED_TEST(MotionCheckSound, AStepWhoseLeadIsRefusedIsRefused) {
  int refused_by_lead = 0;
  bool pulls = false;
  for (const TypeParam& robot : instances<TypeParam>()) {
    pulls = pulls || robot.body_count() > 1;
    for (unsigned seed = 1; seed <= 8; ++seed) {
      const OpenScene open(crowded(seed));
      std::mt19937 random(seed);
      InOwnMemory<detail::MotionCheck> whole, asked;
      whole.assign(robot, open.scene, 1e-3F, 16, true);
      asked.assign(robot, open.scene, 1e-3F, 16, true);
      for (int walk = 0; walk < 200; ++walk) {
        auto s = somewhere(robot, open.scene, random);
        if (!whole.free(s.data())) continue;
        asked.begin(s.data());
        for (bool free = true; free;) {
          const auto u = random_control(robot, s, 0.1F, random);
          auto next = step(robot, s, u, 0.1F);
          free = whole.step_free(s.data(), u.data(), 0.1F, next.data());
          auto lead = next;
          std::fill(lead.begin() + detail::leading_size(robot), lead.end(), std::numeric_limits<float>::quiet_NaN());
          const bool lead_free = asked.lead_free(s.data(), lead.data());
          ASSERT_TRUE(lead_free || !free);
          refused_by_lead += lead_free ? 0 : 1;
          if (lead_free) {
            ASSERT_EQ(asked.step_free(s.data(), u.data(), 0.1F, next.data()), free);
          }
          free = free && robot.within_limits(StateView(next.data(), robot.state_size()));
          s = next;
        }
      }
    }
  }
  EXPECT_EQ(refused_by_lead > 100, pulls) << refused_by_lead;
}

TEST(MotionCheck, AcceptedStepsOfALongSnakeDoNotCrossItself) {
  ChainParameters p;
  p.trailers = 15;
  p.self_collision_gap = 2;
  const Snake snake(p);
  Room room;
  room.bounds = {0, 0, 60, 60};
  room.spacing = 10;
  room.bucket_size = 8;
  const OpenScene open(room);
  const Tally tally = expect_sound(snake, open.scene, 1e-3F, 0.1F, 60, 5);
  EXPECT_GT(tally.accepted, 50);
  EXPECT_GT(tally.rejected, 2);
}

// Bodies shorter than their steps, so that several may jump over a pin at once.
TEST(MotionCheck, AcceptedStepsOfShortBodiesJumpOverNoPin) {
  ChainParameters p;
  p.trailers = 6;
  p.body_length = 0.1F;
  p.body_width = 0.4F;
  const Snake snake(p);
  Tally all;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::mt19937 random(seed);
    Room room;
    room.bounds = {0, 0, 12, 12};
    room.clearance_cell = 0.25;
    for (int i = 0; i < 120; ++i) {
      const double x = uniform(random, 0.5, 11.5);
      const double y = uniform(random, 0.5, 11.5);
      room.loose_pieces.push_back({{snap(x), snap(y)}, {snap(x + 0.03), snap(y)}, {snap(x), snap(y + 0.03)}});
    }
    const OpenScene open(room);
    all += expect_sound(snake, open.scene, 1e-3F, 0.2F, 40, seed);
  }
  EXPECT_GT(all.accepted, 100);
  EXPECT_GT(all.rejected, 50);
}

TEST(MotionCheck, AcceptedStepsOfATruckWhoseCarIsOffItsAxleTouchNothing) {
  ChainParameters p;
  p.trailers = 3;
  p.body_offset = 0.4F;
  Tally all;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const OpenScene open(crowded(seed));
    all += expect_sound(Truck(p), open.scene, 1e-3F, 0.1F, 10, seed);
  }
  EXPECT_GT(all.accepted, 20);
  EXPECT_GT(all.rejected, 5);
}

TEST(MotionCheck, WithoutClearanceTheMarginCoversRounding) {
  ChainParameters p;
  p.trailers = 3;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const OpenScene open(crowded(seed));
    expect_sound(Snake(p), open.scene, 0.0F, 0.1F, 12, seed);
  }
}

TEST(MotionCheck, FarFromTheOriginTheMarginCoversRounding) {
  ChainParameters p;
  p.trailers = 5;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const OpenScene open(crowded(seed, 1985));
    expect_sound(Truck(p), open.scene, 1e-3F, 0.1F, 12, seed);
  }
}

TEST(MotionCheck, StepsWithRoomEverywhereAreAccepted) {
  ChainParameters p;
  p.trailers = 3;
  const Snake snake(p);
  int accepted = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const OpenScene open(crowded(seed));
    std::mt19937 random(seed);
    InOwnMemory<detail::MotionCheck> check;
    check.assign(snake, open.scene, 1e-3F, 16, seed % 2 == 0);
    for (int i = 0; i < 400; ++i) {
      const auto s = somewhere(snake, open.scene, random);
      const auto u = random_control(snake, s, 0.1F, random);
      const auto next = step(snake, s, u, 0.1F);
      if (separation_of_step(snake, open.scene, s, u, 0.1F, 4) < 0.3) continue;
      ASSERT_TRUE(check.free(s.data()));
      check.begin(s.data());
      ASSERT_TRUE(check.step_free(s.data(), u.data(), 0.1F, next.data()));
      ++accepted;
    }
  }
  EXPECT_GT(accepted, 50);
}

// A wall of a centimetre across the room at x = 5; with shortcuts and without.
struct Walled : ::testing::TestWithParam<bool> {
  static Room room() {
    Room result;
    result.boxes = {{5, 0, 5.01, 10}};
    result.clearance_cell = 0.125;
    return result;
  }
  OpenScene open{room()};
  Slider slider{0.1F, 100.0F};
  InOwnMemory<detail::MotionCheck> check;

  void SetUp() override { check.assign(slider, open.scene, 0.0F, 16, GetParam()); }

  // Whether a step from x to x + u dt along y = 5 is accepted after begin.
  bool steps(float x, float speed, float dt = 0.1F) {
    const float s[] = {x, 5}, u[] = {speed, 0}, next[] = {x + speed * dt, 5};
    return check.step_free(s, u, dt, next);
  }
};

TEST_P(Walled, ThinWallBetweenTwoFreeStatesIsSeen) {
  for (float x = 2.0F; x < 4.9F; x += 0.01F) {
    for (const float speed : {5.0F, 12.0F, 30.0F, 45.0F}) {
      const float end = x + 0.1F * speed;
      if (end < 5.08F || end > 9.9F) continue;
      const float s[] = {x, 5}, next[] = {end, 5};
      ASSERT_TRUE(check.free(s));
      ASSERT_TRUE(check.free(next));
      check.begin(s);
      ASSERT_FALSE(steps(x, speed)) << x << " " << speed;
    }
  }
}

TEST_P(Walled, ThinWallIsSeenAfterASlowStepBesideIt) {
  // The slow step learns only of what is near; the fast one must not take that for room.
  const float s[] = {4.945F, 5};
  ASSERT_TRUE(check.free(s));
  check.begin(s);
  ASSERT_TRUE(steps(4.945F, 0.001F));
  EXPECT_FALSE(steps(4.9451F, 20.0F));
  for (float start = 4.90F; start < 4.9495F; start += 0.0005F) {
    const float begin[] = {start, 5};
    check.begin(begin);
    if (!steps(start, 0.001F)) continue;
    EXPECT_FALSE(steps(start + 0.0001F, 12.0F)) << start;
  }
}

TEST_P(Walled, FastStepInTheOpenIsAccepted) {
  const float s[] = {1, 5};
  check.begin(s);
  EXPECT_TRUE(steps(1, 35));  // up to 0.4 m before the wall: by halving
  check.begin(s);
  EXPECT_TRUE(steps(1, 5));
}

TEST_P(Walled, FastStepThatEndsJustBeforeTheWallIsAccepted) {
  check.assign(slider, open.scene, 0.0F, 1, GetParam());
  for (const float gap : {0.001F, 0.01F, 0.1F, 1.0F}) {
    const float s[] = {1, 5};
    check.begin(s);
    EXPECT_TRUE(steps(1, 10 * (3.95F - gap))) << gap;
    check.begin(s);
    EXPECT_FALSE(steps(1, 10 * (3.95F + gap))) << gap;
  }
}

// A turning body leaves the hull of its places: what one part cannot prove, many can, and never the other way round.
TEST_P(Walled, SubstepsProveWhatTheWholeStepCannot) {
  const Unicycle unicycle({});
  InOwnMemory<detail::MotionCheck> whole, parts;
  whole.assign(unicycle, open.scene, 0.0F, 1, GetParam());
  parts.assign(unicycle, open.scene, 0.0F, 16, GetParam());
  int by_whole = 0, by_parts = 0;
  for (float x = 4.74F; x < 4.80F; x += 0.0005F) {
    const std::vector<float> s = {x, 5, 0.5F * kPi}, u = {1, 2};
    const auto next = step(unicycle, s, u, 0.1F);
    whole.begin(s.data());
    parts.begin(s.data());
    const bool one = whole.step_free(s.data(), u.data(), 0.1F, next.data());
    const bool many = parts.step_free(s.data(), u.data(), 0.1F, next.data());
    EXPECT_TRUE(many || !one) << x;
    by_whole += one ? 1 : 0;
    by_parts += many ? 1 : 0;
  }
  EXPECT_GT(by_whole, 0);
  EXPECT_GT(by_parts, by_whole);
}

TEST_P(Walled, StepAlongTheWallIsAcceptedByTheGapItKeeps) {
  for (const float gap : {0.02F, 0.05F, 0.2F}) {
    const float x = 5.0F - 0.05F - gap;
    const float s[] = {x, 4}, u[] = {0, 3}, next[] = {x, 4.3F};
    check.begin(s);
    EXPECT_TRUE(check.step_free(s, u, 0.1F, next)) << gap;
  }
}

TEST_P(Walled, ClearanceIsKept) {
  check.assign(slider, open.scene, 0.5F, 16, GetParam());
  const float near[] = {4.46F, 5}, far[] = {4.44F, 5};
  EXPECT_FALSE(check.free(near));
  EXPECT_TRUE(check.free(far));
}

TEST_P(Walled, StandingStillIsFree) {
  const float s[] = {3, 5};
  check.begin(s);
  EXPECT_TRUE(steps(3, 0));
}

TEST_P(Walled, LeavingTheBoundsIsSeen) {
  const float s[] = {0.5F, 5}, u[] = {-10, 0}, next[] = {-0.5F, 5};
  check.begin(s);
  EXPECT_FALSE(check.step_free(s, u, 0.1F, next));
  EXPECT_FALSE(check.free(next));
}

TEST_P(Walled, CountsWhatItPlaces) {
  const float s[] = {3, 5};
  EXPECT_EQ(check.checks(), 0U);
  check.free(s);
  EXPECT_EQ(check.checks(), 1U);
}

TEST_P(Walled, AFreeStateIsWhereTheNextStepBegins) {
  const float far[] = {8, 5}, s[] = {4, 5}, inside[] = {5, 5};
  check.begin(far);
  ASSERT_TRUE(check.free(s));
  EXPECT_EQ(check.poses()[0].position.x, 4.0F);
  EXPECT_FALSE(steps(4, 20));  // from 8 it would be free
  ASSERT_TRUE(steps(4, 5));
  EXPECT_EQ(check.poses()[0].position.x, 4.5F);
  EXPECT_FALSE(check.free(inside));
  EXPECT_EQ(check.poses()[0].position.x, 4.5F);  // it stays where it was
  EXPECT_FALSE(steps(4.5F, 10));
}

INSTANTIATE_TEST_SUITE_P(Checks, Walled, ::testing::Bool(),
                         [](const auto& check) { return check.param ? "with_shortcuts" : "plain"; });

// A slit: what the robot's width leaves of it decides, to the margin.
TEST(MotionCheckSlit, IsPassedExactlyWhereTheBodyFits) {
  for (const bool shortcuts : {true, false}) {
    for (const double spare : {-0.02, -0.002, 0.002, 0.02}) {
      Room room;
      const double half = 0.05 + spare / 2;
      room.boxes = {{5, 0, 5.5, 5 - half}, {5, 5 + half, 5.5, 10}};
      const OpenScene open(room);
      const Slider slider(0.1F, 100.0F);
      InOwnMemory<detail::MotionCheck> check;
      check.assign(slider, open.scene, 0.0F, 16, shortcuts);
      const float s[] = {4, 5}, u[] = {25, 0}, next[] = {6.5F, 5};
      check.begin(s);
      EXPECT_EQ(check.step_free(s, u, 0.1F, next), spare > 0) << spare;
    }
  }
}

// A shuttle of two squares: the second slides along the first's x axis by its third state.
class Shuttle : public Slider {
 public:
  static constexpr int kMaxState = 3, kMaxControl = 3, kMaxBodies = 2;
  Shuttle() : Slider(0.2F, 1.0F) {}
  int state_size() const { return 3; }
  int control_size() const { return 3; }
  int body_count() const { return 2; }
  int self_collision_gap() const { return 1; }
  void place(StateView s, Pose* poses) const {
    poses[0] = {position(s), {0.0F, 1.0F}};
    poses[1] = {position(s) + Vec2{s[2], 0.0F}, {0.0F, 1.0F}};
  }
  bool travel(StateView, ControlView u, float dt, StateView, Travel* travel) const {
    const float path = dt * length({u[0], u[1]});
    travel[0] = {path, 0.0F, 0.0F, 0.0F};
    travel[1] = {path + dt * std::abs(u[2]), 0.0F, 0.0F, 0.0F};
    return true;
  }
};

TEST(MotionCheckSelf, BodiesThatPassThroughEachOtherAreSeen) {
  static_assert(RobotModel<Shuttle>);
  const OpenScene open{Room{}};
  const Shuttle shuttle;
  InOwnMemory<detail::MotionCheck> check;
  std::mt19937 random(1);
  int crossing = 0, apart = 0;
  for (int i = 0; i < 2000; ++i) {
    if (i % 1000 == 0) check.assign(shuttle, open.scene, 0.0F, 16, i == 0);
    const float from = uniform_float(random, -3, 3), to = uniform_float(random, -3, 3);
    const float s[] = {5, 5, from}, u[] = {0, 0, 10 * (to - from)}, next[] = {5, 5, to};
    if (!check.free(s) || !check.free(next)) continue;
    const bool crosses = (from < 0) != (to < 0);
    check.begin(s);
    const bool accepted = check.step_free(s, u, 0.1F, next);
    if (crosses) {
      ASSERT_FALSE(accepted) << from << " " << to;
      ++crossing;
    } else if (std::min(std::abs(from), std::abs(to)) > 0.5F) {
      ASSERT_TRUE(accepted) << from << " " << to;
      ++apart;
    }
  }
  EXPECT_GT(crossing, 300);
  EXPECT_GT(apart, 300);
}

// Fast and small among slivers: both ends of most steps are free, and most steps are not.
TEST(MotionCheck, FastSmallRobotPassesThroughNoSliver) {
  const Slider slider(0.1F, 100.0F);
  int accepted = 0, rejected = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    std::mt19937 random(seed);
    Room room;
    room.clearance_cell = 0.125;
    for (int i = 0; i < 25; ++i) {
      const double x = uniform(random, 0.5, 9.5), y = uniform(random, 0.5, 9.5), turn = uniform(random, 0, 3);
      const double dx = 0.4 * std::cos(turn), dy = 0.4 * std::sin(turn), side = 0.005;
      room.loose_pieces.push_back({{snap(x - dx), snap(y - dy)},
                                   {snap(x + dx), snap(y + dy)},
                                   {snap(x - side * dy / 0.4), snap(y + side * dx / 0.4)}});
    }
    const OpenScene open(room);
    const auto pieces = rings_of_pieces(open.scene);
    InOwnMemory<detail::MotionCheck> check;
    check.assign(slider, open.scene, 0.0F, 16, seed > 2);
    float s[] = {0.1F, 0.1F};
    for (int i = 0; i < 1500; ++i) {
      const float reach = below(random, 2) == 0 ? 0.02F : 2.0F;  // slow steps between the fast ones
      const float u[] = {uniform_float(random, -10 * wide(reach), 10 * wide(reach)),
                         uniform_float(random, -10 * wide(reach), 10 * wide(reach))};
      const float next[] = {s[0] + 0.1F * u[0], s[1] + 0.1F * u[1]};
      if (i % 50 == 0 || !check.free(s)) {
        s[0] = uniform_float(random, 0.1, 9.9);
        s[1] = uniform_float(random, 0.1, 9.9);
        continue;
      }
      if (!check.step_free(s, u, 0.1F, next)) {
        ++rejected;
        continue;
      }
      ++accepted;
      for (int part = 0; part <= 200; ++part) {
        const double t = part / 200.0;
        const double x = wide(s[0]) + t * (wide(next[0]) - wide(s[0])),
                     y = wide(s[1]) + t * (wide(next[1]) - wide(s[1]));
        const Ring body = {{x - 0.05, y - 0.05}, {x + 0.05, y - 0.05}, {x + 0.05, y + 0.05}, {x - 0.05, y + 0.05}};
        for (const Ring& piece : pieces) ASSERT_GT(separation(body, piece), 0);
      }
      s[0] = next[0];
      s[1] = next[1];
    }
  }
  EXPECT_GT(accepted, 1000);
  EXPECT_GT(rejected, 1000);
}

TEST(MotionCheckEdges, StateWithoutAPoseIsNotFree) {
  const OpenScene open{Room{}};
  const Unicycle robot({});
  InOwnMemory<detail::MotionCheck> check;
  check.assign(robot, open.scene, 0.0F, 16, true);
  for (const float heading : {std::numeric_limits<float>::quiet_NaN(), 1e30F, 9000.0F}) {
    const float s[] = {5, 5, heading};
    EXPECT_FALSE(check.free(s)) << heading;
  }
}

}  // namespace
}  // namespace krait::test::motion_check_test
