// SPDX-License-Identifier: Apache-2.0
#include "peers/controls.hpp"

#include <ompl/control/SpaceInformation.h>
#include <ompl/util/RandomNumbers.h>

namespace krait::bench {
namespace {

namespace ob = ompl::base;
namespace oc = ompl::control;

constexpr double kGentlest = 0.15;  // of the sharpest turn, as krait's own gentle turns

using ValueControl = oc::RealVectorControlSpace::ControlType;

// The share of the sharpest turn that a control may have.
double random_turn(ompl::RNG& rng, const PeerTuning& tuning) {
  return rng.uniform01() < tuning.gentle_share ? rng.uniformReal(kGentlest, 1.0) : 1.0;
}

class SteeringSampler : public oc::DirectedControlSampler {
 public:
  SteeringSampler(const oc::SpaceInformation* space, const PeerProblem& problem)
      : DirectedControlSampler(space), problem_(problem) {}

  unsigned int sampleTo(oc::Control* control, const ob::State* source, ob::State* dest) override {
    double* values = control->as<ValueControl>()->values;
    values[0] = static_cast<double>(peer(dest).position().x);
    values[1] = static_cast<double>(peer(dest).position().y);
    values[2] = rng_.uniformReal(problem_.tuning.slowest, 1.0);
    values[3] = random_turn(rng_, problem_.tuning);
    const int steps = rng_.uniformInt(1, static_cast<int>(si_->getMaxControlDuration()));
    return si_->propagateWhileValid(source, control, steps, dest);
  }

  unsigned int sampleTo(oc::Control* control, const oc::Control*, const ob::State* source, ob::State* dest) override {
    return sampleTo(control, source, dest);
  }

 private:
  const PeerProblem& problem_;
  ompl::RNG rng_;
};

// Targets all over the workspace, now and then the goal: for planners that draw controls without a direction.
class TargetSampler : public oc::RealVectorControlUniformSampler {
 public:
  TargetSampler(const oc::ControlSpace* space, const PeerProblem& problem)
      : RealVectorControlUniformSampler(space), problem_(problem) {}

  void sample(oc::Control* control) override {
    RealVectorControlUniformSampler::sample(control);
    double* values = control->as<ValueControl>()->values;
    values[3] = random_turn(rng_, problem_.tuning);
    if (rng_.uniform01() >= problem_.tuning.goal_bias) return;
    const Vec2 center = goal_center(problem_);
    values[0] = static_cast<double>(center.x);
    values[1] = static_cast<double>(center.y);
  }

 private:
  const PeerProblem& problem_;
};

ob::RealVectorBounds control_bounds(const PeerProblem& problem) {
  if (problem.controls == ControlKind::pid) {
    const Box box = problem.scene.bounds();
    ob::RealVectorBounds bounds(4);
    bounds.low = {static_cast<double>(box.min.x), static_cast<double>(box.min.y), problem.tuning.slowest, kGentlest};
    bounds.high = {static_cast<double>(box.max.x), static_cast<double>(box.max.y), 1.0, 1.0};
    return bounds;
  }
  ob::RealVectorBounds bounds(0);
  for (const ControlAxis& axis : problem.robot.axes()) {
    bounds.low.push_back(static_cast<double>(axis.low));
    bounds.high.push_back(static_cast<double>(axis.high));
  }
  return bounds;
}

}  // namespace

oc::ControlSpacePtr control_space(const ob::StateSpacePtr& states, const PeerProblem& problem) {
  const ob::RealVectorBounds bounds = control_bounds(problem);
  auto space = std::make_shared<oc::RealVectorControlSpace>(states, static_cast<unsigned int>(bounds.low.size()));
  space->setBounds(bounds);
  if (problem.controls == ControlKind::pid) {
    space->setControlSamplerAllocator(
        [&problem](const oc::ControlSpace* controls) { return std::make_shared<TargetSampler>(controls, problem); });
  }
  return space;
}

oc::DirectedControlSamplerPtr steering_sampler(const oc::SpaceInformation* space, const PeerProblem& problem) {
  return std::make_shared<SteeringSampler>(space, problem);
}

}  // namespace krait::bench
