// SPDX-License-Identifier: Apache-2.0
// The equations of motion of the models in double precision, and what they say of the motion between two states.
#pragma once

#include <array>

#include "robot.hpp"

namespace krait::campaign {

inline constexpr int kMostState = 5 + kMaxTrailers;
inline constexpr int kMostBodies = 1 + kMaxTrailers;
using State = std::array<double, kMostState>;

struct Frame {
  double x;
  double y;
  double cos;
  double sin;
};
using Frames = std::array<Frame, kMostBodies>;

// How far a body's frame can have gone, metres, and turned, radians.
struct Reach {
  double path;
  double turn;
};
using Reaches = std::array<Reach, kMostBodies>;

class Equations {
 public:
  explicit Equations(const Robot& robot);

  int state_size() const { return state_size_; }
  int bodies() const { return bodies_; }
  // Bodies i and j must keep apart when |i - j| is at least this.
  int self_collision_gap() const { return gap_; }
  // Of a hitch, radians.
  double max_hitch_angle() const { return max_hitch_; }

  // Component i of a state is an angle: a body's heading, or the steering of a car.
  bool is_angle(std::size_t i) const;

  // d state / d t under a control of two numbers.
  void rates(const State& s, const double* u, State& ds) const;
  void place(const State& s, Frames& frames) const;

  // Between states a and b, `time` seconds apart under a constant control: no body goes or turns more than this.
  void reach(const State& a, const Frames& at_a, const State& b, const Frames& at_b, const double* u, double time,
             Reaches& reaches) const;

  // The hitch angle before body k, radians.
  double hitch(const State& s, int k) const { return s[heading_of(k - 1)] - s[heading_of(k)]; }

  // By how much of the limit the worst of speeds, steering and controls is beyond its own; 0 or less: within. These
  // are linear between states that one control joins.
  double excess(const State& s, const double* u) const;

 private:
  std::size_t heading_of(int body) const {
    return static_cast<std::size_t>(body == 0 ? 2 : state_size_ - bodies_ + body);
  }
  void kinematic_rates(const State& s, const double* u, State& ds) const;
  void chain_rates(const State& s, const double* u, State& ds) const;
  void chain_reach(const State& a, const Frames& at_a, const State& b, const Frames& at_b, double time,
                   Reaches& reaches) const;
  void trailer_reach(const Frames& at_a, const Frames& at_b, double way, double path, Reaches& reaches) const;

  Model model_;
  int state_size_;
  int bodies_;
  int gap_ = 1000;
  double max_hitch_ = 0;
  double wheelbase_ = 1, hitch_length_ = 1;  // chains
  double radius_ = 1, track_ = 1;            // diff_drive
  double max_speed_ = 0, min_speed_ = 0;     // of v, of a unicycle, of a wheel
  double max_steering_ = 0;                  // chains
  double max_turn_rate_ = 0;                 // unicycle2
  double max_first_ = 0, max_second_ = 0;    // of the controls, both ways; where the first is a speed it is not here
};

}  // namespace krait::campaign
