// SPDX-License-Identifier: Apache-2.0
// Drives a robot along a route, leg by leg: a leg is some steps at full speed toward the place ahead on the route that
// its stretch says, and every step is proven as the tree's are.
#pragma once

#include "improve/route.hpp"
#include "plan/ending.hpp"
#include "plan/proven_step.hpp"
#include "plan/way.hpp"

namespace krait::detail {

// What a way is driven by; all of it must stay.
struct WayTools {
  Robot robot;
  const Scene* scene = nullptr;
  const Parameters* parameters = nullptr;
  MotionCheck* check = nullptr;
  Drive* drive = nullptr;
  Drive* brake = nullptr;
  TargetGrid grid;
  const Ending* ending = nullptr;
  float depth = 0.0F;            // metres: how deep inside the goal a way ends
  const float* start = nullptr;  // state_size() floats
};

class WayDrive {
 public:
  enum class Outcome {
    drives,    // has not ended
    reached,   // the way ends the plan
    blocked,   // a step is not free, or the robot gets no further
    too_long,  // it would not have fewer steps than asked for
    full       // the way has no room for more legs
  };

  // The tools must outlive this. What is the same for all ways: legs of `hold` steps, `stride` metres the longest step
  // that the robot has made, `reach` metres how far on along the route its place is looked for, `near` metres how far
  // from the route's end a way may end.
  struct Manner {
    std::uint32_t hold;
    float stride;
    float reach;
    float near;
  };

  void assign(const WayTools& tools, const Manner& manner);

  // Makes `way` the first `legs` legs of `from`, or of none, and drives on from there along the measured route, while
  // it may have fewer than `bound` steps. Drives at most Way::kLegsAState of the legs again.
  void begin(Way& way, const Way& from, std::uint32_t legs, const Route& route, std::uint32_t bound);

  // Ends the way as too long where it is later than a rival at any place from `from` metres along the route on. The
  // rival reached the end of a route of `length` metres, which goes on as this one does from there.
  void race(const Way& rival, float length, float from);

  // Drives at most `steps` steps more.
  Outcome advance(std::uint32_t steps);

  // Metres along the route that the last leg begins at.
  float arc() const { return arc_; }

 private:
  // Measured: bench/ABLATIONS.md, "Constants".
  static constexpr std::uint32_t kMostStuck = 12;  // legs that get no further along the route
  static constexpr float kFurther = 0.025F;        // of `reach`: what counts as further
  static constexpr float kLater = 0.5F;            // steps
  static constexpr float kLeastShare = 0.97F;      // of the route that is left, below which no way on is

  // The same bits as when the leg was driven first.
  void drive_again(const Leg& leg);

  // False when the step is not free.
  bool take_step(Drive& drive);

  // The brake is a leg of its own, toward the same target.
  void begin_braking();

  // One step of the brake; whether it ends the plan. Where it cannot, the way goes on from where the brake began.
  bool brake();

  // So slow that the robot can stop where the route ends.
  float slow_share(const float* state) const;

  Outcome begin_leg();

  // Whether the rival came to where as much of its route is left in fewer steps.
  bool later();

  const WayTools* tools_ = nullptr;
  Manner manner_{};
  ProvenStep step_;
  Way* way_ = nullptr;
  const Route* route_ = nullptr;
  std::uint32_t bound_ = 0;
  float arc_ = 0.0F;
  float furthest_ = 0.0F;  // of arc_, from where on it counted as further
  std::uint32_t stuck_ = 0;
  std::uint32_t left_ = 0;  // steps of the leg
  bool braking_ = false;    // whether the last leg is a brake
  const Way* rival_ = nullptr;
  float rival_length_ = 0.0F;
  float from_ = 0.0F;
  std::uint32_t rival_leg_ = 0;    // that the rival was in where as much of its route was left, and
  std::uint32_t rival_steps_ = 0;  // its steps before that
};

}  // namespace krait::detail
