// SPDX-License-Identifier: Apache-2.0
// The line that a robot is driven along while a plan is improved: via points, and how each is driven to.
#pragma once

#include "base/arena.hpp"
#include "krait/geometry.hpp"
#include "krait/status.hpp"

namespace krait::detail {

struct Via {
  Vec2 at;
  float look;  // metres: how far ahead on the line the robot steers on the way to here
  float turn;  // Target::turn on the way to here
  float arc;   // metres along the line to here
};

// The line from the first via to the last. Every via but the first has a stretch of the line, the one that ends at it.
class Route {
 public:
  // Room for `vias`, 20 bytes each.
  void allocate(Arena& arena, std::uint32_t vias) {
    vias_ = arena.allocate<Via>(Pool::improvement, vias);
    capacity_ = vias;
  }

  // It is driven forwards and shoots from its begin on.
  void clear() {
    count_ = 0;
    gear_ = 1.0F;
    shots_ = kInfinity;
  }
  std::uint32_t count() const { return count_; }
  std::uint32_t capacity() const { return capacity_; }
  bool full() const { return count_ == capacity_; }
  const Via& operator[](std::uint32_t i) const {
    KRAIT_ASSERT(i < count_);
    return vias_[i];
  }
  const Via& last() const {
    KRAIT_ASSERT(count_ > 0);
    return vias_[count_ - 1];
  }
  // Changes need measure() before the line is used again.
  Via& operator[](std::uint32_t i) {
    KRAIT_ASSERT(i < count_);
    return vias_[i];
  }
  // Not when full.
  void insert(std::uint32_t i, const Via& via);
  void add(const Via& via) { insert(count_, via); }
  void remove(std::uint32_t i);
  // Adds a via on the line, `arc` metres along it, and returns which it is: the line stays, and measured. Not when
  // full.
  std::uint32_t divide(float arc);
  // Becomes the same as a route of the same capacity.
  void copy(const Route& from);

  // Finds every via's arc, of one via at least. O(vias).
  void measure();

  // 1, or -1 where the line is driven backwards.
  float gear() const { return gear_; }
  void drive_in(float gear) { gear_ = gear; }
  // Metres before the line's end, from which on the robot shoots at a pose.
  float shots() const { return shots_; }
  void shoot_within(float metres) { shots_ = metres; }

  // Metres along a measured route of at least two vias.
  float length() const { return last().arc; }
  // The via whose stretch contains the place `arc` metres along the line; the last one from there on. O(log vias).
  std::uint32_t stretch(float arc) const;
  // That place; the last via from there on. O(log vias).
  Vec2 point(float arc) const;
  // How far along the line the place nearest to p is, of those from `arc` on and at most `reach` metres on; the first
  // among equals. O(log vias + vias within reach).
  float project(Vec2 p, float arc, float reach) const;

 private:
  Via* vias_ = nullptr;
  std::uint32_t capacity_ = 0;
  std::uint32_t count_ = 0;
  float gear_;   // of a route that was cleared or copied
  float shots_;  // metres, the same
};

}  // namespace krait::detail
