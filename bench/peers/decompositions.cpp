// SPDX-License-Identifier: Apache-2.0
#include "peers/decompositions.hpp"

#include <cmath>

#include "decomposition/locate.hpp"

namespace krait::bench {
namespace {

namespace ob = ompl::base;

ob::RealVectorBounds plane_bounds(const Scene& scene) {
  const Box box = scene.bounds();
  ob::RealVectorBounds bounds(2);
  bounds.low = {static_cast<double>(box.min.x), static_cast<double>(box.min.y)};
  bounds.high = {static_cast<double>(box.max.x), static_cast<double>(box.max.y)};
  return bounds;
}

void position_of(const ob::State* state, std::vector<double>& coordinates) {
  const Vec2 at = peer(state).position();
  coordinates = {static_cast<double>(at.x), static_cast<double>(at.y)};
}

void state_at(const ob::StateSamplerPtr& sampler, const std::vector<double>& coordinates, ob::State* state) {
  sampler->sampleUniform(state);
  peer(state).values[0] = static_cast<float>(coordinates[0]);
  peer(state).values[1] = static_cast<float>(coordinates[1]);
}

}  // namespace

TriangleDecomposition::TriangleDecomposition(const PeerProblem& problem)
    : Decomposition(2, plane_bounds(problem.scene)), problem_(problem) {}

double TriangleDecomposition::getRegionVolume(int region) {
  const auto triangle = static_cast<Index>(region);
  const Scene& scene = problem_.scene;
  const Vec2 a = scene.corner(triangle, 0);
  return 0.5 * static_cast<double>(cross(scene.corner(triangle, 1) - a, scene.corner(triangle, 2) - a));
}

int TriangleDecomposition::locateRegion(const ob::State* state) const {
  const Index triangle = detail::locate(problem_.scene, peer(state).position());
  return triangle == kNone ? -1 : static_cast<int>(triangle);
}

void TriangleDecomposition::project(const ob::State* state, std::vector<double>& coordinates) const {
  position_of(state, coordinates);
}

void TriangleDecomposition::getNeighbors(int region, std::vector<int>& neighbors) const {
  const auto triangle = static_cast<Index>(region);
  for (int edge = 0; edge < 3; ++edge) {
    const Index neighbor = problem_.scene.neighbor(triangle, edge);
    if (neighbor == kNone) continue;
    const float width = problem_.scene.portal_width(problem_.scene.portal(triangle, edge));
    if (width >= problem_.robot.width()) neighbors.push_back(static_cast<int>(neighbor));
  }
}

void TriangleDecomposition::sampleFromRegion(int region, ompl::RNG& rng, std::vector<double>& coordinates) const {
  const auto triangle = static_cast<Index>(region);
  const double root = std::sqrt(rng.uniform01());
  const double share = rng.uniform01();
  const Scene& scene = problem_.scene;
  const Vec2 a = scene.corner(triangle, 0);
  const Vec2 at = a + static_cast<float>(root * (1 - share)) * (scene.corner(triangle, 1) - a) +
                  static_cast<float>(root * share) * (scene.corner(triangle, 2) - a);
  coordinates = {static_cast<double>(at.x), static_cast<double>(at.y)};
}

void TriangleDecomposition::sampleFullState(const ob::StateSamplerPtr& sampler, const std::vector<double>& coordinates,
                                            ob::State* state) const {
  state_at(sampler, coordinates, state);
}

SquareDecomposition::SquareDecomposition(const PeerProblem& problem, int cells_a_side)
    : GridDecomposition(cells_a_side, 2, plane_bounds(problem.scene)) {}

void SquareDecomposition::project(const ob::State* state, std::vector<double>& coordinates) const {
  position_of(state, coordinates);
}

void SquareDecomposition::sampleFullState(const ob::StateSamplerPtr& sampler, const std::vector<double>& coordinates,
                                          ob::State* state) const {
  state_at(sampler, coordinates, state);
}

}  // namespace krait::bench
