// SPDX-License-Identifier: Apache-2.0
// Trucks that push their trailers: what the last one is led to, and that no hitch folds.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "krait/krait.hpp"
#include "motion/drive.hpp"
#include "robot/pushing.hpp"

namespace krait::test::robot_pushing_test {
namespace {

constexpr float kLength = 0.8F;  // of a hitch

template <class R>
typename R::Parameters backing(int trailers) {
  typename R::Parameters p;
  p.trailers = trailers;
  p.min_speed = -1;
  return p;
}

// A truck that is driven backwards, and looked at after every step.
template <class R>
class Backing {
 public:
  explicit Backing(const typename R::Parameters& p, float dt = 0.1F)
      : robot(p), poses(static_cast<std::size_t>(robot.body_count())), dt_(dt) {
    drive.assign(robot, dt);
  }

  // At (0, 0) with the heading 0; of each trailer the hitch angle before it.
  void begin(const std::vector<float>& hitches, float speed = 0) {
    std::vector<float> angles(hitches.size());
    float heading = 0;
    for (std::size_t i = 0; i < hitches.size(); ++i) angles[i] = heading = heading - hitches[i];
    std::vector<float> state(static_cast<std::size_t>(robot.state_size()));
    robot.rest({0, 0}, 0, angles.data(), state.data());
    if (R::kCarState == 5) state[3] = speed;
    drive.begin(state.data());
    place();
  }

  void aim(Vec2 point) { drive.aim({point, -1.0F, dt_}); }

  void step() {
    drive.step();
    place();
  }

  float hitch(std::size_t k) const {
    const SinCos angle = poses[k - 1].heading - poses[k].heading;
    return std::atan2(angle.sin, angle.cos);
  }
  float most_hitch() const {
    float most = 0;
    for (std::size_t k = 1; k < poses.size(); ++k) most = std::max(most, std::fabs(hitch(k)));
    return most;
  }
  const Pose& tail() const { return poses.back(); }

  R robot;
  detail::Drive drive;
  std::vector<Pose> poses;

 private:
  void place() { robot.place(StateView(drive.state(), robot.state_size()), poses.data()); }

  float dt_;
};

template <class R>
class Pushing : public ::testing::Test {};
struct Name {
  template <class R>
  static std::string GetName(int) {
    return R::kCarState == 5 ? "Truck" : "KinematicTruck";
  }
};
using Trucks = ::testing::Types<Truck, KinematicTruck>;
TYPED_TEST_SUITE(Pushing, Trucks, Name);

TYPED_TEST(Pushing, UpToThreeTrailersAreLedByTheLast) {
  for (const int trailers : {0, 1, 2, 3}) EXPECT_EQ(TypeParam(backing<TypeParam>(trailers)).backing_body(), trailers);
  EXPECT_EQ(TypeParam(backing<TypeParam>(4)).backing_body(), 0);
  typename TypeParam::Parameters forwards = backing<TypeParam>(2);
  forwards.min_speed = 0;
  EXPECT_EQ(TypeParam(forwards).backing_body(), 0);
}

// After twelve hitch lengths the last trailer heads away from a point far behind, and all are in line.
TYPED_TEST(Pushing, BentTrailersComeIntoLineBehindAPoint) {
  for (const int trailers : {1, 2, 3}) {
    for (const float dt : {0.05F, 0.1F, 0.3F}) {
      if (trailers == 3 && dt > 0.2F) continue;  // the wheels are too slow
      for (const float side : {1.0F, -1.0F}) {
        const float bend = side * (trailers == 3 ? 0.003F : 0.1F);
        Backing<TypeParam> truck(backing<TypeParam>(trailers), dt);
        std::vector<float> hitches(static_cast<std::size_t>(trailers), bend);
        if (trailers > 2) hitches[2] = -bend;
        truck.begin(hitches);
        truck.aim({-50, 5});
        const int steps = static_cast<int>(12 * kLength / dt);
        for (int i = 0; i < steps; ++i) {
          truck.step();
          ASSERT_LE(truck.most_hitch(), 1.0F) << trailers << " trailers, " << dt << " s, step " << i;
        }
        EXPECT_LE(truck.most_hitch(), 0.06F) << trailers << " trailers, " << dt << " s";
        const Vec2 to = Vec2{-50, 5} - truck.tail().position;
        const float off = cross({truck.tail().heading.cos, truck.tail().heading.sin}, to) / length(to);
        EXPECT_LE(std::fabs(off), 0.15F) << trailers << " trailers, " << dt << " s";
      }
    }
  }
}

// A point to the left behind the last trailer is reached by a curve to that side, and so is one to the right.
TYPED_TEST(Pushing, TheLastTrailerIsLedToThePoint) {
  for (const int trailers : {1, 2, 3}) {
    for (const float side : {1.0F, -1.0F}) {
      Backing<TypeParam> truck(backing<TypeParam>(trailers));
      truck.begin(std::vector<float>(static_cast<std::size_t>(trailers), 0.0F));
      const float aside = trailers == 3 ? 0.5F : 1.5F;
      const Vec2 point{-kLength * static_cast<float>(trailers) - 6, aside * side};
      truck.aim(point);
      float nearest = length(point - truck.tail().position);
      for (int i = 0; i < 100; ++i) {
        truck.step();
        nearest = std::min(nearest, length(point - truck.tail().position));
      }
      EXPECT_LE(nearest, 0.25F) << trailers << " trailers";
    }
  }
}

// One that lies ahead of the last trailer: it turns round to the point's side, without folding, for ten seconds.
TYPED_TEST(Pushing, NoHitchFoldsOnTheWayToAPointAhead) {
  for (const int trailers : {1, 2}) {
    for (const float side : {1.0F, -1.0F}) {
      Backing<TypeParam> truck(backing<TypeParam>(trailers));
      truck.begin(std::vector<float>(static_cast<std::size_t>(trailers), 0.0F));
      truck.aim({30, 3 * side});
      float turned = 0;
      for (int i = 0; i < 100; ++i) {
        truck.step();
        ASSERT_LE(truck.most_hitch(), 1.4F) << trailers << " trailers, step " << i;
        turned = std::max(turned, -truck.tail().heading.sin * side);
      }
      EXPECT_GE(turned, 0.9F) << trailers << " trailers";
    }
  }
}

// With hitches that bend little and wheels that turn little, for which steady turns must be wider.
TYPED_TEST(Pushing, TightBoundsAreKept) {
  for (const int trailers : {1, 2}) {
    typename TypeParam::Parameters p = backing<TypeParam>(trailers);
    p.max_hitch_angle = 0.35F;
    p.max_steering = 0.4F;
    Backing<TypeParam> truck(p);
    truck.begin(std::vector<float>(static_cast<std::size_t>(trailers), 0.0F));
    truck.aim({-5, 40});
    float bent = 0;
    for (int i = 0; i < 100; ++i) {
      truck.step();
      bent = std::max(bent, truck.hitch(static_cast<std::size_t>(trailers)));
      ASSERT_TRUE(truck.robot.within_limits(StateView(truck.drive.state(), truck.robot.state_size())))
          << trailers << " trailers, step " << i;
    }
    EXPECT_GE(bent, 0.1F) << trailers << " trailers";
  }
}

// Where a step at the top speed is half a hitch length, for which answers would come too late.
TYPED_TEST(Pushing, TrailersArePushedNoFasterThanTheyCanBeAnswered) {
  for (const int trailers : {1, 2, 3}) {
    typename TypeParam::Parameters p = backing<TypeParam>(trailers);
    p.min_speed = -4;
    Backing<TypeParam> truck(p);
    truck.begin(std::vector<float>(static_cast<std::size_t>(trailers), 0.0F));
    truck.aim({-100, 0});
    for (int i = 0; i < 20; ++i) truck.step();
    const float before = truck.tail().position.x;
    truck.step();
    const float way = before - truck.tail().position.x;
    EXPECT_NEAR(way, kLength / static_cast<float>(1 + trailers), 0.1F * kLength) << trailers << " trailers";
  }
}

// A point on the circle of a steady turn, which is left alone: every axle goes round one centre.
TEST(PushingTangent, ASteadyTurnStaysSteady) {
  for (const int n : {1, 2, 3}) {
    const double radius = 2.0;  // of the last trailer
    const double d = 0.8;
    const double wheelbase = 0.7;
    std::vector<Pose> poses(static_cast<std::size_t>(n + 1));
    const Vec2 center{0, static_cast<float>(radius)};
    double angle = 0;  // of the tail's axle around the centre, then of those ahead
    for (int k = n; k >= 0; --k) {
      const double own = std::sqrt(radius * radius + (n - k) * d * d);
      poses[static_cast<std::size_t>(k)] = {
          {static_cast<float>(own * std::sin(angle)), center.y - static_cast<float>(own * std::cos(angle))},
          math::sin_cos(static_cast<float>(angle))};
      angle += std::atan2(d, own);
    }
    const double near = 0.75 * d * (1 + n);  // where the point counts as what it is
    const auto around = static_cast<float>(-2 * std::asin(near / (2 * radius)));  // radians, backwards
    const Vec2 point{static_cast<float>(radius) * std::sin(around),
                     center.y - static_cast<float>(radius) * std::cos(around)};
    const double steady = wheelbase / std::sqrt(radius * radius + n * d * d);
    const detail::Train train{n, static_cast<float>(wheelbase), static_cast<float>(d), 1.0F, 1.5F};
    const detail::Wheels wheels{static_cast<float>(steady), 0.05F, 0.1F, kInfinity};
    EXPECT_NEAR(detail::pushing_tangent(train, poses.data(), wheels, point), steady, 1e-5) << n;
  }
}

// By hand: with one trailer that is in line with the point but for its hitch, a step of h hitch lengths multiplies the
// hitch by e^h and takes off (e^h - 1) gains of it, so that e^(-3 h) of it is left.
TEST(PushingTangent, AnswersToAHitchByItsGain) {
  const detail::Train train{1, 0.4F, 0.8F, 1.0F, 1.5F};
  const Pose poses[] = {{{0, 0}, math::sin_cos(0.02F)}, {{-0.8F, 0}, {0.0F, 1.0F}}};
  const Vec2 point{-100, 0};
  const auto gain = [&](float lag, float way) {
    return static_cast<double>(detail::pushing_tangent(train, poses, {0.0F, lag, way, kInfinity}, point)) /
           (0.5 * 0.02);
  };
  const auto expected = [](double h) { return (std::exp(h) - std::exp(-3 * h)) / (std::exp(h) - 1); };
  EXPECT_NEAR(gain(0, 0.08F), expected(0.1), 2e-3);
  EXPECT_NEAR(gain(0, 0.4F), expected(0.5), 2e-3);
  EXPECT_NEAR(gain(0, 0), expected(0.02), 2e-3) << "of a step of a fiftieth, at least";
  EXPECT_NEAR(gain(0, 4), expected(1), 2e-3) << "of one of a hitch length, at most";
  EXPECT_NEAR(gain(0.08F, 0.4F), 1.1 * expected(0.5), 2e-3) << "by what has grown until the wheels have turned";
}

// x, after h hitch lengths backwards with the wheels held: what a hitch is off by grows by itself less what the one
// ahead of it is, the first by itself less `wheels`; by small steps in double.
void push(std::vector<double>& x, double wheels, double h) {
  constexpr int kParts = 2000;
  for (int part = 0; part < kParts; ++part) {
    const std::vector<double> before = x;
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += h / kParts * (before[k] - (k == 0 ? wheels : before[k - 1]));
  }
}

// A step multiplies what hitches are off by with e^(-3 h), in the end.
TEST(PushingTangent, AllHitchesFadeAlike) {
  constexpr float kWay = 0.24F;
  constexpr double h = 0.3;
  for (const int n : {1, 2, 3}) {
    const detail::Train train{n, 0.4F, 0.8F, 1.0F, 1.5F};
    std::vector<double> x(static_cast<std::size_t>(n), 2e-3);
    x[0] = -1e-3;
    double last = 0;
    for (int step = 0; step < 12; ++step) {
      std::vector<Pose> poses(static_cast<std::size_t>(n + 1), Pose{{0, 0}, {0.0F, 1.0F}});
      for (int k = n; k > 0; --k) {
        const auto at = static_cast<std::size_t>(k);
        poses[at - 1].heading = poses[at].heading + math::sin_cos(static_cast<float>(x[at - 1]));
      }
      const float tangent = detail::pushing_tangent(train, poses.data(), {0.0F, 0.0F, kWay, kInfinity}, {-100, 0});
      last = x.back();
      push(x, 2 * static_cast<double>(tangent), h);
    }
    // N poles at p: x falls like step^(N - 1) p^step.
    const double expected = std::exp(-3 * h) * std::pow(12.0 / 11.0, n - 1);
    EXPECT_NEAR(x.back() / last, expected, 0.15 * expected) << n << " trailers";
  }
}

// A trailer that is a milliradian off its reference, pushed for six hitch lengths, is 400 times as far off by then
// where nothing brings it back, and half as far at most where tracking does.
template <class R>
void expect_tracked(int trailers) {
  const R robot(backing<R>(trailers));
  const auto size = static_cast<std::size_t>(robot.state_size());
  std::vector<float> reference(size);
  robot.rest({0, 0}, 0.0F, nullptr, reference.data());
  if (R::kCarState == 5) reference[3] = -1.0F;
  std::vector<float> state = reference;
  state.back() += 1e-3F;
  const float hold[] = {R::kCarState == 5 ? 0.0F : -1.0F, 0.0F};
  const auto drive = [&robot](std::vector<float>& s, const float* u) {
    std::vector<float> next(s.size());
    detail::propagate(robot, s.data(), u, 0.1F, next.data());
    s = next;
  };
  for (int i = 0; i < 96; ++i) {
    float u[] = {hold[0], hold[1]};
    robot.track(StateView(state.data(), robot.state_size()), StateView(reference.data(), robot.state_size()), 0.1F,
                ControlRef(u, 2));
    drive(state, u);
    drive(reference, hold);
  }
  for (std::size_t i = 2; i < size; ++i) {
    if (i == 3 && R::kCarState == 5) continue;
    EXPECT_NEAR(state[i], reference[i], 5e-4F) << trailers << " trailers, component " << i;
  }
}

TEST(PushingCorrection, BringsTrailersBackToTheirReference) {
  for (const int trailers : {1, 2, 3}) {
    expect_tracked<Truck>(trailers);
    expect_tracked<KinematicTruck>(trailers);
  }
}

}  // namespace
}  // namespace krait::test::robot_pushing_test
