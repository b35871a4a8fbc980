// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/frame.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "krait/format.hpp"

namespace krait::host::compiler {
namespace {

constexpr double kSteps = 1 << format::kGridBits;  // a metre
constexpr double kLargestWithoutOrigin = 1000;     // metres

std::string text(const Workspace& w) {
  std::ostringstream out;
  out << "the bounds [" << w.min.x << ", " << w.min.y << "] to [" << w.max.x << ", " << w.max.y << "]";
  return out.str();
}

Point origin_of(const Workspace& w) {
  const double largest = std::max({std::abs(w.min.x), std::abs(w.min.y), std::abs(w.max.x), std::abs(w.max.y)});
  if (largest <= kLargestWithoutOrigin) return {0, 0};
  return {std::round(w.min.x / 2 + w.max.x / 2), std::round(w.min.y / 2 + w.max.y / 2)};
}

// A millionth of a step absorbs the rounding of a decimal to the nearest double.
std::int32_t inwards_up(double steps) { return static_cast<std::int32_t>(std::ceil(steps - 1e-6)); }
std::int32_t inwards_down(double steps) { return static_cast<std::int32_t>(std::floor(steps + 1e-6)); }

}  // namespace

std::string largest_reach() { return std::to_string(static_cast<int>(format::kMaxCoordinate)) + " m"; }

Point Frame::local(Point world) const { return {(world.x - origin.x) * kSteps, (world.y - origin.y) * kSteps}; }

Point Frame::world(GridPoint p) const { return {origin.x + p.x / kSteps, origin.y + p.y / kSteps}; }

GridPoint Frame::nearest(Point world) const {
  const Point p = local(world);
  const auto rounded = [](double value, std::int32_t low, std::int32_t high) {
    // Bounds were rounded inwards: what lay within them still does.
    const double limited =
        value > low - 1.0 && value < high + 1.0 ? std::clamp(value, double(low), double(high)) : value;
    return static_cast<std::int32_t>(std::lround(limited));
  };
  return {rounded(p.x, bounds.min.x, bounds.max.x), rounded(p.y, bounds.min.y, bounds.max.y)};
}

Frame frame_of(const Workspace& w) {
  for (const double value : {w.min.x, w.min.y, w.max.x, w.max.y}) {
    if (!std::isfinite(value)) throw InputError(text(w) + " are not finite numbers");
  }
  if (!(w.min.x < w.max.x && w.min.y < w.max.y)) {
    throw InputError(text(w) + " are empty: the minimum must be below the maximum in x and y");
  }
  Frame frame;
  frame.origin = origin_of(w);
  const Point low = frame.local(w.min), high = frame.local(w.max);
  const double limit = double(format::kMaxCoordinate) * kSteps;
  if (std::min(low.x, low.y) < -limit || std::max(high.x, high.y) > limit) {
    throw InputError(text(w) + " are too large: a scene reaches at most " + largest_reach() +
                     " either way from the whole metre nearest to its middle");
  }
  frame.bounds = {{inwards_up(low.x), inwards_up(low.y)}, {inwards_down(high.x), inwards_down(high.y)}};
  if (frame.bounds.min.x >= frame.bounds.max.x || frame.bounds.min.y >= frame.bounds.max.y) {
    throw InputError(text(w) + " are smaller than the scene's grid of 0.25 mm");
  }
  return frame;
}

}  // namespace krait::host::compiler
