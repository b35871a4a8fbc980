// SPDX-License-Identifier: Apache-2.0
// A long plan of a long snake on a large map is judged in seconds.
#include <gtest/gtest.h>

#include <chrono>
#include <numbers>
#include <random>

#include "plans.hpp"

namespace krait::host::testing {
namespace {

TEST(Speed, ThreeHundredStepsOfSixteenBodiesOnFourHundredThousandCells) {
  const RobotSpec spec = robot("snake", 15);
  const auto steer = [](std::size_t step, const Row&) -> Row {
    if (step < 10) return {2, 0};
    return {0, (step / 20) % 2 == 0 ? 0.5 : -0.5};
  };
  Case c = drive(spec, steer, 300, {18, 20}, 0);
  c.workspace.max = {90, 60};
  CellMap map;
  map.resolution = 0.1;
  map.columns = 900;
  map.rows = 600;
  map.occupied.assign(900UL * 600UL, 0);
  std::mt19937 generator(4);
  std::bernoulli_distribution filled(0.3);
  for (auto& cell : map.occupied) cell = filled(generator) ? 1 : 0;
  // Clear a road of the plan's own width and a little more.
  for (const auto& state : c.plan.states) {
    const int column = static_cast<int>(state[0] * 10);
    const int row = static_cast<int>(state[1] * 10);
    for (int dy = -13; dy <= 13; ++dy) {
      for (int dx = -140; dx <= 13; ++dx) {
        map.occupied[static_cast<std::size_t>((row + dy) * 900 + std::max(0, column + dx))] = 0;
      }
    }
  }
  c.workspace.cells = map;
  const auto begin = std::chrono::steady_clock::now();
  const Verdict verdict = c.verdict();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  RecordProperty("seconds", std::to_string(taken.count()));
  RecordProperty("clearance", std::to_string(verdict.clearance));
  EXPECT_TRUE(verdict.holds) << (verdict.complaints.empty() ? "" : verdict.complaints.front());
  EXPECT_LT(verdict.clearance, kLargestClearance);
  EXPECT_LT(taken.count(), 30) << "a third of a second on an idle machine, without sanitizers";
}

// Figures of eight: full circles to the left and to the right in turn, 80 steps each, by their closed form.
Case eights(std::size_t steps) {
  const auto rate = static_cast<float>(2 * std::numbers::pi / 8);  // rad/s
  Case c = drive(
      robot("unicycle"), [](std::size_t, const Row&) { return Row{}; }, 0, {20, 20}, 0);
  Row begin{20, 20, 0};  // of the circle
  Row state = begin;
  for (std::size_t i = 0; i < steps; ++i) {
    if (i % 80 == 0) begin = state;
    const float turning = (i / 80) % 2 == 0 ? rate : -rate;
    const double radius = 2 / static_cast<double>(turning);  // negative to the right
    state[2] = begin[2] + 0.1 * static_cast<double>(turning) * static_cast<double>(i % 80 + 1);
    state[0] = begin[0] + radius * (std::sin(state[2]) - std::sin(begin[2]));
    state[1] = begin[1] - radius * (std::cos(state[2]) - std::cos(begin[2]));
    c.plan.controls.push_back({2, turning});
    c.plan.states.emplace_back(state.begin(), state.end());
  }
  return c;
}

TEST(Speed, AHundredThousandSteps) {
  const Case c = eights(100'000);
  const auto begin = std::chrono::steady_clock::now();
  const Verdict verdict = c.verdict();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  RecordProperty("seconds", std::to_string(taken.count()));
  RecordProperty("drift", std::to_string(verdict.drift));
  EXPECT_TRUE(verdict.holds) << (verdict.complaints.empty() ? "" : verdict.complaints.front());
  EXPECT_LT(verdict.drift, 1e-5);
  EXPECT_LT(verdict.step_error, 1e-5);
  EXPECT_LT(taken.count(), 60) << "two seconds on an idle machine, without sanitizers";
}

}  // namespace
}  // namespace krait::host::testing
