// SPDX-License-Identifier: Apache-2.0
#include "peers/space.hpp"

#include <cmath>
#include <cstring>

#include "krait/math.hpp"
#include "robot/shape.hpp"

namespace krait::bench {
namespace {

namespace ob = ompl::base;

Vec2 extent(const Scene& scene) { return scene.bounds().max - scene.bounds().min; }

float uniform(ompl::RNG& rng, float low, float high) {
  return static_cast<float>(rng.uniformReal(static_cast<double>(low), static_cast<double>(high)));
}

class StraightSampler : public ob::StateSampler {
 public:
  StraightSampler(const ob::StateSpace* space, const PeerProblem& problem)
      : StateSampler(space), problem_(problem), bounds_(problem.scene.bounds()) {}

  void sampleUniform(ob::State* state) override { place(bounds_.min, bounds_.max, state); }

  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    const Vec2 reach{static_cast<float>(distance), static_cast<float>(distance)};
    place(peer(near).position() - reach, peer(near).position() + reach, state);
  }

  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    sampleUniformNear(state, mean, deviation);
  }

 private:
  void place(Vec2 low, Vec2 high, ob::State* state) {
    Vec2 at;
    at.x = math::clamp(uniform(rng_, low.x, high.x), bounds_.min.x, bounds_.max.x);
    at.y = math::clamp(uniform(rng_, low.y, high.y), bounds_.min.y, bounds_.max.y);
    const float heading = uniform(rng_, -kPi, kPi);
    place_straight(problem_, at, heading, uniform(rng_, 0.0F, 1.0F), peer(state));
  }

  const PeerProblem& problem_;
  const Box bounds_;
};

class PositionProjection : public ob::ProjectionEvaluator {
 public:
  PositionProjection(const ob::StateSpace* space, const PeerProblem& problem)
      : ProjectionEvaluator(space), problem_(problem) {}

  unsigned int getDimension() const override { return 2; }
  void defaultCellSizes() override {
    cellSizes_.assign(2,
                      problem_.tuning.cell_lengths * static_cast<double>(detail::robot_length(problem_.robot.core())));
    const Box bounds = problem_.scene.bounds();
    bounds_.resize(2);
    bounds_.low = {static_cast<double>(bounds.min.x), static_cast<double>(bounds.min.y)};
    bounds_.high = {static_cast<double>(bounds.max.x), static_cast<double>(bounds.max.y)};
  }
  void project(const ob::State* state, Eigen::Ref<Eigen::VectorXd> projection) const override {
    const Vec2 at = peer(state).position();
    projection[0] = static_cast<double>(at.x);
    projection[1] = static_cast<double>(at.y);
  }

 private:
  const PeerProblem& problem_;
};

}  // namespace

void place_straight(const PeerProblem& problem, Vec2 at, float heading, float speed_share, PeerState& state) {
  problem.robot.drive_straight(at, heading, speed_share, state.values);
  state.origin = PeerState::kSampled;
}

PeerSpace::PeerSpace(const PeerProblem& problem)
    : problem_(problem),
      robot_(problem.robot.core()),
      heading_weight_(problem.tuning.heading_weight),
      rest_weight_(problem.tuning.rest_weight) {
  setName("robot");
}

unsigned int PeerSpace::getDimension() const { return static_cast<unsigned int>(robot_.state_size()); }

double PeerSpace::getMaximumExtent() const {
  return static_cast<double>(length(extent(problem_.scene))) + heading_weight_ * M_PI;
}

double PeerSpace::getMeasure() const {
  const Vec2 size = extent(problem_.scene);
  return static_cast<double>(size.x) * static_cast<double>(size.y);
}

bool PeerSpace::satisfiesBounds(const ob::State* state) const {
  return problem_.scene.inside_bounds(peer(state).position()) && robot_.within_limits(peer(state).values);
}

void PeerSpace::copyState(ob::State* destination, const ob::State* source) const {
  std::memcpy(peer(destination).values, peer(source).values, getDimension() * sizeof(float));
  peer(destination).origin = peer(source).origin;
}

// By the components behind position and heading.
double PeerSpace::rest_apart(const ob::State* a, const ob::State* b) const {
  double sum = 0;
  for (unsigned int i = 3; i < getDimension(); ++i) {
    sum += std::abs(static_cast<double>(peer(a).values[i] - peer(b).values[i]));
  }
  return sum;
}

double PeerSpace::distance(const ob::State* a, const ob::State* b) const {
  auto sum = static_cast<double>(length(peer(a).position() - peer(b).position()));
  if (heading_weight_ != 0) {
    const double turn = std::remainder(static_cast<double>(peer(a).values[2] - peer(b).values[2]), 2 * M_PI);
    sum += heading_weight_ * std::abs(turn);
  }
  if (rest_weight_ != 0) sum += rest_weight_ * rest_apart(a, b);
  return sum;
}

bool PeerSpace::equalStates(const ob::State* a, const ob::State* b) const {
  return std::memcmp(peer(a).values, peer(b).values, getDimension() * sizeof(float)) == 0;
}

void PeerSpace::interpolate(const ob::State* from, const ob::State* to, double t, ob::State* state) const {
  const auto share = static_cast<float>(t);
  for (unsigned int i = 0; i < getDimension(); ++i) {
    peer(state).values[i] = peer(from).values[i] + share * (peer(to).values[i] - peer(from).values[i]);
  }
  peer(state).origin = PeerState::kSampled;
}

ob::StateSamplerPtr PeerSpace::allocDefaultStateSampler() const {
  return std::make_shared<StraightSampler>(this, problem_);
}

ob::State* PeerSpace::allocState() const { return new PeerState(); }
void PeerSpace::freeState(ob::State* state) const { delete &peer(state); }

void PeerSpace::registerProjections() {
  registerDefaultProjection(std::make_shared<PositionProjection>(this, problem_));
}

PeerGoal::PeerGoal(const ompl::control::SpaceInformationPtr& space, const PeerProblem& problem)
    : GoalSampleableRegion(space), problem_(problem) {}

double PeerGoal::distanceGoal(const ob::State* state) const {
  const Vec2 at = peer(state).position();
  return in_goal(problem_, at) ? 0.0 : static_cast<double>(length(at - goal_center(problem_))) + threshold_;
}

void PeerGoal::sampleGoal(ob::State* state) const {
  const Box box = goal_box(problem_);
  Vec2 at;
  do {
    at.x = uniform(rng_, box.min.x, box.max.x);
    at.y = uniform(rng_, box.min.y, box.max.y);
  } while (!in_goal(problem_, at));
  place_straight(problem_, at, uniform(rng_, -kPi, kPi), 1.0F, peer(state));
  peer(state).origin = PeerState::kAssumed;
}

}  // namespace krait::bench
