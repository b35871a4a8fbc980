// The motion tree T = (V, E) (section 4.2): a pool of vertices, each with its state, region, parent and the control of
// the edge from the parent.
#pragma once

#include "krait/arena.hpp"
#include "krait/scene/scene.hpp"

namespace krait {

class MotionTree {
 public:
  // Room for `capacity` vertices.
  void take(Arena& arena, std::uint32_t capacity, int state_size, int control_size);

  void clear() { size_ = 0; }
  std::uint32_t size() const { return size_; }
  std::uint32_t capacity() const { return capacity_; }
  bool full() const { return size_ == capacity_; }

  // Adds a vertex whose state and control the caller then writes; not when full. The root's parent is kNone.
  Index add(Index parent, Index region) {
    parents_[size_] = parent;
    regions_[size_] = region;
    return size_++;
  }

  float* state(Index vertex) { return states_ + offset(vertex, state_size_); }
  const float* state(Index vertex) const { return states_ + offset(vertex, state_size_); }
  float* control(Index vertex) { return controls_ + offset(vertex, control_size_); }
  const float* control(Index vertex) const { return controls_ + offset(vertex, control_size_); }
  Index parent(Index vertex) const { return parents_[vertex]; }
  Index region(Index vertex) const { return regions_[vertex]; }

 private:
  static std::size_t offset(Index vertex, int size) { return std::size_t{vertex} * static_cast<std::size_t>(size); }

  Index* parents_ = nullptr;
  Index* regions_ = nullptr;
  float* states_ = nullptr;
  float* controls_ = nullptr;
  int state_size_ = 0;
  int control_size_ = 0;
  std::uint32_t capacity_ = 0;
  std::uint32_t size_ = 0;
};

}  // namespace krait
