// SPDX-License-Identifier: Apache-2.0
// Each lemma of lib/robot/CHAIN.md on steps that are integrated in double precision: what is proven there is so, and
// the bounds that chain.cpp and trailers.hpp compute by it hold. Lemma 13 is in robot_travel_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "krait/robots/detail/defaults.hpp"
#include "robot/trailers.hpp"
#include "robot_oracle.hpp"

namespace krait::test::chain_lemmas_test {
namespace {

constexpr int kParts = 40;
constexpr double kHitchError = 3e-4;  // radians: what a Runge-Kutta step leaves between stored and true angles

double with_rounding(double bound) { return bound * (1 + 1e-5) + 1e-6; }

// A step of a chain: what CHAIN.md knows of it, its true motion, and what the chain says of it.
struct Step {
  double dt;
  double way;       // metres
  double reach;     // radians
  double car_turn;  // radians
  std::vector<Numbers> states;
  Bounds bounds;
  QuickBound quick;

  std::size_t trailers() const { return states[0].size() - Chain::kCarState; }
  // Of body i, 0 is the car.
  double heading(std::size_t i, std::size_t time) const { return states[time][i == 0 ? 2 : 4 + i]; }
  double hitch(std::size_t i, std::size_t time) const { return heading(i - 1, time) - heading(i, time); }
  double largest_hitch(std::size_t i) const {
    double most = 0;
    for (std::size_t t = 0; t < states.size(); ++t) most = std::max(most, std::abs(hitch(i, t)));
    return most;
  }
  double ends(std::size_t i) const { return std::abs(hitch(i, 0)) + std::abs(hitch(i, states.size() - 1)); }
  // How far body i turns, to and fro counted.
  double turned(std::size_t i) const {
    double sum = 0;
    for (std::size_t t = 1; t < states.size(); ++t) sum += std::abs(heading(i, t) - heading(i, t - 1));
    return sum;
  }
  // How far its heading strays from turning uniformly.
  double heading_strays(std::size_t i) const {
    const double from = heading(i, 0), to = heading(i, states.size() - 1);
    double most = 0;
    for (std::size_t t = 0; t < states.size(); ++t) {
      most = std::max(most, std::abs(heading(i, t) - (from + (to - from) * static_cast<double>(t) / kParts)));
    }
    return most;
  }
  // T |P(i)'|, at most: the product of the cosines of the first i hitch angles.
  double folds(std::size_t i) const {
    const auto product = [&](std::size_t t) {
      double cosines = 1;
      for (std::size_t j = 1; j <= i; ++j) cosines *= std::cos(hitch(j, t));
      return cosines;
    };
    double most = 0;
    for (std::size_t t = 1; t < states.size(); ++t)
      most = std::max(most, kParts * std::abs(product(t) - product(t - 1)));
    return most;
  }
  double turn(std::size_t i) const { return wide(bounds.bodies[i].turn); }
};

// An axle's places at all times of the step.
std::vector<Numbers> axle(const Chain& chain, const Step& step, std::size_t i) {
  std::vector<Numbers> places;
  for (const Numbers& s : step.states) {
    const Frame frame = frames(chain, s)[i];
    places.push_back({frame.x, frame.y});
  }
  return places;
}

double length_of(const std::vector<Numbers>& places) {
  double sum = 0;
  for (std::size_t t = 1; t < places.size(); ++t) {
    sum += std::hypot(places[t][0] - places[t - 1][0], places[t][1] - places[t - 1][1]);
  }
  return sum;
}

// How far the places stray from going straight and uniformly from the first to the last.
double strays(const std::vector<Numbers>& places) {
  const Numbers &from = places.front(), &to = places.back();
  double most = 0;
  for (std::size_t t = 0; t < places.size(); ++t) {
    const double part = static_cast<double>(t) / static_cast<double>(places.size() - 1);
    most = std::max(most, std::hypot(places[t][0] - from[0] - part * (to[0] - from[0]),
                                     places[t][1] - from[1] - part * (to[1] - from[1])));
  }
  return most;
}

template <class R>
Step step_of(const R& chain, const std::vector<float>& s, const std::vector<float>& u, float dt,
             const std::vector<float>& next) {
  const ChainParameters& p = chain.parameters();
  const int n = chain.state_size();
  const auto largest = [&](std::size_t i) { return std::max(std::abs(wide(s[i])), std::abs(wide(next[i]))); };
  Step step{wide(dt), wide(dt) * largest(3), 0, 0, {doubles(s)}, bounds_of(chain, s, u, dt, next), {}};
  step.reach = step.way / wide(p.hitch_length);
  step.car_turn = step.way * largest(4) / wide(p.wheelbase);
  step.quick = chain.quick_bound(StateView(s.data(), n), ControlView(u.data(), 2), dt, StateView(next.data(), n));
  for (int part = 0; part < kParts; ++part) {
    step.states.push_back(rk4(chain, step.states.back(), doubles(u), wide(dt) / kParts));
  }
  return step;
}

// Draws steps of the model's chains whose ends are within the limits, and shows each to `visit`.
template <class R, class Visit>
void draw_steps(unsigned seed, const Visit& visit) {
  std::mt19937 random(seed);
  int drawn = 0;
  for (const R& chain : instances<R>()) {
    for (int i = 0; i < 160; ++i) {
      const float dt = std::vector<float>{0.025F, 0.05F, 0.1F, 0.4F}[static_cast<std::size_t>(i % 4)];
      auto s = random_state(chain, random);
      // Every other chain is drawn nearly straight, as bounds that rest on small hitch angles are tight there.
      for (std::size_t k = 5; i % 2 == 0 && k < s.size(); ++k) {
        s[k] = s[k == 5 ? 2 : k - 1] + uniform_float(random, -0.2, 0.2);
      }
      const auto u = random_control(chain, s, dt, random);
      const auto next = step(chain, s, u, dt);
      if (!chain.within_limits(StateView(next.data(), chain.state_size()))) continue;
      visit(chain, step_of(chain, s, u, dt, next));
      ++drawn;
    }
  }
  EXPECT_GT(drawn, 500);
}

// By lemma 7: the sum over the hitches up to i, of sines that lemma 6 has in its turns.
double folding_bound(const Step& step, std::size_t i) {
  double sum = 0;
  for (std::size_t j = 1; j <= i && step.reach > 0; ++j) {
    sum += step.turn(j) / step.reach * (step.turn(j - 1) + step.turn(j));
  }
  return sum;
}

// The norm of lemma 11, for steps whose `reach` is less than 1.
double norm_bound(const Step& step) {
  double squares = 0;
  for (std::size_t i = 1; i <= step.trailers(); ++i) squares += step.ends(i) * step.ends(i);
  return (std::sqrt(squares) + step.car_turn) / (2 - 2 * step.reach);
}

template <class R>
class ChainLemmas : public ::testing::Test {};
using Chains = ::testing::Types<Snake, Truck>;
TYPED_TEST_SUITE(ChainLemmas, Chains, ModelNames);

TEST(ChainBend, Lemma1_APointStraysByAnEighthOfItsAcceleration) {
  std::mt19937 random(1);
  double tightest = 0;
  for (int i = 0; i < 1000; ++i) {
    const double most = uniform(random, 0.1, 5), dt = uniform(random, 0.05, 0.4), h = dt / kParts;
    const bool uniformly = i % 10 == 0;
    double angle = uniform(random, -4, 4), share = 1, fastest = 0;
    Numbers place = {0, 0}, speed = {uniform(random, -3, 3), uniform(random, -3, 3)};
    std::vector<Numbers> places = {place};
    for (int part = 0; part < kParts; ++part) {
      if (!uniformly && part % 8 == 0) angle = uniform(random, -4, 4), share = uniform(random, 0, 1);
      const Numbers a = {share * most * std::cos(angle), share * most * std::sin(angle)};
      fastest = std::max(fastest, std::hypot(speed[0], speed[1]));
      for (std::size_t k = 0; k < 2; ++k) {
        place[k] += h * speed[k] + h * h / 2 * a[k];
        speed[k] += h * a[k];
      }
      places.push_back(place);
    }
    fastest = std::max(fastest, std::hypot(speed[0], speed[1]));
    BodyRates rates{};
    rates.speed = static_cast<float>(fastest);
    rates.acceleration = static_cast<float>(most);
    const double bend = wide(detail::travel_of(rates, static_cast<float>(dt)).bend);
    ASSERT_LE(strays(places), with_rounding(bend));
    tightest = std::max(tightest, strays(places) / bend);
  }
  EXPECT_GT(tightest, 0.99);
}

TYPED_TEST(ChainLemmas, Lemma2_TheCarsAxleGoesAndTurnsNoFurther) {
  draw_steps<TypeParam>(2, [](const Chain& chain, const Step& step) {
    ASSERT_LE(length_of(axle(chain, step, 0)), with_rounding(step.way));
    ASSERT_LE(step.turned(0), with_rounding(step.car_turn));
    ASSERT_LE(length_of(axle(chain, step, 0)), with_rounding(wide(step.bounds.bodies[0].path)));
    ASSERT_LE(step.turned(0), with_rounding(step.turn(0)));
  });
}

// By lemma 1 a bound on the second derivative bounds how far the axle and the heading stray.
TYPED_TEST(ChainLemmas, Lemma3_TheCarIsAcceleratedNoFaster) {
  draw_steps<TypeParam>(3, [](const Chain& chain, const Step& step) {
    const Travel& car = step.bounds.bodies[0];
    ASSERT_LE(strays(axle(chain, step, 0)), with_rounding(wide(car.bend)));
    ASSERT_LE(step.heading_strays(0), with_rounding(wide(car.twist) - step.turn(0) * step.turn(0) / 8));
  });
}

TYPED_TEST(ChainLemmas, Lemma4_AxlesGoNoFurther) {
  draw_steps<TypeParam>(4, [](const Chain& chain, const Step& step) {
    for (std::size_t i = 1; i <= step.trailers(); ++i) {
      ASSERT_LE(length_of(axle(chain, step, i)), with_rounding(wide(step.bounds.bodies[i].path))) << i;
    }
  });
}

TYPED_TEST(ChainLemmas, Lemma5_HitchesFoldNoFurther) {
  draw_steps<TypeParam>(5, [](const Chain& chain, const Step& step) {
    for (std::size_t i = 1; i <= step.trailers(); ++i) {
      const double ends = step.ends(i) + step.turn(i - 1);
      double most = (ends + step.reach) / 2;
      if (most < 1) most = ends / (2 - step.reach);
      ASSERT_LE(step.largest_hitch(i), with_rounding(most)) << i;
      if (!step.bounds.limits_kept) continue;
      ASSERT_LE(step.largest_hitch(i), wide(chain.parameters().max_hitch_angle) + kHitchError) << i;
    }
  });
}

TYPED_TEST(ChainLemmas, Lemma6_TrailersTurnNoFurther) {
  draw_steps<TypeParam>(6, [](const Chain&, const Step& step) {
    for (std::size_t i = 1; i <= step.trailers(); ++i) ASSERT_LE(step.turned(i), with_rounding(step.turn(i))) << i;
  });
}

TYPED_TEST(ChainLemmas, Lemma7_TheChainFoldsNoFaster) {
  draw_steps<TypeParam>(7, [](const Chain&, const Step& step) {
    for (std::size_t i = 1; i <= step.trailers(); ++i) {
      ASSERT_LE(step.folds(i), with_rounding(folding_bound(step, i))) << i;
    }
  });
}

TYPED_TEST(ChainLemmas, Lemma8_HeadingsAreAcceleratedNoFaster) {
  draw_steps<TypeParam>(8, [](const Chain&, const Step& step) {
    for (std::size_t i = 1; i <= step.trailers(); ++i) {
      const double twist = wide(step.bounds.bodies[i].twist) - step.turn(i) * step.turn(i) / 8;
      ASSERT_LE(step.heading_strays(i), with_rounding(twist)) << i;
    }
  });
}

TYPED_TEST(ChainLemmas, Lemma9_AxlesAreAcceleratedNoFaster) {
  draw_steps<TypeParam>(9, [](const Chain& chain, const Step& step) {
    for (std::size_t i = 1; i <= step.trailers(); ++i) {
      ASSERT_LE(strays(axle(chain, step, i)), with_rounding(wide(step.bounds.bodies[i].bend))) << i;
    }
  });
}

TYPED_TEST(ChainLemmas, Lemma10_NoHitchFoldsFurtherThanTheirLargest) {
  draw_steps<TypeParam>(10, [](const Chain& chain, const Step& step) {
    if (step.reach >= 0.9 || step.trailers() == 0) return;
    double ends = 0, hitch = 0, turned = 0;
    for (std::size_t i = 1; i <= step.trailers(); ++i) {
      ends = std::max(ends, step.ends(i));
      hitch = std::max(hitch, step.largest_hitch(i));
      turned = std::max(turned, step.turned(i));
    }
    ASSERT_LE(hitch, with_rounding(std::max((ends + step.car_turn) / (2 - step.reach), ends / (2 - 2 * step.reach))));
    if (!step.quick.limits_kept) return;
    ASSERT_LE(hitch, wide(chain.parameters().max_hitch_angle));
    ASSERT_LE(turned, with_rounding(wide(step.quick.most.turn)));
  });
}

TYPED_TEST(ChainLemmas, Lemma11_AllHitchesTogetherHaveABoundedNorm) {
  draw_steps<TypeParam>(11, [](const Chain&, const Step& step) {
    if (step.reach >= 0.9) return;
    double squares = 0;
    for (std::size_t i = 1; i <= step.trailers(); ++i) squares += step.largest_hitch(i) * step.largest_hitch(i);
    ASSERT_LE(std::sqrt(squares), with_rounding(norm_bound(step)));
  });
}

TYPED_TEST(ChainLemmas, Lemma12_TheWholeChainFoldsNoFaster) {
  int kept = 0;
  draw_steps<TypeParam>(12, [&kept](const Chain& chain, const Step& step) {
    if (step.reach >= 0.9) return;
    const double norm = norm_bound(step);
    for (std::size_t i = 1; i <= step.trailers(); ++i) {
      ASSERT_LE(step.folds(i), with_rounding(norm * (2 * step.reach * norm + step.car_turn))) << i;
      if (!step.quick.limits_kept) continue;
      ++kept;
      ASSERT_LE(strays(axle(chain, step, i)), with_rounding(wide(step.quick.most.bend))) << i;
      ASSERT_LE(step.heading_strays(i), with_rounding(wide(step.quick.most.twist))) << i;
    }
  });
  EXPECT_GT(kept, 500);
}

// A truck at 1 m/s of its rear axle, its wheels turned for a circle of that radius to the left, and its trailers in the
// steady turn of lemma 14, or straight.
Numbers turning(const Truck& truck, double radius, bool steady) {
  const ChainParameters& p = truck.parameters();
  const double psi = std::atan(wide(p.wheelbase) / radius), d = wide(p.hitch_length);
  Numbers s = {0, 0, 0, 1 / std::cos(psi), psi};
  double square = radius * radius;  // of the circle of the axle ahead
  for (int i = 0; i < p.trailers; ++i, square -= d * d) {
    s.push_back(i == 0 ? 0 : s.back());
    if (steady) s.back() -= std::asin(d / std::sqrt(square));
  }
  return s;
}

double largest_hitch(const Numbers& s) {
  double most = 0;
  for (std::size_t i = Chain::kCarState; i < s.size(); ++i) {
    most = std::max(most, std::abs(s[i == Chain::kCarState ? 2 : i - 1] - s[i]));
  }
  return most;
}

TEST(ChainTurn, Lemma14_TrailersFollowATurnOnlyWhereTheLastOneHasARadius) {
  for (const Truck& truck : instances<Truck>()) {
    const ChainParameters& p = truck.parameters();
    if (p.trailers == 0) continue;
    const double d = wide(p.hitch_length), least = d * std::sqrt(p.trailers),
                 radius = wide(Chain::kTurnReserve) * least;
    EXPECT_NEAR(wide(p.wheelbase) / wide(detail::steady_tangent(p)), radius, 1e-5 * radius);
    Numbers s = turning(truck, radius, true);
    const double hitch = largest_hitch(s);
    EXPECT_LE(hitch, std::asin(1 / wide(Chain::kTurnReserve)) + 1e-9);
    EXPECT_LT(hitch, wide(detail::kFoldBound));
    for (int i = 0; i < 1000; ++i) s = rk4(truck, s, {0, 0}, 0.01);
    EXPECT_NEAR(largest_hitch(s), hitch, 1e-5);
    double square = radius * radius;
    for (const Frame& axle : frames(truck, s)) {
      EXPECT_NEAR(std::hypot(axle.x, axle.y - radius), std::sqrt(square), 1e-5 * radius);
      square -= d * d;
    }
    if (p.trailers > 5) continue;  // a straight chain takes longer to follow
    const auto after = [&](double circle) {
      Numbers at = turning(truck, circle, false);
      double most = 0;
      for (int i = 0; i < 20000 && most < 2; ++i)
        most = std::max(most, largest_hitch(at = rk4(truck, at, {0, 0}, 0.01)));
      return most;
    };
    EXPECT_NEAR(after(radius), hitch, 1e-3) << p.trailers;
    EXPECT_GT(after(0.98 * least), 2) << p.trailers;
  }
}

TEST(ChainTurn, Lemma15_TheFirstHitchStaysBelowItsBound) {
  const double bound = wide(detail::kFoldBound);
  for (const Truck& truck : instances<Truck>()) {
    if (truck.parameters().trailers == 0) continue;
    for (const double speed : {0.05, 0.5, 2.5}) {
      for (const double hitch : {-0.5, 0.0, 0.9, bound - 0.01}) {
        Numbers s = turning(truck, 1, false);
        s[3] = speed;
        for (std::size_t k = Chain::kCarState; k < s.size(); ++k) s[k] = -hitch;
        for (int i = 0; i < 4000; ++i) {
          const float tangent = detail::recoverable_tangent(truck.parameters(), static_cast<float>(s[2] - s[5]),
                                                            static_cast<float>(speed));
          s[4] = std::atan(wide(tangent));
          s = rk4(truck, s, {0, 0}, 0.005);
          ASSERT_LT(s[2] - s[5], bound + 1e-5);
        }
        EXPECT_GT(s[2] - s[5], speed < 0.1 ? hitch : bound - 0.01);
      }
    }
  }
}

}  // namespace
}  // namespace krait::test::chain_lemmas_test
