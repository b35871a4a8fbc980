// SPDX-License-Identifier: Apache-2.0
// Wrong programs that do not compile: planners that are copied, and scenes, robots and watches that would be gone when
// they are used. Results that are thrown away are refused in thrown_away.cpp and thrown_away.c.
#include <gtest/gtest.h>

#include <concepts>
#include <type_traits>
#include <utility>

#include "collision/motion_check.hpp"
#include "collision/obstacles.hpp"
#include "krait/krait.hpp"
#include "motion/drive.hpp"
#include "motion/plan_drive.hpp"

namespace krait::test::refused_use_test {
namespace {

template <class P>
constexpr bool kStaysInPlace =
    !std::is_copy_constructible_v<P> && !std::is_copy_assignable_v<P> && !std::is_move_constructible_v<P> &&
    !std::is_move_assignable_v<P> && std::is_default_constructible_v<P>;
static_assert(kStaysInPlace<Planner>);

// Whether a planner can be initialised with a robot of this value category. A scene is given by its address.
template <class R>
concept Initialises = requires(Planner& planner, const Scene& scene, R&& robot) {
  planner.init({nullptr, 0, &scene, std::forward<R>(robot)});
};
static_assert(Initialises<Car&> && Initialises<const Car&> && !Initialises<Car> && !Initialises<const Car>);

template <class S, class R>
concept Checks = requires(detail::MotionCheck check, S&& scene, R&& robot) {
  check.assign(std::forward<R>(robot), std::forward<S>(scene), 0.0F, 1, true);
};
static_assert(Checks<Scene&, Car&> && !Checks<Scene, Car&> && !Checks<Scene&, Car>);

template <class R>
concept Drives = requires(detail::Drive drive, detail::PlanDrive plan_drive, R&& robot, const float* state) {
  drive.assign(std::forward<R>(robot), 0.1F);
  plan_drive.begin(std::forward<R>(robot), 0.1F, state);
};
static_assert(Drives<Car&> && !Drives<Car>);

static_assert(std::is_constructible_v<detail::Obstacles, Scene&, float> &&
              !std::is_constructible_v<detail::Obstacles, Scene, float>);

// Whether a watch can be made from what is called, and whether a planner can be given it during one call.
constexpr auto kWatch = [](const float*, const float*) {};
using Watching = std::remove_const_t<decltype(kWatch)>;
template <class W>
constexpr bool kMakesWatch = std::is_constructible_v<Watch, W>;
static_assert(kMakesWatch<Watching&> && kMakesWatch<const Watching&> && kMakesWatch<Watch> &&
              kMakesWatch<const Watch&>);
static_assert(!kMakesWatch<Watching> && !kMakesWatch<const Watching>);
template <class W>
concept Advances = requires(Planner& planner, W&& watch) {
  { planner.advance(1, std::forward<W>(watch)) } -> std::same_as<Status>;
};
static_assert(Advances<Watching> && Advances<Watching&> && Advances<const Watching&> && Advances<Watch>);

TEST(RefusedUse, IsRefusedWhereThisFileCompiles) { SUCCEED(); }

}  // namespace
}  // namespace krait::test::refused_use_test
