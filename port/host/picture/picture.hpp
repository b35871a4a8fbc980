// SPDX-License-Identifier: Apache-2.0
// Draws a scene, the search and the plan: SVG, PNG and a page that replays them.
// The same picture has the same bytes on one machine (fonts are the machine's own).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/plan_file/plan_file.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

struct Triangle {
  Point corners[3];
};

// Heuristic costs at one moment of the search. Infinite costs are regions cut off from the goal.
struct CostFrame {
  std::uint64_t iteration = 0;
  std::vector<float> costs;  // one a triangle; metres
};

struct TreeVertex {
  float x = 0;
  float y = 0;
  std::uint32_t parent = 0;  // the root's is itself; always smaller than the vertex's own index otherwise
  std::uint32_t iteration = 0;
};

// A place that a search without a plan is about, and a few words beside it.
struct Mark {
  Point at;
  std::string text;
};

// All in local coordinates (world = local + plan.origin).
struct Picture {
  std::string title;
  Point min, max;                     // the bounds; each side more than 0 and at most 1e5 m
  std::vector<Ring> obstacle_pieces;  // convex
  std::vector<Triangle> triangles;
  std::vector<CostFrame> frames;  // ascending by iteration; the first, before the search, has the colours' scale; may
                                  // be empty
  std::vector<TreeVertex> tree;   // ascending by iteration; may be thinned or empty
  std::vector<float> start;       // the state that the search began with, drawn where there is no plan; may be empty
  std::vector<Mark> marks;        // why there is no plan; may be empty
  PlanFile plan;                  // its states may be empty; robot.bodies are needed if they or `start` are not
};

// Each throws InputError, naming the part, for a picture that breaks what is said above (a cost that is NaN, a
// frame of the wrong size, a state of the wrong length, a coordinate that is not finite, ...).

std::string draw_svg(const Picture& picture);
std::string draw_png(const Picture& picture);  // the bytes of the file

// One file that needs no network. A tree vertex takes about 21 bytes of it, a state of a 15-link snake about 350;
// frames are thinned so that they take at most a megabyte (the first and the last stay), states to at most 6,000.
std::string draw_html(const Picture& picture);

}  // namespace krait::host
