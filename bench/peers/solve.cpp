// SPDX-License-Identifier: Apache-2.0
#include "peers/solve.hpp"

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/control/PathControl.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "host/run/query.hpp"
#include "motion/rk4.hpp"
#include "peers/controls.hpp"
#include "peers/motion.hpp"
#include "peers/space.hpp"

namespace krait::bench {
namespace {

namespace ob = ompl::base;
namespace oc = ompl::control;

using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

PeerProblem problem_of(const PeerPlanner& planner, const PeerRobot& robot, const Scene& scene,
                       const host::ResolvedQuery& query, const Parameters& parameters, const PeerTuning& tuning) {
  const float deepest = query.goal.deepest(scene);
  const float depth = parameters.goal_margin < deepest ? parameters.goal_margin : deepest;
  return {robot, scene, query.goal, depth, parameters, planner.controls, tuning};
}

// An objective that the first plan satisfies: SST would go on improving it.
ob::OptimizationObjectivePtr any_solution(const oc::SpaceInformationPtr& space) {
  auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(space);
  objective->setCostThreshold(objective->infiniteCost());
  return objective;
}

// OMPL's objects for one search.
class PeerSearch {
 public:
  PeerSearch(const PeerPlanner& planner, const PeerProblem& problem, const std::vector<float>& start)
      : problem_(problem), motion_(problem, planner.stop) {
    const auto states = std::make_shared<PeerSpace>(problem);
    space_ = std::make_shared<oc::SpaceInformation>(states, control_space(states, problem));
    space_->setStatePropagator(std::make_shared<PeerPropagator>(space_, motion_));
    space_->setStateValidityChecker(std::make_shared<PeerValidity>(space_, motion_));
    space_->setPropagationStepSize(static_cast<double>(problem.parameters.dt));
    space_->setMinMaxControlDuration(1, static_cast<unsigned int>(problem.tuning.max_steps));
    if (planner.controls == ControlKind::pid) {
      space_->setDirectedControlSamplerAllocator(
          [&problem](const oc::SpaceInformation* space) { return steering_sampler(space, problem); });
    }
    space_->setup();
    definition_ = std::make_shared<ob::ProblemDefinition>(space_);
    ob::ScopedState<PeerSpace> first(states);
    std::copy(start.begin(), start.end(), peer(first.get()).values);
    peer(first.get()).origin = PeerState::kSampled;
    definition_->addStartState(first);
    definition_->setGoal(std::make_shared<PeerGoal>(space_, problem));
    definition_->setOptimizationObjective(any_solution(space_));
    planner_ = planner.make(space_, problem);
    planner_->setProblemDefinition(definition_);
    planner_->setup();
  }

  // Whether a plan was found.
  bool run(double seconds) {
    planner_->solve(ob::timedPlannerTerminationCondition(seconds));
    return definition_->hasExactSolution();
  }

  bool start_is_free() { return space_->isValid(definition_->getStartState(0)); }
  std::uint64_t checks() const { return motion_.checks(); }

  // The plan step by step, by the same arithmetic as in the search.
  void take_plan_out(host::PlanFile& plan) const {
    const auto& path = *definition_->getSolutionPath()->as<oc::PathControl>();
    const Robot robot = problem_.robot.core();
    const auto size = static_cast<std::size_t>(robot.state_size());
    std::vector<float> state(peer(path.getState(0)).values, peer(path.getState(0)).values + size);
    std::vector<float> held(static_cast<std::size_t>(robot.control_size()));
    plan.states.push_back(state);
    for (std::size_t i = 0; i < path.getControlCount(); ++i) {
      const long steps = std::lround(path.getControlDuration(static_cast<unsigned int>(i)) / plan.dt);
      for (long step = 0; step < steps && !in_goal(problem_, {state[0], state[1]}); ++step) {
        robot_control(problem_, state.data(), path.getControl(static_cast<unsigned int>(i)), held.data());
        std::vector<float> next(size);
        detail::propagate(robot, state.data(), held.data(), problem_.parameters.dt, next.data());
        state = next;
        plan.controls.push_back(held);
        plan.states.push_back(state);
      }
    }
  }

 private:
  const PeerProblem& problem_;
  PeerMotion motion_;
  oc::SpaceInformationPtr space_;
  ob::ProblemDefinitionPtr definition_;
  ob::PlannerPtr planner_;
};

double length_of(const host::PlanFile& plan) {
  double sum = 0;
  for (std::size_t i = 1; i < plan.states.size(); ++i) {
    sum += std::hypot(static_cast<double>(plan.states[i][0] - plan.states[i - 1][0]),
                      static_cast<double>(plan.states[i][1] - plan.states[i - 1][1]));
  }
  return sum;
}

nlohmann::ordered_json statistics_of(const host::PlanFile& plan, double seconds, std::uint64_t checks) {
  return {{"time_s", seconds},
          {"collision_checks", checks},
          {"plan_steps", plan.controls.size()},
          {"plan_length_m", length_of(plan)},
          {"plan_duration_s", plan.dt * static_cast<double>(plan.controls.size())}};
}

}  // namespace

host::SearchResult solve(const PeerPlanner& planner, const PeerTuning& tuning, const std::string& scene_path,
                         const host::SceneBytes& bytes, const host::SearchRequest& request) {
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(request.seed));
  const Clock::time_point begin = Clock::now();
  const Scene scene = host::open_scene(scene_path, bytes);
  const PeerRobot robot(request.robot);
  const host::ResolvedQuery query = host::resolve(scene, robot.core(), request);
  const PeerProblem problem = problem_of(planner, robot, scene, query, request.parameters, tuning);
  PeerSearch search(planner, problem, query.start);
  if (!search.start_is_free()) throw host::InputError("start_in_collision: the robot cannot stand at the start");
  const bool solved = search.run(request.time_limit.value_or(std::numeric_limits<double>::infinity()));
  host::SearchResult result{query.form, query.asked, 0};
  result.plan.status = to_string(solved ? Status::solved : Status::time_used);
  if (solved) search.take_plan_out(result.plan);
  result.seconds = since(begin);
  result.plan.statistics =
      std::make_shared<const nlohmann::ordered_json>(statistics_of(result.plan, result.seconds, search.checks()));
  return result;
}

}  // namespace krait::bench
