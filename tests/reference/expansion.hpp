// SPDX-License-Identifier: Apache-2.0
// What a search tells of one expansion: the vertex it grows from, its target, and where its states lie.
#pragma once

#include <cstdint>
#include <vector>

#include "scene_builder.hpp"
#include "search/groups.hpp"

namespace krait::test::reference {

struct Expansion {
  bool begun = false;
  Index group = kNone;         // whose count of selections rose
  std::uint32_t selected = 0;  // how many did
  Index vertex = kNone;
  std::vector<Index> members;  // of the group, before it grew
  Target target;
  std::vector<Index> ahead;  // regions on the shortest path after the group's
  std::vector<Point> path;   // positions: the vertex's, then one after each step
  bool broken = false;       // whether a step began elsewhere than the last one ended
};

// Given to advance: looks at the planner when an expansion begins, and at each step.
template <class P>
class Watch {
 public:
  Watch(const P& planner, const std::vector<std::uint32_t>& selections, Expansion& expansion)
      : planner_(&planner), selections_(&selections), expansion_(&expansion) {}

  void expands(Index vertex, const Target& target) const {
    Expansion& e = *expansion_;
    e.begun = true;
    for (Index r = 0; r < selections_->size(); ++r) {
      if (planner_->groups().selections(r) == (*selections_)[r]) continue;
      e.group = r;
      e.selected += planner_->groups().selections(r) - (*selections_)[r];
    }
    e.vertex = vertex;
    planner_->groups().for_each_vertex(e.group, [&](Index member) { e.members.push_back(member); });
    e.target = target;
    e.path.push_back(position(planner_->tree().state(vertex)));
  }

  void operator()(const float* from, const float* to) const {
    const Point begin = position(from);
    expansion_->broken =
        expansion_->broken || begin.x != expansion_->path.back().x || begin.y != expansion_->path.back().y;
    expansion_->path.push_back(position(to));
  }

 private:
  static Point position(const float* state) { return point({state[0], state[1]}); }

  const P* planner_;
  const std::vector<std::uint32_t>* selections_;
  Expansion* expansion_;
};

}  // namespace krait::test::reference
