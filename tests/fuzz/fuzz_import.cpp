// SPDX-License-Identifier: Apache-2.0
// A map, drawing or compiled scene in whichever format recognises the content: one line or a workspace with sound
// numbers, whatever the text says.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "harness.hpp"
#include "host/import/format.hpp"
#include "host/input/json.hpp"

namespace krait::fuzz {
namespace {

using namespace krait::host;

struct Kind {
  const Format& format;
  Outcomes outcomes;
};
Kind kinds[] = {{kSceneFile, Outcomes("scene")},    {kSvg, Outcomes("SVG")},     {kGeoJson, Outcomes("GeoJSON")},
                {kNative, Outcomes("native")},      {kTpcap, Outcomes("TPCAP")}, {kMovingAi, Outcomes("MovingAI")},
                {kDynobench, Outcomes("dynobench")}};
Landmark map_server("map_server, recognised");  // and refused: no picture is there

void look_at(const Source& source, Landmark Outcomes::*outcome) {
  for (Kind& kind : kinds) {
    if (kind.format.recognise(source)) (kind.outcomes.*outcome).reach();
  }
  if (kMapServer.recognise(source)) map_server.reach();
}

constexpr double kMost = 4 * kMaxCoordinate;  // what lies outside the bounds may lie beyond

bool sound(const Point& p) { return std::abs(p.x) <= kMost && std::abs(p.y) <= kMost; }

void require_sound(const Ring& ring) {
  require(ring.size() >= 3, "a ring of fewer than three points");
  for (const Point& p : ring) require(sound(p), "a point out of all bounds");
}

void require_sound(const Workspace& w) {
  require(w.min.x < w.max.x && w.min.y < w.max.y && sound(w.min) && sound(w.max), "bounds that bound nothing");
  for (const Obstacle& obstacle : w.obstacles) {
    require_sound(obstacle.outer);
    for (const Ring& hole : obstacle.holes) require_sound(hole);
  }
  for (const Goal& goal : w.goals) require_sound(goal.polygon);
  for (const Start& start : w.starts) {
    require(sound(start.position) && std::abs(start.heading) <= kMaxAngle, "a start out of all bounds");
    require(start.angles.size() <= 25, "a start with too many angles");
  }
  if (!w.cells) return;
  require(w.cells->columns > 0 && w.cells->rows > 0, "a map without cells");
  const auto cells = static_cast<std::size_t>(w.cells->columns) * static_cast<std::size_t>(w.cells->rows);
  require(w.cells->occupied.size() == cells, "a map whose size lies");
}

}  // namespace
}  // namespace krait::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace krait::fuzz;
  if (size == 0) return 0;  // read_file refuses it
  const krait::host::Source source{"no/such/folder/map", std::string(reinterpret_cast<const char*>(data), size)};
  try {
    require_sound(krait::host::read_workspace(source, {}));
    look_at(source, &Outcomes::accepted);
  } catch (const krait::host::InputError& error) {
    look_at(source, &Outcomes::refused);
    require(std::string(error.what()).find('\n') == std::string::npos, "an error of more than one line");
  }
  return 0;
}
