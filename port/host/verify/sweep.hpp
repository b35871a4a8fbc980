// What the robot's bodies cover while it moves, held against the obstacles and against each other.
#pragma once

#include <cstddef>
#include <vector>

#include "host/verify/complaints.hpp"
#include "host/verify/dynamics.hpp"
#include "host/verify/obstacles.hpp"

namespace krait::host {

class Sweep {
 public:
  // Keeps references. Coordinates of states are those of `obstacles`.
  Sweep(const RobotSpec& robot, const Dynamics& dynamics, const Obstacles& obstacles, Complaints& complaints);

  void check_pose(const State& state);

  // One step of a plan, number `index`: the motion under `control` from `from`, and the jump from where it ends to the
  // stored state `to`. A body that fails is named once a step.
  void check_step(std::size_t index, const State& from, const Control& control, double time, const State& to);

  double clearance() const { return clearance_; }
  double self_clearance() const { return self_clearance_; }
  double sweep_error() const { return sweep_error_; }

 private:
  using Pose = std::vector<Frame>;  // one frame a body

  struct Path {
    std::vector<Pose> poses;
    double error;  // m, how far a body strays from the hulls of consecutive poses
  };

  Path path(const State& from, const Control& control, double time, std::size_t count) const;
  double most_turn(const State& from, const State& to) const;
  double chord_error(const std::vector<Pose>& poses) const;
  double relative_bend(const Pose& before, const Pose& middle, const Pose& after) const;
  template <typename Visit>
  void for_each_pair(const Visit& visit) const;
  void check_hulls(const std::string& step, const std::vector<Pose>& poses, double time);
  bool check_obstacles(const std::string& where, std::size_t body, const Pose& from, const Pose& to);
  bool check_self(const std::string& where, std::size_t first, std::size_t second, const Pose& from, const Pose& to);

  const RobotSpec& robot_;
  const Dynamics& dynamics_;
  const Obstacles& obstacles_;
  Complaints& complaints_;
  std::vector<Convex> shapes_;  // of each body, in its own frame
  std::vector<double> radii_;   // of each body around its frame's origin
  double clearance_;
  double self_clearance_;
  double sweep_error_ = 0;
};

}  // namespace krait::host
