// SPDX-License-Identifier: Apache-2.0
// Whether searches of many seeds are solved in blocks of different sizes. Counts only: the same on every machine.
// Prints a paragraph, and a table of the blocks in which some were not.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>
#include <vector>

#include "host/run/run.hpp"
#include "krait/krait.hpp"

namespace krait::host {
namespace {

constexpr std::uint64_t kIterations = 20'000;
constexpr std::uint64_t kKilobytes[] = {32, 48, 64, 96, 128, 192, 256, 384, 512};

// Of `seeds` searches in a block of that size, how many were solved.
int solved(const krait::Scene& scene, const Snake& robot, std::uint64_t bytes, int seeds) {
  std::vector<std::uint64_t> block(bytes / 8);
  std::vector<float> start(static_cast<std::size_t>(robot.state_size()));
  const ScenePose pose = scene.start(0);
  robot.rest(pose.position, pose.heading, nullptr, start.data());
  static Planner planner;
  if (!planner.init({block.data(), bytes, &scene, robot}, {}, {.iterations = kIterations}).ok()) return 0;
  int count = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    (void)planner.start({start.data(), krait::Goal::named(0), static_cast<std::uint64_t>(seed)});
    count += planner.advance(kIterations) == Status::solved ? 1 : 0;
  }
  return count;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " and ") + words[i];
  return text;
}

// A row of a table of Markdown.
std::string row(const std::string& first, const std::vector<std::string>& cells) {
  std::string text = "| " + first + " |";
  for (const std::string& cell : cells) text += " " + cell + " |";
  return text + "\n";
}

}  // namespace
}  // namespace krait::host

int main(int argc, char** argv) {
  using namespace krait::host;
  CLI::App app("Success by the size of the block");
  std::vector<std::string> files;
  int seeds = 100;
  app.add_option("SCENE", files, "compiled scenes")->required();
  app.add_option("--seeds", seeds, "seeds 1 to N")->capture_default_str()->check(CLI::Range(1, 100'000));
  CLI11_PARSE(app, argc, argv);
  std::vector<SceneBytes> bytes;
  std::vector<krait::Scene> scenes;
  std::vector<std::string> names;
  for (const std::string& file : files) {
    bytes.push_back(SceneBytes::read(file));
    scenes.push_back(open_scene(file, bytes.back()));
    names.emplace_back(scenes.back().name());
  }
  std::vector<std::string> sizes;
  for (const std::uint64_t kilobytes : kKilobytes) sizes.push_back(std::to_string(kilobytes));
  std::string exceptions;
  for (const int links : {5, 15}) {
    krait::ChainParameters parameters;
    parameters.trailers = links;
    const krait::Snake robot(parameters);
    for (const std::uint64_t kilobytes : kKilobytes) {
      std::vector<std::string> counts;
      bool all = true;
      for (const krait::Scene& scene : scenes) {
        const int count = solved(scene, robot, kilobytes * 1024, seeds);
        counts.push_back(std::to_string(count));
        all = all && count == seeds;
      }
      const std::string name = "snake:" + std::to_string(links) + ", " + std::to_string(kilobytes) + " KB";
      if (!all) exceptions += row(name, counts);
    }
  }
  std::printf("In %s, with `snake:5` and with `snake:15`,\n", joined(names).c_str());
  std::printf("in blocks of %s KB, all of %d seeds are solved within %llu thousand expansions%s\n",
              joined(sizes).c_str(), seeds, static_cast<unsigned long long>(kIterations / 1000),
              exceptions.empty() ? "." : ", but for these:\n");
  if (exceptions.empty()) return 0;
  const std::vector<std::string> rule(names.size(), "---");
  std::printf("%s%s%s", row("solved", names).c_str(), row("---", rule).c_str(), exceptions.c_str());
  return 0;
}
