// SPDX-License-Identifier: Apache-2.0
// The motion of a plan, against double precision and against the tree's, and what becomes of ways that do not hold.
#include "motion/plan_drive.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "krait/robots/detail/defaults.hpp"
#include "plan/ending.hpp"
#include "planner_fixture.hpp"
#include "robot_oracle.hpp"
#include "search/adaptive_search.hpp"
#include "step_oracle.hpp"

namespace krait::test::plan_drive_test {
namespace {

constexpr float kStep = 0.05F;  // seconds

double distance(const Numbers& state, const float* other) {
  return std::hypot(state[0] - wide(other[0]), state[1] - wide(other[1]));
}

// By how much a number as a float may be off: half of what is between two floats there.
double rounding(double x) {
  const auto nearest = static_cast<float>(std::fabs(x));
  return 0.5 * (wide(std::nextafter(nearest, kInfinity)) - wide(nearest));
}

// Drives a plan and the tree's way beside it, and what the plan's controls lead to in double precision.
template <class R>
class Drives {
 public:
  explicit Drives(const R& robot, float dt = kStep)
      : robot_(robot), dt_(dt), poses_(static_cast<std::size_t>(robot.body_count())) {
    const std::vector<float> start(static_cast<std::size_t>(robot.state_size()), 0.0F);
    plan_.begin(robot, dt, start.data());
    tree_.assign(robot, dt);
    tree_.begin(start.data());
    truth_ = doubles(start);
  }

  void aim(const Target& target) {
    plan_.aim(target);
    tree_.aim(target);
  }

  void step() {
    place(tree_.state());
    tree_.lead(poses_.data());
    tree_.follow(poses_.data());
    place(plan_.state());
    plan_.step(poses_.data());
    const Numbers control(plan_.control(), plan_.control() + robot_.control_size());
    const Numbers before = truth_;
    for (int part = 0; part < 16; ++part) truth_ = rk4(robot_, truth_, control, wide(dt_) / 16);
    path_ += std::hypot(truth_[0] - before[0], truth_[1] - before[1]);
    plan_.go();
    tree_.go();
  }

  double path() const { return path_; }
  double error() const { return distance(truth_, plan_.state()); }
  double error_of_tree() const { return distance(truth_, tree_.state()); }
  double heading() const { return truth_[2]; }
  Vec2 position() const { return {static_cast<float>(truth_[0]), static_cast<float>(truth_[1])}; }
  double heading_error() const { return std::fabs(truth_[2] - wide(plan_.state()[2])); }

 private:
  void place(const float* state) { robot_.place(StateView(state, robot_.state_size()), poses_.data()); }

  const R& robot_;
  float dt_;
  detail::PlanDrive plan_;
  detail::Drive tree_;
  std::vector<Pose> poses_;
  Numbers truth_;
  double path_ = 0;
};

template <class R>
class PlanDriveOf : public ::testing::Test {};
TYPED_TEST_SUITE(PlanDriveOf, Models, ModelNames);

// Eight minutes of driving: the states are those of the true motion, to a tenth of a millimetre and a millionth
// of the path, and that motion stays beside the tree's.
TYPED_TEST(PlanDriveOf, StaysWithTheTrueMotionAndBesideTheTree) {
  for (const TypeParam& robot : instances<TypeParam>()) {
    std::mt19937 random(1);
    Drives<TypeParam> drives(robot);
    Target target{{50, 50}, 0.9F};
    for (int i = 0; i < 10'000; ++i) {
      if (i % 40 == 0) {
        target.point = {uniform_float(random, 0, 100), uniform_float(random, 0, 100)};
        drives.aim(target);
      }
      drives.step();
      ASSERT_LE(drives.error(), 1e-4 + 1e-6 * drives.path()) << "step " << i;
      ASSERT_LE(drives.error_of_tree(), 0.01) << "step " << i;
    }
    EXPECT_GT(drives.path(), 50);
  }
}

// Metres, metres, radians a second and radians a second squared.
DifferentialDrive on_wheels(float radius, float track_width, float speed, float acceleration) {
  DifferentialDriveParameters p;
  p.wheel_radius = radius;
  p.track_width = track_width;
  p.max_wheel_speed = speed;
  p.max_wheel_acceleration = acceleration;
  return DifferentialDrive(p);
}

// Wheels that swap their speeds turn the heading to and fro: at the ends of such a step and in its middle the
// position's rate is the same, and another in between.
TEST(PlanDriveOfWheels, ThatSwapTheirSpeedsStaysWithTheTrueMotion) {
  const DifferentialDrive robot = on_wheels(0.8464F, 2.966F, 7.633F, 3.942F);
  Drives<DifferentialDrive> drives(robot, 0.401003F);
  std::mt19937 random(3);
  for (int i = 0; i < 10'000; ++i) {
    if (i % 40 == 0) {
      Target target{{uniform_float(random, 0, 200), uniform_float(random, 0, 200)}};
      target.speed = uniform_float(random, 0.75, 1) * (below(random, 3) == 0 ? -1.0F : 1.0F);
      drives.aim(target);
    }
    drives.step();
    ASSERT_LE(drives.error(), 1e-4 + 1e-6 * drives.path()) << "step " << i;
  }
}

// Fast wheels, whose speeds in float have an error that turns the robot by 1e-7 rad a step, always the same way where
// it drives straight on for long; the bound is five times the rounding of the largest heading so far
// as a float, at most 3e-6.
TEST(PlanDriveOfWheels, ThatAreFastKeepsItsHeading) {
  const DifferentialDrive robot = on_wheels(0.04721F, 0.3289F, 50.67F, 523.8F);
  Drives<DifferentialDrive> drives(robot, 0.2458F);
  std::mt19937 random(3);
  double most = 0;
  for (int i = 0; i < 4'000; ++i) {
    if (i % 40 == 0) drives.aim({{uniform_float(random, 0, 200), uniform_float(random, 0, 200)}});
    drives.step();
    most = std::max(most, rounding(drives.heading()));
    ASSERT_LE(drives.heading_error(), std::min(5 * most, 3e-6)) << "step " << i;
    ASSERT_LE(drives.error(), 1e-4 + 5e-7 * drives.path()) << "step " << i;
  }
}

// A TurtleBot at top speed for a kilometre, with a slight turn now and then. A wheel that cannot be faster leaves no
// way to catch up, and turning goes on.
TEST(PlanDriveOfWheels, ThatCanBeNoFasterTurnsTowardTheTreesLine) {
  const DifferentialDrive robot = on_wheels(0.033F, 0.16F, 6.6667F, 30);
  Drives<DifferentialDrive> drives(robot, 0.1F);
  std::mt19937 random(1);
  for (int i = 0; i < 48'000; ++i) {
    if (i % 100 == 0) {
      const SinCos to = math::sin_cos(static_cast<float>(drives.heading()) + uniform_float(random, -0.2F, 0.2F));
      drives.aim({drives.position() + 100.0F * Vec2{to.cos, to.sin}});
    }
    drives.step();
    ASSERT_LE(drives.error_of_tree(), 0.01) << "step " << i;
  }
  EXPECT_GT(drives.path(), 1000);
}

// By how much faster than its reference the robot should be, in metres a second, where it is so far ahead of it.
float catches_up(float ahead, float speed) {
  const DifferentialDrive robot(DifferentialDriveParameters{});
  const float wheels = speed / robot.parameters().wheel_radius;
  const float reference[5] = {0, 0, 0, wheels, wheels};
  const float state[5] = {ahead, 0, 0, wheels, wheels};
  float u[2] = {0, 0};
  robot.track(StateView(state, 5), StateView(reference, 5), 0.1F, ControlRef(u, 2));
  EXPECT_EQ(u[0], u[1]);
  return u[0] * 0.1F * robot.parameters().wheel_radius;
}

TEST(PlanDriveOfWheels, ThatLagCatchUpByAShareOfTheSpeedAndNotOnceItsReferenceIsAtRest) {
  EXPECT_NEAR(catches_up(-0.02F, 0.5F), 0.02F, 1e-6F);
  EXPECT_NEAR(catches_up(-0.5F, 0.5F), 0.05F, 1e-6F);
  EXPECT_NEAR(catches_up(0.5F, -0.5F), -0.05F, 1e-6F);
  EXPECT_LE(catches_up(-0.5F, 0), 0.25F * detail::kRestSpeed);
  EXPECT_GE(catches_up(0.5F, 0), -0.25F * detail::kRestSpeed);
  EXPECT_NEAR(catches_up(-5e-4F, 0), 5e-4F, 1e-6F);
}

// Waves its heading once a step, 0.1 rad to both sides: it goes the same way at the ends of a step and in its middle.
class Wave : public Unicycle {
 public:
  static constexpr int kMaxState = 4;
  static constexpr float kRate = 2 * kPi / kStep;

  Wave() : Unicycle({}) {}
  int state_size() const { return 4; }
  void derivative(StateView s, ControlView, StateRef ds) const {
    const SinCos heading = math::sin_cos(s[2]);
    ds[0] = heading.cos;
    ds[1] = heading.sin;
    ds[2] = 0.1F * kRate * math::sin_cos(s[3]).cos;
    ds[3] = kRate;
  }
  float fastest_rate(float) const { return kRate; }
  void track(StateView, StateView, float, ControlRef) const = delete;
};

Numbers rate(const Wave&, const Numbers& s, const Numbers&) {
  const double waves = wide(Wave::kRate);
  return {std::cos(s[2]), std::sin(s[2]), wide(0.1F) * waves * std::cos(s[3]), waves};
}

TEST(PlanDriveOfWave, StaysWithTheTrueMotion) {
  const Wave robot;
  Drives<Wave> drives(robot);
  drives.aim({{100, 0}});
  for (int i = 0; i < 100; ++i) {
    drives.step();
    ASSERT_LE(drives.error(), 1e-4 + 1e-6 * drives.path()) << "step " << i;
  }
}

// A robot whose dynamics change too fast for its time step, which it does not state, and which does not keep to the
// tree's way: its plans end elsewhere than the tree.
class Whirl : public Unicycle {
 public:
  Whirl() : Unicycle(parameters()) {}
  float fastest_rate(float) const = delete;
  void track(StateView, StateView, float, ControlRef) const = delete;

 private:
  static UnicycleParameters parameters() {
    UnicycleParameters p;
    p.max_turn_rate = 2.0F;
    return p;
  }
};

TEST(PlanDriveOfWhirl, HasNoRateAndNoTracking) {
  EXPECT_EQ(detail::fastest_rate(Whirl(), 1.0F), 0.0F);
  float u[] = {1, 1};
  const float s[] = {0, 0, 0}, reference[] = {1, 1, 1};
  detail::track(Whirl(), StateView(s, 3), StateView(reference, 3), 1.0F, ControlRef(u, 2));
  EXPECT_EQ(u[0], 1.0F);
  EXPECT_EQ(u[1], 1.0F);
}

// Solves with a time step of a second; counts how many ways were refused, and holds what is solved to double precision.
TEST(PlanDriveOfWhirl, IsNotGivenOutWhereItMissesOrCollides) {
  const float start[] = {2, 6, 0};
  std::uint64_t solved = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Bench<Whirl> bench(two_rooms(), Whirl());
    bench.parameters.dt = 1.0F;
    bench.limits.iterations = 3000;
    ASSERT_TRUE(bench.init().ok());
    const Status status = bench.solve({start, Goal::named(0), seed});
    refused += bench.planner.statistics().plans_refused;
    if (status != Status::solved) continue;
    ++solved;
    const Path path(bench.planner.plan());
    const Unicycle& robot = bench.robot;
    const auto pieces = rings_of_pieces(bench.open.scene);
    Numbers state = doubles(path.states.front());
    for (std::size_t i = 0; i < path.controls.size(); ++i) {
      const Numbers control = doubles(path.controls[i]);
      for (int part = 0; part < 32; ++part) {
        state = rk4(robot, state, control, 1.0 / 32);
        ASSERT_GT(separation_of_state(robot, bench.open.scene, pieces, state), 0) << seed;
      }
    }
    ASSERT_LE(distance(state, path.states.back().data()), 0.01) << seed;
    const Vec2 end{static_cast<float>(state[0]), static_cast<float>(state[1])};
    ASSERT_TRUE(Goal::named(0).contains(bench.open.scene, end, 0.0F)) << seed;
  }
  EXPECT_GT(solved, 100U);
  EXPECT_GE(refused, 3U);
}

// Hitches of the tree stay 2 mrad away from their limit, although many come near: what drives a little beside the tree
// keeps the limit itself.
TEST(PlanDriveOfHitches, HasRoomBetweenTheTreeAndTheLimit) {
  ChainParameters p = small_chain(3);
  p.hitch_length = 0.5F;
  p.max_hitch_angle = 0.1F;
  Bench<Snake> bench(two_rooms(), Snake(p));
  bench.parameters.tuning.doomed_steps = 0;
  bench.parameters.tuning.candidates = 0;
  bench.parameters.tuning.path_lengths = 0.0F;
  bench.parameters.tuning.stopping_ways = 0.0F;
  bench.parameters.dt = 0.01F;
  bench.limits.iterations = 2000;
  ASSERT_TRUE(bench.init().ok());
  const float start[8] = {3, 6};
  float nearest = 1;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    ASSERT_EQ(bench.solve({start, Goal::named(0), seed}), Status::budget_used);
    const detail::MotionTree& tree = detail::opened(bench.planner).tree();
    for (Index vertex = 0; vertex < tree.vertices(); ++vertex) {
      const float* state = tree.state(vertex);
      float ahead = state[2];
      for (int hitch = 5; hitch < 8; ++hitch) {
        nearest = std::min(nearest, p.max_hitch_angle - std::fabs(ahead - state[hitch]));
        ahead = state[hitch];
      }
    }
  }
  EXPECT_GE(nearest, 2e-3F - 1e-6F);
  EXPECT_LE(nearest, 2.5e-3F);
}

// Drives a chain to and fro, waving, and carries the errors of its states along.
template <class R>
class PushedChain {
 public:
  PushedChain(const typename R::Parameters& parameters, std::uint32_t seed)
      : robot_(parameters), random_(seed), start_(static_cast<std::size_t>(robot_.state_size())), errors_(start_) {
    plan_.begin(robot_, kStep, start_.data());
    truth_ = doubles(start_);
  }

  // Back no further than until trailers have folded or errors have grown as large as no plan's may.
  void drive(int steps, bool back) {
    for (int i = 0; i < steps && !(back && (folded() || carried() > 2e-3)); ++i) {
      if (i % 10 == 0) aim(back);
      step();
      ASSERT_LE(error(), carried() + 2.5e-7) << "step " << i;  // a float is off by so much by itself
      ASSERT_LE(shift(), wide(off_) + 1e-6) << "step " << i;
    }
  }

  // Of the trailers' headings, radians: how far they are off, and by what was carried.
  double error() const {
    double most = 0;
    for (std::size_t i = R::kCarState; i < start_.size(); ++i)
      most = std::max(most, std::fabs(truth_[i] - wide(plan_.state()[i])));
    return most;
  }
  double carried() const {
    double most = 0;
    for (std::size_t i = R::kCarState; i < start_.size(); ++i) most = std::max(most, std::fabs(wide(errors_[i])));
    return most;
  }

 private:
  bool folded() const {
    for (std::size_t i = R::kCarState; i < start_.size(); ++i) {
      if (std::fabs(plan_.state()[i == R::kCarState ? 2 : i - 1] - plan_.state()[i]) > 1.2F) return true;
    }
    return false;
  }

  // How far trailers are off, relative to the car, metres.
  double shift() const {
    const std::vector<Frame> exact = frames(robot_, truth_);
    const std::vector<Frame> own = frames(robot_, Numbers(plan_.state(), plan_.state() + robot_.state_size()));
    double most = 0;
    for (std::size_t k = 1; k < own.size(); ++k) {
      const double x = (exact[k].x - exact[0].x) - (own[k].x - own[0].x);
      const double y = (exact[k].y - exact[0].y) - (own[k].y - own[0].y);
      most = std::max(most, std::hypot(x, y));
    }
    return most;
  }

  void aim(bool back) {
    const float heading = plan_.state()[2] + uniform_float(random_, -0.3F, 0.3F);
    const SinCos to = math::sin_cos(back ? heading + kPi : heading);
    plan_.aim({{plan_.state()[0] + 5 * to.cos, plan_.state()[1] + 5 * to.sin}, back ? -1.0F : 1.0F, kStep});
  }

  void step() {
    std::vector<Pose> poses(static_cast<std::size_t>(robot_.body_count()));
    const StateView state(plan_.state(), robot_.state_size());
    robot_.place(state, poses.data());
    plan_.step(poses.data());
    off_ = detail::carry_errors(robot_, state, poses.data(), ControlView(plan_.control(), 2), kStep, errors_.data());
    const Numbers control(plan_.control(), plan_.control() + 2);
    for (int part = 0; part < 32; ++part) truth_ = rk4(robot_, truth_, control, wide(kStep) / 32);
    plan_.go();
  }

  R robot_;
  std::mt19937 random_;
  std::vector<float> start_;
  std::vector<float> errors_;
  detail::PlanDrive plan_;
  Numbers truth_;
  float off_ = 0;
};

template <class R>
typename R::Parameters pushed_chain(int trailers) {
  typename R::Parameters p;
  p.trailers = trailers;
  p.hitch_length = 0.1F;
  p.min_speed = -p.max_speed;
  return p;
}

// Errors grow with every hitch length that trailers are pushed, and fade where they are pulled: what is carried along
// is larger, and stays below a hundredth of a milliradian while they are pulled.
template <class R>
void expect_carried(int trailers) {
  double most = 0;
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    PushedChain<R> chain(pushed_chain<R>(trailers), seed);
    for (int turn = 0; turn < 8; ++turn) {
      chain.drive(60, false);
      EXPECT_LE(chain.carried(), 1e-6 * (4 + trailers));
      chain.drive(60, true);
      most = std::max(most, chain.carried());
    }
  }
  EXPECT_GT(most, 5e-5) << "of pushed trailers";
}

TEST(PlanDriveOfPushedChains, IsOffByLessThanTheErrorsThatAreCarried) {
  for (const int trailers : {1, 2, 3, 6, 25}) {
    SCOPED_TRACE(trailers);
    expect_carried<Truck>(trailers);
    expect_carried<Snake>(trailers);
    expect_carried<KinematicTruck>(trailers);
  }
}

// Ways through a lane in which nobody can turn round, from x back to the goal: a trailer is pushed all the way.
struct PushedWays {
  std::uint64_t solved = 0;
  std::uint64_t refused = 0;
  double error = 0;  // radians, of the trailer, where a plan's controls are driven in double precision
};

PushedWays push_back_from(float x) {
  Room room;
  room.bounds = {0, 0, 14, 1.2};
  room.goals = {{0.8, 0.1, 1.4, 1.1}};
  ChainParameters p = pushed_chain<Truck>(1);
  p.hitch_length = 0.4F;
  PushedWays ways;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Bench<Truck> bench(room, Truck(p));
    bench.parameters.tuning.reverse_share = 0.5F;
    bench.limits.iterations = 2000;
    EXPECT_TRUE(bench.init().ok());
    const float start[] = {x, 0.6F, 0, 0, 0, 0};
    const Status status = bench.solve({start, Goal::named(0), seed});
    ways.refused += bench.planner.statistics().plans_refused;
    if (status != Status::solved) continue;
    ++ways.solved;
    const Path path(bench.planner.plan());
    Numbers truth = doubles(path.states.front());
    for (std::size_t i = 0; i < path.controls.size(); ++i) {
      const Numbers control = doubles(path.controls[i]);
      const double part = wide(bench.parameters.dt) / 32;
      for (int j = 0; j < 32; ++j) truth = rk4(bench.robot, truth, control, part);
      ways.error = std::max(ways.error, std::fabs(truth[5] - wide(path.states[i + 1][5])));
    }
  }
  return ways;
}

TEST(PlanDriveOfPushedChains, IsRefusedWhereErrorsGrewLarge) {
  const PushedWays near = push_back_from(4);
  EXPECT_GE(near.solved, 15U) << "after 6 hitch lengths";
  EXPECT_LE(near.error, 2e-3);
  const PushedWays far = push_back_from(7);
  EXPECT_GE(far.refused, 3U) << "after 14 hitch lengths";
  EXPECT_LE(far.error, 2e-3);
}

// A robot whose heading goes astray by 0.1 mrad a step, which puts no body aside.
struct Straying : Unicycle {
  Straying() : Unicycle(small_unicycle()) {}
  float carry_errors(StateView /*s*/, const Pose* /*poses*/, ControlView /*u*/, float /*dt*/, float* errors) const {
    errors[2] += 1e-4F;
    return 0;
  }
};

TEST(PlanDriveOfPushedChains, NoPlanIsLongerThanItsErrorsAllow) {
  Bench<Straying> bench(two_rooms(), Straying());
  bench.limits.iterations = 500;
  ASSERT_TRUE(bench.init().ok());
  const float start[] = {1, 4, 0};
  ASSERT_EQ(bench.solve({start, Goal::disc({2, 4}, 0.3F), 1}), Status::solved);
  EXPECT_LE(bench.planner.plan().steps(), 20U);
  EXPECT_EQ(bench.solve({start, Goal::disc({9, 4}, 0.3F), 1}), Status::budget_used) << "80 steps away";
  EXPECT_GE(bench.planner.statistics().plans_refused, 1U);
}

// The work of a call is bounded however long the plan is: what one call does is one expansion, of the tree or the way.
TEST(PlanDriveCalls, DriveAnExpansionEach) {
  const float start[] = {2, 6, 0};
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  bench.parameters.tuning.max_steps = 5;
  ASSERT_TRUE(bench.init().ok());
  EXPECT_EQ(bench.planner.start({start}), Status::searching);
  std::uint64_t placed = 0, driving = 0;
  while (bench.planner.status() == Status::searching) {
    const Statistics before = bench.planner.statistics();
    (void)bench.planner.advance(1);
    const Statistics after = bench.planner.statistics();
    driving += after.iterations == before.iterations ? 1 : 0;
    placed = std::max(placed, after.collision_checks - before.collision_checks);
  }
  ASSERT_EQ(bench.planner.status(), Status::solved);
  EXPECT_GE(driving * 5, bench.planner.statistics().plan_steps);
  EXPECT_LE(placed, 5U * (2 * bench.parameters.tuning.max_substeps - 1) + 1);
}

}  // namespace
}  // namespace krait::test::plan_drive_test
