// SPDX-License-Identifier: Apache-2.0
// Looks for ways of fewer steps than a plan has. In rounds: a line to the goal, along the shortest path of regions or
// along the plan, is pulled taut, and its corners are rounded by what the robot can turn; or the route of the best way
// so far is taken up. It is driven corner by corner: once there is a better way, each is passed some times, with random
// changes, and the quickest time is kept. Where none gets past a corner, the one before it is passed in another way,
// and where that does not help the route is changed around the place of the failure. What is better than the plan is
// driven once more and proven as the plan was, and only then takes its place. Where trailers must be straight at the
// goal and the plan does not back in, corners are moved outward for them, most shots are tighter, and a line of the
// regions that is much shorter than the plan is taken in most rounds. Where no line from the start leads to a better
// way but backwards, as where the robot must leave its start by a manoeuvre, lines begin behind some first legs of the
// plan, which are kept, and before each line the planner restarts its search. A long chain seldom gets along a line at
// all: in most of its rounds the search is restarted.
#pragma once

#include "decomposition/locate.hpp"
#include "decomposition/regions.hpp"
#include "improve/corners.hpp"
#include "improve/taut_line.hpp"
#include "improve/way_drive.hpp"
#include "krait/plan.hpp"
#include "plan/plan_proof.hpp"

namespace krait::detail {

class Improver {
 public:
  Improver();

  // Room for ways of `legs` legs, and for routes that are as long.
  void allocate(Arena& arena, std::uint32_t legs, int state_size);

  // Begins with a plan of one step or more, which must stay, as must what the tools name and `proof`. The regions'
  // costs and paths are those of the goal, as they were before any was raised. A plan ends as deep inside the
  // goal as `depth` says. Its rounds are restarted searches, too, only if `restarts`.
  void begin(const WayTools& tools, PlanProof& proof, const Regions& regions, const PlanPath& plan,
             const EndDepth& depth, const Random& random, bool restarts);

  // Continues by one iteration, which is at most max_steps steps of a drive, and some more at its begin: those that
  // Way::kLegsAState legs have, driven again unproven, or a turn in the void; or a stretch of pulling a line taut; or
  // the regions from the start to the goal. Returns whether there is a better plan now. Not while searching().
  bool iterate();

  // Whether this round is a restarted search for a plan of fewer steps, until search_over. It may change the tree and
  // the regions.
  bool searching() const { return stage_ == Stage::searching; }
  // Whether the round after it is one, too. Where it is not, search_over must find the regions as begin does.
  bool searches_next() const { return searched_ < searches_; }
  void search_over() { begin_round(); }

  // Whether the way has fewer steps than the best plan so far, and there is room for its legs. O(legs).
  bool is_better(const PlanPath& found) const;
  // Makes a plan that a search has found, and that is_better, the best, by a copy. O(legs).
  void take_found(const PlanPath& found);

  // The best plan so far.
  const PlanPath& plan() const { return plan_; }
  // What the best plan measures, once iterate has found one.
  const PlanMeasures& measures() const { return measures_; }

 private:
  using Outcome = WayDrive::Outcome;

  enum class Stage : std::uint8_t { turning, searching, keeping, tracing, pulling, driving, proving };

  // Room for the line of a short plan, however few legs its ways may have.
  static constexpr std::uint32_t kLeastVias = 64;
  static constexpr std::uint32_t kLeastPoints = 256;
  // Measured: bench/ABLATIONS.md, "Constants" and "Plans are improved". A unit is Turns::unit.
  static constexpr int kLongChain = 4;             // bodies of a chain, from which on searches restart
  static constexpr std::uint32_t kSearches = 7;    // rounds of such searches before each round along a line
  static constexpr std::uint32_t kHold = 2;        // steps of a leg, or more where a way has no room for such legs
  static constexpr float kAgain = 0.5F;            // share of the rounds along the best way's route, once there is one
  static constexpr std::uint32_t kFromStart = 2;   // lines from the start, without a better way by which legs are kept
  static constexpr float kKeep = 0.5F;             // share of the lines after those that begin behind kept legs
  static constexpr std::uint32_t kTries = 6;       // drives past a corner, once there is a best way
  static constexpr std::uint32_t kMostTries = 12;  // drives past a corner that none gets past, at most
  static constexpr std::uint32_t kReturns = 4;     // to the corner before one that none gets past, in a round
  static constexpr float kStraightOn = 0.99F;      // cosine of a turn: above it a via is no corner and is passed once
  // Units, beside the trailers' length: how far past a corner its drives end, at most half way to the next via.
  static constexpr float kPast = 0.7F;
  static constexpr float kAhead = 2.0F;  // units from where a drive ends to the point that the robot should face
  static constexpr float kAskew = 1.0F;  // units of the way: what it costs to face at right angles to that point
  static constexpr std::uint32_t kPatience = 12;  // changes without a nearer way, after which a round ends
  static constexpr float kNearer = 0.06F;         // units of the route: a way that ends so much nearer is better
  static constexpr float kAsNear = 0.025F;        // units: a way that ends at most so much further off is as near
  static constexpr float kTakenAsNear = 0.3F;     // share of the ways that are as near which replace the one before
  static constexpr float kRounded = 0.6F;         // share of the new routes whose corners are rounded
  // Sum of the cosines at a route's ends: how far away from its ends a robot must face to drive it backwards.
  static constexpr float kWorthBackwards = 0.3F;
  // Share that is driven backwards of such routes, and of those behind kept legs after which the plan drives so.
  static constexpr float kBackwards = 0.5F;
  static constexpr float kNoShots = 0.3F;         // routes without shots before their end, for each that has some
  static constexpr float kVaryShots = 0.1F;       // share of the changes that draw anew where shots begin
  static constexpr std::uint32_t kRunUp = 15;     // steps straight on before a turn is measured
  static constexpr std::uint32_t kTurning = 30;   // steps of that turn
  static constexpr std::uint32_t kMeasured = 15;  // steps at the end of that turn, by which it is measured
  static constexpr float kBraking = 0.3F;         // share of the sharpest braking: how shots brake
  static constexpr float kShortcut = 0.75F;  // share of the plan's length: a shorter line of the regions is a shortcut
  static constexpr float kTakeShortcut = 0.7F;   // share of the rounds that follow a shortcut
  static constexpr float kOtherShots = 0.75F;    // share of the rounds with other lines of shots, without detours
  static constexpr float kLeastArcs = 0.25F;     // times the usual radii: the least of such lines' arcs
  static constexpr float kMoreArcs = 0.35F;      // times the usual radii: how much more than the least they are at most
  static constexpr float kLeastLeads = 0.5F;     // times the usual lengths: the least of such lines' straight ends
  static constexpr float kMoreLeads = 1.0F;      // times the usual lengths: how much more they are at most
  static constexpr float kSearchAhead = 2.4F;    // units: how far on along a route the robot's place is looked for
  static constexpr float kSpacing = 0.5F;        // units between the points of a line that is pulled taut
  static constexpr float kLeastDisc = 1.15F;     // times body 0's half width: the least disc that a taut line is for
  static constexpr float kMoreDisc = 1.1F;       // times body 0's half width: how much larger that disc is at most
  static constexpr float kPullStep = 0.5F;       // times body 0's half width: step of looks along a line of sight
  static constexpr float kBeforeFailure = 6.0F;  // units before a failure at which the stretch to be changed begins
  static constexpr float kAroundFailure = 8.0F;  // units: length of that stretch
  static constexpr float kNearFailure = 2.0F;    // units to the nearest via of that stretch, from which on one is added
  static constexpr float kSpread = 4.0F;         // units around a change and before a corner at which vias are added
  static constexpr float kFar = 1.5F;            // times kSpread: vias are added only where the next ones are further

  Way& current() { return ways_[here_]; }
  Way& trial() { return ways_[1 - here_]; }
  Route& route() { return routes_[here_of_routes_]; }
  Route& changed() { return routes_[1 - here_of_routes_]; }

  struct Size {
    std::uint32_t legs, steps;
  };
  static Size size(const PlanPath& plan);

  void take_plan(const PlanPath& plan);

  // What the robot's turns are like: far ahead for some steps, then far to the left, as if nothing was there.
  void measure_turn();

  void aim_aside(const Pose& pose, bool to_the_left);

  void begin_round();

  // A new line: in turn that of the regions and that of the plan.
  void begin_line();

  // Whether no line from the start has led to a better way, or only one that is driven backwards, which mostly is slow.
  bool in_vain() const;

  // How many of the plan's first legs the next line's ways begin with: 0, unless no way from the start was better. A
  // robot that must leave its start by a manoeuvre gets along no line that begins there.
  std::uint32_t legs_to_keep();

  // The round's ways begin with that many legs of the plan.
  void begin_keeping(std::uint32_t legs);

  void keep();

  // One unproven step along the plan. Returns whether it was a leg's last: the next leg is then the one to follow.
  bool follow_plan();

  // Goes on to the round's line, or along the route that it has already.
  void end_keeping();

  // Whether trailers must be straight at the goal, and the plan does not back in. Elsewhere no shortcut is taken, and
  // shots have the usual lines.
  bool straightens() const;

  // Whether this round is one along the line of the regions since that is much shorter than the plan.
  bool takes_shortcut();

  // The middles of the portals between the regions from there on. False where they have no path.
  bool trace_regions(Vec2 from);

  // The plan's positions.
  void trace();

  void begin_pull();

  void pull();

  // Makes the line a route.
  void make_route();

  // Adds a via to a measured route a little before its via i, where the one before that is far away and there is room.
  // Returns whether it did: via i is then via i + 1.
  bool divide_before(Route& route, std::uint32_t i) const;

  // Adds vias on the route a little before its corners, and a little after its begin: what is tried at one is then
  // driven from near there.
  void divide_stretches();

  // Whether a robot of one body turns less at the line's ends if it drives the line backwards.
  bool saves_turns_backwards() const;

  // Whether routes differ in where shots at the pose begin: for a robot that turns on the spot almost every shot ends
  // in the pose, and an early one keeps it from turning on its way.
  bool chooses_shots() const;

  // Draws which lines the round's shots have: the usual arcs are those of a turn that lasts, and tighter ones leave
  // more room for the straight end.
  void vary_shots();

  // Draws again where a measured route's shots begin. Returns from where on along the route that matters.
  float change_shots(Route& route);

  // Drives the route from its begin on.
  void begin_search();

  // Drives the changed route from the leg on, until it has come so far.
  void begin_drive(std::uint32_t leg, float until);

  void drive();

  // Goes to a corner of the route, 1 or more, as if it had been driven past `tries` times in vain.
  void begin_corner(std::uint32_t corner, std::uint32_t tries);

  // Goes on to the next corner of the route.
  void next_corner();

  // Whether the route turns at the corner, or is at one of its ends.
  bool turns();

  // Metres along a measured route: where the drives to the via after that corner begin, 0 for the first via.
  float end_of_corner(const Route& route, std::uint32_t corner) const;

  // The last leg of the current way that begins before there.
  std::uint32_t leg_at_end_of_corner(std::uint32_t corner);

  // Drives the changed route past the corner, and on by the way in which the robot can stop, or to its end after the
  // last one.
  void drive_corner();

  // Learns from a drive that has not reached the goal.
  void learn_corner(Outcome outcome);

  // A corner that was passed the quicker is kept.
  void learn_passed();

  // Steps that the driven way would take to the goal at best.
  float least_steps();

  // Goes back to the corner before one that none gets past, and drives past that with random changes until one does.
  void return_to_corner_before();

  // Drives past the corner with a random change at it.
  void try_corner();

  // Repairs the way that was blocked at the corner.
  void begin_repair();

  // A way that comes nearer to the goal is better; of those that come as near another one is taken now and then.
  void learn_blocked();

  void accept();

  // Changes the route around the failure, or ends the round.
  void repair();

  // The changed route, measured, ends in the goal: as before where a change has moved it out of there.
  void keep_end();

  // A via of the changed route from a little before the place where the current way failed to a little after, a new one
  // if there is none.
  std::uint32_t via_near_failure();

  // Bounds how much of the route a change at via i concerns, by vias on the line where its neighbours are far. Returns
  // the via's new number.
  std::uint32_t spread_around(std::uint32_t i);

  // The first leg of the current way that may look further along the route than `from`, or else the last from which it
  // can change.
  std::uint32_t first_that_sees(float from);

  void begin_proof();

  bool prove();

  bool finish_proof();

  WayTools tools_;
  PlanProof* proof_ = nullptr;
  const Regions* regions_ = nullptr;
  PlanPath plan_;
  std::uint32_t plan_legs_ = 0;
  std::uint32_t plan_steps_ = 0;
  bool ends_ahead_ = true;         // whether its last motion is ahead
  bool searches_in_vain_ = false;  // whether searches are restarted while no line from the start has helped
  EndDepth depth_;
  PlanMeasures measures_;
  Random random_;
  float robot_length_ = 1.0F;
  float half_width_ = 0.0F;
  float trailing_ = 0.0F;  // metres: of one trailer that cuts corners as all do
  float stride_ = 0.0F;    // metres: the longest step that the robot made
  float stopping_ = 0.0F;  // metres: the longest way in which it would have stopped
  float sharpest_ = 0.0F;  // radians of a step of the sharpest turn
  Turns turns_{};
  std::uint32_t share_ = 0;     // of the turns, that is measured next
  std::uint32_t searches_ = 0;  // before each round along a line, and
  std::uint32_t searched_ = 0;  // those that have begun since the last one
  Stage stage_ = Stage::turning;
  std::uint32_t round_ = 0;
  float shortest_ = kInfinity;  // metres: the last line that was that of the regions in its turn
  TautLine line_;
  Way best_;
  Way ways_[2];  // the best of this round, and the one that is driven
  int here_ = 0;
  Route routes_[2];  // that those ways follow
  int here_of_routes_ = 0;
  WayDrive drives_;
  Route best_route_;         // that the best way follows; of no vias where it follows none
  std::uint32_t best_kept_;  // legs of the best way before it follows that route
  std::uint32_t kept_;       // legs of the plan that the round's ways begin with
  float gear_;               // 1, or -1 where the route after them is driven backwards
  std::uint32_t corner_;     // the via that is passed,
  std::uint32_t returns_;    // that remain,
  std::uint32_t tries_;      // how often it was driven to,
  std::uint32_t from_leg_;   // from which leg on,
  float least_steps_;        // and the least steps that a way past it promises
  bool repairing_;           // whether no way got past it
  float remaining_;          // metres of the route where the current way fails,
  float failed_;             // metres along the route to there,
  std::uint32_t vain_;       // and changes since the last that helped
  Index leg_ = 0;            // that is kept, traced or proven next, and
  std::uint32_t step_ = 0;   // how many of its steps are
};

}  // namespace krait::detail
