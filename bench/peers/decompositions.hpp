// SPDX-License-Identifier: Apache-2.0
// Decompositions of the workspace for Syclop.
#pragma once

#include <ompl/control/planners/syclop/GridDecomposition.h>

#include "peers/problem.hpp"

namespace krait::bench {

// The scene's own triangles, as the core uses them: portals narrower than the robot join nothing.
class TriangleDecomposition : public ompl::control::Decomposition {
 public:
  explicit TriangleDecomposition(const PeerProblem& problem);

  int getNumRegions() const override { return static_cast<int>(problem_.scene.triangle_count()); }
  double getRegionVolume(int region) override;
  int locateRegion(const ompl::base::State* state) const override;
  void project(const ompl::base::State* state, std::vector<double>& coordinates) const override;
  void getNeighbors(int region, std::vector<int>& neighbors) const override;
  void sampleFromRegion(int region, ompl::RNG& rng, std::vector<double>& coordinates) const override;
  void sampleFullState(const ompl::base::StateSamplerPtr& sampler, const std::vector<double>& coordinates,
                       ompl::base::State* state) const override;

 private:
  const PeerProblem& problem_;
};

// Square cells over the bounds, OMPL's own.
class SquareDecomposition : public ompl::control::GridDecomposition {
 public:
  SquareDecomposition(const PeerProblem& problem, int cells_a_side);

  void project(const ompl::base::State* state, std::vector<double>& coordinates) const override;
  void sampleFullState(const ompl::base::StateSamplerPtr& sampler, const std::vector<double>& coordinates,
                       ompl::base::State* state) const override;
};

}  // namespace krait::bench
