// SPDX-License-Identifier: Apache-2.0
// A scene, a robot, a planner and its block together.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "krait/krait.hpp"
#include "scene_builder.hpp"
#include "user_robot.hpp"

namespace krait::test {

// Two rooms of 6 by 8 metres and a door of 2 m in the wall between them; the goal is in the right one.
inline Room two_rooms(double door = 2) {
  Room room;
  room.bounds = {0, 0, 12, 8};
  room.boxes = {{6, 0, 6.25, 4 - door / 2}, {6, 4 + door / 2, 6.25, 8}};
  room.goals = {{9.5, 5.5, 11.5, 7.5}, {6.05, 0.5, 6.2, 1.5}, {1, 1, 3, 3}};
  return room;
}

// The first-order car with a trailer of dynobench's problems (github.com/quimortiz/dynobench), which backs at a fifth
// of its speed.
inline KinematicTruck car_with_trailer() {
  KinematicTruckParameters p;
  p.trailers = 1;
  p.body_length = 0.5F;
  p.body_width = 0.25F;
  p.wheelbase = 0.25F;
  p.hitch_length = 0.5F;
  p.max_speed = 0.5F;
  p.min_speed = -0.1F;
  p.max_steering = 1.047F;
  KinematicTruck robot(p);
  static constexpr Vec2 kTrailer[] = {{-0.15F, -0.125F}, {0.15F, -0.125F}, {0.15F, 0.125F}, {-0.15F, 0.125F}};
  robot.set_body(1, {kTrailer, 4});
  return robot;
}

template <class R, class P = Planner>
struct Bench {
  template <class... PlannersOwn>
  Bench(const Room& room, const R& r, const PlannersOwn&... own) : open(room), robot(r), planner(own...) {
    limits.vertices = 20'000;
    limits.iterations = 20'000;
  }

  // Gives the planner a block that holds its limits exactly.
  Failure init() { return init(P::bytes_required(open.scene, robot, limits)); }
  Failure init(std::uint64_t bytes) {
    block.assign((bytes + 7) / 8, 0xA5A5A5A5A5A5A5A5ULL);
    return planner.init({block.data(), bytes, &open.scene, robot}, parameters, limits);
  }
  Status solve(const Query& query) {
    (void)planner.start(query);
    return planner.advance(1'000'000'000);
  }

  OpenScene open;
  R robot;
  Parameters parameters;
  Limits limits;
  std::vector<std::uint64_t> block;
  P planner;
};

// Searches in a block amid other memory, of which nothing may change.
template <class R, class P>
void expect_nothing_written_outside(Bench<R, P>& bench, const float* start) {
  constexpr std::uint64_t kPattern = 0x5151515151515151ULL;
  constexpr std::size_t kAround = 32;
  const std::uint64_t needed = P::bytes_required(bench.open.scene, bench.robot, bench.limits);
  std::vector<std::uint64_t> memory(needed / 8 + 2 * kAround, kPattern);
  const Setup setup{memory.data() + kAround, needed, &bench.open.scene, bench.robot};
  ASSERT_TRUE(bench.planner.init(setup, bench.parameters, bench.limits).ok());
  for (const std::uint64_t seed : {1U, 2U, 3U}) (void)bench.solve({start, Goal::named(0), seed});
  for (std::size_t i = 0; i < kAround; ++i) {
    ASSERT_EQ(memory[i], kPattern);
    ASSERT_EQ(memory[kAround + needed / 8 + i], kPattern);
  }
}

// A plan's states and controls, by its cursor.
struct Path {
  explicit Path(const Plan& plan) {
    PlanCursor at = plan.cursor();
    for (; !at.done(); at.advance()) {
      states.emplace_back(at.state(), at.state() + plan.state_size());
      controls.emplace_back(at.control(), at.control() + plan.control_size());
    }
    states.emplace_back(at.state(), at.state() + plan.state_size());
  }

  std::vector<std::vector<float>> states, controls;
};

// A state in which all but the position is zero.
template <class R>
std::vector<float> standing(const R& robot, Vec2 at) {
  std::vector<float> state(static_cast<std::size_t>(robot.state_size()), 0.0F);
  state[0] = at.x;
  state[1] = at.y;
  return state;
}

inline Unicycle small_unicycle() {
  UnicycleParameters p;
  p.body_length = 0.5F;
  p.body_width = 0.4F;
  return Unicycle(p);
}

}  // namespace krait::test
