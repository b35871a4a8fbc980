// SPDX-License-Identifier: Apache-2.0
// Collects what a drawing holds: shapes, each in a role.
#pragma once

#include <optional>
#include <string_view>

#include "host/workspace/workspace.hpp"

namespace krait::host {

enum class Role { obstacle, bounds, goal, start, none };

inline constexpr const char* kRoles = "obstacle, bounds, goal, start, none";

// By its word in kRoles.
std::optional<Role> role_of(std::string_view word);

class Drawing {
 public:
  explicit Drawing(std::string file) : file_(std::move(file)) {}

  void add_obstacle(Obstacle obstacle) { workspace_.obstacles.push_back(std::move(obstacle)); }
  void add_goal(const std::string& name, Goal goal);               // an empty name becomes goal, goal 2, ...
  void add_start(const std::string& name, Start start);            // start, start 2, ...
  void set_bounds(const std::string& place, const Ring& polygon);  // throws InputError where there are bounds already

  bool has_bounds() const { return bounds_.has_value(); }
  Workspace& workspace() { return workspace_; }

  // The bounds are the box around their polygon, and what of the box lies outside the polygon is an obstacle. Without a
  // polygon they are the box around all shapes, and a warning says so. Throws InputError where they have no size.
  Workspace take();

 private:
  void bound_all();

  std::string file_;
  Workspace workspace_;
  std::optional<Ring> bounds_;
};

}  // namespace krait::host
