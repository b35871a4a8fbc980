// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/pieces.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "krait/format.hpp"

namespace krait::host::compiler {
namespace {

using Outline = std::vector<std::uint32_t>;  // indices of points, counter-clockwise; straight vertices stay in

class Merger {
 public:
  Merger(const Triangulation& t, const std::function<bool(const Face&)>& solid) : t_(t), outlines_(t.faces.size()) {
    for (std::uint32_t f = 0; f < t.faces.size(); ++f) {
      const Face& face = t.faces[f];
      if (!solid(face)) continue;
      outlines_[f] = {face.corners[0], face.corners[1], face.corners[2]};
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t other = face.neighbors[i];
        if (other == kNone || other < f || !solid(t.faces[other])) continue;
        const GridPoint a = t.corner(face, i), b = t.corner(face, i + 1);
        diagonals_.push_back({dot(a, b, b), f, other, face.corners[i], face.corners[(i + 1) % 3]});
      }
    }
    std::sort(diagonals_.begin(), diagonals_.end());
    parents_.resize(outlines_.size());
    std::iota(parents_.begin(), parents_.end(), 0U);
  }

  std::vector<GridRing> run() {
    for (const Diagonal& d : diagonals_) merge(d);
    std::vector<GridRing> pieces;
    for (const Outline& outline : outlines_) {
      if (!outline.empty()) pieces.push_back(strict(outline));
    }
    return pieces;
  }

 private:
  struct Diagonal {
    std::int64_t squared_length;
    std::uint32_t left, right;  // faces
    std::uint32_t from, to;     // points, left on the left
    bool operator<(const Diagonal& o) const {
      return std::pair(-squared_length, std::pair(left, right)) <
             std::pair(-o.squared_length, std::pair(o.left, o.right));
    }
  };

  std::uint32_t root(std::uint32_t face) {
    while (parents_[face] != face) face = parents_[face] = parents_[parents_[face]];
    return face;
  }

  void merge(const Diagonal& d) {
    const std::uint32_t left = root(d.left), right = root(d.right);
    if (left == right) return;
    const Outline joined = join(outlines_[left], outlines_[right], d.from, d.to);
    if (!convex(joined)) return;
    parents_[right] = left;
    outlines_[left] = joined;
    outlines_[right].clear();
  }

  // Both outlines without the stretch around from → to that they share.
  static Outline join(Outline a, Outline b, std::uint32_t from, std::uint32_t to) {
    std::rotate(a.begin(), std::find(a.begin(), a.end(), to), a.end());    // to … from
    std::rotate(b.begin(), std::find(b.begin(), b.end(), from), b.end());  // from … to
    std::size_t ahead = 0, behind = 0;  // vertices beyond `to` and before `from` that are shared too
    while (ahead + 2 < a.size() && ahead + 2 < b.size() && a[ahead + 1] == b[b.size() - 2 - ahead]) ++ahead;
    while (ahead + behind + 2 < a.size() && ahead + behind + 2 < b.size() && a[a.size() - 2 - behind] == b[behind + 1])
      ++behind;
    Outline joined(a.begin() + std::ptrdiff_t(ahead), a.end() - std::ptrdiff_t(behind));
    joined.insert(joined.end(), b.begin() + std::ptrdiff_t(behind) + 1, b.end() - std::ptrdiff_t(ahead) - 1);
    return joined;
  }

  GridRing strict(const Outline& outline) const {
    GridRing ring;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const GridPoint before = t_.points[outline[(i + outline.size() - 1) % outline.size()]];
      const GridPoint here = t_.points[outline[i]], after = t_.points[outline[(i + 1) % outline.size()]];
      if (cross(before, here, after) != 0) ring.push_back(here);
    }
    return ring;
  }

  bool convex(const Outline& outline) const {
    int corners = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const GridPoint before = t_.points[outline[(i + outline.size() - 1) % outline.size()]];
      const GridPoint here = t_.points[outline[i]], after = t_.points[outline[(i + 1) % outline.size()]];
      const std::int64_t turn = cross(before, here, after);
      if (turn < 0 || (turn == 0 && dot(here, before, after) > 0)) return false;
      corners += turn > 0;
    }
    return corners <= format::kMaxPieceVertices;
  }

  const Triangulation& t_;
  std::vector<Outline> outlines_;  // by the root face of the piece
  std::vector<Diagonal> diagonals_;
  std::vector<std::uint32_t> parents_;
};

}  // namespace

std::vector<GridRing> convex_pieces(const Triangulation& t, const std::function<bool(const Face&)>& solid) {
  return Merger(t, solid).run();
}

}  // namespace krait::host::compiler
