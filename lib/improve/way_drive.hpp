// SPDX-License-Identifier: Apache-2.0
// Drives a robot along a route, leg by leg: a leg is some steps at full speed toward the place ahead on the route that
// its stretch says, and every step is proven as the tree's are. Near a pose it shoots as the tree does.
#pragma once

#include "improve/route.hpp"
#include "last_metres/last_metres.hpp"
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
  LastMetres* last_metres = nullptr;  // null: none are driven
  float depth = 0.0F;                 // metres: how deep inside the goal a way ends
  const float* start = nullptr;       // state_size() floats
};

class WayDrive {
 public:
  enum class Outcome {
    drives,    // has not ended
    reached,   // the way ends the plan
    passed,    // the next leg would begin behind the place on the route that it should get to
    blocked,   // a step is not free, or the robot gets no further
    too_long,  // it would not have fewer steps than the limit
    full       // the way has no room for more legs
  };

  // Room for a state.
  void allocate(Arena& arena, int state_size);

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
  // it may have fewer than `bound` steps and has not come `until` metres along it. Drives at most Way::kLegsAState of
  // the legs again, and none where the last way since assign began with as many: `from` must begin with the same.
  void begin(Way& way, const Way& from, std::uint32_t legs, const Route& route, std::uint32_t bound, float until);

  // Drives at most `steps` steps more.
  Outcome advance(std::uint32_t steps);

  // Metres along the route that the last leg begins at, or the next one would.
  float arc() const { return arc_; }

 private:
  // Measured: bench/ABLATIONS.md, "Constants".
  static constexpr std::uint32_t kMostStuck = 12;  // legs that get no further along the route
  static constexpr float kFurther = 0.025F;        // of `reach`: what counts as further
  static constexpr float kLeastShare = 0.97F;      // of the route or line that remains: any way on is at least as long
  static constexpr float kNextShots = 0.65F;  // of the route that remained when the robot last shot: it shoots again
                                              // when no more than that remains

  // Drives to where that leg of the way begins, or would begin, with the same bits as when its legs were driven first.
  void drive_again(const Way& way, std::uint32_t legs);

  // False when the step is not free.
  bool take_step(Drive& drive);

  // The brake is a leg of its own, toward the same target.
  void begin_braking();

  // One step of the brake; whether it ends the plan. Where it cannot, the way goes on from where the brake began.
  bool brake();

  // Chooses shots from the way's last state if it is near a pose.
  void begin_shots();

  // The next shot from there. False when none remains.
  bool begin_shot();

  // One step of a shot; whether it ends the plan. Where none does, the way goes on from where they began.
  bool shoot();

  // Each leg is one of the way. False where the shot has none any more, or would be too long.
  bool begin_shot_leg(const Moment& now);

  // So slow that the robot can stop where the route ends.
  float slow_share(const float* state) const;

  Outcome begin_leg();

  // Whether the way would not have fewer steps than the limit, with `remaining` metres to drive, a step at least.
  bool too_long(float remaining) const;

  const WayTools* tools_;
  Manner manner_;
  ProvenStep step_;
  Way* way_;
  const Route* route_;
  std::uint32_t bound_;
  float until_;
  float* resumed_from_;          // the state from which the last way differs from the one before,
  std::uint32_t resumed_after_;  // after so many legs; kNone: there is none since assign
  float arc_;
  float furthest_;  // of arc_, from where on it counted as further
  std::uint32_t stuck_;
  std::uint32_t remaining_;  // steps of the leg
  bool braking_;             // whether the last leg is a brake
  bool shooting_;            // whether the last legs are a shot's,
  float next_shots_;         // metres of the route that remain where they begin next,
  std::uint32_t shot_;       // the first of them,
  std::uint32_t leg_steps_;  // and the steps of the last
};

}  // namespace krait::detail
