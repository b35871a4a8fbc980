// SPDX-License-Identifier: Apache-2.0
#include "krait/plan/plan.hpp"

#include <bit>

#include "krait/base/contract.hpp"

namespace krait {

void Fnv::add(const float* values, int count) {
  for (int i = 0; i < count; ++i) {
    const auto bits = std::bit_cast<std::uint32_t>(values[i]);
    for (unsigned shift = 0; shift < 32; shift += 8) value_ = (value_ ^ ((bits >> shift) & 0xFFU)) * 0x100000001B3ULL;
  }
}

void PlanMeter::add(const float* state, int state_size, const float* control, int control_size, const float* next) {
  hash_.add(state, state_size);
  hash_.add(control, control_size);
  ++measures_.steps;
  measures_.length += krait::length(Vec2{next[0], next[1]} - Vec2{state[0], state[1]});
}

PlanMeasures PlanMeter::end(const float* state, int state_size) {
  hash_.add(state, state_size);
  measures_.hash = hash_.value();
  return measures_;
}

Index PlanPath::next(Index leg) const {
  if (tree_ != nullptr) return tree_->next_of_path(leg);
  return leg + 1 < way_->count() ? leg + 1 : kNone;
}

PlanCursor::PlanCursor(const Robot& robot, const PlanPath& path, const float* start, float dt)
    : robot_(robot), path_(path), leg_(path.first()) {
  drive_.begin(robot, dt, start);
  enter();
}

void PlanCursor::advance() {
  KRAIT_ASSERT(!done());
  drive_.go();
  if (++step_ == path_.steps(leg_)) {
    leg_ = path_.next(leg_);
    enter();
  } else {
    step();
  }
}

void PlanCursor::enter() {
  step_ = 0;
  if (leg_ == kNone) return;
  drive_.aim(path_.target(leg_));
  step();
}

void PlanCursor::step() {
  Pose poses[kMaxBodies];
  robot_.place(drive_.state(), poses);
  drive_.step(poses);
}

Plan::Plan(const Robot& robot, const PlanPath& path, const float* start, float dt)
    : robot_(robot), path_(path), start_(start), dt_(dt) {
  for (Index leg = path.first(); leg != kNone; leg = path.next(leg)) steps_ += path.steps(leg);
}

void Plan::copy(float* states, float* controls) const {
  if (empty()) return;
  PlanCursor at = cursor();
  for (; !at.done(); at.advance()) {
    for (int i = 0; i < state_size(); ++i) *states++ = at.state()[i];
    for (int i = 0; i < control_size(); ++i) *controls++ = at.control()[i];
  }
  for (int i = 0; i < state_size(); ++i) *states++ = at.state()[i];
}

PlanMeasures Plan::measures() const {
  PlanMeter meter;
  PlanCursor at = cursor();
  for (; !at.done(); at.advance()) meter.add(at.state(), state_size(), at.control(), control_size(), at.next());
  return meter.end(at.state(), state_size());
}

}  // namespace krait
