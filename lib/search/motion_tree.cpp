#include "krait/search/motion_tree.hpp"

namespace krait {

void MotionTree::take(Arena& arena, std::uint32_t capacity, int state_size, int control_size) {
  capacity_ = capacity;
  state_size_ = state_size;
  control_size_ = control_size;
  parents_ = arena.take<Index>(Pool::vertices, capacity);
  regions_ = arena.take<Index>(Pool::vertices, capacity);
  states_ = arena.take<float>(Pool::states, std::uint64_t{capacity} * static_cast<std::uint64_t>(state_size));
  controls_ = arena.take<float>(Pool::controls, std::uint64_t{capacity} * static_cast<std::uint64_t>(control_size));
}

}  // namespace krait
