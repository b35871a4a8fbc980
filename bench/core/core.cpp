// SPDX-License-Identifier: Apache-2.0
// krait-bench-core: what the parts of a search cost, for a snake in a compiled scene over some seeds. Each figure is
// the time for all seeds together: the search as it is, then its parts done again from a recording of it.
#include <benchmark/benchmark.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "collision/motion_check.hpp"
#include "core/recording.hpp"
#include "decomposition/regions.hpp"
#include "host/run/query.hpp"
#include "host/run/robots.hpp"
#include "host/run/run.hpp"
#include "host/workspace/workspace.hpp"
#include "krait/robots/detail/defaults.hpp"
#include "motion/rk4.hpp"
#include "search/adaptive_search.hpp"
#include "search/groups.hpp"
#include "tests/core/in_own_memory.hpp"
#include "trials/trials.hpp"

namespace krait::bench {
namespace {

constexpr std::uint64_t kMemory = 64U << 20U;  // bytes of the planner's block

struct Options {
  std::string scene;
  std::string robot = "snake:15";
  std::uint64_t seeds = 60;
  std::uint64_t first_seed = 1;
};

// The searches of all seeds.
class Workload {
 public:
  explicit Workload(const Options& options)
      : bytes_(host::SceneBytes::read(options.scene)),
        scene_(host::open_scene(options.scene, bytes_)),
        spec_(host::parse_robot(options.robot)),
        robot_(snake(spec_)),
        limits_(Planner::limits_for(kMemory, scene_, robot_)),
        start_(start_of(scene_, robot_, spec_)),
        seeds_(options.seeds) {
    for (std::uint64_t seed = options.first_seed; seed < options.first_seed + seeds_; ++seed) {
      Planner planner;
      set_up(planner, recording_, seed);
      recordings_.push_back(record(recording_, planner, parameters_.dt));
      if (planner.status() != Status::solved) throw host::InputError("a search of the scene is not solved");
      plan_steps_ += planner.statistics().plan_steps;
      vertices_ += planner.statistics().vertices;
    }
  }

  const host::SceneBytes& bytes() const { return bytes_; }
  const Scene& scene() const { return scene_; }
  const Snake& robot() const { return robot_; }
  const Parameters& parameters() const { return parameters_; }
  std::uint64_t seeds() const { return seeds_; }

  void set_up(Planner& planner, const Robot& robot, std::uint64_t seed) {
    if (!planner.init({block_.data(), kMemory, &scene_, robot}, parameters_, limits_).ok()) {
      throw host::InputError("the planner refuses the robot or its memory");
    }
    (void)planner.start({start_.data(), Goal::named(0), seed});
  }

  // Calls visit(expansion) for every expansion of every search.
  template <class Visit>
  void for_each_expansion(Visit visit) const {
    for (const auto& recording : recordings_) {
      for (const Expansion& expansion : recording) visit(expansion);
    }
  }

  void count(benchmark::State& state) const {
    std::size_t expansions = 0;
    std::size_t attempts = 0;
    for_each_expansion([&](const Expansion& expansion) {
      ++expansions;
      attempts += expansion.attempts.size();
    });
    state.counters["seeds"] = static_cast<double>(seeds_);
    state.counters["vertices"] = static_cast<double>(vertices_);
    state.counters["attempts"] = static_cast<double>(attempts);
    state.counters["expansions"] = static_cast<double>(expansions);
    state.counters["plan_steps"] = static_cast<double>(plan_steps_);
  }

 private:
  static Snake snake(const host::RobotSpec& spec) {
    if (spec.model != "snake") throw host::InputError("the parts of a search are measured for a snake: snake:LINKS");
    return *host::CoreRobot(spec).as<Snake>();
  }

  static std::vector<float> start_of(const Scene& scene, const Snake& robot, const host::RobotSpec& spec) {
    host::SearchRequest request;
    request.robot = spec;
    return host::state_at(robot, scene, host::resolve_start(scene, request));
  }

  host::SceneBytes bytes_;
  Scene scene_;
  host::RobotSpec spec_;
  Snake robot_;
  Limits limits_;
  RecordingSnake recording_{robot_};
  Parameters parameters_;
  std::vector<float> start_;
  std::uint64_t seeds_;
  std::vector<std::uint64_t> block_ = std::vector<std::uint64_t>(kMemory / 8);
  std::vector<std::vector<Expansion>> recordings_;
  std::uint64_t vertices_ = 0;
  std::uint64_t plan_steps_ = 0;
};

// Scene::open.
void open(benchmark::State& state, const Workload& work) {
  for (auto _ : state) {
    for (std::uint64_t seed = 1; seed <= work.seeds(); ++seed) {
      Scene scene;
      benchmark::DoNotOptimize(Scene::open(work.bytes().data(), work.bytes().size(), scene));
    }
  }
}

// init and start: tables, checks, the first Dijkstra.
void set_up(benchmark::State& state, Workload& work) {
  for (auto _ : state) {
    for (std::uint64_t seed = 1; seed <= work.seeds(); ++seed) {
      Planner planner;
      work.set_up(planner, work.robot(), seed);
      benchmark::DoNotOptimize(planner.status());
    }
  }
}

// init, start and advance to the plan.
void plan(benchmark::State& state, Workload& work) {
  for (auto _ : state) {
    for (std::uint64_t seed = 1; seed <= work.seeds(); ++seed) {
      Planner planner;
      work.set_up(planner, work.robot(), seed);
      benchmark::DoNotOptimize(planner.advance(UINT64_MAX));
    }
  }
  work.count(state);
}

test::InOwnMemory<detail::MotionCheck> check_of(const Workload& work) {
  test::InOwnMemory<detail::MotionCheck> check;
  const Parameters& p = work.parameters();
  check.assign(work.robot(), work.scene(), p.clearance, static_cast<int>(p.tuning.max_substeps), true);
  return check;
}

// The floor of the method: a Runge-Kutta step and the proof that it is free, for every vertex.
void steps_of_vertices(benchmark::State& state, const Workload& work) {
  test::InOwnMemory<detail::MotionCheck> check = check_of(work);
  const float dt = work.parameters().dt;
  float next[Snake::kMaxState];
  for (auto _ : state) {
    work.for_each_expansion([&](const Expansion& expansion) {
      if (expansion.taken > 0) check.begin(expansion.attempts.front().state.data());
      for (std::size_t i = 0; i < expansion.taken; ++i) {
        const Attempt& attempt = expansion.attempts[i];
        detail::propagate(work.robot(), attempt.state.data(), check.poses(), attempt.control.data(), dt, next);
        benchmark::DoNotOptimize(check.step_free(attempt.state.data(), attempt.control.data(), dt, next));
      }
    });
  }
}

// The frames at the beginning of every step that was tried, one step's after the other's.
std::vector<Pose> frames_of_attempts(const Workload& work) {
  std::vector<Pose> frames;
  const int bodies = work.robot().body_count();
  work.for_each_expansion([&](const Expansion& expansion) {
    for (const Attempt& attempt : expansion.attempts) {
      frames.resize(frames.size() + static_cast<std::size_t>(bodies));
      work.robot().place(StateView(attempt.state.data(), work.robot().state_size()), &frames.back() + 1 - bodies);
    }
  });
  return frames;
}

// The controller, for every step that was tried.
void steer_steps(benchmark::State& state, const Workload& work) {
  const std::vector<Pose> frames = frames_of_attempts(work);
  float control[Snake::kMaxControl];
  const Snake& robot = work.robot();
  for (auto _ : state) {
    const Pose* at = frames.data();
    work.for_each_expansion([&](const Expansion& expansion) {
      Steering steering;
      for (const Attempt& attempt : expansion.attempts) {
        detail::steer(robot, StateView(attempt.state.data(), robot.state_size()), at, expansion.target, steering,
                      ControlRef(control, robot.control_size()));
        benchmark::DoNotOptimize(control);
        at += robot.body_count();
      }
    });
  }
}

// Runge-Kutta, for every step that was tried.
void propagate_steps(benchmark::State& state, const Workload& work) {
  const std::vector<Pose> frames = frames_of_attempts(work);
  float next[Snake::kMaxState];
  for (auto _ : state) {
    const Pose* at = frames.data();
    work.for_each_expansion([&](const Expansion& expansion) {
      for (const Attempt& attempt : expansion.attempts) {
        detail::propagate(work.robot(), attempt.state.data(), at, attempt.control.data(), work.parameters().dt, next);
        benchmark::DoNotOptimize(next);
        at += work.robot().body_count();
      }
    });
  }
}

// The collision check, for every step that was tried.
void check_steps(benchmark::State& state, const Workload& work) {
  test::InOwnMemory<detail::MotionCheck> check = check_of(work);
  const float dt = work.parameters().dt;
  for (auto _ : state) {
    work.for_each_expansion([&](const Expansion& expansion) {
      if (!expansion.attempts.empty()) check.begin(expansion.attempts.front().state.data());
      for (const Attempt& attempt : expansion.attempts) {
        benchmark::DoNotOptimize(
            check.step_free(attempt.state.data(), attempt.control.data(), dt, attempt.next.data()));
      }
    });
  }
}

// A full Dijkstra, once a seed.
void shortest_paths(benchmark::State& state, Workload& work) {
  Planner planner;
  work.set_up(planner, work.robot(), 1);
  detail::Regions regions = detail::opened(planner).regions();
  for (auto _ : state) {
    for (std::uint64_t seed = 1; seed <= work.seeds(); ++seed) regions.update();
  }
}

// The choice of a group in the tree of a whole search, once a seed.
void select_group(benchmark::State& state, Workload& work) {
  Planner planner;
  work.set_up(planner, work.robot(), 1);
  (void)planner.advance(UINT64_MAX);
  detail::Groups groups = detail::opened(planner).groups();
  for (auto _ : state) {
    for (std::uint64_t seed = 1; seed <= work.seeds(); ++seed)
      benchmark::DoNotOptimize(groups.select(detail::opened(planner).regions()));
  }
}

void register_all(Workload& work) {
  const auto add = [&work](const char* name, auto measure) {
    benchmark::RegisterBenchmark(name, [&work, measure](benchmark::State& state) { measure(state, work); });
  };
  add("open", open);
  add("set_up", set_up);
  add("plan", plan);
  add("floor", steps_of_vertices);
  add("steer", steer_steps);
  add("propagate", propagate_steps);
  add("check", check_steps);
  add("shortest_paths", shortest_paths);
  add("select_group", select_group);
}

void measure(const Options& options) {
  Workload work(options);
  register_all(work);
  benchmark::RunSpecifiedBenchmarks();
}

// Accepts Google Benchmark's options, and no others. It copies them, but keeps the program's name where it is.
void configure(char* program, std::vector<std::string> options) {
  std::vector<char*> arguments{program};
  for (std::string& option : options) arguments.push_back(option.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (count > 1) throw host::InputError(std::string("unknown option ") + arguments[1]);
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("What the parts of a search cost. Options --benchmark_… are Google Benchmark's.", "krait-bench-core");
  app.allow_extras();
  app.add_option("--scene", options.scene, "a .krait file")->required();
  app.add_option("--robot", options.robot, "snake:LINKS")->capture_default_str();
  app.add_option("--seeds", options.seeds)->check(CLI::Range(1, 10000))->capture_default_str();
  app.add_option("--first-seed", options.first_seed)->check(CLI::Range(1, 1000000))->capture_default_str();
  app.callback([&] {
    configure(argv[0], app.remaining());
    measure(options);
  });
  return run_program(app, argc, argv);
}

}  // namespace
}  // namespace krait::bench

int main(int argc, char** argv) { return krait::bench::run(argc, argv); }
