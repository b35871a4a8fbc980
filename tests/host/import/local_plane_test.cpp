// SPDX-License-Identifier: Apache-2.0
// Degrees in metres, against published lengths of a degree and against the meridian's arc.
#include "host/import/local_plane.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "../scratch.hpp"

namespace krait::host::local_plane_test {
namespace {

using testing::HasSubstr;

TEST(LocalPlane, TheDatumIsTheOrigin) {
  const LocalPlane plane({-122.3, -37.9});
  EXPECT_NEAR(plane.at({-122.3, -37.9}).x, 0, 1e-9);
  EXPECT_NEAR(plane.at({-122.3, -37.9}).y, 0, 1e-9);
}

// A thousandth of the published lengths of a degree, in metres.
TEST(LocalPlane, AThousandthOfADegreeHasItsKnownLength) {
  const LocalPlane equator({20, 0});
  EXPECT_NEAR(equator.at({20.001, 0}).x, 111.320, 0.001);
  EXPECT_NEAR(equator.at({20, 0.001}).y, 110.574, 0.001);
  const LocalPlane north({-70, 60});
  EXPECT_NEAR(north.at({-69.999, 60}).x, 55.800, 0.001);
  EXPECT_NEAR(north.at({-70, 60.001}).y, 111.412, 0.001);
  const LocalPlane south({179.9995, -60});
  EXPECT_NEAR(south.at({-179.9995, -60}).x, 55.800, 0.001) << "across the line of dates";
  EXPECT_NEAR(south.at({179.9995, -60.001}).y, -111.412, 0.001);
}

// The meridian's length between two latitudes, by the midpoint rule over its radius of curvature.
double meridian(double from, double to) {
  constexpr double kDegree = std::numbers::pi / 180;
  constexpr double kSquash = 0.00669437999014;
  constexpr int kParts = 100000;
  double sum = 0;
  for (int i = 0; i < kParts; ++i) {
    const double s = std::sin((from + (to - from) * (i + 0.5) / kParts) * kDegree);
    sum += 6378137 * (1 - kSquash) / std::pow(1 - kSquash * s * s, 1.5);
  }
  return sum * (to - from) * kDegree / kParts;
}

TEST(LocalPlane, LengthsAreTrueToTheStatedError) {
  const LocalPlane plane({9, 48});
  const double near = 48 + 2000 / 111190.0;
  const double far = 48 + 10000 / 111190.0;
  EXPECT_NEAR(plane.at({9, near}).y, meridian(48, near), 0.04e-3);
  EXPECT_NEAR(plane.at({9, far}).y, meridian(48, far), 5e-3);
  EXPECT_GT(meridian(48, far) - plane.at({9, far}).y, 3e-3) << "the error is of that size";
}

TEST(LocalPlane, ReachesAHundredKilometres) {
  const LocalPlane plane({0, 0});
  EXPECT_TRUE(plane.reaches({0.89, 0}));
  EXPECT_FALSE(plane.reaches({0.9, 0}));
  EXPECT_FALSE(plane.reaches({180, 0}));
}

TEST(Datum, IsReadWithLongitudeFirst) {
  const LonLat datum = parse_datum("-122.25,37.5");
  EXPECT_EQ(datum.longitude, -122.25);
  EXPECT_EQ(datum.latitude, 37.5);
  for (const char* text : {"", "1", "1,2,3", "1;2", "181,0", "0,91", "nan,0", "0,inf", "1, 2", "x,y"}) {
    EXPECT_THAT(error_of([&] { parse_datum(text); }), HasSubstr("give LONGITUDE,LATITUDE in degrees")) << text;
  }
}

}  // namespace
}  // namespace krait::host::local_plane_test
