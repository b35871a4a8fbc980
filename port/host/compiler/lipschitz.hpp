// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds on a distance along a segment: a distance changes by at most 1 a metre, so a few samples bound it everywhere.
#pragma once

#include <algorithm>
#include <queue>

namespace krait::host::compiler {

// Whether f(t) <= limit for all t in [0, length]; f changes by at most 1 a unit of t. Where f exceeds the limit by less
// than `slack` the answer may be yes.
template <class F>
bool never_exceeds(const F& f, double from, double to, double limit, double slack) {
  const double middle = (from + to) / 2, half = (to - from) / 2;
  const double value = f(middle);
  if (value > limit + slack) return false;
  if (value + half <= limit + slack) return true;
  return never_exceeds(f, from, middle, limit, slack) && never_exceeds(f, middle, to, limit, slack);
}

// An upper bound of f on [0, length], at most `slack` and `share` of the maximum above the maximum.
template <class F>
double maximum(const F& f, double length, double slack, double share) {
  struct Piece {
    double bound, from, to, f_from, f_to;
    bool operator<(const Piece& other) const { return bound < other.bound; }
  };
  const auto piece = [](double from, double to, double f_from, double f_to) {
    return Piece{(f_from + f_to + to - from) / 2, from, to, f_from, f_to};
  };
  std::priority_queue<Piece> pieces;
  pieces.push(piece(0, length, f(0), f(length)));
  double best = std::max(pieces.top().f_from, pieces.top().f_to);
  while (pieces.top().bound > best * (1 + share) + slack) {
    const Piece p = pieces.top();
    pieces.pop();
    const double middle = (p.from + p.to) / 2, value = f(middle);
    best = std::max(best, value);
    pieces.push(piece(p.from, middle, p.f_from, value));
    pieces.push(piece(middle, p.to, value, p.f_to));
  }
  return pieces.top().bound;
}

}  // namespace krait::host::compiler
