// SPDX-License-Identifier: Apache-2.0
#include "peers/planners.hpp"

#include <ompl/control/planners/est/EST.h>
#include <ompl/control/planners/kpiece/KPIECE1.h>
#include <ompl/control/planners/pdst/PDST.h>
#include <ompl/control/planners/rrt/RRT.h>
#include <ompl/control/planners/sst/SST.h>
#include <ompl/control/planners/syclop/SyclopEST.h>
#include <ompl/control/planners/syclop/SyclopRRT.h>

#include <limits>

#include "host/workspace/workspace.hpp"
#include "peers/decompositions.hpp"

namespace krait::bench {
namespace {

namespace ob = ompl::base;
namespace oc = ompl::control;

using Space = oc::SpaceInformationPtr;

constexpr int kCellsASide = 32;
constexpr double kRange = 20;           // m, EST samples so near
constexpr double kSelectionRadius = 1;  // m
constexpr double kPruningRadius = 0.3;  // m
constexpr int kGridSamples = 10'000;    // to estimate which cells are free; triangles are

ob::PlannerPtr make_rrt(const Space& space, const PeerProblem&) {
  auto planner = std::make_shared<oc::RRT>(space);
  planner->setGoalBias(kGoalBias);
  planner->setIntermediateStates(true);
  return planner;
}

ob::PlannerPtr make_kpiece(const Space& space, const PeerProblem&) { return std::make_shared<oc::KPIECE1>(space); }

ob::PlannerPtr make_est(const Space& space, const PeerProblem&) {
  auto planner = std::make_shared<oc::EST>(space);
  planner->setRange(kRange);
  return planner;
}

ob::PlannerPtr make_pdst(const Space& space, const PeerProblem&) { return std::make_shared<oc::PDST>(space); }

ob::PlannerPtr make_sst(const Space& space, const PeerProblem&) {
  auto planner = std::make_shared<oc::SST>(space);
  planner->setSelectionRadius(kSelectionRadius);
  planner->setPruningRadius(kPruningRadius);
  return planner;
}

template <class Planner>
ob::PlannerPtr make_syclop_on_triangles(const Space& space, const PeerProblem& problem) {
  auto planner = std::make_shared<Planner>(space, std::make_shared<TriangleDecomposition>(problem));
  planner->setNumFreeVolumeSamples(0);
  return planner;
}

template <class Planner>
ob::PlannerPtr make_syclop_on_grid(const Space& space, const PeerProblem& problem) {
  auto planner = std::make_shared<Planner>(space, std::make_shared<SquareDecomposition>(problem, kCellsASide));
  planner->setNumFreeVolumeSamples(kGridSamples);
  return planner;
}

}  // namespace

const std::vector<PeerPlanner>& peer_planners() {
  constexpr ControlKind pid = ControlKind::pid;
  constexpr ControlKind random = ControlKind::random;
  static const std::vector<PeerPlanner> planners = {
      {"RRT", pid, 0, Stop::at_target, 40, make_rrt, "every step a vertex, goal bias 5 %"},
      {"KPIECE1", pid, 0, Stop::in_goal, 40, make_kpiece, "cells of the robot's length, OMPL's factors"},
      {"EST", pid, 0, Stop::in_goal, 40, make_est, "range 20 m, cells of the robot's length"},
      {"PDST", pid, 0, Stop::in_goal, 40, make_pdst, "on the plane, goal bias 5 %"},
      {"SST", pid, 1, Stop::never, 40, make_sst, "selection radius 1 m, pruning radius 0.3 m, a radian counts as 1 m"},
      {"SyclopRRT", pid, 0, Stop::in_goal, 10, make_syclop_on_triangles<oc::SyclopRRT>, "on our triangles"},
      {"SyclopEST", pid, 0, Stop::in_goal, 40, make_syclop_on_triangles<oc::SyclopEST>, "on our triangles"},
      {"SyclopRRT-grid", pid, 0, Stop::in_goal, 10, make_syclop_on_grid<oc::SyclopRRT>, "on 32 x 32 cells"},
      {"SyclopEST-grid", pid, 0, Stop::in_goal, 40, make_syclop_on_grid<oc::SyclopEST>, "on 32 x 32 cells"},
      {"RRT-random", random, 0, Stop::in_goal, 20, make_rrt, "RRT with the robot's own controls at random"},
      {"KPIECE1-random", random, 0, Stop::in_goal, 20, make_kpiece, "KPIECE1 with the robot's own controls at random"},
      {"EST-random", random, 0, Stop::in_goal, 20, make_est, "EST with the robot's own controls at random"},
      {"PDST-random", random, 0, Stop::in_goal, 20, make_pdst, "PDST with the robot's own controls at random"},
      {"SST-random", random, 1, Stop::never, 20, make_sst, "SST with the robot's own controls at random"},
      {"SyclopRRT-random", random, 0, Stop::in_goal, 20, make_syclop_on_triangles<oc::SyclopRRT>,
       "SyclopRRT with the robot's own controls at random"},
      {"SyclopEST-random", random, 0, Stop::in_goal, 20, make_syclop_on_triangles<oc::SyclopEST>,
       "SyclopEST with the robot's own controls at random"}};
  return planners;
}

const PeerPlanner& peer_planner(const std::string& name) {
  std::string known;
  for (const PeerPlanner& planner : peer_planners()) {
    if (name == planner.name) return planner;
    known += (known.empty() ? "" : ", ") + std::string(planner.name);
  }
  throw host::InputError("no peer '" + name + "' (there is: " + known + ")");
}

}  // namespace krait::bench
