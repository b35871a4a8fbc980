// SPDX-License-Identifier: Apache-2.0
// A room in which first plans wind, planners that have one there, and what must be so of better ones.
#pragma once

#include <algorithm>

#include "planner_fixture.hpp"
#include "robot_oracle.hpp"

namespace krait::test {

inline constexpr std::uint32_t kLegs = 64;

// Three walls with doors at their ends, so that first plans wind.
inline Room winding() {
  Room room;
  room.bounds = {0, 0, 16, 8};
  room.boxes = {{4, 0, 4.25, 5.5}, {8, 2.5, 8.25, 8}, {12, 0, 12.25, 5.5}};
  room.goals = {{13.5, 0.5, 15.5, 2.5}, {0.5, 0.5, 3, 3}};
  return room;
}

inline Car small_car() {
  ChainParameters p = Car::defaults();
  p.body_length = 0.6F;
  p.body_width = 0.3F;
  p.wheelbase = 0.4F;
  return Car(p);
}

template <class R>
std::vector<float> start_of(const R& robot, float heading = 0.0F) {
  std::vector<float> state(static_cast<std::size_t>(robot.state_size()));
  if constexpr (kTows<R>) {
    robot.rest({2, 2}, heading, nullptr, state.data());
  } else {
    robot.rest({2, 2}, heading, state.data());
  }
  return state;
}

// A planner with a first plan in the winding room.
template <class R>
struct Solved : Bench<R> {
  explicit Solved(const R& r, std::uint64_t seed = 1, std::uint32_t legs = kLegs, const Goal& goal = Goal::named(0),
                  float heading = 0.0F)
      : Bench<R>(winding(), r) {
    this->limits.way_legs = legs;
    EXPECT_TRUE(this->init().ok());
    start = start_of(r, heading);
    EXPECT_EQ(this->solve({start.data(), goal, seed}), Status::solved);
  }
  std::vector<float> start;
};

// Improves the first plan, by `cut` iterations a call, until all has cost `times` as many collision checks as it did.
inline void improve_by_checks(Planner& planner, std::uint64_t times, std::uint64_t cut = 10) {
  const std::uint64_t most = times * planner.statistics().collision_checks;
  while (planner.statistics().collision_checks < most) ASSERT_EQ(planner.improve(cut), Status::solved);
}

inline bool same(const Statistics& a, const Statistics& b) {
  return a.hash == b.hash && a.plan_steps == b.plan_steps && a.improvements == b.improvements &&
         a.collision_checks == b.collision_checks;
}

template <class R>
void expect_independent_of_cuts(const R& robot, const Goal& goal = Goal::named(0)) {
  Solved<R> whole(robot, 1, kLegs, goal);
  Solved<R> single(robot, 1, kLegs, goal);
  Solved<R> mixed(robot, 1, kLegs, goal);
  EXPECT_EQ(whole.planner.improve(1000), Status::solved);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(single.planner.improve(1), Status::solved);
  for (int i = 0; i < 1000;) {
    const int cut = i % 7 + 1 < 1000 - i ? i % 7 + 1 : 1000 - i;
    EXPECT_EQ(mixed.planner.improve(static_cast<std::uint64_t>(cut)), Status::solved);
    i += cut;
  }
  EXPECT_GT(whole.planner.statistics().improvements, 0U);
  EXPECT_TRUE(same(whole.planner.statistics(), single.planner.statistics()));
  EXPECT_TRUE(same(whole.planner.statistics(), mixed.planner.statistics()));
  EXPECT_EQ(whole.planner.plan().hash(), single.planner.plan().hash());
}

// Whether a line along an edge of the body or a side of the box keeps them apart.
inline bool apart(const std::vector<Numbers>& body, const Rect& box) {
  const std::vector<Numbers> corners = {{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}};
  std::vector<Numbers> axes = {{1, 0}, {0, 1}};
  for (std::size_t i = 0; i < body.size(); ++i) {
    const Numbers& next = body[(i + 1) % body.size()];
    axes.push_back({next[1] - body[i][1], body[i][0] - next[0]});
  }
  const auto reach = [](const std::vector<Numbers>& points, const Numbers& axis) {
    std::pair<double, double> range{1e9, -1e9};
    for (const Numbers& p : points) {
      const double along = axis[0] * p[0] + axis[1] * p[1];
      range = {std::min(range.first, along), std::max(range.second, along)};
    }
    return range;
  };
  return std::any_of(axes.begin(), axes.end(), [&](const Numbers& axis) {
    const auto a = reach(body, axis);
    const auto b = reach(corners, axis);
    return a.second < b.first || b.second < a.first;
  });
}

// The plan's controls alone, from the start, in double precision and fine steps: the robot meets its plan's states and
// no wall. Where that ends.
template <class R>
Numbers drive_alone(const Solved<R>& bench, const Path& path) {
  EXPECT_EQ(path.states.front(), bench.start);
  constexpr int kParts = 10;
  Numbers state(bench.start.begin(), bench.start.end());
  for (std::size_t i = 0; i < path.controls.size(); ++i) {
    const Numbers control(path.controls[i].begin(), path.controls[i].end());
    for (int part = 0; part < kParts; ++part) {
      state = rk4(bench.robot, state, control, wide(bench.parameters.dt) / kParts);
      for (int k = 0; k < bench.robot.body_count(); ++k) {
        const std::vector<Numbers> body =
            vertices(bench.robot.body(k), frames(bench.robot, state)[static_cast<std::size_t>(k)]);
        for (const Rect& box : winding().boxes) EXPECT_TRUE(apart(body, box)) << "step " << i << ", body " << k;
      }
    }
    for (std::size_t k = 0; k < state.size(); ++k) {
      EXPECT_NEAR(wide(path.states[i + 1][k]), state[k], 1e-3) << "step " << i << ", component " << k;
    }
  }
  return state;
}

}  // namespace krait::test
