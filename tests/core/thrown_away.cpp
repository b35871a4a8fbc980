// SPDX-License-Identifier: Apache-2.0
// Must not compile: every result that says what went wrong is thrown away.
#include "krait/krait.hpp"
#include "krait/robot_check.hpp"
#include "search/search.hpp"

void plan(krait::Planner& planner, const krait::Scene& scene, const krait::Unicycle& robot) {
  krait::Scene opened;
  krait::Scene::open(nullptr, 0, opened);
  planner.init({nullptr, 0, &scene, robot});
  planner.start(krait::Query());
  planner.advance(1);
  planner.advance(1, krait::Watch());
  planner.advance(1, [](const float*, const float*) {});
  planner.improve(1);
  planner.status();
  planner.failure();
}

// Internal ones: their types alone say so.
struct Inside : krait::detail::Search {
  void plan(const krait::Setup& setup, const krait::detail::Keeper& keeper) {
    check_setup(setup, {}, {});
    begin({}, keeper);
  }
};

void ask(const krait::Scene& scene, const krait::Robot& robot, float* state, krait::Pose* poses) {
  krait::Travel travel[krait::Unicycle::kMaxBodies];
  krait::Parameters().first_bad();
  krait::Limits().first_bad();
  krait::Goal::named(0).valid(scene);
  robot.travel(state, state, 0.1F, state, travel);
  robot.sketch(state, poses, state, 0.1F);
  robot.rest({0.0F, 0.0F}, 0.0F, nullptr, 0, state);
  krait::check_robot(robot, {});
}
