// SPDX-License-Identifier: Apache-2.0
// The core never calls the heap: malloc and its like abort here while it works.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "decomposition/locate.hpp"
#include "planner_fixture.hpp"
#include "robot_oracle.hpp"

#if defined(__SANITIZE_ADDRESS__) || !defined(__GLIBC__)
#define KRAIT_NO_TRAP 1
#endif

namespace {
bool trapped = false;
int calls = 0;
}  // namespace

#ifndef KRAIT_NO_TRAP
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void __libc_free(void* block);

void* malloc(std::size_t size) noexcept {
  if (trapped) ++calls;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  if (trapped) ++calls;
  return __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) noexcept {
  if (trapped) ++calls;
  return __libc_realloc(block, size);
}
void free(void* block) noexcept {
  if (trapped) ++calls;
  __libc_free(block);
}
}
#endif

namespace krait::test::heap_trap_test {
namespace {

// Counts heap calls while it lives.
class Trap {
 public:
  Trap() {
    calls = 0;
    trapped = true;
  }
  ~Trap() { trapped = false; }
  Trap(const Trap&) = delete;
  Trap& operator=(const Trap&) = delete;
};

class HeapTrap : public ::testing::Test {
 protected:
  void SetUp() override {
#ifdef KRAIT_NO_TRAP
    GTEST_SKIP() << "malloc cannot be replaced here: a sanitiser or another C library has it";
#endif
  }
};

TEST_F(HeapTrap, SeesTheHeap) {
  void* volatile block = nullptr;
  {
    const Trap trap;
    block = std::malloc(16);
    std::free(block);
    block = ::operator new(16);
    ::operator delete(block);
  }
  EXPECT_EQ(calls, 4);
}

TEST_F(HeapTrap, OpenAndLocateDoNotUseTheHeap) {
  const SceneBytes bytes = data_of(random_room(1)).bytes();
  Index found = kNone;
  {
    const Trap trap;
    Scene scene;
    if (Scene::open(bytes.data(), bytes.size(), scene).ok()) found = detail::locate(scene, {11, 11});
    if (scene.find_goal("goal0") != 0) found = kNone;
  }
  EXPECT_EQ(calls, 0);
  EXPECT_NE(found, kNone);
}

template <class R>
void expect_no_heap(const R& robot, const std::vector<float>& start) {
  Bench<R> bench(two_rooms(), robot);
  bench.limits.way_legs = 64;
  std::vector<std::uint64_t> block(Planner::bytes_required(bench.open.scene, robot, bench.limits) / 8);
  std::vector<float> states(100'000), controls(100'000);
  bench.parameters.tuning.kappa = 1;
  Status status = Status::searching;
  {
    const Trap trap;
    const Limits most = bench.planner.limits_for(block.size() * 8, bench.open.scene, robot, 64);
    bench.limits.vertices = most.vertices;
    (void)bench.planner.init({block.data(), block.size() * 8, &bench.open.scene, bench.robot}, bench.parameters,
                             bench.limits);
    (void)bench.planner.start({start.data()});
    status = bench.planner.advance(1'000'000);
    if (status == Status::solved) status = bench.planner.improve(200);
    const Plan plan = bench.planner.plan();
    if (plan.steps() < 1000) plan.copy(states.data(), controls.data());
  }
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(status, Status::solved);
}

template <class R>
class HeapTrapOf : public HeapTrap {};
TYPED_TEST_SUITE(HeapTrapOf, Models, ModelNames);

TYPED_TEST(HeapTrapOf, PlansWithoutTheHeap) {
  const TypeParam robot = small_robot<TypeParam>();
  expect_no_heap(robot, standing(robot, {2, 6}));
}

TEST_F(HeapTrap, ARobotOfYourOwnPlansWithoutTheHeap) { expect_no_heap(Slider(0.5F, 1.5F), {2, 6}); }

}  // namespace
}  // namespace krait::test::heap_trap_test
