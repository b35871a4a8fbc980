// SPDX-License-Identifier: Apache-2.0
// Reads a map or drawing of any known format into a Workspace.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "host/workspace/workspace.hpp"

namespace krait::host {

inline constexpr double kMaxLongitude = 180;              // degrees
inline constexpr double kMaxLatitude = 90;                // degrees
inline constexpr double kMinUnit = 1e-6;                  // metres
inline constexpr double kMaxUnit = 1e6;                   // metres
inline constexpr std::uint64_t kMaxMapBytes = 64U << 20;  // of a file

// The words of --help, for every command that reads maps.
inline constexpr const char* kAboutUnit =
    "how long one unit of the file's coordinates is: GeoJSON in metres has 1, SVG has its own width and height";
inline constexpr const char* kAboutDatum =
    "the point that becomes [0, 0] where GeoJSON has longitudes and latitudes (WGS84, degrees)";

enum class Unknown { map, free, occupied };  // how a map's unknown cells count; map: by the file's thresholds

struct LonLat {  // degrees, east and north positive; WGS84
  double longitude = 0;
  double latitude = 0;
};

struct ImportOptions {
  Unknown unknown = Unknown::map;
  std::optional<double> unit = std::nullopt;   // metres, kMinUnit to kMaxUnit; goes before what a drawing says
  std::optional<LonLat> datum = std::nullopt;  // goes before what a GeoJSON says; not with a unit
  bool undoes_shift = false;                   // who asks adds a far map's shift back: no warning of it
};

// "11.57,48.14", longitude before latitude. Throws InputError that names --datum.
LonLat parse_datum(const std::string& text);

// The names of the formats of maps and drawings, for --help: "SVG, GeoJSON".
std::string map_formats();

// What import_workspace warns of where a compiled scene's name says that it is something else; empty where it does not.
std::string misnamed_scene(const std::string& path);

// Chooses the format by content, or by name where the content fits none: one of map_formats(), or a compiled scene.
// Throws InputError.
Workspace import_workspace(const std::string& path, const ImportOptions& options);

}  // namespace krait::host
