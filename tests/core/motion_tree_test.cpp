// SPDX-License-Identifier: Apache-2.0
// The motion tree against one made of shared pointers, and what its memory holds at any time.
#include "plan/motion_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include "draws.hpp"

namespace krait::test::motion_tree_test {
namespace {

constexpr int kStateSize = 3;
constexpr Box kBounds{{-4, 10}, {28, 26}};

// An expansion that lives as long as something points to it.
struct Node {
  std::shared_ptr<Node> before;  // where it branches off: none at the root
  std::uint32_t at_step = 0;
  Index slot = kNone;
  Target target;
  std::uint32_t steps = 0;
};

struct Kept {
  std::shared_ptr<Node> node;
  std::uint32_t step = 0;
  std::vector<float> state;
};

class Fixture {
 public:
  Fixture(std::uint32_t vertices, std::uint32_t expansions) {
    detail::Arena counting;
    tree.allocate(counting, vertices, expansions, kStateSize);
    block.assign(counting.needed() / 8, 0x7E7E7E7E7E7E7E7EULL);
    detail::Arena arena(block.data(), block.size() * 8);
    tree.allocate(arena, vertices, expansions, kStateSize);
    tree.reset(kBounds, 0);
  }

  std::vector<std::uint64_t> block;
  detail::MotionTree tree;
};

std::vector<float> some_state(std::mt19937& random) {
  return {uniform_float(random, -4, 28), uniform_float(random, 10, 26), uniform_float(random, -3, 3)};
}

// The tree and its reference, grown together.
class Grown {
 public:
  Grown(std::uint32_t vertices, std::uint32_t expansions, unsigned seed)
      : fixture_(vertices, expansions), vertices_(vertices), expansions_(expansions), random_(seed) {
    keep({}, 0);
  }

  detail::MotionTree& tree() { return fixture_.tree; }
  const std::map<Index, Kept>& kept() const { return kept_; }

  // An expansion from some vertex that keeps some of its states, in free slots or in others' place.
  void expand() {
    if (tree().expansions_full()) return;
    const Kept from = any()->second;
    const auto node = std::make_shared<Node>();
    *node = {from.node,
             from.step,
             kNone,
             {{uniform_float(random_, -4, 28), uniform_float(random_, 10, 26)},
              uniform_float(random_, -1, 1),
              0,
              uniform_float(random_, 0.1, 1)}};
    node->slot = tree().begin_expansion(branch(from), node->target);
    nodes_.push_back(node);
    most_nodes_ = std::max(most_nodes_, alive().size());
    check();
    const std::uint32_t steps = below(random_, 41);
    for (std::uint32_t step = 1; step <= steps; ++step) {
      if (random_() % 3 == 0) continue;
      if (!tree().vertices_full()) {
        keep(node, step);
      } else if (kept_.size() > 1) {
        replace(node, step);
      }
    }
    tree().end_expansion(node->slot, steps);
    node->steps = steps;
  }

  void remove() {
    if (kept_.size() < 2) return;
    const auto vertex = any_but_the_root();
    tree().remove(vertex->first);
    kept_.erase(vertex);
  }

  // That the tree is the reference.
  void check() {
    ASSERT_EQ(tree().vertices(), kept_.size());
    ASSERT_EQ(tree().vertices_full(), kept_.size() == vertices_);
    ASSERT_EQ(tree().most_vertices(), most_vertices_);
    for (const auto& [vertex, kept] : kept_) {
      ASSERT_EQ(tree().branch(vertex).expansion, branch(kept).expansion);
      ASSERT_EQ(tree().branch(vertex).step, branch(kept).step);
      ASSERT_EQ(std::vector<float>(tree().state(vertex), tree().state(vertex) + kStateSize), kept.state);
    }
    const auto living = alive();
    ASSERT_EQ(tree().expansions(), living.size());
    ASSERT_EQ(tree().expansions_full(), living.size() == expansions_);
    ASSERT_EQ(tree().most_expansions(), most_nodes_);
    std::map<Index, int> slots;
    for (const auto& node : living) {
      ASSERT_EQ(++slots[node->slot], 1);
      ASSERT_LT(node->slot, expansions_);
      expect_stored(*node);
    }
    ASSERT_EQ(tree().bytes_untouched(),
              (vertices_ - most_vertices_) * (4 + 4 * kStateSize) + (expansions_ - most_nodes_) * 16);
  }

  // Turns the path to a vertex around and compares it, step by step.
  void check_path(Index vertex) {
    std::vector<std::pair<std::shared_ptr<Node>, std::uint32_t>> expected;  // expansion, steps taken of it
    const Kept& last = kept_.at(vertex);
    std::uint32_t steps = last.step;
    for (auto node = last.node; node != nullptr; node = node->before) {
      expected.push_back({node, steps});
      steps = node->at_step;
    }
    std::reverse(expected.begin(), expected.end());
    const Index first = tree().turn_path(tree().branch(vertex));
    Index at = first;
    for (const auto& [node, taken] : expected) {
      ASSERT_EQ(at, node->slot);
      ASSERT_EQ(tree().steps(at), taken);
      expect_target(*node);
      at = tree().next_of_path(at);
      node->steps = taken;
    }
    ASSERT_EQ(at, kNone);
    tree().turn_path_back(first);
  }

  // Of a vertex that is not the root's, kNone when there is none.
  Index any_vertex() { return kept_.size() < 2 ? kNone : any_but_the_root()->first; }
  std::mt19937& random() { return random_; }

 private:
  static detail::Branch branch(const Kept& kept) {
    return kept.node == nullptr ? detail::Branch{} : detail::Branch{kept.node->slot, kept.step};
  }

  std::map<Index, Kept>::iterator any() { return std::next(kept_.begin(), below(random_, kept_.size())); }
  std::map<Index, Kept>::iterator any_but_the_root() {
    return std::next(kept_.begin(), 1 + below(random_, kept_.size() - 1));
  }

  void keep(const std::shared_ptr<Node>& node, std::uint32_t step) {
    const Kept kept{node, step, some_state(random_)};
    const Index vertex = tree().add(branch(kept), kept.state.data());
    ASSERT_LT(vertex, vertices_);
    ASSERT_TRUE(kept_.insert({vertex, kept}).second) << "a slot in use was given again";
    most_vertices_ = std::max(most_vertices_, kept_.size());
  }

  void replace(const std::shared_ptr<Node>& node, std::uint32_t step) {
    auto& [vertex, kept] = *any_but_the_root();
    kept = {node, step, some_state(random_)};
    tree().replace(vertex, branch(kept), kept.state.data());
  }

  std::vector<std::shared_ptr<Node>> alive() {
    std::vector<std::shared_ptr<Node>> result;
    for (const auto& node : nodes_) {
      if (const auto living = node.lock()) result.push_back(living);
    }
    nodes_.assign(result.begin(), result.end());
    return result;
  }

  void expect_stored(const Node& node) {
    const detail::Branch origin = tree().origin(node.slot);
    ASSERT_EQ(origin.expansion, node.before == nullptr ? kNone : node.before->slot);
    ASSERT_EQ(origin.step, node.before == nullptr ? 0 : node.at_step);
    ASSERT_EQ(tree().steps(node.slot), node.steps);
    expect_target(node);
  }

  // A target is stored to half a 65535th of the bounds, of the speeds and of the turns.
  void expect_target(const Node& node) {
    const Target target = tree().target(node.slot);
    ASSERT_NEAR(target.point.x, node.target.point.x, 0.5 * 32 / 65535 + 1e-5);
    ASSERT_NEAR(target.point.y, node.target.point.y, 0.5 * 16 / 65535 + 1e-5);
    ASSERT_NEAR(target.speed, node.target.speed, 0.5 / 32767 + 1e-6);
    ASSERT_NEAR(target.turn, node.target.turn, 0.5 / 65535 + 1e-6);
  }

  Fixture fixture_;
  std::size_t vertices_, expansions_;
  std::mt19937 random_;
  std::map<Index, Kept> kept_;
  std::vector<std::weak_ptr<Node>> nodes_;
  std::size_t most_vertices_ = 0, most_nodes_ = 0;
};

TEST(MotionTree, AgreesWithOneOfSharedPointersInRandomOperations) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    std::mt19937 sizes(seed);
    Grown grown(2 + below(sizes, 60), 2 + below(sizes, 30), seed);
    for (int i = 0; i < 600; ++i) {
      grown.random()() % 3 == 0 ? grown.expand() : grown.remove();
      grown.check();
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(MotionTree, TurnsThePathToAnyVertexAround) {
  int paths = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    Grown grown(50, 40, seed);
    for (int i = 0; i < 100; ++i) grown.random()() % 4 != 0 ? grown.expand() : grown.remove();
    const Index vertex = grown.any_vertex();
    if (vertex == kNone) continue;
    grown.check_path(vertex);
    if (HasFatalFailure()) return;
    // Turned back, the tree goes on to grow.
    for (int i = 0; i < 100; ++i) grown.random()() % 4 != 0 ? grown.expand() : grown.remove();
    const Index later = grown.any_vertex();
    if (later != kNone) grown.check_path(later);
    if (HasFatalFailure()) return;
    ++paths;
  }
  EXPECT_GT(paths, 150);
}

TEST(MotionTree, TurnsAPathWhoseLastExpansionStillGrows) {
  Fixture f(10, 10);
  const float state[kStateSize] = {};
  f.tree.add({}, state);
  const Index first = f.tree.begin_expansion({}, {{0, 20}, 1.0F});
  f.tree.add({first, 3}, state);
  f.tree.end_expansion(first, 7);
  const Index second = f.tree.begin_expansion({first, 3}, {{1, 20}, 1.0F});
  EXPECT_EQ(f.tree.turn_path({second, 5}), first);
  EXPECT_EQ(f.tree.steps(first), 3U);
  EXPECT_EQ(f.tree.next_of_path(first), second);
  EXPECT_EQ(f.tree.steps(second), 5U);
  EXPECT_EQ(f.tree.next_of_path(second), kNone);
}

TEST(MotionTree, AnExpansionLivesWhileAVertexOrALaterOneNeedsIt) {
  Fixture f(10, 10);
  const float state[kStateSize] = {1, 2, 3};
  f.tree.add({}, state);
  const Index first = f.tree.begin_expansion({}, {{0, 20}, 1.0F});
  const Index a = f.tree.add({first, 1}, state);
  const Index b = f.tree.add({first, 2}, state);
  f.tree.end_expansion(first, 2);
  f.tree.remove(a);
  EXPECT_EQ(f.tree.expansions(), 1U);  // b needs it
  const Index second = f.tree.begin_expansion({first, 2}, {{0, 20}, 1.0F});
  const Index c = f.tree.add({second, 1}, state);
  f.tree.end_expansion(second, 1);
  f.tree.remove(b);
  EXPECT_EQ(f.tree.expansions(), 2U);  // the second needs it
  f.tree.remove(c);
  EXPECT_EQ(f.tree.expansions(), 0U);
  EXPECT_EQ(f.tree.vertices(), 1U);
}

TEST(MotionTree, AnExpansionThatKeptNothingGoesWhenItEnds) {
  Fixture f(10, 10);
  const Index expansion = f.tree.begin_expansion({}, {{0, 20}, 1.0F});
  EXPECT_EQ(f.tree.expansions(), 1U);
  f.tree.end_expansion(expansion, 5);
  EXPECT_EQ(f.tree.expansions(), 0U);
  EXPECT_EQ(f.tree.most_expansions(), 1U);
}

TEST(MotionTree, AReplacedVertexInItsOwnExpansionKeepsIt) {
  Fixture f(1, 1);
  const float one[kStateSize] = {1, 1, 1}, two[kStateSize] = {2, 2, 2};
  const Index expansion = f.tree.begin_expansion({}, {{0, 20}, 1.0F});
  const Index vertex = f.tree.add({expansion, 1}, one);
  f.tree.end_expansion(expansion, 4);
  f.tree.replace(vertex, {expansion, 4}, two);
  EXPECT_EQ(f.tree.expansions(), 1U);
  EXPECT_EQ(f.tree.branch(vertex).step, 4U);
  EXPECT_EQ(f.tree.state(vertex)[2], 2.0F);
}

TEST(MotionTree, SlotsAreReusedBeforeNewOnesAreTaken) {
  Fixture f(100, 100);
  const float state[kStateSize] = {};
  for (int round = 0; round < 50; ++round) {
    const Index expansion = f.tree.begin_expansion({}, {{0, 20}, 1.0F});
    const Index a = f.tree.add({expansion, 1}, state), b = f.tree.add({expansion, 2}, state);
    f.tree.end_expansion(expansion, 2);
    EXPECT_LT(std::max(a, b), 2U);
    EXPECT_EQ(expansion, 0U);
    f.tree.remove(a);
    f.tree.remove(b);
  }
  EXPECT_EQ(f.tree.most_vertices(), 2U);
  EXPECT_EQ(f.tree.most_expansions(), 1U);
}

TEST(MotionTree, TargetsAtAndBeyondTheBoundsAreHeldInThem) {
  Fixture f(2, 2);
  const auto stored = [&](Vec2 point, float speed) {
    const Index expansion = f.tree.begin_expansion({}, {point, speed});
    const Target target = f.tree.target(expansion);
    f.tree.end_expansion(expansion, 0);
    return target;
  };
  for (const float excess : {0.0F, 1.0F, 1e30F}) {
    const Target low = stored({-4 - excess, 10 - excess}, -1.0F - excess);
    EXPECT_EQ(low.point.x, -4.0F);
    EXPECT_EQ(low.point.y, 10.0F);
    EXPECT_EQ(low.speed, -1.0F);
    const Target high = stored({28 + excess, 26 + excess}, 1.0F + excess);
    EXPECT_NEAR(high.point.x, 28.0F, 1e-5F);
    EXPECT_NEAR(high.point.y, 26.0F, 1e-5F);
    EXPECT_EQ(high.speed, 1.0F);
  }
  EXPECT_EQ(stored({0, 20}, 0.0F).speed, 0.0F);
}

TEST(MotionTree, StoredTargetsAreStoredAsThemselves) {
  Fixture f(2, 2);
  std::mt19937 random(1);
  for (int i = 0; i < 10'000; ++i) {
    Target wanted{{uniform_float(random, -4, 28), uniform_float(random, 10, 26)}, uniform_float(random, -1, 1)};
    wanted.turn = uniform_float(random, 0, 1);
    Target target[2];
    for (Target& t : target) {
      const Index expansion = f.tree.begin_expansion({}, wanted);
      wanted = t = f.tree.target(expansion);
      f.tree.end_expansion(expansion, 0);
    }
    ASSERT_EQ(target[0].turn, target[1].turn);
    ASSERT_EQ(target[0].point.x, target[1].point.x);
    ASSERT_EQ(target[0].point.y, target[1].point.y);
    ASSERT_EQ(target[0].speed, target[1].speed);
  }
}

TEST(MotionTree, TheLongestExpansionIsCountedToTheStep) {
  Fixture f(3, 2);
  const float state[kStateSize] = {};
  const Index expansion = f.tree.begin_expansion({}, {{0, 20}, 1.0F});
  const Index vertex = f.tree.add({expansion, detail::MotionTree::kMostSteps}, state);
  f.tree.end_expansion(expansion, detail::MotionTree::kMostSteps);
  EXPECT_EQ(f.tree.steps(expansion), detail::MotionTree::kMostSteps);
  EXPECT_EQ(f.tree.branch(vertex).step, detail::MotionTree::kMostSteps);
  EXPECT_EQ(f.tree.branch(vertex).expansion, expansion);
  f.tree.remove(vertex);
  EXPECT_EQ(f.tree.expansions(), 0U);
}

TEST(MotionTree, KeepsSpareExpansionsBack) {
  Fixture f(4, 4);
  f.tree.reset(kBounds, 1);
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(f.tree.expansions_full());
    f.tree.begin_expansion({}, {{0, 20}, 1.0F});
  }
  EXPECT_TRUE(f.tree.expansions_full());
  EXPECT_EQ(f.tree.begin_expansion({}, {{0, 20}, 0.0F}), 3U);
  EXPECT_EQ(f.tree.target(3).speed, 0.0F);
  f.tree.end_expansion(3, 0);
  f.tree.end_expansion(0, 0);
  EXPECT_FALSE(f.tree.expansions_full());
}

TEST(MotionTree, ClearForgetsEverything) {
  Fixture f(4, 4);
  const float state[kStateSize] = {};
  for (int round = 0; round < 3; ++round) {
    for (Index i = 0; i < 4; ++i) {
      const Index expansion = f.tree.begin_expansion({}, {{0, 20}, 1.0F});
      EXPECT_EQ(expansion, i);
      EXPECT_EQ(f.tree.add({expansion, 1}, state), i);
      f.tree.end_expansion(expansion, 1);
    }
    EXPECT_TRUE(f.tree.vertices_full());
    EXPECT_TRUE(f.tree.expansions_full());
    EXPECT_EQ(f.tree.bytes_untouched(), 0U);
    f.tree.remove(2);
    f.tree.reset(kBounds, 0);
    EXPECT_EQ(f.tree.vertices(), 0U);
    EXPECT_EQ(f.tree.expansions(), 0U);
    EXPECT_EQ(f.tree.most_vertices(), 0U);
    EXPECT_EQ(f.tree.most_expansions(), 0U);
  }
}

}  // namespace
}  // namespace krait::test::motion_tree_test
