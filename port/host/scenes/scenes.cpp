// SPDX-License-Identifier: Apache-2.0
#include "host/scenes/scenes.hpp"

#include <algorithm>
#include <set>

#include "host/export/export.hpp"
#include "host/input/json.hpp"

namespace krait::host {
namespace {

constexpr double kSide = 50;      // m, of the workspace at scale 1
constexpr double kWall = 1;       // m, thickness
constexpr double kWide = 1.4;     // m, a passage that the robot fits through
constexpr double kNarrow = 0.4;   // m, one that it does not
constexpr double kStreet = 3.5;   // m, between blocks
constexpr double kGoalSide = 3;   // m
constexpr double kTailRoom = 22;  // m from the start to the left bound, for 25 trailers of 0.8 m and half a body

struct Gap {
  double center;  // along the wall, at scale 1
  double width;   // m
};

Ring rectangle(const Point& min, const Point& max) { return {min, {max.x, min.y}, max, {min.x, max.y}}; }

// Draws at scale 1, writes at the scene's scale.
class Drawing {
 public:
  Drawing(const std::string& name, double scale) : scale_(scale) {
    scene_.workspace.name = name;
    scene_.workspace.max = {kSide * scale, kSide * scale};
  }

  // A wall around the line y = at from x = from to x = to, half its thickness longer at both ends, so that walls whose
  // lines meet overlap.
  void horizontal(double at, double from, double to, const std::vector<Gap>& gaps = {}) {
    wall(at, from, to, gaps, true);
  }
  void vertical(double at, double from, double to, const std::vector<Gap>& gaps = {}) {
    wall(at, from, to, gaps, false);
  }

  void pillar(double x, double y) { add(rectangle(around(x, y, 1, -1), around(x, y, 1, 1))); }

  // The start looks along +x, in the middle of a hall that reaches from the left bound to the right one.
  void start(double x, double y) {
    scene_.workspace.starts = {{"start", {std::max(scale_ * x, kTailRoom), scale_ * y}, 0, {}}};
  }

  void goal(double x, double y) {
    scene_.workspace.goals = {{"goal", rectangle(around(x, y, kGoalSide / 2, -1), around(x, y, kGoalSide / 2, 1))}};
  }

  void add(const Ring& ring) {
    const std::string label = "obstacles[" + std::to_string(scene_.workspace.obstacles.size()) + "]";
    scene_.workspace.obstacles.push_back({label, ring, {}});
  }

  double scale() const { return scale_; }
  Scene take() { return std::move(scene_); }

 private:
  Point around(double x, double y, double half, double sign) const {
    return {scale_ * x + sign * half, scale_ * y + sign * half};
  }

  void wall(double at, double from, double to, const std::vector<Gap>& gaps, bool along_x) {
    const double low = scale_ * at - kWall / 2;
    const double high = scale_ * at + kWall / 2;
    const auto corner = [&](double along, double across) {
      return along_x ? Point{along, across} : Point{across, along};
    };
    double begin = scale_ * from - kWall / 2;
    for (const Gap& gap : gaps) {
      const double gap_begin = scale_ * gap.center - gap.width / 2;
      const double gap_end = scale_ * gap.center + gap.width / 2;
      add(rectangle(corner(begin, low), corner(gap_begin, high)));
      scene_.passages.push_back({corner(gap_begin, low), corner(gap_end, high), gap.width, gap.width == kWide});
      begin = gap_end;
    }
    add(rectangle(corner(begin, low), corner(scale_ * to + kWall / 2, high)));
  }

  double scale_;
  Scene scene_;
};

// The paper's figure 1: a room with openings at the top and on the right that are too narrow, and one on the left.
void draw_openings(Drawing& drawing) {
  drawing.horizontal(14, 18, 38);
  drawing.horizontal(34, 18, 38, {{31, kNarrow}});
  drawing.vertical(18, 14, 34, {{22, kWide}});
  drawing.vertical(38, 14, 34, {{27, kNarrow}});
  for (const Point& p : Ring{{8, 30}, {8, 14}, {27, 7}, {44, 20}, {45, 34}}) drawing.pillar(p.x, p.y);
  drawing.start(30, 43);
  drawing.goal(31, 26);
}

// Three walls from side to side; the passage through each is far from the straight way.
void draw_gates(Drawing& drawing) {
  drawing.horizontal(12, 0, kSide, {{11, kNarrow}, {22, kWide}, {34, kNarrow}, {42, kNarrow}});
  drawing.horizontal(25, 0, kSide, {{8, kNarrow}, {20, kNarrow}, {30, kNarrow}, {41, kWide}});
  drawing.horizontal(38, 0, kSide, {{9, kWide}, {21, kNarrow}, {33, kNarrow}, {43, kNarrow}});
  drawing.start(30, 6);
  drawing.goal(40, 44);
}

// A hall and three rows of three rooms; most doors on the straight way are too narrow.
void draw_rooms(Drawing& drawing) {
  drawing.horizontal(11, 0, kSide, {{7, kWide}, {27, kNarrow}, {41, kNarrow}});
  drawing.horizontal(24, 0, kSide, {{10, kWide}, {25, kNarrow}, {42, kNarrow}});
  drawing.horizontal(37, 0, kSide, {{8, kNarrow}, {27, kWide}, {42, kNarrow}});
  drawing.vertical(17, 11, kSide, {{18, kNarrow}, {30, kWide}, {44, kNarrow}});
  drawing.vertical(33, 11, kSide, {{18, kWide}, {30, kNarrow}, {44, kWide}});
  drawing.start(30, 5.5);
  drawing.goal(42, 44);
}

// Five bays between the teeth of a comb, each behind a passable gate; only one of them leads on to the goal's hall.
void draw_comb(Drawing& drawing) {
  drawing.horizontal(12, 0, kSide, {{5, kWide}, {15, kWide}, {25, kWide}, {35, kWide}, {45, kWide}});
  drawing.horizontal(38, 0, kSide, {{5, kNarrow}, {15, kWide}, {25, kNarrow}, {35, kNarrow}, {45, kNarrow}});
  for (const double x : {10.0, 20.0, 30.0, 40.0}) drawing.vertical(x, 12, 38);
  drawing.start(30, 6);
  drawing.goal(45, 44);
}

// An aisle between solid blocks, along y.
struct Aisle {
  double center;  // at scale 1
  double width;   // m
};

// The blocks of a band of aisles from y = bottom to top (at scale 1), `margin` (m) away from both.
void draw_aisles(Drawing& drawing, const std::vector<Aisle>& aisles, double bottom, double top, double margin = 0) {
  const double s = drawing.scale();
  const double low = s * bottom + margin;
  const double high = s * top - margin;
  double left = 0;
  for (const Aisle& aisle : aisles) {
    drawing.add(rectangle({left, low}, {s * aisle.center - aisle.width / 2, high}));
    left = s * aisle.center + aisle.width / 2;
  }
  drawing.add(rectangle({left, low}, {s * kSide, high}));
}

// Three halls across the workspace, joined by aisles 1.9 to 3.3 m wide; no passage is too narrow.
void draw_corridors(Drawing& drawing) {
  draw_aisles(drawing, {{6, 2.6}, {17, 1.9}, {29, 2.2}, {42, 3.0}}, 8, 22);
  draw_aisles(drawing, {{9, 2.2}, {21, 3.3}, {33, 1.9}, {45, 2.4}}, 29, 42);
  drawing.start(30, 4);
  drawing.goal(5, 46);
}

// A town quarter between two halls: three rows of blocks with streets between them. Behind every street through a row
// stands a block of the next one (from scale 1 on).
void draw_streets(Drawing& drawing) {
  const auto row = [&](double bottom, double top, const std::vector<double>& crossings) {
    std::vector<Aisle> aisles;
    for (const double x : crossings) aisles.push_back({x, kStreet});
    draw_aisles(drawing, aisles, bottom, top, kStreet / 2);
  };
  row(8, 19.5, {7, 17, 29, 41});
  row(19.5, 30.5, {11, 23, 35, 45});
  row(30.5, 42, {5, 17, 28, 40});
  drawing.start(30, 4);
  drawing.goal(5, 46);
}

struct Entry {
  SceneName name;
  void (*draw)(Drawing&);
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = {
      {{"openings", "a room open on the left; its openings at the top and on the right are too narrow"}, draw_openings},
      {{"gates", "three walls, each with one passable gate among four"}, draw_gates},
      {{"rooms", "a hall and nine rooms; most doors on the straight way are too narrow"}, draw_rooms},
      {{"comb", "five bays; only one leads on to the goal"}, draw_comb},
      {{"corridors", "three halls joined by aisles 1.9 to 3.3 m wide; nothing too narrow"}, draw_corridors},
      {{"streets", "a town quarter: streets of 3.5 m around staggered blocks; nothing too narrow"}, draw_streets}};
  return all;
}

}  // namespace

const std::vector<SceneName>& scene_names() {
  static const std::vector<SceneName> names = [] {
    std::vector<SceneName> list;
    for (const Entry& entry : entries()) list.push_back(entry.name);
    return list;
  }();
  return names;
}

Scene make_scene(const std::string& name, double scale) {
  if (!(scale >= kMinSceneScale && scale <= kMaxSceneScale)) {
    throw InputError("--scale: must be from " + shown(kMinSceneScale) + " to " + shown(kMaxSceneScale) +
                     " times the shipped size, is " + shown(scale));
  }
  std::string known;
  for (const Entry& entry : entries()) {
    known += (known.empty() ? "" : ", ") + std::string(entry.name.name);
    if (name != entry.name.name) continue;
    Drawing drawing(name, scale);
    entry.draw(drawing);
    return drawing.take();
  }
  throw InputError("unknown scene \"" + name + "\"; known are " + known);
}

std::string scene_json(const std::string& name, double scale) { return native_json(make_scene(name, scale).workspace); }

}  // namespace krait::host
