// SPDX-License-Identifier: Apache-2.0
// What every planner of the library shares: its memory, the query's checks, the motion tree, the steps of an expansion
// (Algorithm 2, lines 4 to 15), and the plan at the end.
#pragma once

#include "krait/base/arena.hpp"
#include "krait/base/arithmetic.hpp"
#include "krait/base/random.hpp"
#include "krait/collision/goal_room.hpp"
#include "krait/collision/motion_check.hpp"
#include "krait/decomposition/locate.hpp"
#include "krait/decomposition/regions.hpp"
#include "krait/improve/improver.hpp"
#include "krait/motion/drive.hpp"
#include "krait/parameters.hpp"
#include "krait/plan/ending.hpp"
#include "krait/plan/motion_tree.hpp"
#include "krait/plan/plan.hpp"
#include "krait/plan/plan_proof.hpp"
#include "krait/robot/robot.hpp"
#include "krait/robot/shape.hpp"
#include "krait/search/last_metres.hpp"
#include "krait/search/restarts.hpp"
#include "krait/search/statistics.hpp"
#include "krait/search/watch.hpp"

namespace krait {

struct Query {
  const float* start = nullptr;  // robot.state_size() floats, copied; the position in the scene's local coordinates
  Goal goal = Goal::named(0);
  std::uint64_t seed = 1;
};

// `Guide` is what a planner keeps by vertex to choose where to grow from: take(arena, scene, vertices) allocates it,
// and take_work(arena, robot), where there is such a member, arrays of the robot's sizes. `Derived` is the planner,
// which has
//   reset_guide()                  resets the guide
//   restart_unit()                 as Restarts::begin has it
//   doomed_steps()                 Parameters::doomed_steps or 0
//   open_steps()                   Parameters::open_steps or 0
//   slowest()                      Parameters::slowest or another such share
//   end_speed()                    Parameters::end_speed or infinity
//   shoots()                       whether it may drive the last metres to a pose, so that an expansion may go on
//   iterate(watch)                 one expansion
//   keep(region, branch, state)    hears of every new state that is not doomed, and may keep it as a vertex; false when
//                                  it cannot go on
template <class Derived, class Guide>
class Search {
 public:
  Search() = default;
  // A copy would write to the same block.
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  // Bytes of the block that init needs. The same on every target. O(1).
  static std::uint64_t bytes_required(const Scene& scene, const Robot& robot, const Limits& limits);

  // The limits that spend a block of `bytes` best: as many vertices and expansions as fit beside `way_legs` legs, at
  // least 2. O(1).
  static Limits limits_for(std::uint64_t bytes, const Scene& scene, const Robot& robot, std::uint32_t way_legs = 0);

  // Uses the block, aligned to Arena::kAlignment, which like robot and scene must outlive the planner and stay where
  // it is; copies parameters and limits. Returns ok, or why not: bad_arithmetic, bad_argument (a scene that was not
  // opened, too), bad_robot, arena_too_small. May be called again.
  [[nodiscard]] Failure init(void* block, std::uint64_t bytes, const Scene& scene, const Robot& robot,
                             const Parameters& parameters, const Limits& limits);
  // Temporaries would not outlive the planner.
  Failure init(void*, std::uint64_t, const Scene&&, const Robot&, const Parameters&, const Limits&) = delete;

  // Begins a search, ending any other. Returns searching; or solved, when a plan may end with the start; or no_route,
  // goal_in_obstacle, start_outside, start_in_collision, bad_argument; bad_scene, when the scene is found to be another
  // than at init (Scene::fingerprint); after an init that failed, what that one gave. Work: a Dijkstra, 2730 distances.
  [[nodiscard]] Status start(const Query& query);

  // At most `iterations` expansions more; returns at once when the search has ended. Where an expansion comes so near
  // to the goal that braking may end there, it brakes, and from every fourth state near a pose it drives the shortest
  // few of at most 216 lines to it (last_metres.hpp); such steps count as steps of the expansion for the work of a
  // call, and it goes on where they lead to nothing. A way that has reached the goal is driven once more before it is
  // returned as a plan: up to max_steps steps of it count as one of `iterations` here, but not in Statistics and
  // Limits. The result does not depend on how a search is cut into calls.
  [[nodiscard]] Status advance(std::uint64_t iterations) { return advance(iterations, Watch()); }

  // The same, and calls watch(from, to), states, for every step that the tree grows by; before an expansion
  // watch.expands(vertex, target), where there is such a member.
  [[nodiscard]] Status advance(std::uint64_t iterations, const Watch& watch);

  // At most `iterations` more of looking for a plan of fewer steps; plan() and Statistics::plan_steps, plan_length,
  // plan_duration and hash are then those of the best so far, which was driven and proven as the first one was. Work of
  // one, which must end in the goal as the first did, so that few are found for a pose: at most max_steps steps, and 16
  // legs' steps that are not proven, or O(way_legs); the first call after start begins with one Dijkstra. The result
  // does not depend on how the iterations are cut into calls. Plans and their cursors from before the call end with it.
  // Returns status() and does nothing where that is not solved or the plan has no steps; bad_argument where
  // Limits::way_legs is 0.
  [[nodiscard]] Status improve(std::uint64_t iterations);

  // What init cut the block into: Arena::needed(Pool) bytes a pool.
  const Arena& arena() const { return arena_; }
  const MotionTree& tree() const { return tree_; }
  const Regions& regions() const { return regions_; }
  const Guide& guide() const { return guide_; }
  // Where the search stands: ready before the first start; before init, bad_argument.
  [[nodiscard]] Status status() const { return failure_.status; }
  [[nodiscard]] const Failure& failure() const { return failure_; }

  // After start_in_collision: what the robot is too near to at its start; else Hindrance::none. O(pieces near the robot
  // + bodies^2).
  Contact contact();

  // Of a search that ended without a plan: the widest way, which after no_route is too narrow for the robot; all zero
  // else. Work: at most two Dijkstras for the widest way, two for the costs, and 4,095 distances of a point.
  Bottleneck bottleneck();

  // Whether a way has reached the goal and is driven once more; the tree does not grow meanwhile.
  bool driving() const { return driven_ != kNone; }

  // Ends the search as time_used, for a port whose clock says so. No effect once it has ended.
  void stop_for_time();

  // Empty unless solved. Valid until the next start or improve.
  Plan plan() const;

  Statistics statistics() const;

 protected:
  static constexpr std::uint32_t kPatience = 10;  // tries after which half of the gentle share turns gently

  enum class Expansion { goal_reached, target_reached, target_not_reached, collision, tree_full, goes_on };

  struct Expanded {
    Expansion result;
    Index region;               // of the last state
    Branch last;                // the last state, when there was a step
    std::uint32_t crossed = 0;  // how often a step ended in another region than it began in
  };

  // Algorithm 2, lines 4 to 15: from a vertex, which lies in `region` (or kNone: not known), toward the target. The
  // tree must have room for an expansion. Where it goes_on, that is for go_on.
  Expanded expand(Index vertex, Index region, const Target& toward, const Watch& watch);

  // The next max_steps steps of a long expansion.
  Expanded go_on(const Watch& watch);

  // The way to a point at a random speed, and in a turn that is gentle the more often, the more often it was tried.
  Target any_way_to(Vec2 point, std::uint32_t tries);

  // Lets the robot drive to a target in the goal so slowly that it can stop there.
  void slow_for(Target& target, Index from) const;

  Vec2 random_point_in_bounds();

  Vec2 position(Index vertex) const { return {tree_.state(vertex)[0], tree_.state(vertex)[1]}; }

  Status finish(Status status);

  Robot robot_;
  const Scene* scene_ = nullptr;
  Parameters parameters_;
  Limits limits_;
  Statistics statistics_;
  Regions regions_;
  MotionTree tree_;
  Guide guide_;
  Drive drive_;
  Random random_;
  float robot_length_ = 1.0F;

 private:
  static constexpr std::uint32_t kRecent = Parameters::kMostDoomedSteps + 1;
  static constexpr std::uint32_t kOpen = 1;       // how often an expansion past max_steps may have crossed a portal
  static constexpr float kGentlest = 0.15F;       // of the sharpest turn
  static constexpr float kReachRounding = 1e-2F;  // metres
  static constexpr float kLeastCost = 0.05F;      // of an edge, in robot lengths: keeps h + C above h
  static constexpr float kStartDepth = 1e-4F;     // metres: how deep inside the goal a plan without steps is
  static constexpr float kDepthKept = 0.1F;       // share of the goal's margin that a plan keeps

  static Failure bad_argument(Argument argument);

  Status scene_changed();

  static void take_pools(Arena& arena, const Scene& scene, const Robot& robot, const Limits& limits, Regions& regions,
                         MotionTree& tree, Guide& guide, Improver& improver);

  // Arrays of the robot's sizes; `recent` is kRecent states.
  static void take_work(Arena& arena, const Robot& robot, Guide& guide, MotionCheck& check, float*& recent);

  Derived& derived() { return static_cast<Derived&>(*this); }
  const Derived& derived() const { return static_cast<const Derived&>(*this); }

  // The arguments that do not change between queries. Returns solved, or what is wrong.
  Failure check_setup(const Robot& robot, const Scene& scene, const Parameters& parameters, const Limits& limits);

  // Checks the query, computes the heuristic costs and plants the root. searching when the search can begin; solved
  // when a plan may end with the start.
  Status begin(const Query& query);

  // Whether the last metres are driven.
  bool shoots() const { return ending_.goal().is_pose() && derived().shoots(); }

  // Those that end a way: a brake or the legs of a shot, which half of a small tree must do for.
  std::uint32_t spare_expansions() const;

  Nimbleness nimbleness() const;

  // Resets the edge costs and finds the shortest paths. False when no region belongs to the goal.
  bool find_paths();

  // Forgets all but the start and where the random numbers have got to.
  void begin_anew();

  Failure check_query(const Query& query);

  Status plant(bool fits);

  // Before the first step.
  Vec2 start_position() const { return {drive_.state()[0], drive_.state()[1]}; }

  // A disc that lies in body 0, and goes where the body goes.
  struct InnerDisc {
    Vec2 at;       // its centre at the start
    float radius;  // metres, the clearance included
    float reach;   // metres: how far the centre may be from the goal while the position is inside
  };

  // Around the middle of body 0.
  InnerDisc body_disc();

  // Around the position: smaller, but where the position is.
  InnerDisc position_disc() const;

  // No obstacle comes nearer to the position than the disc around it that lies in body 0, if there is one.
  float least_portal_width() const;

  // Where a disc in body 0 finds no room in the goal, or no way from the start to so near the goal that the position
  // could be inside, there is no way for the robot. False then.
  bool body_fits();

  // Of the points that the disc's centre may be at in the end.
  GoalRoom room_at_goal(const InnerDisc& disc) const;

  Bottleneck bottleneck_for(const InnerDisc& disc);

  // At most max_steps steps, and what becomes of the expansion.
  Expanded drive(Expanded& expanded, const Watch& watch);

  // Whether the expansion waits for what may end the way from its last state.
  bool aside() const { return braking() || shooting_; }

  Expansion take_turn(Expanded& expanded, const Watch& watch);

  // Whether the expansion continues after this step. Past max_steps it does in the open only, and while each step
  // decreases the distance to the target.
  bool goes_on(const Expanded& expanded);

  // One step, and what becomes of it.
  Expansion grow(Expanded& expanded, const Watch& watch);

  // The next shot from the expansion's last state. False when there is none left.
  bool begin_shot();

  // One step of a shot. Where none ends in the goal, the expansion goes on from where they began.
  Expansion shoot(Expanded& expanded, const Watch& watch);

  // Each leg is an expansion of its own, which the tree has slots for.
  bool begin_shot_leg(Branch from);

  // What becomes of an expansion whose last state does not end it in the goal.
  Expansion settle(const Expanded& expanded);

  bool braking() const { return braking_ != kNone; }

  // The brake is an expansion of its own, toward the same target, which the tree has a slot for.
  void begin_braking(Branch from);

  // One step of the brake. Where it cannot end in the goal, the expansion goes on from where the brake began.
  Expansion brake(const Expanded& expanded, const Watch& watch);

  Expansion end_braking();

  void remember(std::uint32_t step, Index region);

  float* recent(std::uint32_t step) const {
    return recent_ + static_cast<std::size_t>(step % kRecent) * static_cast<std::size_t>(robot_.state_size());
  }

  // Has the state `back` steps before the expansion's last kept, if there is one.
  bool keep_recent(Branch last, std::uint32_t back);

  // CONTROLLER, MOTION and COLLISION (lines 5 and 6). False when the step is not free or leaves the robot's limits.
  bool take_step(Drive& drive) { return ProvenStep(robot_, *scene_, parameters_, check_).take(drive); }

  // The region of a position; where no triangle contains it (a reference point outside the body may stand on an
  // obstacle), the last state's.
  Index region_of(Vec2 at, Index last) const;

  float tree_clearance() const { return parameters_.clearance + kTreeSlack * robot_length_; }

  void keep_for_tree() { check_.keep(tree_clearance(), longest_tree_step(robot_, parameters_.dt)); }

  // The way to `last`, and on by the brake if it brakes, has reached the goal. It is driven once more from the start,
  // expansion by expansion, as the plan's controls alone would drive the robot, and every step is proven again: what
  // holds is the plan. Until then the tree is used for nothing else. O(expansions of the way).
  void begin_plan(Branch last);

  // At most max_steps steps of one expansion of the way.
  void drive_plan();

  // Ends the search as solved where the way that was driven ends in the goal; as internal where the tree beside it was
  // not the same as when it grew.
  void finish_plan();

  void note(const PlanMeasures& measures);

  // Goes on with the search; with its next try, since other ways to the goal would mostly begin as this one did.
  void refuse_plan();

  void begin_to_improve();

  PlanPath found_path() const { return {tree_, path_}; }

  bool ready_ = false;
  std::uint32_t fingerprint_ = 0;                    // the scene's at init
  Failure failure_ = bad_argument(Argument::block);  // until init has one
  Arena arena_;
  MotionCheck check_;
  Ending ending_;
  float goal_depth_ = 0.0F;  // metres: how deep inside the goal the tree's ways end
  EndDepth end_depth_;       // and plans
  Restarts restarts_;
  Expanded expanded_{};            // the last expansion
  float apart_ = kInfinity;        // metres: how far the target of a long one was
  float* recent_ = nullptr;        // the last kRecent states of the expansion, step s at place s % kRecent,
  Index recent_regions_[kRecent];  // and their regions
  Index root_region_ = kNone;
  Index path_ = kNone;    // the plan's first expansion
  Index driven_ = kNone;  // the expansion of the way to the goal that is driven next; kNone while the tree grows
  std::uint32_t steps_left_ = 0;  // of that expansion
  Branch reached_;                // the state of the way that reached the goal, or where it began to brake
  Index braking_ = kNone;         // the expansion that brakes for the goal; kNone: none does
  std::uint32_t brake_steps_ = 0;
  Drive brake_;
  bool shooting_ = false;        // whether the last metres are driven; braking_ is their last leg
  std::uint32_t shot_legs_ = 0;  // of this shot
  LastMetres last_metres_;
  PlanProof proof_;
  bool improving_ = false;  // since the first call of improve
  Improver improver_;
};

}  // namespace krait
