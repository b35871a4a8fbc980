// SPDX-License-Identifier: Apache-2.0
// Checks the bytes of a scene file before anything else reads them.
#pragma once

#include "krait/scene.hpp"
#include "scene/cells.hpp"

namespace krait::detail {

class SceneChecker {
 public:
  SceneChecker(const std::byte* bytes, std::size_t size) : bytes_(bytes), size_(size) {}

  // Lengths, order, overlap and alignment of everything, and the check sum; copies the header. False on failure.
  bool header(format::Header& header);

  // Every element of every section. Only after header() said true, on a scene that views these bytes.
  bool contents(const Scene& scene);

  // The first failure, or solved.
  const Failure& failure() const { return failure_; }

 private:
  bool fail(format::Section section, std::uint32_t element);
  bool fail_header(std::uint32_t element);

  bool preamble(const format::Header& h);
  bool geometry(const format::Header& h);
  bool layout(const format::Header& h);
  bool vertices(const Scene& s);
  bool triangles(const Scene& s);
  bool adjacency(const Scene& s);
  bool portals(const Scene& s);
  bool goals(const Scene& s);
  bool starts(const Scene& s);
  bool pieces(const Scene& s);
  bool names(const Scene& s);
  bool gaps(const Scene& s);
  bool offsets(format::Section section, const std::uint32_t* offsets, std::uint32_t count, std::uint32_t total,
               std::uint32_t least, std::uint32_t most);

  // The lists of triangles or pieces by bucket.
  struct Lists {
    format::Section section;
    IndexArray entries;
    const std::uint32_t* offsets;  // a bucket and one
    std::uint32_t total;           // entries
    std::uint32_t elements;        // triangles or pieces of the scene
  };
  bool buckets(const Scene& s);
  bool bucket_triangles(const Scene& s, const CellSquares& cells);
  bool bucket_pieces(const Scene& s, const CellSquares& cells);
  bool ascending(const Lists& lists, std::size_t buckets);
  bool longest(const std::uint32_t* offsets, std::size_t buckets, std::uint32_t most, std::uint32_t field);
  // The lists of the cells in rows() and columns(row) of cells_of(element) must name the element, and no others.
  template <class CellsOf>
  bool complete(const Lists& lists, const CellSquares& cells, CellsOf cells_of);
  template <class CellsOf>
  static std::uint32_t misplaced(const Lists& lists, const CellSquares& cells, CellsOf cells_of);
  bool holds(const Lists& lists, std::size_t bucket, Index element);

  bool clearance(const Scene& s);
  bool clearance_steps(const Scene& s, const CellSquares& cells);
  bool clearance_to_bounds(const Scene& s, const CellSquares& cells);
  bool clearance_to_pieces(const Scene& s, const CellSquares& cells);
  bool row_clear_of(const Scene& s, const CellSquares& cells, const GridPolygon& piece, std::int32_t row,
                    const CellSpan& met, const CellSpan& columns);

  const std::byte* bytes_;
  std::size_t size_;
  Failure failure_;
};

}  // namespace krait::detail
