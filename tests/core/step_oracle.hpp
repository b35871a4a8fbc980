// SPDX-License-Identifier: Apache-2.0
// How near a robot comes to anything during a step of its true motion, in double precision.
#pragma once

#include <limits>
#include <vector>

#include "convex.hpp"
#include "krait/robots/detail/defaults.hpp"
#include "robot_oracle.hpp"

namespace krait::test {

inline std::vector<Ring> rings_of_pieces(const Scene& scene) {
  std::vector<Ring> result;
  for (Index p = 0; p < scene.piece_count(); ++p) result.push_back(ring(scene.piece(p)));
  return result;
}

// Least separation of the bodies from the pieces, the bounds and one another in one state.
template <class R>
double separation_of_state(const R& robot, const Scene& scene, const std::vector<Ring>& pieces, const Numbers& state) {
  const auto placed = frames(robot, state);
  const Box b = scene.bounds();
  const Rect bounds{point(b.min).x, point(b.min).y, point(b.max).x, point(b.max).y};
  std::vector<Ring> bodies;
  for (std::size_t k = 0; k < placed.size(); ++k) {
    Ring body;
    for (const Numbers& v : vertices(robot.body(static_cast<int>(k)), placed[k])) body.push_back({v[0], v[1]});
    bodies.push_back(body);
  }
  double least = std::numeric_limits<double>::infinity();
  for (const Ring& body : bodies) {
    least = std::min(least, room_inside(body, bounds));
    for (const Ring& piece : pieces) least = std::min(least, separation(body, piece));
  }
  const auto gap = static_cast<std::size_t>(detail::self_collision_gap(robot));
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + gap; j < bodies.size(); ++j) least = std::min(least, separation(bodies[i], bodies[j]));
  }
  return least;
}

// The same over a whole step, by `parts` sub-steps of the true motion.
template <class R>
double separation_of_step(const R& robot, const Scene& scene, const std::vector<float>& s, const std::vector<float>& u,
                          float dt, int parts) {
  const auto pieces = rings_of_pieces(scene);
  Numbers state = doubles(s);
  double least = separation_of_state(robot, scene, pieces, state);
  for (int i = 0; i < parts; ++i) {
    state = rk4(robot, state, doubles(u), wide(dt) / parts);
    least = std::min(least, separation_of_state(robot, scene, pieces, state));
  }
  return least;
}

}  // namespace krait::test
