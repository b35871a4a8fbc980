// SPDX-License-Identifier: Apache-2.0
#include "plan/target_grid.hpp"

namespace krait::detail {
namespace {

constexpr float kParts = 65535.0F;
constexpr float kSpeedParts = 32767.0F;

std::uint16_t parts(float x, float low, float unit) {
  constexpr float kHalf = 0.5F;
  return static_cast<std::uint16_t>(math::clamp((x - low) / unit, 0.0F, kParts) + kHalf);
}

}  // namespace

TargetGrid::TargetGrid(const Box& bounds) : low_(bounds.min), unit_((1.0F / kParts) * (bounds.max - bounds.min)) {}

PackedTarget TargetGrid::pack(const Target& target) const {
  const float scaled = math::clamp(target.speed, -1.0F, 1.0F) * kSpeedParts;
  return {parts(target.point.x, low_.x, unit_.x), parts(target.point.y, low_.y, unit_.y),
          static_cast<std::int16_t>(scaled + (scaled < 0.0F ? -0.5F : 0.5F)), parts(target.turn, 0.0F, 1.0F / kParts)};
}

Target TargetGrid::unpack(const PackedTarget& packed) const {
  Target target;
  target.point = {low_.x + static_cast<float>(packed.x) * unit_.x, low_.y + static_cast<float>(packed.y) * unit_.y};
  target.speed = static_cast<float>(packed.speed) / kSpeedParts;
  target.turn = static_cast<float>(packed.turn) / kParts;
  return target;
}

}  // namespace krait::detail
