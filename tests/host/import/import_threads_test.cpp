// SPDX-License-Identifier: Apache-2.0
// Imports in threads of one program do not touch each other. Run under ThreadSanitizer too (preset thread).
#include <gmock/gmock.h>

#include <thread>

#include "../scratch.hpp"
#include "host/import/import.hpp"
#include "png_writer.hpp"

namespace krait::host::import_threads_test {
namespace {

class ImportThreads : public ScratchTest {
 protected:
  // One map a format, and one that no format takes.
  std::vector<std::string> maps() const {
    write("m.png", encode({PNG_COLOR_TYPE_GRAY, 8}, 3, {"abc", "def"}));
    write("m.pgm", "P2 3 1 100\n0 50 100\n");
    const std::string rules =
        "resolution: 0.5\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n";
    return {write("n.json", R"({"bounds": {"min": [0, 0], "max": [9, 9]},
                               "obstacles": [{"circle": {"center": [4, 4], "radius": 1}}]})"),
            write("png.yaml", "image: m.png\n" + rules),
            write("pgm.yaml", "image: m.pgm\n" + rules),
            write("a.map", "type octile\nheight 1\nwidth 3\nmap\n.@.\n"),
            write("d.yaml",
                  "environment:\n  min: [0, 0]\n  max: [6, 5]\n  obstacles:\n"
                  "    - {type: box, center: [2, 3], size: [1, 0.5]}\n"),
            write("broken.json", "{")};
  }

  // What an import has read, in a line.
  static std::string import_of(const std::string& path) {
    try {
      const Workspace w = import_workspace(path, {});
      std::string text = w.name;
      for (const double bound : {w.min.x, w.min.y, w.max.x, w.max.y}) text.append(" ").append(std::to_string(bound));
      for (const Obstacle& obstacle : w.obstacles) text.append(" ").append(std::to_string(obstacle.outer.size()));
      if (w.cells) text.append(w.cells->occupied.begin(), w.cells->occupied.end());
      return text;
    } catch (const InputError& error) {
      return error.what();
    }
  }
};

TEST_F(ImportThreads, ReadAsTheyDoAlone) {
  constexpr int kThreads = 4, kRounds = 20;
  const std::vector<std::string> paths = maps();
  std::vector<std::string> alone;
  for (const std::string& path : paths) alone.push_back(import_of(path));
  EXPECT_THAT(alone.back(), testing::HasSubstr("broken.json"));
  std::vector<int> same(kThreads, 0);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < same.size(); ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t i = 0; i < kRounds * paths.size(); ++i) {
        const std::size_t which = (i + t) % paths.size();
        same[t] += import_of(paths[which]) == alone[which] ? 1 : 0;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(same, testing::Each(kRounds * static_cast<int>(paths.size())));
}

}  // namespace
}  // namespace krait::host::import_threads_test
