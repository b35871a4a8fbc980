// SPDX-License-Identifier: Apache-2.0
#include "krait/plan.hpp"

#include <new>
#include <type_traits>

#include "krait/status.hpp"
#include "plan/plan_meter.hpp"
#include "plan/plan_walk.hpp"

namespace krait {
namespace {

using detail::PlanWalk;

PlanWalk& walk_of(std::byte* bytes) { return *std::launder(reinterpret_cast<PlanWalk*>(bytes)); }
const PlanWalk& walk_of(const std::byte* bytes) { return *std::launder(reinterpret_cast<const PlanWalk*>(bytes)); }

detail::PlanMeasures measured(PlanWalk at) {
  detail::PlanMeter meter;
  for (; !at.done(); at.advance()) {
    meter.add(at.state(), at.state_size(), at.control(), at.control_size(), at.next());
  }
  return meter.end(at.state(), at.state_size());
}

}  // namespace

PlanCursor::PlanCursor() {
  static_assert(sizeof(PlanWalk) <= kWalkBytes && alignof(PlanWalk) <= alignof(std::uint64_t));
  static_assert(std::is_trivially_copyable_v<PlanWalk>);
  ::new (walk_) PlanWalk;
}

PlanCursor::PlanCursor(const Robot& robot, const detail::PlanPath& path, const float* start, float dt) {
  ::new (walk_) PlanWalk(robot, path, start, dt);
}

int PlanCursor::state_size() const { return walk_of(walk_).state_size(); }

int PlanCursor::control_size() const { return walk_of(walk_).control_size(); }

bool PlanCursor::done() const { return walk_of(walk_).done(); }

const float* PlanCursor::state() const { return walk_of(walk_).state(); }

const float* PlanCursor::control() const { return walk_of(walk_).control(); }

const float* PlanCursor::next() const { return walk_of(walk_).next(); }

void PlanCursor::advance() { walk_of(walk_).advance(); }

Plan::Plan(const Robot& robot, const detail::PlanPath& path, const float* start, float dt)
    : robot_(robot), path_(path), start_(start), dt_(dt) {
  for (Index leg = path.first(); leg != kNone; leg = path.next(leg)) steps_ += path.steps(leg);
}

float Plan::length() const { return empty() ? 0.0F : measured({robot_, path_, start_, dt_}).length; }

std::uint64_t Plan::hash() const { return empty() ? 0 : measured({robot_, path_, start_, dt_}).hash; }

void Plan::copy(float* states, float* controls) const {
  if (empty()) return;
  PlanCursor at = cursor();
  for (; !at.done(); at.advance()) {
    for (int i = 0; i < state_size(); ++i) *states++ = at.state()[i];
    for (int i = 0; i < control_size(); ++i) *controls++ = at.control()[i];
  }
  for (int i = 0; i < state_size(); ++i) *states++ = at.state()[i];
}

}  // namespace krait
