// SPDX-License-Identifier: Apache-2.0
#include "krait/geometry.hpp"

#include "base/lanes/angles.hpp"

namespace krait {

#ifdef KRAIT_LANES
[[gnu::flatten]]
#endif
void turn_to(const float* angles, int count, Pose* frames) {
#ifdef KRAIT_LANES
  if (count >= detail::lanes::kLeastAngles) return detail::lanes::turn_frames(angles, count, frames);
#endif
  for (int i = 0; i < count; ++i) frames[i].heading = math::sin_cos(angles[i]);
}

}  // namespace krait
