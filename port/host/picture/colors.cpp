// SPDX-License-Identifier: Apache-2.0
#include "host/picture/colors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace krait::host {

namespace {

// The diverging scheme "RdYlBu" of C. Brewer, ColorBrewer.org, marked there as safe for colour-blind readers.
constexpr std::array<Color, 11> kStops = {{{0xa5, 0x00, 0x26},
                                           {0xd7, 0x30, 0x27},
                                           {0xf4, 0x6d, 0x43},
                                           {0xfd, 0xae, 0x61},
                                           {0xfe, 0xe0, 0x90},
                                           {0xff, 0xff, 0xbf},
                                           {0xe0, 0xf3, 0xf8},
                                           {0xab, 0xd9, 0xe9},
                                           {0x74, 0xad, 0xd1},
                                           {0x45, 0x75, 0xb4},
                                           {0x31, 0x36, 0x95}}};

std::uint8_t mix(std::uint8_t a, std::uint8_t b, double share) {
  return static_cast<std::uint8_t>(std::lround(a + (b - a) * share));
}

}  // namespace

Color level_color(std::uint8_t level) {
  if (level == kInfiniteLevel) return kCutOff;
  const double position = level * (kStops.size() - 1.0) / (kLevels - 1);
  const auto below = std::min(static_cast<std::size_t>(position), kStops.size() - 2);
  const double share = position - static_cast<double>(below);
  const Color a = kStops[below];
  const Color b = kStops[below + 1];
  return {mix(a.red, b.red, share), mix(a.green, b.green, share), mix(a.blue, b.blue, share)};
}

double top_cost(const std::vector<float>& costs) {
  std::vector<float> finite;
  std::copy_if(costs.begin(), costs.end(), std::back_inserter(finite), [](float cost) { return std::isfinite(cost); });
  if (finite.empty()) return 0;
  std::sort(finite.begin(), finite.end());
  const double largest = finite.back();
  const double usual = finite[(finite.size() - 1) * 98 / 100];
  return std::max(0.0, usual > 0 && largest > 1.5 * usual ? usual : largest);
}

std::uint8_t cost_level(float cost, double top) {
  if (std::isinf(cost)) return kInfiniteLevel;
  if (!(top > 0)) return 0;
  const double share = std::clamp(static_cast<double>(cost) / top, 0.0, 1.0);
  return static_cast<std::uint8_t>(std::lround(share * (kLevels - 1)));
}

}  // namespace krait::host
