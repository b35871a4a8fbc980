// A solved plan: read by a cursor in O(1) memory, or copied.
#pragma once

#include <cstdint>

#include "krait/search/motion_tree.hpp"

namespace krait {

// The states and controls s0 u0 s1 u1 … sL of a plan, in the planner's memory: valid until its next start.
class Plan {
 public:
  Plan() = default;
  // `vertices`: the tree's, root first; `states` of them.
  Plan(const MotionTree& tree, const Index* vertices, std::uint32_t states, float dt, int state_size, int control_size)
      : tree_(&tree),
        vertices_(vertices),
        states_(states),
        dt_(dt),
        state_size_(state_size),
        control_size_(control_size) {}

  bool empty() const { return states_ == 0; }
  std::uint32_t steps() const { return states_ == 0 ? 0 : states_ - 1; }
  int state_size() const { return state_size_; }
  int control_size() const { return control_size_; }

  // state_size() floats, i <= steps(); control_size() floats held from state i to i + 1, i < steps().
  const float* state(std::uint32_t i) const { return tree_->state(vertices_[i]); }
  const float* control(std::uint32_t i) const { return tree_->control(vertices_[i + 1]); }
  Index vertex(std::uint32_t i) const { return vertices_[i]; }

  float dt() const { return dt_; }                                      // seconds
  float duration() const { return dt_ * static_cast<float>(steps()); }  // seconds
  float length() const;                                                 // metres, of the line through the positions

  // FNV-1a 64 over s0, u0, s1, u1, …, sL, each float as 4 little-endian bytes; 0 for no plan.
  std::uint64_t hash() const;

  // (steps() + 1) * state_size() and steps() * control_size() floats into the caller's arrays.
  void copy(float* states, float* controls) const;

 private:
  const MotionTree* tree_ = nullptr;
  const Index* vertices_ = nullptr;
  std::uint32_t states_ = 0;
  float dt_ = 0.0F;
  int state_size_ = 0;
  int control_size_ = 0;
};

}  // namespace krait
