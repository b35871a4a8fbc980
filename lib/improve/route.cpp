// SPDX-License-Identifier: Apache-2.0
#include "improve/route.hpp"

#include <algorithm>

namespace krait::detail {

void Route::insert(std::uint32_t i, const Via& via) {
  KRAIT_ASSERT(!full() && i <= count_);
  for (std::uint32_t k = count_++; k > i; --k) vias_[k] = vias_[k - 1];
  vias_[i] = via;
}

void Route::remove(std::uint32_t i) {
  KRAIT_ASSERT(i < count_);
  --count_;
  for (std::uint32_t k = i; k < count_; ++k) vias_[k] = vias_[k + 1];
}

std::uint32_t Route::divide(float arc) {
  const std::uint32_t i = stretch(arc);
  Via via = vias_[i];
  via.at = point(arc);
  via.arc = arc;
  insert(i, via);
  return i;
}

void Route::copy(const Route& from) {
  KRAIT_ASSERT(from.count_ <= capacity_);
  count_ = from.count_;
  gear_ = from.gear_;
  shots_ = from.shots_;
  for (std::uint32_t i = 0; i < count_; ++i) vias_[i] = from.vias_[i];
}

void Route::measure() {
  KRAIT_ASSERT(count_ > 0);
  vias_[0].arc = 0.0F;
  for (std::uint32_t i = 1; i < count_; ++i) {
    vias_[i].arc = vias_[i - 1].arc + krait::length(vias_[i].at - vias_[i - 1].at);
  }
}

std::uint32_t Route::stretch(float arc) const {
  KRAIT_ASSERT(count_ > 1);
  std::uint32_t low = 1;
  std::uint32_t high = count_ - 1;
  while (low < high) {
    const std::uint32_t middle = low + (high - low) / 2;
    if (vias_[middle].arc <= arc) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

Vec2 Route::point(float arc) const {
  const Via& to = vias_[stretch(arc)];
  const Via& from = *(&to - 1);
  const float whole = to.arc - from.arc;
  if (!(arc < to.arc) || !(whole > 0.0F)) return to.at;
  return from.at + ((arc - from.arc) / whole) * (to.at - from.at);
}

float Route::project(Vec2 p, float arc, float reach) const {
  const float end = std::min(length(), arc + reach);
  float nearest = arc;
  float least = kInfinity;
  for (std::uint32_t i = stretch(arc); i < count_ && vias_[i - 1].arc <= end; ++i) {
    const Vec2 from = vias_[i - 1].at;
    const Vec2 along = vias_[i].at - from;
    const float begin = vias_[i - 1].arc;
    const float whole = vias_[i].arc - begin;
    const float scaled = whole > 0.0F ? dot(p - from, along) / whole : 0.0F;
    const float low = std::max(begin, arc);
    const float high = std::min(end, vias_[i].arc);
    const float at = math::clamp(begin + scaled, low, high);
    const Vec2 place = whole > 0.0F ? from + ((at - begin) / whole) * along : from;
    const Vec2 apart = p - place;
    const float squared = dot(apart, apart);
    if (!(squared < least)) continue;
    least = squared;
    nearest = at;
  }
  return nearest;
}

}  // namespace krait::detail
