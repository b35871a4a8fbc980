// SPDX-License-Identifier: Apache-2.0
// Wrong programs that do not compile: planners that are copied, and scenes and robots that would be gone when they are
// used. Results that are thrown away are refused in thrown_away.cpp and thrown_away.c.
#include <gtest/gtest.h>

#include <type_traits>
#include <utility>

#include "krait/krait.hpp"

namespace krait {
namespace {

template <class P>
constexpr bool kStaysInPlace =
    !std::is_copy_constructible_v<P> && !std::is_copy_assignable_v<P> && !std::is_move_constructible_v<P> &&
    !std::is_move_assignable_v<P> && std::is_default_constructible_v<P>;
static_assert(kStaysInPlace<Planner>);
static_assert(kStaysInPlace<PriorPlanner>);
static_assert(kStaysInPlace<RrtPlanner>);

// Whether a planner can be initialised with a scene and a robot of these value categories.
template <class P, class S, class R>
concept Initialises = requires(P& planner, void* block, S&& scene, R&& robot, Parameters parameters, Limits limits) {
  planner.init(block, 0, std::forward<S>(scene), std::forward<R>(robot), parameters, limits);
};
template <class P>
constexpr bool kKeepsNoTemporary =
    Initialises<P, const Scene&, const Car&>&& Initialises<P, Scene&, Car&> && !Initialises<P, Scene, Car&> &&
    !Initialises<P, const Scene, const Car&> && !Initialises<P, Scene&, Car> && !Initialises<P, Scene&, const Car> &&
    !Initialises<P, Scene, Car>;
static_assert(kKeepsNoTemporary<Planner>);
static_assert(kKeepsNoTemporary<PriorPlanner>);
static_assert(kKeepsNoTemporary<RrtPlanner>);

template <class S, class R>
concept Checks = requires(MotionCheck check, S&& scene, R&& robot) {
  check.assign(std::forward<R>(robot), std::forward<S>(scene), 0.0F, 1, true);
};
static_assert(Checks<Scene&, Car&> && !Checks<Scene, Car&> && !Checks<Scene&, Car>);

template <class R>
concept Drives = requires(Drive drive, PlanDrive plan_drive, R&& robot, const float* state) {
  drive.assign(std::forward<R>(robot), 0.1F);
  plan_drive.begin(std::forward<R>(robot), 0.1F, state);
};
static_assert(Drives<Car&> && !Drives<Car>);

static_assert(std::is_constructible_v<Obstacles, Scene&, float> && !std::is_constructible_v<Obstacles, Scene, float>);

TEST(RefusedUse, IsRefusedWhereThisFileCompiles) { SUCCEED(); }

}  // namespace
}  // namespace krait
