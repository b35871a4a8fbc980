// SPDX-License-Identifier: Apache-2.0
// Exact geometry on the grid that the coordinates of every scene lie on.
#pragma once

#include <cstdint>

#include "krait/format.hpp"
#include "krait/geometry.hpp"

namespace krait::detail {

inline constexpr auto kGridSteps = static_cast<float>(1 << format::kGridBits);  // a metre

// Grid coordinates of a point, rounded to the nearest: exact for every coordinate of a scene. |p| must be at most
// format::kMaxCoordinate.
struct GridPoint {
  std::int32_t x;
  std::int32_t y;
};
inline std::int32_t to_grid(float x) {
  const float scaled = x * kGridSteps;
  return static_cast<std::int32_t>(scaled + (scaled >= 0.0F ? 0.5F : -0.5F));
}
inline GridPoint to_grid(Vec2 p) { return {to_grid(p.x), to_grid(p.y)}; }

// The grid steps in a length: exact for a multiple of the grid of at most twice format::kMaxCoordinate, where to_grid
// is not, since floats beyond 2^23 have no halves.
inline std::int32_t grid_steps(float length) { return static_cast<std::int32_t>(length * kGridSteps); }

// Twice the signed area of (a, b, c): positive when counter-clockwise. Exact.
inline std::int64_t orientation(GridPoint a, GridPoint b, GridPoint c) {
  return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

}  // namespace krait::detail
