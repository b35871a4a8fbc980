// SPDX-License-Identifier: Apache-2.0
// Every robot: Runge-Kutta under random controls, steering toward random targets with the bodies placed, and the motion
// of a plan.
#include "base/random.hpp"
#include "motion/plan_drive.hpp"
#include "motion/rk4.hpp"
#include "stages.hpp"

namespace krait::stages {
namespace {

constexpr int kSteps = 1500;
constexpr int kExpansion = 40;  // steps before a new beginning
constexpr float kStep = 0.1F;   // seconds

template <RobotModel R>
struct Vehicle {
  const R& robot;
  float state[R::kMaxState] = {};
  float control[R::kMaxControl] = {};

  StateView view() const { return StateView(state, robot.state_size()); }

  void step() {
    float next[R::kMaxState];
    detail::propagate(robot, state, control, kStep, next);
    for (int i = 0; i < robot.state_size(); ++i) state[i] = next[i];
  }

  void stand() {
    for (float& x : state) x = 0.0F;
  }
};

template <RobotModel R>
void runge_kutta(const firmware::Board& board, const char* name, const R& robot) {
  Hash hash;
  detail::Random random(11);
  Vehicle<R> vehicle{robot};
  for (int step = 0; step < kSteps; ++step) {
    if (step % kExpansion == 0) vehicle.stand();
    for (int i = 0; i < robot.control_size(); ++i) vehicle.control[i] = spread(random, 2.0F);
    vehicle.step();
    hash.add(vehicle.state, robot.state_size());
  }
  report(board, {"rk4", name}, hash);
}

template <RobotModel R>
void add_bodies(const Vehicle<R>& vehicle, Hash& hash) {
  const R& robot = vehicle.robot;
  Pose poses[R::kMaxBodies];
  robot.place(vehicle.view(), poses);
  const ControlView control(vehicle.control, robot.control_size());
  Travel travel[R::kMaxBodies];
  robot.travel(vehicle.view(), control, kStep, vehicle.view(), travel);
  for (int k = 0; k < robot.body_count(); ++k) {
    hash.add(poses[k].position);
    hash.add(poses[k].heading.sin);
    hash.add(poses[k].heading.cos);
    hash.add(travel[k].path);
    hash.add(travel[k].turn);
    hash.add(travel[k].bend);
    hash.add(travel[k].twist);
  }
}

template <RobotModel R>
void steering(const firmware::Board& board, const char* name, const R& robot) {
  Hash controls;
  Hash bodies;
  detail::Random random(12);
  Vehicle<R> vehicle{robot};
  Target target{};
  Steering memory;
  for (int step = 0; step < kSteps; ++step) {
    if (step % kExpansion == 0) {
      const float x = spread(random, 20.0F);
      const float y = spread(random, 20.0F);
      target = {{x, y}, 0.75F + 0.25F * random.unit(), kStep};
      memory = {};
      if (!robot.within_limits(vehicle.view())) vehicle.stand();
    }
    robot.steer(vehicle.view(), target, memory, ControlRef(vehicle.control, robot.control_size()));
    controls.add(vehicle.control, robot.control_size());
    vehicle.step();
    add_bodies(vehicle, bodies);
  }
  report(board, {"steer", name}, controls);
  report(board, {"bodies", name}, bodies);
}

// The motion of a plan.
template <RobotModel R>
void driving(const firmware::Board& board, const char* name, const R& robot) {
  static detail::PlanDrive drive;
  const float start[R::kMaxState] = {};
  Hash hash;
  detail::Random random(13);
  drive.begin(robot, kStep, start);
  for (int step = 0; step < kSteps / 3; ++step) {
    if (step % kExpansion == 0) {
      const float x = spread(random, 20.0F);
      const float y = spread(random, 20.0F);
      drive.aim({{x, y}, 0.75F + 0.25F * random.unit()});
    }
    Pose poses[R::kMaxBodies];
    robot.place(StateView(drive.state(), robot.state_size()), poses);
    drive.step(poses);
    hash.add(drive.control(), robot.control_size());
    drive.go();
    hash.add(drive.state(), robot.state_size());
  }
  report(board, {"drive", name}, hash);
}

}  // namespace

void motion(const firmware::Board& board) {
  for_each_robot([&](const char* name, const auto& robot) {
    runge_kutta(board, name, robot);
    steering(board, name, robot);
    driving(board, name, robot);
  });
}

}  // namespace krait::stages
