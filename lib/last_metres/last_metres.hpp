// SPDX-License-Identifier: Apache-2.0
// The last metres to a pose: lines of arcs and straight pieces from where the robot is to the goal, the shortest of
// which are driven with the controller in the loop, so slowly in the end that the robot comes to rest at the pose. A
// robot that turns on the spot does so before straight pieces, and at the pose. One that drives backwards also tries
// lines to the ends of ways out of the pose, and drives these in reverse. One that pushes trailers leads the last of
// them backwards to where it stands when body 0 is at the pose and all are in line.
#pragma once

#include <cstdint>

#include "collision/sight.hpp"
#include "krait/goal.hpp"
#include "last_metres/dubins.hpp"
#include "last_metres/manoeuvre.hpp"
#include "last_metres/nimbleness.hpp"
#include "last_metres/pull_outs.hpp"

namespace krait::detail {

// A line to a pose that is driven in one go, or to a way out of it.
struct Shot {
  Pose end;     // of the body that leads; of a swing, where its last arc begins
  float lead;   // metres of the line's straight end or, of a swing, of its last arc
  float stage;  // metres ahead of the pose: the line leads there, and trailers are pushed back from there; or 0
  float length;
  std::uint8_t word;
  std::uint8_t radius;
  std::uint8_t way;  // out of the goal, to whose end the line leads; Manoeuvre::kNoWay: it leads to the goal
  bool backward;
};

class LastMetres {
 public:
  // Measured: bench/ABLATIONS.md, "Constants".
  static constexpr std::uint32_t kHold = 2;        // steps of a leg, at least, or
  static constexpr std::uint32_t kLongest = 64;    // of one that turns on the spot, at most
  static constexpr std::uint32_t kMostLegs = 192;  // of a shot
  static constexpr std::uint32_t kEvery = 4;       // states of an expansion, of which one shoots

  // For a goal, at which shots are aimed if it is a pose; the scene must outlive this.
  void assign(const Scene& scene, const Goal& goal, const Nimbleness& robot);

  // How sharply later shots brake, of the sharpest: assign sets what keeps most of them on their lines.
  void brake(float share) { braking_ = share; }

  // How many metres the robot drives at its top speed in the time that it takes to turn by a radian as fast as it can,
  // by which least_remaining counts turns; assign sets 0.
  void count_turns(float metres) { turn_ = metres; }

  // Which lines later shots have: with arcs and straight ends of so many times the size that assign sets, and with
  // detours, ways out or stages or swings, where others fail.
  struct Lines {
    float radii = 1.0F;
    float leads = 1.0F;
    bool detours = true;
  };
  void draw_with(const Lines& lines);

  // Whether a position is so near to the goal that it pays to shoot.
  bool near(Vec2 position) const { return length(position - goal_.center()) <= capture_; }

  // Whether trailers must be straight at the goal.
  bool asks_for_straight() const { return goal_.facing().hitches < kInfinity; }

  // Metres within which it does.
  float capture() const { return capture_; }

  // Chooses the shots from where the robot is, by the frames of its bodies: of all words, radii, straight ends and ways
  // that the goal allows the shortest few on which a disc in the robot seems to be free. At most 128 looks at a place
  // (Sight::slack) a line.
  void choose(const Pose* poses);

  // Chooses the shots to ways out of the goal, which it finds where it has not yet. Parking calls it.
  void choose_ways(const Pose* poses);

  // Whether the robot drives ways out of narrow places.
  bool parks() const { return robot_.parking != nullptr; }

  // Finds the ways out of where body 0 stands: with far_out those rather that end with a long arc. Those of the goal
  // are found anew when they are needed. Returns how many there are. Departure calls it.
  int find_ways_from(const Pose& start, bool far_out);

  // Whether the ways that manoeuvre() drives are those which find_ways_from found last.
  bool ways_lead_from_start() const { return ways_of_ == WaysOf::start; }
  Manoeuvre& manoeuvre() { return manoeuvre_; }

  // Measures a robot that pushes trailers, by its frames. Docking calls these five.
  void measure_push(const Pose* poses);

  // Chooses, once after choose, the shots whose lines turn too far and back at their end, so that trailers which need
  // to be straight are straightened within less room than a straight end needs. Returns whether there are any. At most
  // 128 steps a line in which trailers are drawn.
  bool choose_swings(const Pose* poses);

  // Whether a shot along the line may be driven: it does not push too far, or a swing straightens the trailers.
  bool allows(const Pose* poses, const Shot& shot, const CurvedLine& line) const;

  // Chooses the shots that pull the trailers straight ahead of the goal and then push them back to it.
  void choose_stages(const Pose* poses);

  // Begins the rest of such a shot, whose line has ended ahead of the goal: the line back.
  void turn_back();

  // Begins the next shot that was chosen, from the same place. False when none remains.
  bool next(const Pose* poses);

  // The next leg's target. False when the shot has ended, the robot is too far off its line, or it does not turn.
  bool aim(const Moment& now, Target& target);

  // Metres at the top speed that take no more time than what remains of the shot's line and turns. After aim.
  float least_remaining(const Moment& now) const;

  // Whether a leg of `steps` steps is over: one that turns the robot or its wheels, when they have turned.
  bool leg_over(std::uint32_t steps, const Moment& now);

 private:
  static constexpr float kLook = 0.5F;  // how far ahead the robot steers, in lengths of body 0; measured, too
  static constexpr int kRadii = 3;
  static constexpr int kShortLeadCount = 2;
  static constexpr int kLeadCount = 2 * kShortLeadCount;
  static constexpr std::uint32_t kMostShots = 4;  // measured, too

  enum class WaysOf : std::uint8_t { none, goal, start };

  // Whether the shot turns on the spot and drives straight.
  bool on_the_spot(const Shot& shot) const { return radii_[shot.radius] == 0.0F; }

  // To which side the last arc of a swing turns, left (1) or right (-1); 0: the shot is none.
  static int swing(const Shot& shot) { return shot.radius < kRadii ? 0 : (shot.radius == kRadii ? 1 : -1); }

  // Where the shot's line is `lead` metres from its end, and the direction that it has there.
  static Pose before_end(const Shot& shot, float lead);

  // The body that keeps to the shot's line: body 0, or one that is pushed.
  int leader(const Shot& shot) const { return shot.backward ? robot_.backing_body : 0; }

  void forget_shots(bool by_detour);

  PullOuts::Body body_that_pulls_out(float short_cost) const;

  // Draws the shot's line. False where it has none, or one with arcs that is longer than `most` metres.
  bool draw(const Pose& from, const Shot& shot, float most, CurvedLine& line) const;
  void consider_leads(const Pose* poses, int first, int last);
  void consider_words(const Pose* poses, Shot& shot);

  void consider(const Pose* poses, Shot& shot);
  bool looks_free(const CurvedLine& line) const;

  // Whether trailers that are drawn along the line seem to be free, do not fold, and are straight at its end.
  bool straightens(const Pose* poses, const CurvedLine& line) const;

  // Body 0 where a swing ends whose last arc turns to that side, for one of the goal's headings.
  Pose end_of_swing(SinCos heading, int side) const;

  // Goes along the line as far as the robot has come. False where the robot is too far off the line.
  bool keep_to_line(const Pose& at);

  // Radians by which the robot has to turn still, along the line or on the spot.
  float least_turn(const Moment& now) const;

  // Metres that remain of the shot's line.
  float remaining() const { return line_.length() - arc_; }

  // Whether the robot is where the line ends.
  bool arrived() const { return remaining() <= near_; }

  // The straight piece from here toward the goal, or to the lead before it. Returns whether the robot faces it.
  bool begin_straight(const Shot& shot, const Pose& at);

  // Makes the leg a turn on the spot. False when the last one has not turned the robot.
  bool turn(const Pose& at, Target& target);

  // What body 0 has to turn to face where it should, radians.
  float off(const Pose& at) const { return angle_between(at.heading, facing_); }

  // A point that far along a line, or nearer where that is outside of the bounds.
  Vec2 point_ahead(const CurvedLine& line, float arc, float look) const;

  const Scene* scene_;
  Goal goal_ = Goal::named(0);
  Nimbleness robot_;
  Sight sight_;
  Sight spin_;  // for a disc that body 0 lies in
  float braking_;
  float turn_;               // metres, by which a radian counts
  float radii_[kRadii + 2];  // metres; the last two are that of swings
  float leads_[kLeadCount];  // metres, the short ones first
  int short_leads_;          // how many are only for where there is no room for the others
  float capture_;
  std::uint32_t hold_;  // steps of a leg that does not turn on the spot
  float reach_back_;    // metres from body 0 to the backing body, where all are in line
  float push_look_;     // metres ahead of that to which it is steered,
  float look_;          // and of body 0 where that leads
  float most_push_;     // metres of the longest line along which it is pushed
  Shot shots_[kMostShots];
  std::uint32_t shot_count_;
  std::uint32_t shot_;  // the one after that which is driven
  bool swung_;          // whether swings have been chosen
  bool by_detour_;      // whether the shots that were chosen last lead to ways out or to stages
  WaysOf ways_of_;      // what ways_ lead out of
  bool detours_;        // whether ways out, swings and stages are
  PullOuts ways_;
  Manoeuvre manoeuvre_;
  CurvedLine line_;      // that is driven
  float arc_;            // metres along it
  std::uint32_t stops_;  // legs that only brake
  float near_;           // metres from the line's end, where it stops
  float lead_;           // metres before the goal, where the straight piece ends
  bool straight_;        // whether a straight piece begins, toward which the robot turns
  bool turning_;         // whether the leg turns on the spot
  SinCos facing_;        // what it turns body 0 to,
  float enough_;         // radians off that,
  float off_;            // and how far it was off when the leg began
};

}  // namespace krait::detail
