// SPDX-License-Identifier: Apache-2.0
#include "host/run/depth.hpp"

#include <cmath>

#include "host/picture/poses.hpp"
#include "host/run/local_point.hpp"
#include "host/workspace/ring.hpp"

namespace krait::host {
namespace {

Ring ring_of(Polygon piece) {
  Ring ring;
  for (int i = 0; i < piece.count; ++i) ring.push_back(local_point(piece[i]));
  return ring;
}

}  // namespace

Ring deep_part(Ring ring, const Ring& body, double depth) {
  for (std::size_t i = 0; i < body.size() && !ring.empty(); ++i) {
    const Point a = body[i], b = body[(i + 1) % body.size()];
    const double side = std::hypot(b.x - a.x, b.y - a.y);
    ring = clip(ring, [&](const Point& p) { return cross(a, b, p) / side - depth; });
  }
  return ring;
}

bool reaches_deeper(const RobotSpec& robot, const std::vector<float>& state, const krait::Scene& scene, double depth) {
  const std::vector<Pose> poses = body_poses(robot, state);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const Ring body = placed(robot.bodies[k], {poses[k].x, poses[k].y}, poses[k].heading);
    for (Index piece = 0; piece < scene.piece_count(); ++piece) {
      if (!deep_part(ring_of(scene.piece(piece)), body, depth).empty()) return true;
    }
  }
  return false;
}

}  // namespace krait::host
