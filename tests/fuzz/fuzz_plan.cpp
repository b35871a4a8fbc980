// SPDX-License-Identifier: Apache-2.0
// Any scene that opens can be planned in, and the verifier, which reads the file with code of its own, agrees with
// every plan. The check sum's four bytes, which are repaired, choose robot, planner, seed, and how the search is cut
// short: by little memory, which is recycled, and by restarts after every few expansions.
#include <cstring>
#include <string>

#include "host/import/format.hpp"
#include "host/run/run.hpp"
#include "host/verify/verify.hpp"
#include "scene_input.hpp"

namespace krait::fuzz {
namespace {

using namespace krait::host;

struct Choice {
  std::uint8_t robot, planner, seed, ways;

  bool paper() const { return (ways & 1U) != 0; }
  std::uint64_t memory() const { return std::uint64_t{32 * 1024} << (ways >> 1U & 7U); }  // bytes, up to 4 MB
  std::uint32_t restart_unit() const { return 4000U >> 4U * (ways >> 4U & 3U); }          // 4000, 250, 15 or none
};

SearchRequest request_of(const Choice& choice) {
  static const char* const kRobots[] = {"unicycle", "car", "diff_drive", "snake:2", "truck:1", "snake:6"};
  static const char* const kPlanners[] = {"adaptive", "adaptive", "prior", "rrt"};
  SearchRequest request;
  request.robot = parse_robot(kRobots[choice.robot % std::size(kRobots)]);
  request.planner = kPlanners[choice.planner % std::size(kPlanners)];
  request.seed = choice.seed;
  if (choice.paper()) request.parameters = Parameters::paper();
  if (!choice.paper()) request.parameters.tuning.restart_unit = choice.restart_unit();
  request.memory = choice.memory();
  request.iterations = 2000;
  return request;
}

Workspace workspace_of(SceneInput& input) {
  const Source source{"scene", std::string(reinterpret_cast<const char*>(input.data()), input.size())};
  return kSceneFile.read(source, {});
}

void plan(SceneInput& input, const Choice& choice) {
  const SearchResult result = run_search("scene", SceneBytes::copy(input.data(), input.size()), request_of(choice), {});
  require(result.plan.status != "internal", "a plan was not replayed");
  if (result.plan.status != "solved" || choice.paper()) return;  // the paper's plans are free at their states only
  const Verdict verdict = verify(workspace_of(input), result.plan, result.asked);
  for (const std::string& complaint : verdict.complaints) std::fprintf(stderr, "fuzz: %s\n", complaint.c_str());
  require(verdict.holds, "a plan does not hold");
}

}  // namespace
}  // namespace krait::fuzz

namespace {

constexpr std::size_t kSum = offsetof(krait::format::Header, crc32);

}  // namespace

// Most changed scenes do not open: three in four times only what is chosen changes.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  const unsigned rest = seed / 4;
  if (seed % 4 == 0 || size < sizeof(krait::format::Header)) return krait::fuzz::change_scene(data, size, most, rest);
  std::memcpy(data + kSum, &rest, sizeof rest);
  return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace krait::fuzz;
  Choice choice{};
  if (size < sizeof(krait::format::Header)) return 0;
  std::memcpy(&choice, data + kSum, sizeof choice);
  SceneInput input(data, size);
  try {
    plan(input, choice);
  } catch (const krait::host::InputError&) {
  }
  return 0;
}
