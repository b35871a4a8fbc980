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

#include "peers/decompositions.hpp"
#include "trials/named.hpp"

namespace krait::bench {
namespace {

namespace ob = ompl::base;
namespace oc = ompl::control;

using Space = oc::SpaceInformationPtr;

constexpr int kGridSamples = 10'000;  // to estimate which cells are free; triangles are

ob::PlannerPtr make_rrt(const Space& space, const PeerProblem& problem) {
  auto planner = std::make_shared<oc::RRT>(space);
  planner->setGoalBias(problem.tuning.goal_bias);
  planner->setIntermediateStates(true);
  return planner;
}

ob::PlannerPtr make_kpiece(const Space& space, const PeerProblem&) { return std::make_shared<oc::KPIECE1>(space); }

ob::PlannerPtr make_est(const Space& space, const PeerProblem& problem) {
  auto planner = std::make_shared<oc::EST>(space);
  planner->setRange(problem.tuning.range);
  return planner;
}

ob::PlannerPtr make_pdst(const Space& space, const PeerProblem&) { return std::make_shared<oc::PDST>(space); }

ob::PlannerPtr make_sst(const Space& space, const PeerProblem& problem) {
  auto planner = std::make_shared<oc::SST>(space);
  planner->setSelectionRadius(problem.tuning.selection_radius);
  planner->setPruningRadius(problem.tuning.pruning_radius);
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
  const auto cells = static_cast<int>(problem.tuning.cells_a_side);
  auto planner = std::make_shared<Planner>(space, std::make_shared<SquareDecomposition>(problem, cells));
  planner->setNumFreeVolumeSamples(kGridSamples);
  return planner;
}

struct Setting {
  const char* name;
  double PeerTuning::*member;
  double least;
  double most;
};

constexpr Setting kSettings[] = {{"goal_bias", &PeerTuning::goal_bias, 0, 1},
                                 {"max_steps", &PeerTuning::max_steps, 1, 1000},
                                 {"slowest", &PeerTuning::slowest, 0.05, 1},
                                 {"stop_at_target", &PeerTuning::stop_at_target, 0, 1},
                                 {"gentle_share", &PeerTuning::gentle_share, 0, 1},
                                 {"heading_weight", &PeerTuning::heading_weight, 0, 100},
                                 {"range", &PeerTuning::range, 0.1, 1000},
                                 {"selection_radius", &PeerTuning::selection_radius, 0.001, 100},
                                 {"pruning_radius", &PeerTuning::pruning_radius, 0.001, 100},
                                 {"cells_a_side", &PeerTuning::cells_a_side, 1, 1000},
                                 {"cell_lengths", &PeerTuning::cell_lengths, 0.01, 100}};

// The planner with the robot's own controls at random instead of targets that it steers to.
PeerPlanner with_random_controls(PeerPlanner planner) {
  planner.description = planner.name + " with the robot's own controls at random";
  planner.name += "-random";
  planner.controls = ControlKind::random;
  planner.tuning = {
      .max_steps = 20, .heading_weight = planner.tuning.heading_weight, .rest_weight = planner.tuning.rest_weight};
  return planner;
}

std::vector<PeerPlanner> all_planners() {
  constexpr ControlKind pid = ControlKind::pid;
  std::vector<PeerPlanner> planners = {
      {"RRT",
       pid,
       Stop::in_goal,
       {.stop_at_target = 1, .gentle_share = 0.2},
       make_rrt,
       "every step a vertex, goal bias 5 %"},
      {"KPIECE1",
       pid,
       Stop::in_goal,
       {.gentle_share = 0.2},
       make_kpiece,
       "cells of the robot's length, OMPL's factors"},
      {"EST",
       pid,
       Stop::in_goal,
       {.stop_at_target = 1, .gentle_share = 0.2, .cell_lengths = 2},
       make_est,
       "range 20 m, cells of twice the robot's length"},
      // It looks a motion's states up by their distance. Those of a robot that turns on the spot differ in no position.
      {"PDST",
       pid,
       Stop::in_goal,
       {.gentle_share = 0.2, .heading_weight = 1, .rest_weight = 1},
       make_pdst,
       "on the plane, goal bias 5 %"},
      {"SST",
       pid,
       Stop::never,
       {.max_steps = 80, .heading_weight = 1},
       make_sst,
       "selection radius 1 m, pruning radius 0.3 m, a radian counts as 1 m"},
      {"SyclopRRT",
       pid,
       Stop::in_goal,
       {.max_steps = 5, .gentle_share = 0.2},
       make_syclop_on_triangles<oc::SyclopRRT>,
       "on our triangles"},
      {"SyclopEST",
       pid,
       Stop::in_goal,
       {.stop_at_target = 1, .gentle_share = 0.2},
       make_syclop_on_triangles<oc::SyclopEST>,
       "on our triangles"},
      {"SyclopRRT-grid",
       pid,
       Stop::in_goal,
       {.max_steps = 5, .gentle_share = 0.2},
       make_syclop_on_grid<oc::SyclopRRT>,
       "on 32 x 32 cells"},
      {"SyclopEST-grid",
       pid,
       Stop::in_goal,
       {.stop_at_target = 1, .gentle_share = 0.2},
       make_syclop_on_grid<oc::SyclopEST>,
       "on 32 x 32 cells"}};
  const std::size_t steered = planners.size();
  for (std::size_t i = 0; i < steered; ++i) {
    if (!planners[i].name.ends_with("-grid")) planners.push_back(with_random_controls(planners[i]));
  }
  return planners;
}

}  // namespace

const std::vector<PeerPlanner>& peer_planners() {
  static const std::vector<PeerPlanner> planners = all_planners();
  return planners;
}

const PeerPlanner& peer_planner(const std::string& name) { return named(peer_planners(), "peer", name); }

PeerTuning tuned(const PeerPlanner& planner, const std::map<std::string, double>& settings) {
  PeerTuning tuning = planner.tuning;
  for (const auto& [name, value] : settings) {
    const Setting& setting = named(kSettings, "setting", name);
    refuse_outside(name, value, setting.least, setting.most);
    tuning.*setting.member = value;
  }
  return tuning;
}

}  // namespace krait::bench
