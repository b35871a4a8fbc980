// SPDX-License-Identifier: Apache-2.0
// The robot's motion for OMPL: a step of the core's integrator under a control, and whether that step is free by the
// core's own proof (MotionCheck), which looks at whole steps.
#pragma once

#include <ompl/base/StateValidityChecker.h>
#include <ompl/control/SpaceInformation.h>
#include <ompl/control/StatePropagator.h>
#include <ompl/control/spaces/RealVectorControlSpace.h>

#include "collision/motion_check.hpp"
#include "peers/problem.hpp"
#include "tests/core/in_own_memory.hpp"

namespace krait::bench {

// The robot's own control, held for a step, that a control of OMPL's planners stands for.
void robot_control(const PeerProblem& problem, const float* state, const ompl::control::Control* control, float* held);

// OMPL's planners take a step with propagate and then call isValid on its end. So the last step is remembered, and
// judged only by isValid.
class PeerMotion {
 public:
  PeerMotion(const PeerProblem& problem, Stop stop);

  void take_step(const PeerState& from, const ompl::control::Control* control, PeerState& to);
  bool valid(const PeerState& state);
  // Placements of the robot that were tested.
  std::uint64_t checks() const { return check_.checks(); }

 private:
  struct Step {
    std::uint64_t number = PeerState::kSampled;
    std::uint64_t from_origin;
    float from[kMaxState];
    float target_distance;  // from where the step begins
    float held[kMaxControl];
  };

  bool at_rest_valid(const PeerState& state);
  bool ended_before_last_step() const;
  bool last_step_free(const PeerState& to);

  const PeerProblem& problem_;
  const Robot robot_;
  const Stop stop_;
  test::InOwnMemory<detail::MotionCheck> check_;
  Step last_;
  std::uint64_t proven_ = PeerState::kSampled;  // number of the step that check_ goes on from
};

class PeerPropagator : public ompl::control::StatePropagator {
 public:
  PeerPropagator(const ompl::control::SpaceInformationPtr& space, PeerMotion& motion)
      : StatePropagator(space), motion_(motion) {}

  void propagate(const ompl::base::State* state, const ompl::control::Control* control, double duration,
                 ompl::base::State* result) const override;
  bool canPropagateBackward() const override { return false; }

 private:
  PeerMotion& motion_;
};

class PeerValidity : public ompl::base::StateValidityChecker {
 public:
  PeerValidity(const ompl::control::SpaceInformationPtr& space, PeerMotion& motion)
      : StateValidityChecker(space), motion_(motion) {}

  bool isValid(const ompl::base::State* state) const override { return motion_.valid(peer(state)); }

 private:
  PeerMotion& motion_;
};

}  // namespace krait::bench
