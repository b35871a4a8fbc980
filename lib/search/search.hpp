// SPDX-License-Identifier: Apache-2.0
// What every planner shares: its block of memory, the checks of a query, the motion tree, and the plan at the end.
// Where the tree grows is the planner's own.
#pragma once

#include "base/arena.hpp"
#include "base/random.hpp"
#include "collision/motion_check.hpp"
#include "decomposition/regions.hpp"
#include "improve/improver.hpp"
#include "krait/parameters.hpp"
#include "krait/plan.hpp"
#include "krait/planner.hpp"
#include "krait/robot.hpp"
#include "plan/ending.hpp"
#include "plan/motion_tree.hpp"
#include "plan/plan_proof.hpp"
#include "search/disc_route.hpp"
#include "search/expander.hpp"
#include "search/restarts.hpp"

namespace krait::detail {

// Copied from flash, which takes less of it than code that writes each.
inline constexpr Parameters kDefaults;

// A planner has it as its base, and
//   bytes_required   counts what is kept here and what it keeps itself
//   init             check_setup, take_block, and what it keeps itself from arena_
//   start            usable, then begin
//   advance          advance_by, an iteration being new_try where new_try_due, or else expand or continue_expansion
//   improve          improve_by, a restarted search being what advance does from resume_restarted to pause_restarted
//   keep             as Keeper has it
class Search {
 public:
  // A copy would write to the same block.
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  // Does what Planner::improve does, for a planner that does not restart its search.
  Status improve(std::uint64_t iterations) {
    return improve_by(iterations, false, [] {});
  }

  // How init divided the block: Arena::needed(Pool) bytes a pool.
  const Arena& arena() const { return arena_; }
  const MotionTree& tree() const { return tree_; }
  const Regions& regions() const { return regions_; }

  // These do what the members of Planner do.
  Status status() const { return failure_.status; }
  [[nodiscard]] const Failure& failure() const { return failure_; }
  Contact contact();
  Bottleneck bottleneck();
  void stop_for_time();
  Plan plan() const;
  Statistics statistics() const;

  // Whether a way has reached the goal and is driven once more; the tree does not grow meanwhile.
  bool driving() const { return driven_ != kNone; }

 protected:
  // Measured: bench/ABLATIONS.md, "Constants".
  static constexpr std::uint32_t kPatience = 10;  // tries after which half of the shares turn gently and reverse

  Search() = default;
  ~Search() = default;

  // Counts what is kept here, in an arena without a block.
  static void count(Arena& counting, const Scene& scene, const Robot& robot, const Limits& limits);

  // The limits with the most vertices for which required(limits) is at most `bytes`, at least 2. O(1).
  template <class Required>
  static Limits limits_within(std::uint64_t bytes, Limits limits, Required required) {
    std::uint32_t fits = 2;
    std::uint32_t too_many = MotionTree::kMostExpansions + 1;
    while (too_many - fits > 1) {
      limits.vertices = fits + (too_many - fits) / 2;
      (required(limits) <= bytes ? fits : too_many) = limits.vertices;
    }
    limits.vertices = fits;
    return limits;
  }

  // The arguments that do not change between queries, copied. The search is not ready from here on.
  Failure check_setup(const Setup& setup, const Parameters& parameters, const Limits& limits);

  // Begins to cut up the block, of which required(limits) bytes are needed: as many vertices as fit where the limits
  // state none. The search is ready where it succeeds.
  template <class Required>
  Failure take_block(const Setup& setup, Required required) {
    if (limits_.vertices == 0) limits_ = limits_within(setup.bytes, limits_, required);
    return take_block(setup.block, setup.bytes, required(limits_));
  }

  // Whether the search is ready, and its scene is that of init. Where it is not, status() says so.
  bool usable();

  // Whether a search has started since init, so that the arrays in the block have been written.
  bool started() const { return ready_ && status() != Status::ready && status() != Status::bad_scene; }

  // Checks the query, computes the heuristic costs and adds the root. Returns searching when the search can begin;
  // solved when a plan may end with the start.
  Status begin(const Query& query, const Keeper& keeper);

  Expander& expander() { return expander_; }

  // Makes iterations while the search goes on: calls iterate() for an expansion, unless a way is driven or the budget
  // is used.
  template <class Iterate>
  Status advance_by(std::uint64_t iterations, Iterate iterate) {
    for (; iterations > 0 && status() == Status::searching; --iterations) {
      if (driving()) {
        drive_plan();
      } else if (count_expansion()) {
        iterate();
      }
    }
    return status();
  }

  // Improves the plan by `iterations` iterations: calls search() for one of a restarted search; there are such only if
  // `restarts`.
  template <class RestartedSearch>
  Status improve_by(std::uint64_t iterations, bool restarts, RestartedSearch search) {
    if (status() != Status::solved || path_ == kNone) return status();
    if (limits_.way_legs == 0) return Status::bad_argument;
    if (!improving_) begin_to_improve(restarts);
    for (; iterations > 0 && status() == Status::solved; --iterations) {
      if (improver_.searching()) {
        search();
      } else {
        improve_along_line();
      }
    }
    return status();
  }

  // Lets the restarted search go on; false when it has yet to begin: then begin_restarted, which is an iteration of its
  // own.
  bool resume_restarted();
  void begin_restarted();
  // Lets it rest: the status is solved, as it is for the caller of improve.
  void pause_restarted();

  // Whether a try is over; then new_try forgets all but the start and where the random numbers have got to.
  bool new_try_due() { return restarts_.due(); }
  void new_try();

  // Expander::expand, and what it means for the search.
  Expanded expand(Index vertex, Index region, const Target& toward, const Watch& watch);

  // Lets the try, whose length is in expansions, not count the last.
  void uncount_expansion() { restarts_.uncount(); }

  // What the end of an expansion means for the search.
  Expanded finish_expansion(const Expanded& expanded);

  // The next max_steps steps of a long expansion.
  Expanded continue_expansion(const Watch& watch);

  // The way to a point at a random speed. The more often it was tried, the more often is the turn gentle, and does the
  // robot drive backwards.
  Target any_way_to(Vec2 point, std::uint32_t tries);

  // Lets a robot that is nearer to the target than stopping_ways of its stopping ways drive there at the speed from
  // which that many end there; in the goal than one of them, where the plan must not end fast.
  void slow_for(Target& target, Index from, bool in_goal) const;

  Vec2 random_point_in_bounds();

  Vec2 position(Index vertex) const { return {tree_.state(vertex)[0], tree_.state(vertex)[1]}; }

  void finish(Status status);

  bool shoots_at_poses_ = true;
  bool shortcuts_ = true;  // the plan is the same without, which tests and measurements of them search
  Robot robot_;
  const Scene* scene_ = nullptr;
  Parameters parameters_ = kDefaults;
  Limits limits_;
  Statistics statistics_;
  Arena arena_;
  Regions regions_;
  MotionTree tree_;
  Random random_;
  float robot_length_ = 1.0F;

 private:
  // Measured: bench/ABLATIONS.md, "Constants".
  static constexpr float kLeastCost = 0.05F;    // of an edge, in robot lengths: keeps h + C above h
  static constexpr float kDepthKept = 0.1F;     // share of the goal's margin that a plan keeps
  static constexpr float kUnitRegions = 90.0F;  // regions of a way whose tries last restart_unit,
  static constexpr float kShortestTry = 0.1F;   // and how much of it those of a short way last at least
  // Metres: how deep inside the goal a plan without steps is: more than the rounding of a coordinate of 2 km, 6e-5.
  static constexpr float kStartDepth = 1e-4F;

  static Failure bad_argument(Argument argument);

  // Begins the first of the tries, whose unit is determined by restart_unit and the way from the start. O(R).
  void begin_tries();

  // An iteration while driving(): at most max_steps steps of one expansion of the way.
  void drive_plan();

  // Counts an iteration that is an expansion. False, and the search has ended, when the budget is used.
  bool count_expansion();

  static void take_pools(Arena& arena, const Scene& scene, const Robot& robot, const Limits& limits, Regions& regions,
                         MotionTree& tree, Improver& improver, MotionCheck& check, RecentStates& recent);

  Failure take_block(void* block, std::uint64_t bytes, std::uint64_t needed);

  Failure check_query(const Query& query);

  // Whether the last metres are driven.
  bool shoots() const { return ending_.goal().is_pose() && shoots_at_poses_; }

  // Those that end a way: a brake or the legs of a shot, which half of a small tree must do for.
  std::uint32_t spare_expansions() const;

  void equip_expander(const Keeper& keeper);

  // Resets the edge costs and finds the shortest paths. False when no region belongs to the goal.
  bool find_paths();

  void add_root(bool fits);

  void keep_root() { (void)keeper_(root_region_, {}, expander_.state()); }

  // Before the first step.
  Vec2 start_position() const { return {expander_.state()[0], expander_.state()[1]}; }

  DiscRoute disc_route();

  float tree_clearance() const { return parameters_.clearance + kTreeSlack * robot_length_; }

  void keep_for_tree() { check_.keep(tree_clearance(), longest_tree_step(robot_, parameters_.dt)); }

  // The way to `end` has reached the goal. It is driven once more from the start, expansion by expansion, as the plan's
  // controls alone would drive the robot, and every step is proven again: what holds is the plan. Until then the tree
  // is used for nothing else. O(expansions of the way).
  void begin_plan(Branch end);

  // Ends the search as solved where the way that was driven ends in the goal; as internal where the tree beside it was
  // not the same as when it grew.
  void finish_plan();

  void record(const PlanMeasures& measures);

  // Goes on with the search; with its next try, since other ways to the goal would mostly begin as this one did.
  void refuse_plan();

  void begin_to_improve(bool restarts);

  void improve_along_line();

  PlanPath found_path() const { return {tree_, path_}; }

  bool ready_ = false;
  std::uint32_t fingerprint_ = 0;                    // the scene's at init
  Failure failure_ = bad_argument(Argument::block);  // until init has one
  MotionCheck check_;
  Ending ending_;
  Keeper keeper_;
  Expander expander_;
  Restarts restarts_;
  float goal_depth_ = 0.0F;  // metres: how deep inside the goal the tree's ways end
  EndDepth end_depth_;       // and plans
  Index root_region_ = kNone;
  Index path_ = kNone;    // the plan's first expansion
  Index driven_ = kNone;  // the expansion of the way to the goal that is driven next; kNone while the tree grows
  std::uint32_t steps_remaining_ = 0;  // of that expansion
  PlanProof proof_;
  bool improving_ = false;          // since the first call of improve
  bool restarted_goes_on_ = false;  // whether a restarted search has begun and not ended
  Improver improver_;
};

}  // namespace krait::detail
