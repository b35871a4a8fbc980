// SPDX-License-Identifier: Apache-2.0
// Expands the motion tree (Algorithm 2, lines 4 to 15): from a vertex toward a target, step by step, as long as every
// step is free. Near the goal it brakes, and to a pose it drives the last metres.
#pragma once

#include "collision/motion_check.hpp"
#include "decomposition/regions.hpp"
#include "krait/planner.hpp"
#include "last_metres/last_metres.hpp"
#include "motion/drive.hpp"
#include "plan/ending.hpp"
#include "plan/motion_tree.hpp"
#include "search/recent_states.hpp"

namespace krait::detail {

// Who keeps the states to grow from.
class Keeper {
 public:
  Keeper() = default;
  // Calls search.keep(region, branch, state) of every new state that is not doomed. It may make the state a vertex, and
  // returns false when the search cannot go on. The search must outlive this.
  template <class S>
  explicit Keeper(S& search) : search_(&search), keep_(&keep<S>) {}

  bool operator()(Index region, Branch branch, const float* state) const {
    return keep_(search_, region, branch, state);
  }

 private:
  template <class S>
  static bool keep(void* search, Index region, Branch branch, const float* state) {
    return static_cast<S*>(search)->keep(region, branch, state);
  }

  void* search_ = nullptr;
  bool (*keep_)(void* search, Index region, Branch branch, const float* state) = nullptr;
};

// What expansions grow the tree with; all of it must outlive them.
struct ExpanderTools {
  Robot robot;
  const Scene* scene;
  const Parameters* parameters;
  const Regions* regions;
  MotionTree* tree;
  MotionCheck* check;
  const Ending* ending;
  Statistics* statistics;
  Keeper keeper;
  float robot_length;              // metres, of body 0
  float goal_depth;                // metres: how deep inside the goal a way ends
  bool shoots;                     // whether the last metres to a pose are driven
  std::uint32_t spare_expansions;  // that the tree keeps back for what ends a way
};

enum class Outcome : std::uint8_t { goal_reached, target_reached, target_not_reached, collision, tree_full, goes_on };

struct Expanded {
  Outcome outcome;
  Index region;               // of the last state
  Branch last;                // the last state, when there was a step
  std::uint32_t crossed = 0;  // how often a step ended in another region than it began in
};

class Expander {
 public:
  // Steps last dt seconds. The robot must outlive this; `recent` has its memory.
  void set_up(const Robot& robot, float dt, const RecentStates& recent);

  // Prepares for a query.
  void assign(const ExpanderTools& tools);

  // Forgets what goes on: the tree has been emptied.
  void reset();

  // Expands from a vertex, which lies in `region` (or kNone: not known), toward the target. The tree must have room for
  // an expansion. At most SearchTuning::max_steps steps; where it goes_on, continue_expansion makes as many more.
  Expanded expand(Index vertex, Index region, const Target& toward, const Watch& watch);
  Expanded continue_expansion(const Watch& watch);

  // A way from the root that is driven leg by leg, each of them an expansion: begin_legs, then begin_leg and its steps,
  // then the next, and end_legs when the way or an iteration has ended.
  void begin_legs();
  // False where the tree has no room for it.
  bool begin_leg(const Target& target);
  // One step; target_not_reached where the way may go on. `keeps`: the state after it is kept to grow from.
  Outcome take_leg_step(bool keeps, const Watch& watch);
  // Ends the last leg, unless the outcome is that the way has reached the goal or goes on.
  const Expanded& end_legs(Outcome outcome);
  // The state that the legs have come to.
  Moment now() const { return {tools_.robot, drive_.state(), tools_.check->poses()}; }

  const ExpanderTools& tools() const { return tools_; }

  // The last state of an expansion that has reached the goal, that of its brake included.
  Branch end() const { return braking() ? Branch{braking_, brake_steps_} : expanded_.last; }

  // Ends an expansion whose way to the goal is no plan.
  void refuse();

  // Puts the robot there without growing the tree.
  void place(const float* state) { drive_.begin(state); }
  const float* state() const { return drive_.state(); }

  // The drives are free for others while no expansion runs.
  Drive& drive() { return drive_; }
  Drive& brake() { return brake_; }
  LastMetres& last_metres() { return last_metres_; }

 private:
  // How often an expansion past max_steps may have crossed a portal; measured: bench/ABLATIONS.md, "Constants".
  static constexpr std::uint32_t kOpen = 1;

  Vec2 position() const { return {drive_.state()[0], drive_.state()[1]}; }

  // Metres from the target: of body 0, backwards of the one that leads.
  float target_distance() const;

  bool braking() const { return braking_ != kNone; }

  // Whether the expansion waits for what may end the way from its last state.
  bool waits() const { return braking() || shooting_; }

  Outcome take_turn(const Watch& watch);

  // Whether the expansion continues after this step. Past max_steps it does in the open only, and while each step
  // decreases the distance to the target.
  bool continues();

  // One step, and what becomes of it.
  Outcome grow(const Watch& watch);

  // The next shot from the expansion's last state. False when none remains.
  bool begin_shot();

  // One step of a shot. Where none ends in the goal, the expansion goes on from where they began.
  Outcome shoot(const Watch& watch);

  // Each leg is an expansion of its own, which the tree has slots for.
  bool begin_shot_leg(const Moment& now);

  // Metres: how near a target is reached.
  float near(Vec2 target) const;

  // Ends a step that does not end the expansion in the goal: keeps a state, and returns whether the target is reached.
  Outcome end_step();

  // The brake is an expansion of its own, toward the same target, which the tree has a slot for.
  void begin_braking();

  // One step of the brake. Where it cannot end in the goal, the expansion goes on from where the brake began.
  Outcome take_brake_step(const Watch& watch);

  Outcome end_braking();

  // Has the state `back` steps before the last kept, if there is one.
  bool keep_recent(std::uint32_t back);

  // CONTROLLER, MOTION and COLLISION (lines 5 and 6), and the vertex after the step, to which the drive goes. False
  // when the step is not free or leaves the robot's limits.
  bool take_step(Drive& drive, const Watch& watch);

  // The region of a position; where no triangle contains it (a reference point outside the body may stand on an
  // obstacle), the last state's.
  Index region_of(Vec2 at, Index last) const;

  // Numbers have values since reset, expand, begin_legs or what begins a brake or a shot.
  ExpanderTools tools_;
  Drive drive_;
  RecentStates recent_;
  Expanded expanded_;  // the last expansion
  float near_;         // metres: how near its target is reached
  float apart_;        // metres: how far the target of a long one was
  Index braking_;      // the expansion that brakes for the goal; kNone: none does
  std::uint32_t brake_steps_;
  Drive brake_;
  bool shooting_;            // whether the last metres are driven; braking_ is their last leg
  std::uint32_t shot_legs_;  // of this shot
  LastMetres last_metres_;
};

}  // namespace krait::detail
