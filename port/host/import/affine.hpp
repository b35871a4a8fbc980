// SPDX-License-Identifier: Apache-2.0
// Maps of the plane that keep lines straight, as drawings nest them.
#pragma once

#include <cmath>

#include "host/workspace/workspace.hpp"

namespace krait::host {

struct Affine {  // (x, y) to (a x + c y + e, b x + d y + f), as SVG's matrix()
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  Point at(const Point& p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }

  // First `inner`, then this.
  Affine after(const Affine& inner) const {
    const Point o = at({inner.e, inner.f});
    return {a * inner.a + c * inner.b,
            b * inner.a + d * inner.b,
            a * inner.c + c * inner.d,
            b * inner.c + d * inner.d,
            o.x,
            o.y};
  }

  // At least as much as any length grows.
  double stretch() const { return std::hypot(std::hypot(a, b), std::hypot(c, d)); }
};

}  // namespace krait::host
