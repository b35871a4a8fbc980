// SPDX-License-Identifier: Apache-2.0
#include "krait/status.hpp"

#include <cstddef>

namespace krait {
namespace {

constexpr const char* kStatusNames[] = {"ok",
                                        "ready",
                                        "searching",
                                        "solved",
                                        "no_route",
                                        "budget_used",
                                        "tree_full",
                                        "time_used",
                                        "bad_scene",
                                        "bad_robot",
                                        "bad_argument",
                                        "start_outside",
                                        "start_in_collision",
                                        "goal_in_obstacle",
                                        "arena_too_small",
                                        "bad_arithmetic",
                                        "internal"};
static_assert(sizeof(kStatusNames) / sizeof(kStatusNames[0]) == static_cast<std::size_t>(Status::internal) + 1);

constexpr const char* kArgumentNames[] = {"none",
                                          "block",
                                          "scene",
                                          "start",
                                          "goal",
                                          "iterations",
                                          "vertices",
                                          "expansions",
                                          "when_full",
                                          "way_legs",
                                          "alpha",
                                          "beta",
                                          "gamma",
                                          "kappa",
                                          "update_regions",
                                          "group_sample",
                                          "epsilon",
                                          "dt",
                                          "max_steps",
                                          "open_steps",
                                          "path_regions",
                                          "near_radius",
                                          "goal_near_radius",
                                          "clearance",
                                          "stray_share",
                                          "gentle_share",
                                          "sight_tries",
                                          "candidates",
                                          "least_sketch",
                                          "doomed_steps",
                                          "restart_unit",
                                          "slowest",
                                          "reverse_share",
                                          "cost_length",
                                          "goal_margin",
                                          "end_speed",
                                          "max_substeps",
                                          "robot_dimensions",
                                          "robot_polygon",
                                          "robot_sizes"};
static_assert(sizeof(kArgumentNames) / sizeof(kArgumentNames[0]) ==
              static_cast<std::size_t>(Argument::robot_sizes) + 1);

}  // namespace

const char* to_string(Status status) { return kStatusNames[static_cast<std::size_t>(status)]; }

const char* to_string(Argument argument) { return kArgumentNames[static_cast<std::size_t>(argument)]; }

}  // namespace krait
