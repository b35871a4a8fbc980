// SPDX-License-Identifier: Apache-2.0
// The robot's states for OMPL: their distance, samples (bodies in a line that drive straight on) and projection to the
// plane.
#pragma once

#include <ompl/base/ProjectionEvaluator.h>
#include <ompl/base/StateSpace.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/control/SpaceInformation.h>
#include <ompl/util/RandomNumbers.h>

#include "peers/problem.hpp"

namespace krait::bench {

// Distance: metres between positions, plus what the tuning lets the headings and the other components count.
class PeerSpace : public ompl::base::StateSpace {
 public:
  explicit PeerSpace(const PeerProblem& problem);

  unsigned int getDimension() const override;
  double getMaximumExtent() const override;
  double getMeasure() const override;
  void enforceBounds(ompl::base::State*) const override {}
  bool satisfiesBounds(const ompl::base::State* state) const override;
  void copyState(ompl::base::State* destination, const ompl::base::State* source) const override;
  double distance(const ompl::base::State* a, const ompl::base::State* b) const override;
  bool equalStates(const ompl::base::State* a, const ompl::base::State* b) const override;
  void interpolate(const ompl::base::State* from, const ompl::base::State* to, double t,
                   ompl::base::State* state) const override;
  ompl::base::StateSamplerPtr allocDefaultStateSampler() const override;
  ompl::base::State* allocState() const override;
  void freeState(ompl::base::State* state) const override;
  // Cells of the robot's length.
  void registerProjections() override;

 private:
  double rest_apart(const ompl::base::State* a, const ompl::base::State* b) const;

  const PeerProblem& problem_;
  const Robot robot_;
  double heading_weight_;
  double rest_weight_;
};

// A state that no step has reached: PeerRobot::drive_straight.
void place_straight(const PeerProblem& problem, Vec2 at, float heading, float speed_share, PeerState& state);

class PeerGoal : public ompl::base::GoalSampleableRegion {
 public:
  PeerGoal(const ompl::control::SpaceInformationPtr& space, const PeerProblem& problem);

  double distanceGoal(const ompl::base::State* state) const override;
  void sampleGoal(ompl::base::State* state) const override;
  unsigned int maxSampleCount() const override { return kSamples; }

 private:
  static constexpr unsigned int kSamples = 100;

  const PeerProblem& problem_;
  mutable ompl::RNG rng_;
};

}  // namespace krait::bench
