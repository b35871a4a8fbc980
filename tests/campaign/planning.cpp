// SPDX-License-Identifier: Apache-2.0
#include "planning.hpp"

#include <stdexcept>

#include "krait/krait.hpp"

namespace krait::campaign {
namespace {

constexpr std::uint64_t kSlice = 8;  // expansions between looks at the work

std::string text_of(const Failure& failure) {
  const bool argument = failure.status == Status::bad_argument || failure.status == Status::bad_robot;
  return to_string(failure.status) +
         (argument ? std::string(": ") + to_string(static_cast<Argument>(failure.element)) : std::string());
}

// The block is as a program leaves it that plans again and again.
std::uint64_t* block(std::uint64_t bytes) {
  static std::vector<std::uint64_t> words;
  if (words.size() < (bytes + 7) / 8) words.resize((bytes + 7) / 8, 0xA5A5A5A5A5A5A5A5ULL);
  return words.data();
}

void copy(const Plan& plan, PlanRecord& record) {
  record.dt = plan.dt();
  PlanCursor at = plan.cursor();
  for (; !at.done(); at.advance()) {
    record.states.insert(record.states.end(), at.state(), at.state() + plan.state_size());
    record.controls.insert(record.controls.end(), at.control(), at.control() + plan.control_size());
  }
  record.states.insert(record.states.end(), at.state(), at.state() + plan.state_size());
}

template <class R>
Planned plan_with(R robot, const Scene& scene, const Query& query) {
  for (std::size_t k = 0; k < query.robot.own_bodies.size(); ++k) {
    const std::vector<Vec2>& body = query.robot.own_bodies[k];
    robot.set_body(static_cast<int>(k), {body.data(), static_cast<int>(body.size())});
  }
  Planner planner;
  const Limits limits{.iterations = query.iterations};
  Planned result;
  const Failure ready = planner.init({block(query.bytes), query.bytes, &scene, robot}, query.parameters, limits);
  if (!ready.ok()) {
    result.end = text_of(ready);
    return result;
  }
  (void)planner.start({query.start.data(), query.goal, query.seed});
  const auto bodies = static_cast<std::uint64_t>(robot.body_count());
  while (planner.advance(kSlice) == Status::searching && planner.statistics().collision_checks * bodies < query.work) {
  }
  result.solved = planner.status() == Status::solved;
  result.end = planner.status() == Status::searching ? "work_used" : text_of(planner.failure());
  if (result.solved) copy(planner.plan(), result.plan);
  return result;
}

}  // namespace

Planned plan(const Scene& scene, const Query& query) {
#define KRAIT_PLAN(name, Class, file, trailers) \
  case Model::name:                             \
    return plan_with(Class(query.robot.parameters<Class::Parameters>()), scene, query);
  switch (query.robot.model) { KRAIT_MODELS(KRAIT_PLAN) }
#undef KRAIT_PLAN
  throw std::logic_error("a model that nothing plans for");
}

}  // namespace krait::campaign
