// SPDX-License-Identifier: Apache-2.0
// The part of the checker that holds the bucket lists and the clearances to the geometry: what they leave out or call
// free a planner would drive through.
#include <algorithm>

#include "scene/cells.hpp"
#include "scene/checker.hpp"
#include "scene/grid_point.hpp"

namespace krait::detail {
namespace {

using format::Header;
using format::Section;

// The cells that a triangle meets.
class TriangleCells {
 public:
  TriangleCells(const CellSquares& cells, const Scene& scene, Index triangle)
      : cells_(cells), triangle_(polygon(scene, triangle)) {}

  CellSpan rows() const { return cells_.rows_between(triangle_.box.min.y, triangle_.box.max.y); }
  CellSpan columns(std::int32_t row) const { return cells_.columns_of(triangle_, row); }

 private:
  static GridPolygon polygon(const Scene& scene, Index triangle) {
    const Vec2 corners[] = {scene.corner(triangle, 0), scene.corner(triangle, 1), scene.corner(triangle, 2)};
    return GridPolygon({corners, 3});
  }

  const CellSquares& cells_;
  GridPolygon triangle_;
};

// The cells that a box meets.
class BoxCells {
 public:
  BoxCells(const CellSquares& cells, const Box& box)
      : rows_(cells.rows_between(to_grid(box.min.y), to_grid(box.max.y))),
        columns_(cells.columns_between(to_grid(box.min.x), to_grid(box.max.x))) {}

  CellSpan rows() const { return rows_; }
  CellSpan columns(std::int32_t) const { return columns_; }

 private:
  CellSpan rows_;
  CellSpan columns_;
};

// Between two intervals.
std::int64_t gap(std::int32_t low, std::int32_t high, std::int32_t other_low, std::int32_t other_high) {
  if (high < other_low) return std::int64_t{other_low} - high;
  return other_high < low ? std::int64_t{low} - other_high : 0;
}

bool box_within(const GridBox& box, const GridBox& square, std::int64_t reach) {
  const std::int64_t dx = gap(box.min.x, box.max.x, square.min.x, square.max.x);
  const std::int64_t dy = gap(box.min.y, box.max.y, square.min.y, square.max.y);
  return dx * dx + dy * dy < reach * reach;
}

bool vertex_within(const GridPolygon& piece, const GridBox& square, std::int64_t reach) {
  for (int i = 0; i < piece.count; ++i) {
    if (box_within({piece[i], piece[i]}, square, reach)) return true;
  }
  return false;
}

// Whether p is beside the edge, not before or after it, not on its left, where the piece lies, and nearer than `reach`.
// The test is in float, and tolerates a millionth in the file's favour.
bool beside_within(GridPoint p, GridPoint from, GridPoint to, float reach) {
  constexpr float kRounding = 1.0F + 1e-6F;
  const std::int64_t area = orientation(from, to, p);
  if (area > 0) return false;
  const std::int64_t dx = to.x - from.x;
  const std::int64_t dy = to.y - from.y;
  const std::int64_t square = dx * dx + dy * dy;
  const std::int64_t along = dx * (p.x - from.x) + dy * (p.y - from.y);
  if (along <= 0 || along >= square) return false;
  return static_cast<float>(-area) * kRounding < reach * std::sqrt(static_cast<float>(square));
}

// Asks each edge for the corner that is nearest to its line. Where two are, and only the other one is beside the edge,
// one of the edge's ends is as near to the square.
bool edge_within(const GridPolygon& piece, const GridBox& square, std::int32_t reach) {
  for (int i = 0; i < piece.count; ++i) {
    const GridPoint from = piece[i];
    const GridPoint to = piece.after(i);
    const GridPoint corner{to.y < from.y ? square.max.x : square.min.x, to.x > from.x ? square.max.y : square.min.y};
    if (beside_within(corner, from, to, static_cast<float>(reach))) return true;
  }
  return false;
}

// Whether a piece that does not meet the square comes nearer to it than `reach` grid steps.
bool within(const GridPolygon& piece, const GridBox& square, std::int32_t reach) {
  return box_within(piece.box, square, reach) &&
         (vertex_within(piece, square, reach) || edge_within(piece, square, reach));
}

std::uint8_t difference(std::uint8_t a, std::uint8_t b) {
  const std::uint8_t low = std::min(a, b);
  const std::uint8_t high = std::max(a, b);
  return static_cast<std::uint8_t>(high - low);
}

// The first column where the clearances of two rows differ by more than a cell, those of `other` shifted by -1, 0 or 1
// column; `columns` if none does. The largest difference comes first, in bytes alone, so that a compiler can take many
// at once.
std::int32_t first_steep(const std::uint8_t* row, const std::uint8_t* other, std::int32_t shift, std::int32_t columns) {
  const std::int32_t from = shift < 0 ? 1 : 0;
  const std::int32_t to = shift > 0 ? columns - 1 : columns;
  std::uint8_t most = 0;
  for (std::int32_t i = from; i < to; ++i) {
    const std::uint8_t step = difference(row[i], other[i + shift]);
    most = std::max(most, step);
  }
  if (most <= format::kClearanceUnits) return columns;
  std::int32_t first = from;
  while (difference(row[first], other[first + shift]) <= format::kClearanceUnits) ++first;
  return first;
}

// The columns that a polygon meets in one row and in the rows beside it.
struct Neighborhood {
  CellSpan below;
  CellSpan here;
  CellSpan above;

  // One column more on either side of all three.
  CellSpan columns(std::int32_t columns) const {
    CellSpan all{columns, -1};
    include(below, all);
    include(here, all);
    include(above, all);
    if (all.first < 0) all.first = 0;
    if (all.last > columns - 1) all.last = columns - 1;
    return all;
  }

 private:
  static void include(const CellSpan& span, CellSpan& all) {
    if (span.count() == 0) return;
    if (span.first - 1 < all.first) all.first = span.first - 1;
    if (span.last + 1 > all.last) all.last = span.last + 1;
  }
};

}  // namespace

// Entries ascend, so none is there twice; if every element is found wherever it belongs and there are no more entries
// than that, none is out of place.
template <class CellsOf>
bool SceneChecker::complete(const Lists& lists, const CellSquares& cells, CellsOf cells_of) {
  std::uint64_t found = 0;
  for (Index element = 0; element < lists.elements; ++element) {
    const auto met = cells_of(element);
    const CellSpan across = met.rows();
    for (std::int32_t row = across.first; row <= across.last; ++row) {
      const CellSpan along = met.columns(row);
      for (std::int32_t column = along.first; column <= along.last; ++column) {
        if (!holds(lists, cells.number(column, row), element)) return false;
      }
      found += along.count();
    }
  }
  return found == lists.total || fail(lists.section, misplaced(lists, cells, cells_of));
}

// The first entry that stands where its element does not belong.
template <class CellsOf>
std::uint32_t SceneChecker::misplaced(const Lists& lists, const CellSquares& cells, CellsOf cells_of) {
  std::uint32_t entry = 0;
  std::size_t bucket = 0;
  for (std::int32_t row = 0; row < cells.rows(); ++row) {
    for (std::int32_t column = 0; column < cells.columns(); ++column, ++bucket) {
      for (; entry < lists.offsets[bucket + 1]; ++entry) {
        const auto met = cells_of(lists.entries[entry]);
        if (!met.rows().holds(row) || !met.columns(row).holds(column)) return entry;
      }
    }
  }
  return entry;
}

// Whether the bucket's list, which is sorted, holds the element. Searches by bisection.
bool SceneChecker::holds(const Lists& lists, std::size_t bucket, Index element) {
  std::uint32_t first = lists.offsets[bucket];
  std::uint32_t last = lists.offsets[bucket + 1];
  while (first < last) {
    const std::uint32_t middle = first + (last - first) / 2;
    if (lists.entries[middle] == element) return true;
    if (lists.entries[middle] < element) {
      first = middle + 1;
    } else {
      last = middle;
    }
  }
  return fail(lists.section, first);
}

bool SceneChecker::ascending(const Lists& lists, std::size_t buckets) {
  for (std::size_t b = 0; b < buckets; ++b) {
    for (std::uint32_t i = lists.offsets[b]; i < lists.offsets[b + 1]; ++i) {
      const bool above = i == lists.offsets[b] || lists.entries[i] > lists.entries[i - 1];
      if (lists.entries[i] >= lists.elements || !above) return fail(lists.section, i);
    }
  }
  return true;
}

bool SceneChecker::longest(const std::uint32_t* offsets, std::size_t buckets, std::uint32_t most, std::uint32_t field) {
  std::uint32_t longest = 0;
  for (std::size_t b = 0; b < buckets; ++b) {
    if (offsets[b + 1] - offsets[b] > longest) longest = offsets[b + 1] - offsets[b];
  }
  return longest == most || fail_header(field);
}

bool SceneChecker::buckets(const Scene& s) {
  const Header& h = s.header_;
  const std::uint32_t count = h.bucket_columns * h.bucket_rows;
  const CellSquares cells(s.bounds(), h.bucket_size, h.bucket_columns, h.bucket_rows);
  return offsets(Section::bucket_triangle_offsets, s.bucket_triangle_offsets_, count, h.bucket_triangles, 0,
                 h.most_bucket_triangles) &&
         longest(s.bucket_triangle_offsets_, count, h.most_bucket_triangles, offsetof(Header, most_bucket_triangles)) &&
         bucket_triangles(s, cells) &&
         offsets(Section::bucket_piece_offsets, s.bucket_piece_offsets_, count, h.bucket_pieces, 0,
                 h.most_bucket_pieces) &&
         longest(s.bucket_piece_offsets_, count, h.most_bucket_pieces, offsetof(Header, most_bucket_pieces)) &&
         bucket_pieces(s, cells);
}

bool SceneChecker::bucket_triangles(const Scene& s, const CellSquares& cells) {
  const Lists lists{Section::bucket_triangles, s.bucket_triangles_, s.bucket_triangle_offsets_,
                    s.header_.bucket_triangles, s.header_.triangles};
  return ascending(lists, cells.number(0, cells.rows())) &&
         complete(lists, cells, [&](Index triangle) { return TriangleCells(cells, s, triangle); });
}

bool SceneChecker::bucket_pieces(const Scene& s, const CellSquares& cells) {
  const Lists lists{Section::bucket_pieces, s.bucket_pieces_, s.bucket_piece_offsets_, s.header_.bucket_pieces,
                    s.header_.pieces};
  return ascending(lists, cells.number(0, cells.rows())) &&
         complete(lists, cells, [&](Index piece) { return BoxCells(cells, s.piece_box(piece)); });
}

// No cell claims more than there is, by induction over the distance. Where the nearest obstacle or bound of a cell
// lies within it or one of its eight neighbours, the claim is compared with that. Else the way there, from the cell's
// square through those of its neighbours, is a cell long or more when it leaves the last of them: that neighbour is
// nearer by a cell at least, and the claim is at most its claim and a cell.
bool SceneChecker::clearance(const Scene& s) {
  const Header& h = s.header_;
  const CellSquares cells(s.bounds(), h.clearance_cell, h.clearance_columns, h.clearance_rows);
  return clearance_steps(s, cells) && clearance_to_bounds(s, cells) && clearance_to_pieces(s, cells);
}

// Neighbours, by side or corner, differ by a cell at most.
bool SceneChecker::clearance_steps(const Scene& s, const CellSquares& cells) {
  const std::int32_t columns = cells.columns();
  for (std::int32_t row = 0; row < cells.rows(); ++row) {
    const std::uint8_t* here = s.clearance_ + cells.number(0, row);
    std::int32_t first = first_steep(here, here, -1, columns);
    for (std::int32_t shift = -1; shift <= 1 && row > 0; ++shift) {
      const std::int32_t steep = first_steep(here, here - columns, shift, columns);
      if (steep < first) first = steep;
    }
    if (first < columns) return fail(Section::clearance, static_cast<std::uint32_t>(cells.number(first, row)));
  }
  return true;
}

// Only in the three outermost columns and rows can a bound lie within a cell or a neighbour: in the innermost of them
// where the outermost reaches no further over the bound than the margin by which cells are widened.
bool SceneChecker::clearance_to_bounds(const Scene& s, const CellSquares& cells) {
  constexpr std::int32_t kNear = 3;
  const std::int32_t unit = cells.size() / format::kClearanceUnits;
  const std::int32_t columns = cells.columns();
  for (std::int32_t row = 0; row < cells.rows(); ++row) {
    const bool every = row < kNear || row >= cells.rows() - kNear || columns <= 2 * kNear;
    const std::int32_t beside = cells.row_to_bounds(row);
    for (std::int32_t column = 0; column < columns; ++column) {
      if (!every && column == kNear) column = columns - kNear;
      const std::int32_t along = cells.column_to_bounds(column);
      const std::size_t here = cells.number(column, row);
      const std::int32_t claim = s.clearance_[here] * unit;
      if (claim > 0 && (claim > beside || claim > along)) {
        return fail(Section::clearance, static_cast<std::uint32_t>(here));
      }
    }
  }
  return true;
}

// Slivers of half a square grid step may lie on each other in any number and still be smaller than the bounds: what
// they cost is bounded by the cells that are looked at for a byte of the file.
bool SceneChecker::clearance_to_pieces(const Scene& s, const CellSquares& cells) {
  std::uint64_t looks = 0;
  for (Index p = 0; p < s.header_.pieces; ++p) {
    const GridPolygon piece(s.piece(p));
    const CellSpan rows = cells.rows_between(piece.box.min.y, piece.box.max.y);
    Neighborhood near{{}, {}, cells.columns_of(piece, rows.first)};
    for (std::int32_t row = rows.first - 1; row <= rows.last + 1; ++row) {
      const CellSpan columns = near.columns(cells.columns());
      if (row >= 0 && row < cells.rows()) {
        looks += columns.count();
        if (looks > std::uint64_t{format::kMostLooks} * size_)
          return fail(Section::piece_vertices, s.piece_offsets_[p]);
        if (!row_clear_of(s, cells, piece, row, near.here, columns)) return false;
      }
      const bool more = row + 2 <= rows.last;
      near = {near.here, near.above, more ? cells.columns_of(piece, row + 2) : CellSpan{}};
    }
  }
  return true;
}

bool SceneChecker::row_clear_of(const Scene& s, const CellSquares& cells, const GridPolygon& piece, std::int32_t row,
                                const CellSpan& met, const CellSpan& columns) {
  const std::int32_t unit = cells.size() / format::kClearanceUnits;
  for (std::int32_t column = columns.first; column <= columns.last; ++column) {
    const std::size_t here = cells.number(column, row);
    if (s.clearance_[here] == 0) continue;
    if (met.holds(column) || within(piece, cells.square(column, row), s.clearance_[here] * unit)) {
      return fail(Section::clearance, static_cast<std::uint32_t>(here));
    }
  }
  return true;
}

}  // namespace krait::detail
