// SPDX-License-Identifier: Apache-2.0
// Which of the outlines of one shape are holes in others.
#pragma once

#include <cstddef>
#include <vector>

#include "host/workspace/workspace.hpp"

namespace krait::host {

enum class FillRule { nonzero, even_odd };

struct Filling {
  std::vector<Obstacle> obstacles;
  bool loses_hole = false;  // since its outline touches another
};

// Outlines and holes by the fill rule, each hole with the outline around it. Where outlines touch themselves or one
// another, or `work` (comparisons, from which those made are subtracted) does not suffice to find out, each is an
// obstacle of its own: more than what is filled, never less. Rings of fewer than three points have no area and are
// dropped.
Filling filled(const std::string& label, std::vector<Ring> rings, FillRule rule, std::size_t& work);

}  // namespace krait::host
