// SPDX-License-Identifier: Apache-2.0
#include "host/import/local_plane.hpp"

#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>

namespace krait::host {
namespace {

constexpr double kEquator = 6378137;                         // m, WGS84's semi-major axis
constexpr double kFlattening = 1 / 298.257223563;            // WGS84
constexpr double kSquash = kFlattening * (2 - kFlattening);  // the ellipsoid's eccentricity, squared
constexpr double kMaxDistance = 1e5;                         // m

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

bool read_number(std::string_view text, double most, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && std::abs(value) <= most;
}

}  // namespace

LonLat parse_datum(const std::string& text) {
  const std::size_t comma = text.find(',');
  LonLat datum;
  const bool sound = comma != std::string::npos &&
                     read_number(std::string_view(text).substr(0, comma), kMaxLongitude, datum.longitude) &&
                     read_number(std::string_view(text).substr(comma + 1), kMaxLatitude, datum.latitude);
  if (sound) return datum;
  throw InputError("--datum " + text + ": give LONGITUDE,LATITUDE in degrees, east and north positive, as 11.57,48.14");
}

LocalPlane::LocalPlane(const LonLat& datum)
    : sin_lon_(std::sin(radians(datum.longitude))),
      cos_lon_(std::cos(radians(datum.longitude))),
      sin_lat_(std::sin(radians(datum.latitude))),
      cos_lat_(std::cos(radians(datum.latitude))),
      datum_(from_center(sin_lon_, cos_lon_, sin_lat_, cos_lat_)) {}

LocalPlane::Vector LocalPlane::from_center(double sin_lon, double cos_lon, double sin_lat, double cos_lat) {
  const double radius = kEquator / std::sqrt(1 - kSquash * sin_lat * sin_lat);  // of curvature, east to west
  return {radius * cos_lat * cos_lon, radius * cos_lat * sin_lon, radius * (1 - kSquash) * sin_lat};
}

LocalPlane::Vector LocalPlane::offset(const LonLat& place) const {
  const double lon = radians(place.longitude);
  const double lat = radians(place.latitude);
  const Vector p = from_center(std::sin(lon), std::cos(lon), std::sin(lat), std::cos(lat));
  return {p.x - datum_.x, p.y - datum_.y, p.z - datum_.z};
}

Point LocalPlane::at(const LonLat& place) const {
  const Vector d = offset(place);
  const double outward = cos_lon_ * d.x + sin_lon_ * d.y;  // in the datum's meridian, parallel to the equator
  return {cos_lon_ * d.y - sin_lon_ * d.x, cos_lat_ * d.z - sin_lat_ * outward};
}

bool LocalPlane::reaches(const LonLat& place) const {
  const Vector d = offset(place);
  return d.x * d.x + d.y * d.y + d.z * d.z <= kMaxDistance * kMaxDistance;
}

}  // namespace krait::host
