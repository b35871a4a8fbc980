// SPDX-License-Identifier: Apache-2.0
// No call of advance(1) does more than work_bound says. The calls are counted where they happen: the core is compiled
// into this test with every function's entry reported (-finstrument-functions).
#include "host/run/work.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "collision/distance.hpp"
#include "collision/sight.hpp"
#include "decomposition/indexed_heap.hpp"
#include "host/run/robots.hpp"
#include "paths.hpp"

namespace krait::host {
namespace {

struct Counter {
  const void* function;
  std::uint64_t calls;
};

// Functions that are counted; few, so that a look at all of them at every call is cheap.
Counter counters[6];

void forget() {
  for (Counter& counter : counters) counter.calls = 0;
}

// The address of a member function that is not virtual: its first word (Itanium C++ ABI, 2.3).
template <class Member>
const void* address_of(Member member) {
  const void* address = nullptr;
  std::memcpy(&address, &member, sizeof address);
  return address;
}

}  // namespace
}  // namespace krait::host

extern "C" {
__attribute__((no_instrument_function)) void __cyg_profile_func_enter(void* function, void*) {
  for (krait::host::Counter& counter : krait::host::counters) counter.calls += counter.function == function ? 1 : 0;
}
__attribute__((no_instrument_function)) void __cyg_profile_func_exit(void*, void*) {}
}

namespace krait::host {
namespace {

struct SceneFile {
  std::vector<std::uint64_t> words;
  krait::Scene scene;

  explicit SceneFile(const std::string& name) {
    const std::filesystem::path base = std::filesystem::path(testing::TempDir()) / ("work_" + name);
    const std::string program = test::program_path("krait");
    const std::string command = program + " scene " + name + " -o " + base.string() + ".json && " + program +
                                " compile " + base.string() + ".json -o " + base.string() + ".krait";
    if (std::system(command.c_str()) != 0) throw std::runtime_error("cannot run: " + command);
    std::ifstream file(base.string() + ".krait", std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    words.resize((bytes.size() + 7) / 8);
    std::memcpy(words.data(), bytes.data(), bytes.size());
    if (!krait::Scene::open(words.data(), bytes.size(), scene).ok()) throw std::runtime_error(name + ": bad scene");
  }
};

// The most of each that one call of advance(1) did, over the first 400 calls of a search.
template <RobotModel R>
Work most_work(const krait::Scene& scene, const R& robot, std::uint64_t seed) {
  counters[0].function = address_of(&Robot::integrate_lead);
  counters[1].function = reinterpret_cast<const void*>(&detail::polygon_distance);
  counters[2].function = address_of(&detail::IndexedHeap::push);
  counters[3].function = address_of(&detail::IndexedHeap::pop);
  counters[4].function = address_of(&Robot::sketch);
  counters[5].function = address_of(&detail::Sight::slack);
  std::vector<std::uint64_t> block(1U << 19U);
  const auto planner = std::make_unique<Planner>();
  const Limits limits = planner->limits_for(8 * block.size(), scene, robot);
  EXPECT_TRUE(planner->init({block.data(), 8 * block.size(), &scene, robot}, Parameters(), limits).ok());
  float state[R::kMaxState] = {};
  const ScenePose start = scene.start(0);
  state[0] = start.position.x;
  state[1] = start.position.y;
  for (int i = 2; i < robot.state_size(); ++i) state[i] = i == 3 || i == 4 ? 0.0F : start.heading;
  EXPECT_EQ(planner->start({state, krait::Goal::named(0), seed}), Status::searching);
  Work most;
  std::uint64_t placed = planner->statistics().collision_checks;
  for (int call = 0; call < 400 && planner->status() == Status::searching; ++call) {
    forget();
    (void)planner->advance(1);
    const Statistics now = planner->statistics();
    most.placements = std::max(most.placements, now.collision_checks - placed);
    most.runge_kutta_steps = std::max(most.runge_kutta_steps, counters[0].calls);
    most.polygon_distances = std::max(most.polygon_distances, counters[1].calls);
    most.heap_operations = std::max(most.heap_operations, counters[2].calls + counters[3].calls);
    most.sketched_steps = std::max(most.sketched_steps, counters[4].calls);
    most.discs = std::max(most.discs, counters[5].calls);
    placed = now.collision_checks;
  }
  return most;
}

void expect_bounded(const char* name_of_robot) {
  const RobotSpec spec = parse_robot(name_of_robot);
  Work counted;
  for (const char* name : {"openings", "rooms", "corridors"}) {
    const SceneFile file(name);
    const Work bound = work_bound(file.scene, extent_of(spec, Parameters()), Parameters());
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      SCOPED_TRACE(std::string(name) + ", seed " + std::to_string(seed));
      const Work most = CoreRobot(spec).visit([&](const auto& robot) { return most_work(file.scene, robot, seed); });
      EXPECT_LE(most.placements, bound.placements);
      EXPECT_LE(most.runge_kutta_steps, bound.runge_kutta_steps);
      EXPECT_LE(most.polygon_distances, bound.polygon_distances);
      EXPECT_LE(most.heap_operations, bound.heap_operations);
      EXPECT_LE(most.sketched_steps, bound.sketched_steps);
      EXPECT_LE(most.discs, bound.discs);
      counted.runge_kutta_steps += most.runge_kutta_steps;
      counted.polygon_distances += most.polygon_distances;
      counted.heap_operations += most.heap_operations;
      counted.sketched_steps += most.sketched_steps;
      counted.discs += most.discs;
    }
  }
  // What is not counted is not bounded.
  EXPECT_GT(counted.runge_kutta_steps, 0U);
  EXPECT_GT(counted.polygon_distances, 0U);
  EXPECT_GT(counted.heap_operations, 0U);
  EXPECT_GT(counted.sketched_steps, 0U);
  EXPECT_GT(counted.discs, 0U);
}

TEST(Work, OfALongSnakeIsBounded) { expect_bounded("snake:15"); }
TEST(Work, OfAShortSnakeIsBounded) { expect_bounded("snake:5"); }
TEST(Work, OfACarIsBounded) { expect_bounded("car"); }
TEST(Work, OfAUnicycleIsBounded) { expect_bounded("unicycle"); }
TEST(Work, OfADifferentialDriveIsBounded) { expect_bounded("diff_drive"); }

}  // namespace
}  // namespace krait::host
