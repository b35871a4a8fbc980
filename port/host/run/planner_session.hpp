// SPDX-License-Identifier: Apache-2.0
// The template behind Session, for each planner.
#pragma once

#include <memory>
#include <string>

#include "decomposition/regions.hpp"
#include "firmware/improvement.hpp"
#include "host/run/session.hpp"
#include "search/adaptive_search.hpp"

namespace krait::host {

template <class P>
class PlannerSession : public Session {
 public:
  PlannerSession(const krait::Scene& scene, const SearchRequest& request, Block& block)
      : core_(request.robot), robot_(core_.view()), query_(resolve(scene, robot_, request)) {
    const Setup setup{block.data(), request.memory, &scene, robot_};
    refuse(firmware::init_with_room(planner_, setup, request.parameters, request.iterations, request.improve), scene,
           request);
    (void)planner_.start({query_.start.data(), query_.goal, request.seed});
    refuse(planner_.failure(), scene, request);
    if (planner_.status() == Status::start_in_collision) refuse(planner_.contact(), scene, request);
  }
  // The planner points to the robot.
  PlannerSession(const PlannerSession&) = delete;
  PlannerSession& operator=(const PlannerSession&) = delete;

  Status advance(std::uint64_t iterations) override { return planner_.advance(iterations); }
  Status improve(std::uint64_t iterations) override { return planner_.improve(iterations); }
  void stop_for_time() override { planner_.stop_for_time(); }
  Status status() const override { return planner_.status(); }
  Statistics statistics() const override { return planner_.statistics(); }
  const detail::Regions& regions() const override { return planner_.regions(); }
  Bottleneck bottleneck() override { return planner_.bottleneck(); }
  Effort effort() const override {
    if constexpr (requires { planner_.effort(); }) return planner_.effort();
    return {};
  }
  std::vector<std::vector<float>> states_in([[maybe_unused]] Index region) const override {
    std::vector<std::vector<float>> states;
    if constexpr (requires { planner_.groups(); }) {
      planner_.groups().for_each_vertex(region, [&](Index vertex) {
        const float* const state = planner_.tree().state(vertex);
        states.emplace_back(state, state + robot_.state_size());
      });
    }
    return states;
  }
  const Robot& robot() const override { return robot_; }
  float cost_to_go() const override {
    if constexpr (requires { planner_.cost_to_go(); }) return planner_.cost_to_go();
    return kInfinity;
  }
  Status advance_watched(const Watch& watch) override {
    const auto with_vectors = [&](const float* from, const float* to) {
      const int n = robot_.state_size();
      watch({from, from + n}, {to, to + n});
    };
    return planner_.advance(1, with_vectors);
  }
  void copy_plan(PlanFile& file) const override {
    const Plan plan = planner_.plan();
    if (plan.empty()) return;
    PlanCursor at = plan.cursor();
    for (; !at.done(); at.advance()) {
      file.states.emplace_back(at.state(), at.state() + plan.state_size());
      file.controls.emplace_back(at.control(), at.control() + plan.control_size());
    }
    file.states.emplace_back(at.state(), at.state() + plan.state_size());
  }
  const ResolvedQuery& query() const override { return query_; }

 private:
  CoreRobot core_;
  Robot robot_;
  ResolvedQuery query_;
  P planner_;
};

}  // namespace krait::host
