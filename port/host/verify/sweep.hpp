// SPDX-License-Identifier: Apache-2.0
// What the robot's bodies cover while it moves, held against the obstacles and against each other.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host/verify/complaints.hpp"
#include "host/verify/drive.hpp"
#include "host/verify/dynamics.hpp"
#include "host/verify/obstacles.hpp"

namespace krait::host {

// Each body that fails is named once: with the first place where it does, and by how much it fails there and later.
class Sweep {
 public:
  // Keeps references. Coordinates of states are those of `obstacles`.
  Sweep(const RobotSpec& robot, const Dynamics& dynamics, const Obstacles& obstacles, Complaints& complaints);

  // `where` begins each complaint, as in "start".
  void check_pose(const std::string& where, const State& state);

  // The hull of each body in two states.
  void check_between(const std::string& where, const State& from, const State& to);

  // A motion of `time` seconds.
  void check_leg(const std::string& where, const Leg& leg, double time);

  double clearance() const { return clearance_; }
  double self_clearance() const { return self_clearance_; }
  double stray() const { return stray_; }

 private:
  // What a body does wrong, as in " overlaps the wall by up to " 0.1 " m".
  struct Failure {
    std::string before;
    std::optional<double> amount;
    std::string after;
  };

  // A body's first.
  struct Failed {
    std::string before;
    std::size_t complaint = 0;
  };

  // Poses of one motion, and how to say where one of them is.
  struct Way {
    const std::string& where;
    const std::vector<Pose>& poses;
    double sub_step;  // seconds; 0: there is nothing to tell apart

    std::string body(std::size_t index, std::size_t body) const;
  };

  void check_way(const Way& way);
  void check_obstacles(const Way& way, std::size_t body, std::size_t first, std::size_t last);
  bool is_clear(const Convex& hull) const;
  void measure(const Way& way, std::size_t body, std::size_t index, const Convex& hull);
  void check_pair(const Way& way, std::size_t first, std::size_t second);
  bool are_apart(const Way& way, std::size_t first, std::size_t second) const;
  void measure_pair(const Way& way, std::size_t first, std::size_t second, std::size_t index);
  double pair_reach(std::size_t first, std::size_t second) const;
  void fail(const Way& way, std::size_t body, std::size_t index, const Failure& failure);

  const RobotSpec& robot_;
  const Dynamics& dynamics_;
  const Obstacles& obstacles_;
  Complaints& complaints_;
  std::vector<Convex> shapes_;  // of each body, in its own frame
  std::vector<double> radii_;   // of each body around its frame's origin
  std::vector<std::optional<Failed>> failed_;
  double clearance_;
  double self_clearance_;
  double stray_ = 0;
};

}  // namespace krait::host
