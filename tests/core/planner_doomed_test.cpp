// SPDX-License-Identifier: Apache-2.0
// The last states before a collision: they are not kept to grow from.
#include "planner_fixture.hpp"
#include "search/adaptive_search.hpp"

namespace krait::test::planner_doomed_test {
namespace {

constexpr float kStart[] = {2, 6, 0};

// Single expansions of one search, and which of their states the tree keeps.
class Expansions {
 public:
  Expansions(std::uint32_t doomed_steps, std::uint64_t seed) : bench_(two_rooms(0.8), small_unicycle()) {
    bench_.parameters.tuning.doomed_steps = doomed_steps;
    bench_.parameters.tuning.group_sample = 65535;  // nothing is left out by chance
    EXPECT_TRUE(bench_.init().ok());
    EXPECT_EQ(bench_.planner.start({kStart, Goal::named(0), seed}), Status::searching);
  }

  // Makes one expansion. False when the search has ended.
  bool next() {
    states_.clear();
    kept_before_ = detail::opened(bench_.planner).tree().vertices();
    return bench_.planner.advance(1,
                                  [&](const float*, const float* to) {
                                    states_.push_back({to[0], to[1], to[2]});
                                  }) == Status::searching &&
           !detail::opened(bench_.planner).driving();
  }

  std::size_t made() const { return states_.size(); }
  std::size_t kept() const { return detail::opened(bench_.planner).tree().vertices() - kept_before_; }

  // Whether the first states that were made, and no others, are those that were kept.
  bool first_are_kept() const {
    const detail::MotionTree& tree = detail::opened(bench_.planner).tree();
    for (std::size_t i = 0; i < kept(); ++i) {
      const float* state = tree.state(static_cast<Index>(kept_before_ + i));
      if (!std::equal(states_[i].begin(), states_[i].end(), state)) return false;
      if (tree.branch(static_cast<Index>(kept_before_ + i)).step != i + 1) return false;
    }
    return true;
  }

  // How many states are in another region than their group's; on an edge between two either is right.
  std::uint32_t misplaced() const {
    const detail::MotionTree& tree = detail::opened(bench_.planner).tree();
    const Scene& scene = bench_.open.scene;
    std::vector<std::uint32_t> in_region(scene.triangle_count());
    for (Index vertex = 0; vertex < tree.vertices(); ++vertex) {
      const float* state = tree.state(vertex);
      ++in_region[detail::opened(bench_.planner).regions().region(detail::locate(scene, {state[0], state[1]}))];
    }
    std::uint32_t missing = 0;
    for (Index region = 0; region < scene.triangle_count(); ++region) {
      const std::uint32_t grouped = detail::opened(bench_.planner).groups().size(region);
      if (grouped < in_region[region]) missing += in_region[region] - grouped;
    }
    return missing;
  }

 private:
  Bench<Unicycle> bench_;
  std::size_t kept_before_ = 0;
  std::vector<std::vector<float>> states_;
};

class DoomedSteps : public ::testing::TestWithParam<std::uint32_t> {};

// An expansion keeps all of its states, or all but the last.
TEST_P(DoomedSteps, AreNotKept) {
  const std::size_t doomed = GetParam();
  int cut = 0, whole = 0, nothing = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Expansions expansions(GetParam(), seed);
    while (expansions.next()) {
      const std::size_t made = expansions.made();
      const std::size_t kept = expansions.kept();
      ASSERT_TRUE(kept == made || kept + doomed == made || (kept == 0 && made < doomed)) << made << " " << kept;
      ASSERT_TRUE(expansions.first_are_kept());
      cut += kept > 0 && kept < made ? 1 : 0;
      nothing += kept == 0 && made > 0 ? 1 : 0;
      whole += kept == made && made > 0 ? 1 : 0;
    }
    ASSERT_LE(expansions.misplaced(), 2U);
  }
  EXPECT_GT(whole, 0);
  EXPECT_EQ(cut > 0, doomed > 0);
  EXPECT_EQ(nothing > 0, doomed > 0);
}

INSTANTIATE_TEST_SUITE_P(All, DoomedSteps, ::testing::Values(0, 1, 2, 3));

TEST(PlannerDoomedSteps, AreNotThePapers) {
  EXPECT_EQ(Parameters::paper().tuning.doomed_steps, 0U);
  const auto hashes_with = [](std::uint32_t doomed_steps) {
    Bench<Unicycle> bench(two_rooms(), small_unicycle());
    bench.parameters.tuning.doomed_steps = doomed_steps;
    bench.parameters.tuning.sight_tries = 0;  // more expansions collide
    bench.parameters.tuning.candidates = 0;
    EXPECT_TRUE(bench.init().ok());
    std::vector<std::uint64_t> hashes;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      EXPECT_EQ(bench.solve({kStart, Goal::named(0), seed}), Status::solved);
      hashes.push_back(bench.planner.statistics().hash);
    }
    return hashes;
  };
  EXPECT_NE(hashes_with(0), hashes_with(3));
}

}  // namespace
}  // namespace krait::test::planner_doomed_test
