// SPDX-License-Identifier: Apache-2.0
// Which controls OMPL's planners try: targets for our controller, or the robot's own at random.
#pragma once

#include <ompl/control/DirectedControlSampler.h>
#include <ompl/control/spaces/RealVectorControlSpace.h>

#include "peers/problem.hpp"

namespace krait::bench {

// ControlKind::pid: (x, y, share of the top speed, share of the sharpest turn); random: the robot's own control.
ompl::control::ControlSpacePtr control_space(const ompl::base::StateSpacePtr& states, const PeerProblem& problem);

// Steers to the sampled state's position, with a random speed and sharpness, until there, in the goal, or at an
// obstacle.
ompl::control::DirectedControlSamplerPtr steering_sampler(const ompl::control::SpaceInformation* space,
                                                          const PeerProblem& problem);

}  // namespace krait::bench
