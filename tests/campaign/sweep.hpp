// SPDX-License-Identifier: Apache-2.0
// Sweeps the bodies along a driven way: intervals are halved until nothing can have happened in them unseen.
#pragma once

#include <vector>

#include "drive.hpp"
#include "field.hpp"

namespace krait::campaign {

// A body that met another, or an obstacle or the bounds (other -1). Steps count from 0, with the part of the step.
struct Contact {
  int body;
  int other;
  double step;   // the first time
  double depth;  // m, the most
};

class Sweep {
 public:
  Sweep(const Equations& equations, std::vector<Convex> bodies, const Field& field);

  // The first state; a body that begins in an obstacle has a contact.
  void begin(const State& state);
  // On to the state `time` seconds later, under a constant control. `step` is for contacts.
  void go(const State& to, const double* u, double time, double step);

  double clearance() const { return clearance_; }
  const std::vector<Contact>& contacts() const { return contacts_; }
  double hitch_excess() const { return hitch_excess_; }  // the largest beyond the limit, as a share of it

 private:
  struct Pose {
    State state;
    Frames frames;
    // Of each body the room, as far as it was looked for; 0: not yet.
    std::array<double, kMostBodies> room;
    std::array<double, kMostBodies> looked;
  };
  struct Pair {
    int first;
    int second;
  };
  // What is to be proven of an interval.
  struct Open {
    std::vector<int> bodies;
    std::vector<Pair> pairs;
    std::vector<int> hitches;  // the bodies behind them

    bool none() const { return bodies.empty() && pairs.empty() && hitches.empty(); }
  };

  void set(Pose& pose, const State& state) const;
  double room(Pose& pose, int k, double reach);
  void prove(Pose& a, Pose& b, const double* u, double time, const Open& open, std::size_t depth);
  bool body_free(Pose& a, Pose& b, int k, double way);
  bool pair_free(const Pose& a, const Pose& b, const Pair& pair, double way);
  bool hitch_within(const Pose& a, const Pose& b, int k, double turn);
  double pair_room(const Pose& pose, const Pair& pair) const;
  void meet(int body, int other, double room);

  const Equations& equations_;
  const std::vector<Convex> bodies_;
  const Field& field_;
  std::vector<Frame> middles_;    // of the bodies, in their frames; only x and y
  std::vector<double> radii_;     // of the bodies around their middles
  std::vector<double> farthest_;  // of their corners from their frames' origins
  Open all_;
  std::vector<Open> left_;  // by depth
  Pose here_, next_;
  double step_ = 0;
  double clearance_ = 1;
  double hitch_excess_ = 0;
  std::vector<Contact> contacts_;
};

}  // namespace krait::campaign
