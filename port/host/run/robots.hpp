// SPDX-License-Identifier: Apache-2.0
// From a robot's specification to the core's robot.
#pragma once

#include <utility>

#include "host/robot_file/robot_file.hpp"
#include "host/run/work.hpp"
#include "krait/krait.hpp"

namespace krait::host {

ChainParameters chain_parameters(const RobotSpec& spec);
UnicycleParameters unicycle_parameters(const RobotSpec& spec);
DifferentialDriveParameters differential_drive_parameters(const RobotSpec& spec);

// Gives the robot the specification's bodies.
template <class R>
R with_bodies(R robot, const RobotSpec& spec) {
  for (std::size_t k = 0; k < spec.bodies.size(); ++k) {
    Vec2 vertices[kMaxVertices];
    int count = 0;
    for (const Point& p : spec.bodies[k]) {
      if (count < kMaxVertices) vertices[count++] = {static_cast<float>(p.x), static_cast<float>(p.y)};
    }
    robot.set_body(static_cast<int>(k), {vertices, count});
  }
  return robot;
}

// What `use` returns for the core's robot of the specification.
template <class Use>
auto with_core_robot(const RobotSpec& spec, const Use& use) {
  if (spec.model == "unicycle") return use(with_bodies(Unicycle(unicycle_parameters(spec)), spec));
  if (spec.model == "diff_drive") return use(with_bodies(DifferentialDrive(differential_drive_parameters(spec)), spec));
  if (spec.model == "car") return use(with_bodies(Car(chain_parameters(spec)), spec));
  if (spec.model == "truck") return use(with_bodies(Truck(chain_parameters(spec)), spec));
  return use(with_bodies(Snake(chain_parameters(spec)), spec));
}

// What work_bound needs to know of a robot.
RobotExtent extent_of(const RobotSpec& spec, const Parameters& parameters);

}  // namespace krait::host
