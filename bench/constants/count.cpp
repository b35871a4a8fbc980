// SPDX-License-Identifier: Apache-2.0
// What searches cost and how long their plans are, in counts that any machine repeats: count KIND ROBOT,… FIRST
// LAST SCENE… with compiled scenes. Prints a line for each scene and robot: their names, then a number for each seed.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "krait/krait.hpp"
#include "krait/robots/detail/defaults.hpp"

namespace krait::bench {
namespace {

constexpr std::uint64_t kIterations = 20'000;  // of a search; one that uses them up costs what it has cost
constexpr std::uint64_t kBlock = 8U << 20U;    // bytes; enough that nothing is given up
constexpr std::uint32_t kWayLegs = 400;        // of a plan that is improved,
constexpr std::uint64_t kImprove = 3;          // times the first plan's collision checks
constexpr std::uint64_t kSlice = 16;           // iterations between looks at them
constexpr float kPi = 3.14159265F;

// What is counted: the vertices of a search to the scene's goal, of one to a pose in its middle, also with the hitches
// within 0.2 rad; or the steps of the plan, improved, to the goal or to a pose.
enum class Kind { search, pose, straight, improve, improve_pose };

bool improves(Kind kind) { return kind == Kind::improve || kind == Kind::improve_pose; }

Goal goal_of(const Scene& scene, Kind kind, std::uint64_t seed) {
  const Goal named = Goal::named(0);
  if (kind == Kind::search || kind == Kind::improve) return named;
  const Box box = named.box(scene);
  Facing facing;
  facing.heading = 0.5F * kPi * static_cast<float>(seed % 4);
  if (kind == Kind::straight) facing.hitches = 0.2F;
  return Goal::pose(0.5F * (box.min + box.max), 0.1F, facing);
}

std::uint64_t improved_steps(Planner& planner) {
  const std::uint64_t most = (1 + kImprove) * planner.statistics().collision_checks;
  while (planner.statistics().collision_checks < most && planner.improve(kSlice) == Status::solved) {
  }
  return planner.statistics().plan_steps;
}

template <class R>
void count(const char* name, const R& robot, const Scene& scene, Kind kind, std::uint64_t first, std::uint64_t last) {
  static std::vector<std::uint64_t> block(kBlock / 8);
  static Planner planner;
  Limits limits{.iterations = kIterations};
  if (improves(kind)) limits.way_legs = kWayLegs;
  if (!planner.init({block.data(), kBlock, &scene, robot}, {}, limits).ok()) std::exit(2);
  float start[R::kMaxState];
  const ScenePose pose = scene.start(0);
  (void)detail::rest(robot, pose.position, pose.heading, nullptr, 0, start);
  std::printf("%s %s", scene.name(), name);
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    (void)planner.start({start, goal_of(scene, kind, seed), seed});
    const bool solved = planner.advance(kIterations + 1'000'000) == Status::solved;
    const bool counts_steps = improves(kind) && solved;
    std::printf(" %llu", (unsigned long long)(counts_steps ? improved_steps(planner) : planner.statistics().vertices));
  }
  std::printf("\n");
}

ChainParameters with_trailers(int trailers) {
  ChainParameters parameters;
  parameters.trailers = trailers;
  return parameters;
}

void count_all(const Scene& scene, const std::string& robots, Kind kind, std::uint64_t first, std::uint64_t last) {
  const auto count_one = [&](const char* name, const auto& robot) {
    if (("," + robots + ",").find(std::string(",") + name + ",") == std::string::npos) return;
    count(name, robot, scene, kind, first, last);
  };
  ChainParameters reversing = Car::defaults();
  reversing.min_speed = -1.0F;
  count_one("car", Car(Car::defaults()));
  count_one("reversing-car", Car(reversing));
  count_one("truck:1", Truck(with_trailers(1)));
  count_one("truck:2", Truck(with_trailers(2)));
  count_one("snake:5", Snake(with_trailers(5)));
  count_one("snake:15", Snake(with_trailers(15)));
  count_one("unicycle", Unicycle({}));
  count_one("diff_drive", DifferentialDrive({}));
}

}  // namespace
}  // namespace krait::bench

int main(int argc, char** argv) {
  using namespace krait::bench;
  if (argc < 6) return 2;
  const std::string name = argv[1];
  const Kind kind = name == "search"     ? Kind::search
                    : name == "pose"     ? Kind::pose
                    : name == "straight" ? Kind::straight
                    : name == "improve"  ? Kind::improve
                                         : Kind::improve_pose;
  for (int i = 5; i < argc; ++i) {
    std::ifstream file(argv[i], std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    std::vector<std::uint64_t> words((bytes.size() + 7) / 8);
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(words.data()));
    krait::Scene scene;
    if (!krait::Scene::open(words.data(), bytes.size(), scene).ok()) return 2;
    count_all(scene, argv[2], kind, std::strtoull(argv[3], nullptr, 10), std::strtoull(argv[4], nullptr, 10));
  }
  return 0;
}
