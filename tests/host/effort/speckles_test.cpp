// SPDX-License-Identifier: GPL-3.0-or-later
// The README's claim of a map of single cells that stand alone: what its scene takes, in bytes.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host/compiler/compiler.hpp"
#include "host/reduce/reduce.hpp"
#include "host/robot_file/robot_file.hpp"
#include "long_tests.hpp"

namespace krait::host {
namespace {

constexpr double kCell = 0.1;   // metres
constexpr double kCorner = 20;  // metres: of the start and the goal from the corners of the map
constexpr double kWay = 13.5;   // metres: of the corridor

// 4,000 by 4,000 cells where tests are long, else 1,000 by 1,000; one in 267 is occupied, but for a disc of 2 m around
// the start and the goal.
Workspace speckled() {
  const auto size = static_cast<int>(test::by_length(1000, 4000));
  const double reach = size * kCell;
  Workspace w;
  w.max = {reach, reach};
  const auto cells = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  w.cells = CellMap{size, size, kCell, {0, 0}, 0, std::vector<std::uint8_t>(cells, 0)};
  const double far = reach - kCorner;
  w.starts = {{"start", {kCorner, kCorner}, 0.78, {}}};
  w.goals = {
      {"goal", {{far - 0.5, far - 0.5}, {far + 0.5, far - 0.5}, {far + 0.5, far + 0.5}, {far - 0.5, far + 0.5}}}};
  std::mt19937_64 random(1);
  for (std::size_t left = cells * 3 / 800; left > 0;) {
    const std::size_t cell = random() % cells;
    const double x = kCell * double(cell % std::size_t(size)), y = kCell * double(cell / std::size_t(size));
    const bool near = std::hypot(x - kCorner, y - kCorner) < 2 || std::hypot(x - far, y - far) < 2;
    if (near || w.cells->occupied[cell] != 0) continue;
    w.cells->occupied[cell] = 1;
    --left;
  }
  return w;
}

// Fine regions may be as small as a 500th of the map: a small map has more of them around each cell.
TEST(Speckles, TakeNoMoreBytesThanTheReadmeSays) {
  const Workspace w = speckled();
  EXPECT_LE(compile(w, {}).bytes.size(), test::by_length(8'100'000, 52'000'000));
  EXPECT_LE(compile(w, {-1, {}, true}).bytes.size(), test::by_length(1'630'000, 26'000'000));
  const Girth husky = girth_of(parse_robot("husky"));
  const Workspace corridor = reduced(w, {{}, {}, husky, kWay, husky});
  EXPECT_LE(compile(corridor, {-1, {}, true}).bytes.size(), test::by_length(630'000, 2'950'000));
}

}  // namespace
}  // namespace krait::host
