// SPDX-License-Identifier: Apache-2.0
// Searches followed by a second planner that is written from the paper alone: every decision is held against it.
#include "choices.hpp"
#include "rivals.hpp"
#include "robot_oracle.hpp"
#include "search/adaptive_search.hpp"

namespace krait::test::reference {
namespace {

// A scene that a search does not solve soon, and a robot for it.
Room dead_end() {
  Room room = two_rooms(1);
  room.boxes.push_back({2, 5.8, 6, 6});
  return room;
}

// The goal lies behind a door narrower than the robot.
Room narrow_door() { return two_rooms(0.3); }

// Posts that the triangulation does not know of stand around the goal, closer than the robot is wide.
Room fenced_goal() {
  Room room = two_rooms(2);
  for (int i = 0; i < 7; ++i) {
    const double along = 0.35 * i;
    for (const double across : {0.0, 2.1}) {
      room.loose_pieces.push_back(corners({9.4 + along, 5.4 + across, 9.45 + along, 5.45 + across}));
      room.loose_pieces.push_back(corners({9.4 + across, 5.4 + along, 9.45 + across, 5.45 + along}));
    }
  }
  return room;
}

Room winding() {
  Room room = two_rooms(2);
  room.boxes = {{3, 2, 3.2, 8}, {6, 0, 6.2, 6}, {8.5, 1.2, 8.7, 8}};
  return room;
}

// From a position, what a step of 0.1 s at 1 m/s and the body's reach can touch.
constexpr double kUnicyclesReach = 0.1 + 0.33 + 0.02;

template <class R>
void at_start(const R& robot, std::vector<float>& state) {
  state.assign(static_cast<std::size_t>(robot.state_size()), 0.0F);
  state[0] = 1.2F;
  state[1] = 6.9F;
}

Rules rules_of(const Parameters& p, double length, double inner_radius) {
  Rules rules{double{p.tuning.alpha}, double{p.tuning.beta}, double{p.tuning.epsilon}};
  rules.gamma = double{p.tuning.gamma};
  rules.cost_length = double{p.tuning.cost_length} * length;
  rules.kappa = p.tuning.kappa;
  rules.raise_goal = p.tuning.raise_goal;
  rules.max_steps = p.tuning.max_steps;
  rules.near = double{p.tuning.near_radius} * length;
  rules.goal_near = double{p.tuning.goal_near_radius} * length;
  rules.path_reach = double{p.tuning.path_lengths} * length;
  rules.doomed_steps = p.tuning.doomed_steps;
  rules.sample = p.tuning.group_sample;
  rules.restart_unit = p.tuning.restart_unit;
  rules.least_width = p.tuning.prune_portals ? 2 * (inner_radius + double{p.clearance}) : 0;
  rules.least_cost = 0.05 * length;
  rules.goal_depth = double{p.goal_margin};  // goals of two metres: less than a tenth of their size
  return rules;
}

Shares shares_of(const Parameters& p) {
  Shares shares;
  shares.path_regions = p.tuning.path_regions;
  shares.ahead = 1 - double{p.tuning.stray_share};
  shares.slowest = double{p.tuning.slowest};
  shares.reverse = double{p.tuning.reverse_share};
  shares.gentle = double{p.tuning.gentle_share};
  return shares;
}

// The planner of prior work: Algorithm 2's other choices, and costs that never change.
Rules rules_of_prior(const Parameters& p, double length, double inner_radius) {
  Rules rules = rules_of(p, length, inner_radius);
  rules.epsilon = double{rivals::PriorParameters().epsilon};
  rules.gamma = 0;
  rules.goal_near = rules.near;
  rules.path_reach = 0;
  rules.doomed_steps = 0;
  rules.restart_unit = 0;
  rules.sample = kUnboundedSample;
  return rules;
}

Shares shares_of_prior(const Parameters& p) {
  const rivals::PriorParameters prior;
  Shares shares = shares_of(p);
  shares.path_regions = prior.path_regions;
  shares.slowest = double{rivals::kRivalsSlowest};
  shares.ahead = double{prior.path_share};
  shares.goal = double{prior.goal_share};
  shares.strays_in_bounds = false;
  shares.nearest = double{prior.nearest_share};
  return shares;
}

// What followed searches came to, so that a test sees that they went through what it is about.
struct Seen {
  std::uint64_t expansions = 0, updates = 0, goal_raises = 0, doomed = 0, longest = 0, solved = 0, refused = 0;
  std::uint64_t ends[4] = {};
};

// Follows searches of the scene with seeds 1, 2, … until they have come to `expansions`, at most 300 a search.
template <class P, class R>
void follow(Bench<R, P>& bench, const Rules& rules, Choices& choices, std::uint32_t path_regions,
            std::uint64_t expansions, Seen& seen) {
  ASSERT_TRUE(bench.init().ok());
  std::vector<float> start;
  at_start(bench.robot, start);
  for (std::uint64_t seed = 1; seen.expansions < expansions; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    ASSERT_EQ(bench.planner.start({start.data(), Goal::named(0), seed}), Status::searching);
    Follower follower(bench.planner, bench.open.scene, 0, start.data(), rules, path_regions);
    for (int i = 0; i < 300 && bench.planner.status() == Status::searching && !follower.refused(); ++i) {
      const std::optional<Expansion> expansion = follower.follow();
      if (testing::Test::HasFailure()) return;
      if (!expansion) continue;
      choices.add(bench.planner, follower, bench.open.scene, *expansion);
      ++seen.expansions;
      ++seen.ends[static_cast<int>(follower.result())];
      seen.longest = std::max<std::uint64_t>(seen.longest, expansion->path.size() - 1);
    }
    seen.updates += follower.updates();
    seen.goal_raises += follower.goal_raises();
    seen.doomed += follower.doomed();
    seen.solved += bench.planner.status() == Status::solved ? 1 : 0;
    seen.refused += follower.refused() ? 1 : 0;
  }
  EXPECT_LE(10 * seen.refused, seen.solved + 10) << "ways that did not hold as driven";
}

// Whether searches came to all ends that there are, expansions as long as they may be among them.
void expect_all_ends(const Seen& seen, std::uint32_t max_steps) {
  for (const Result result : {Result::goal_reached, Result::target_reached, Result::collision}) {
    EXPECT_GT(seen.ends[static_cast<int>(result)], 0U) << static_cast<int>(result);
  }
  EXPECT_EQ(seen.longest, max_steps);
}

// Without looks before driving, long ways and brakes, which are not the paper's.
Parameters adaptive() {
  Parameters p;
  p.end_speed = kInfinity;
  p.tuning.open_steps = 0;
  p.tuning.sight_tries = 0;
  p.tuning.candidates = 0;
  p.tuning.max_steps = 24;
  p.tuning.kappa = 7;
  return p;
}

struct Setting {
  const char* name;
  Room (*room)();
};

class ReferencePlanner : public testing::TestWithParam<Setting> {};

TEST_P(ReferencePlanner, AgreesWithAdaptive) {
  Bench<Unicycle, detail::AdaptiveSearch> bench(GetParam().room(), small_unicycle());
  bench.parameters = adaptive();
  bench.parameters.tuning.prune_portals = false;  // so that the narrow door is tried
  Rules rules = rules_of(bench.parameters, 0.5, 0.2);
  rules.reach = kUnicyclesReach;
  Choices choices(shares_of(bench.parameters));
  Seen seen;
  follow(bench, rules, choices, bench.parameters.tuning.path_regions, 1000, seen);
  choices.expect();
  EXPECT_GT(seen.updates, 20U);
  EXPECT_GT(seen.doomed, 100U);
}

// Algorithms 1 and 2 with the constants of the paper's Table 2.
TEST_P(ReferencePlanner, AgreesWithThePapers) {
  Bench<Unicycle, detail::AdaptiveSearch> bench(GetParam().room(), small_unicycle());
  bench.parameters = Parameters::paper();
  Rules rules{8, 0.85, 0.01};
  rules.gamma = 50;
  rules.kappa = 20;
  rules.near = double{bench.parameters.tuning.near_radius} * 0.5;
  rules.goal_near = rules.near;
  rules.least_cost = 0.025;
  rules.reach = kUnicyclesReach;
  Shares shares;
  shares.slowest = double{bench.parameters.tuning.slowest};
  shares.reverse = double{bench.parameters.tuning.reverse_share};
  Choices choices(shares);
  Seen seen;
  follow(bench, rules, choices, shares.path_regions, 1000, seen);
  choices.expect();
  EXPECT_GT(seen.updates, 10U);
  EXPECT_EQ(seen.doomed, 0U);
}

TEST_P(ReferencePlanner, AgreesWithPriorWork) {
  Bench<Unicycle, PriorPlanner> bench(GetParam().room(), small_unicycle());
  bench.parameters.tuning.max_steps = 24;
  bench.parameters.tuning.prune_portals = false;
  Rules rules = rules_of_prior(bench.parameters, 0.5, 0.2);
  rules.reach = kUnicyclesReach;
  const Shares shares = shares_of_prior(bench.parameters);
  Choices choices(shares);
  Seen seen;
  follow(bench, rules, choices, shares.path_regions, 1000, seen);
  choices.expect();
  EXPECT_EQ(seen.longest, 24U);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ReferencePlanner,
                         testing::Values(Setting{"dead_end", dead_end}, Setting{"narrow_door", narrow_door},
                                         Setting{"fenced_goal", fenced_goal}, Setting{"winding", winding}),
                         [](const auto& setting) { return std::string(setting.param.name); });

// Failures right before the goal raise its edges where they are asked to.
TEST(ReferencePlannerGoal, IsRaisedOnlyWhereAskedTo) {
  for (const bool raise_goal : {false, true}) {
    Bench<Unicycle, detail::AdaptiveSearch> bench(fenced_goal(), small_unicycle());
    bench.parameters = adaptive();
    bench.parameters.tuning.raise_goal = raise_goal;
    bench.parameters.tuning.prune_portals = false;
    Rules rules = rules_of(bench.parameters, 0.5, 0.2);
    Choices choices(shares_of(bench.parameters));
    Seen seen;
    follow(bench, rules, choices, bench.parameters.tuning.path_regions, 900, seen);
    EXPECT_GT(seen.goal_raises, 20U);
  }
}

// Of searches that end: how, and expansions as long as they may be.
TEST(ReferencePlannerEnds, AreAllSeen) {
  for (const std::uint32_t max_steps : {8U, 40U}) {
    Bench<Unicycle, detail::AdaptiveSearch> bench(two_rooms(1), small_unicycle());
    bench.parameters = adaptive();
    bench.parameters.tuning.max_steps = max_steps;
    Rules rules = rules_of(bench.parameters, 0.5, 0.2);
    rules.reach = kUnicyclesReach;
    Choices choices(shares_of(bench.parameters));
    Seen seen;
    follow(bench, rules, choices, bench.parameters.tuning.path_regions, 1000, seen);
    choices.expect();
    expect_all_ends(seen, max_steps);
    EXPECT_GT(seen.solved, 5U);
  }
}

// Tries of 1, 1, 2, 1, 1, 2, 4, … units, each with costs and groups as at first.
TEST(ReferencePlannerRestarts, ForgetWhatTheTryHasLearnt) {
  Bench<Unicycle, detail::AdaptiveSearch> bench(narrow_door(), small_unicycle());
  bench.parameters = adaptive();
  bench.parameters.tuning.restart_unit = 300;  // of which a short way's tries last a tenth
  bench.parameters.tuning.prune_portals = false;
  Rules rules = rules_of(bench.parameters, 0.5, 0.2);
  Choices choices(shares_of(bench.parameters));
  Seen seen;
  follow(bench, rules, choices, bench.parameters.tuning.path_regions, 400, seen);
  EXPECT_EQ(bench.planner.statistics().restarts, 6U);  // after 30, 60, 120, 150, 180, 240 expansions
}

// Robots with states of their own: a car that pulls two trailers. planner_ways_test holds how it slows for targets.
TEST(ReferencePlannerChain, AgreesWithAdaptive) {
  Bench<Snake, detail::AdaptiveSearch> bench(dead_end(), Snake(small_chain(2)));
  bench.parameters = adaptive();
  bench.parameters.tuning.stopping_ways = 0.0F;
  Choices choices(shares_of(bench.parameters));
  Seen seen;
  follow(bench, rules_of(bench.parameters, 0.4, 0.15), choices, bench.parameters.tuning.path_regions, 900, seen);
  EXPECT_GT(seen.updates, 10U);
  EXPECT_GT(seen.expansions, 500U);
}

}  // namespace
}  // namespace krait::test::reference
