// SPDX-License-Identifier: Apache-2.0
// A drawing's obstacles and bounds as the judge sees them: the edges of its polygons and of its occupied cells, in a
// grid of buckets, double precision. Nothing of the compiled scene is in it.
#pragma once

#include <cstdint>
#include <vector>

#include "equations.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::campaign {

struct Box {
  double left, bottom, right, top;
};

// A body in the world, and the box around it.
struct Placed {
  Convex shape;
  Box box;
};
Placed placed(const Convex& body, const Frame& frame);

// Between two convex polygons, metres: their distance, or less the least way that parts them where they overlap.
double apart(const Convex& a, const Convex& b);

class Field {
 public:
  // Coordinates become relative to `origin`.
  Field(const host::Workspace& workspace, host::Point origin);

  // The distance from the body to the nearest edge and the bounds, at most `reach`; negative where it crosses one, by
  // how far it must move to leave it.
  double room(const Placed& body, double reach) const;

  // Whether no edge comes near the box and it lies in the bounds.
  bool clear(const Box& box) const;

  // Whether a corner of the body lies in an obstacle or out of the bounds.
  bool inside(const Placed& body) const;

 private:
  struct Edge {
    double ax, ay, bx, by;
  };
  struct Range {
    int left, bottom, right, top;  // buckets, right and top included
  };

  void add_ring(const host::Ring& ring, host::Point origin);
  void add_cells(const host::CellMap& map, host::Point origin);
  void fill_buckets();
  Range range(const Box& box) const;
  bool meets(const Edge& edge, int column, int row) const;
  bool empty(const Range& range) const;
  bool solid(double x, double y) const;
  std::size_t bucket(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  Box bounds_;
  std::vector<Edge> edges_;
  struct Outline {
    std::vector<host::Ring> rings;  // the first is the outer one
  };
  std::vector<Outline> outlines_;
  host::CellMap cells_;
  double cells_cos_ = 1, cells_sin_ = 0;
  double size_ = 1;  // of a bucket
  int columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> offsets_;  // by bucket, into list_
  std::vector<std::uint32_t> list_;
  std::vector<std::uint32_t> sums_;  // of the entries of all buckets left of and below a corner
};

}  // namespace krait::campaign
