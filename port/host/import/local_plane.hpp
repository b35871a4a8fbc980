// SPDX-License-Identifier: Apache-2.0
// Longitudes and latitudes (WGS84, at the height of the ellipsoid) as metres east and north of a datum.
#pragma once

#include "host/import/import.hpp"

namespace krait::host {

// The plane that touches the ellipsoid in the datum; points are projected at right angles to it. A length within d of
// the datum is short by at most d^3 / (6 R^2), R = 6,357 km: 0.04 mm at 2 km, 5 mm at 10 km. At a height of h above the
// ellipsoid all lengths are short by h / R, 0.16 mm a metre at 1 km.
class LocalPlane {
 public:
  explicit LocalPlane(const LonLat& datum);

  // x east, y north, metres. Far from the datum the result is meaningless: see reaches().
  Point at(const LonLat& place) const;

  // Whether the place lies within 100 km of the datum.
  bool reaches(const LonLat& place) const;

 private:
  struct Vector {
    double x, y, z;
  };
  static Vector from_center(double sin_lon, double cos_lon, double sin_lat, double cos_lat);
  Vector offset(const LonLat& place) const;

  double sin_lon_, cos_lon_, sin_lat_, cos_lat_;  // of the datum
  Vector datum_;                                  // from the centre of the earth, metres
};

}  // namespace krait::host
