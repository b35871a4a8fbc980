// SPDX-License-Identifier: Apache-2.0
// The last metres to a pose: lines of arcs and straight pieces from where the robot is to the goal, the shortest of
// which are driven with the controller in the loop, so slowly in the end that the robot comes to rest at the pose. A
// robot that turns on the spot does so before straight pieces, and at the pose.
#pragma once

#include <cstdint>

#include "collision/sight.hpp"
#include "krait/goal.hpp"
#include "krait/robots/model.hpp"
#include "search/dubins.hpp"

namespace krait::detail {

// What lines must be like for a robot.
struct Nimbleness {
  float length;          // metres, of body 0
  float turning_radius;  // metres; 0: turns on the spot
  float top_speed;       // m/s
  float half_width;      // metres: the radius of a disc around the position that lies in body 0
  float reach;           // metres: that of one which body 0 lies in
  bool backward;         // whether it may drive a line backwards
  float dt;              // seconds
};

class LastMetres {
 public:
  // Measured: bench/ABLATIONS.md, "Constants".
  static constexpr std::uint32_t kHold = 2;       // steps of a leg, or
  static constexpr std::uint32_t kLongest = 64;   // of one that turns on the spot, at most
  static constexpr std::uint32_t kMostLegs = 96;  // of a shot
  static constexpr std::uint32_t kEvery = 4;      // of so many states of an expansion one shoots

  // For a goal that is a pose; the scene must outlive this.
  void assign(const Scene& scene, const Goal& goal, const Nimbleness& robot);

  // Whether a position is so near to the goal that it pays to shoot.
  bool near(Vec2 position) const { return length(position - goal_.center()) <= capture_; }

  // Chooses the shots from a pose of body 0: of all words, radii, straight ends and ways that the goal allows the
  // shortest few on which a disc in the robot seems to be free. At most 128 looks at a place (Sight::slack) a line.
  void choose(const Pose& from);

  // Begins the next shot that was chosen, from the same pose. False when there is none left.
  bool next(const Pose& from);

  // The next leg's target, where body 0 is at `at`, moves at `speed` m/s and would come to rest within `stopping_way`
  // metres. False when the shot has ended, the robot has left its line, or it does not turn.
  bool aim(const Pose& at, float speed, float stopping_way, Target& target);

  // Whether a leg of so many steps is over where body 0 is at `at`: one that turns, when it has turned.
  bool leg_over(std::uint32_t steps, const Pose& at) const;

 private:
  static constexpr int kRadii = 3;
  static constexpr int kMostLeads = 4;
  static constexpr std::uint32_t kMostShots = 4;  // measured likewise

  struct Shot {
    float length;
    std::uint8_t word;
    std::uint8_t radius;
    std::uint8_t lead;
    bool backward;
    bool opposite;  // ends with the heading opposite to the goal's
  };

  // Whether the shot turns on the spot and drives straight.
  bool on_the_spot(const Shot& shot) const { return radii_[shot.radius] == 0.0F; }

  // The direction in which the shot drives in the end.
  SinCos end_direction(const Shot& shot) const;

  // Where the shot's line is `lead` metres from the goal.
  Vec2 before_goal(const Shot& shot, float lead) const;

  bool draw(const Pose& from, const Shot& shot, CurvedLine& line) const;
  void consider_leads(const Pose& from, int first, int last);
  void consider(const Pose& from, Shot shot);
  bool looks_free(const CurvedLine& line) const;

  // Goes along the line as far as the robot has come. False where it has left the line.
  bool keep_to_line(const Pose& at);

  // Whether the robot is where the line ends.
  bool arrived() const { return line_.length() - arc_ <= near_; }

  // The straight piece from here toward the goal, or to the lead before it. Returns whether the robot faces it.
  bool begin_straight(const Shot& shot, const Pose& at);

  // Makes the leg a turn on the spot. False when the last one has not turned the robot.
  bool turn(const Pose& at, Target& target);

  // What body 0 has to turn to face where it should, radians.
  float off(const Pose& at) const { return angle_between(at.heading, facing_); }

  // A point that far along a line, or nearer where that is outside of the bounds.
  Vec2 point_ahead(const CurvedLine& line, float arc, float look) const;

  const Scene* scene_ = nullptr;
  Goal goal_ = Goal::named(0);
  Nimbleness robot_{};
  Sight sight_;
  Sight spin_;  // for a disc that body 0 lies in
  float radii_[kRadii];
  float leads_[kMostLeads];
  int lead_count_ = 0;
  int short_leads_ = 0;  // of the leads, the first
  float capture_ = 0.0F;
  Shot shots_[kMostShots];
  std::uint32_t shot_count_ = 0;
  std::uint32_t shot_ = 0;   // the one after that which is driven
  CurvedLine line_;          // that is driven
  float arc_ = 0.0F;         // metres along it
  std::uint32_t stops_ = 0;  // legs that only brake
  float near_ = 0.0F;        // metres from the line's end, where it stops
  float lead_ = 0.0F;        // metres before the goal, where the straight piece ends
  bool straight_ = false;    // whether a straight piece begins, toward which the robot turns
  bool turning_ = false;     // whether the leg turns on the spot
  SinCos facing_{};          // what it turns body 0 to,
  float enough_ = 0.0F;      // radians off that,
  float off_ = kInfinity;    // and how far it was off when the leg began
};

}  // namespace krait::detail
