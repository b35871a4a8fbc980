// SPDX-License-Identifier: Apache-2.0
// Bucket lists and clearances are held to the geometry: no entry can be left out, no claim raised above the truth.
#include <gtest/gtest.h>

#include <algorithm>

#include "convex.hpp"
#include "scene_builder.hpp"

namespace krait::test::scene_grids_test {
namespace {

bool opens(const SceneData& data) {
  const SceneBytes bytes = data.bytes();
  Scene scene;
  return Scene::open(bytes.data(), bytes.size(), scene).ok();
}

// Boxes and convex pieces at all angles, buckets and cells of odd sizes.
Room any_room(unsigned seed) {
  std::mt19937 random(seed);
  Room room = random_room(seed, 9, 4);
  room.bucket_size = uniform(random, 0.3, 4);
  room.clearance_cell = uniform(random, 0.35, 1);
  for (int i = 0; i < 4; ++i) {
    room.loose_pieces.push_back(random_convex(random, {uniform(random, 1.5, 7.5), uniform(random, 1.5, 7.5)}, 1.2));
  }
  return room;
}

// Floats of more than 2^23 grid steps have no halves to round by.
TEST(SceneExtent, OfAnOddNumberOfGridStepsMayBeAWholeNumberOfBuckets) {
  constexpr double kStep = 1.0 / 4096;
  constexpr int kBucket = 2'999'997;
  for (const int more : {-1, 0, 1}) {
    Room room;
    room.bounds = {-4'500'000 * kStep, -10, (3 * kBucket - 4'500'000) * kStep, 10};
    room.spacing = 400;
    room.clearance_cell = 2;
    room.bucket_size = (kBucket + more) * kStep;
    EXPECT_TRUE(opens(data_of(room))) << more;
  }
}

class SceneGrids : public ::testing::TestWithParam<unsigned> {};

TEST_P(SceneGrids, OfASoundSceneAreTaken) { EXPECT_TRUE(opens(data_of(any_room(GetParam())))); }

TEST_P(SceneGrids, NoEntryOfABucketCanBeLeftOut) {
  const SceneData sound = data_of(any_room(GetParam()));
  for (auto lists : {&SceneData::bucket_triangles, &SceneData::bucket_pieces}) {
    for (std::size_t bucket = 0; bucket < (sound.*lists).size(); ++bucket) {
      for (std::size_t i = 0; i < (sound.*lists)[bucket].size(); i += 3) {
        SceneData data = sound;
        auto& list = (data.*lists)[bucket];
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
        ASSERT_FALSE(opens(data)) << bucket << " " << i;
      }
    }
  }
}

// A lie that leaves the number of entries as it is: one piece stands in for another.
TEST_P(SceneGrids, NoEntryOfABucketCanBeExchanged) {
  const SceneData sound = data_of(any_room(GetParam()));
  for (std::size_t bucket = 0; bucket < sound.bucket_pieces.size(); ++bucket) {
    if (sound.bucket_pieces[bucket].size() != 1) continue;
    for (Index other = 0; other < sound.pieces.size(); ++other) {
      if (other == sound.bucket_pieces[bucket][0]) continue;
      SceneData data = sound;
      data.bucket_pieces[bucket][0] = other;
      ASSERT_FALSE(opens(data)) << bucket << " " << other;
    }
  }
}

// Of the cell, widened as FORMAT.md says, to the nearest piece or bound.
double true_clearance(const SceneData& data, std::uint32_t column, std::uint32_t row) {
  const format::Header& h = data.header;
  const double size = static_cast<double>(h.clearance_cell), wide = 4.0 / 4096;
  const double x0 = static_cast<double>(h.bounds_min_x) + column * size - wide, x1 = x0 + size + 2 * wide;
  const double y0 = static_cast<double>(h.bounds_min_y) + row * size - wide, y1 = y0 + size + 2 * wide;
  double least = std::min(std::min(x0 - static_cast<double>(h.bounds_min_x), static_cast<double>(h.bounds_max_x) - x1),
                          std::min(y0 - static_cast<double>(h.bounds_min_y), static_cast<double>(h.bounds_max_y) - y1));
  const Ring square = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  for (const auto& piece : data.pieces) {
    least = std::min(least, distance(square, ring({piece.data(), static_cast<int>(piece.size())})));
  }
  return std::max(least, 0.0);
}

// Raises bytes wherever the checker lets it, until nothing can be raised: the boldest claims that open takes.
TEST_P(SceneGrids, NoClearanceCanBeRaisedAboveTheTruth) {
  SceneData data = data_of(any_room(GetParam()));
  int raised = 0;
  for (bool more = true; more;) {
    more = false;
    for (std::uint8_t& byte : data.clearance) {
      for (const int step : {4, 1}) {
        if (byte + step > 255) continue;
        byte = static_cast<std::uint8_t>(byte + step);
        if (opens(data)) {
          ++raised;
          more = true;
          break;
        }
        byte = static_cast<std::uint8_t>(byte - step);
      }
    }
  }
  EXPECT_GT(raised, 10);
  const double unit = static_cast<double>(data.header.clearance_unit);
  for (std::uint32_t row = 0; row < data.header.clearance_rows; ++row) {
    for (std::uint32_t column = 0; column < data.header.clearance_columns; ++column) {
      const int byte = data.clearance[row * data.header.clearance_columns + column];
      ASSERT_LE(byte * unit, true_clearance(data, column, row) * (1 + 2e-6)) << column << " " << row;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, SceneGrids, ::testing::Range(0U, 8U));

}  // namespace
}  // namespace krait::test::scene_grids_test
