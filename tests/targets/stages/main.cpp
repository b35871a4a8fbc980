// SPDX-License-Identifier: Apache-2.0
// Prints the hash of every stage: the kernels first, then for each scene where the board has scenes.
#include "firmware/application.hpp"
#include "firmware/scene_pack.hpp"
#include "stages.hpp"

namespace krait::stages {

void report(const firmware::Board& board, std::initializer_list<const char*> name, const Hash& hash) {
  const auto say = [&](const char* text) { board.port.log(board.port.context, text); };
  char line[] = " 0000000000000000\n";
  for (unsigned i = 0; i < 16; ++i) line[1 + i] = "0123456789abcdef"[(hash.value() >> (60U - 4U * i)) & 15U];
  const char* before = "";
  for (const char* part : name) {
    say(before);
    say(part);
    before = "/";
  }
  say(line);
}

namespace {

// Which scenes these are: a difference here is the compiler's, not the machine's.
void scene_bytes(const firmware::Board& board, const Scene& scene) {
  Hash hash;
  hash.add(scene.header().crc32);
  report(board, {scene.name(), "scene"}, hash);
}

}  // namespace
}  // namespace krait::stages

namespace krait::firmware {

int run(const Board& board, int, const char* const*) {
  stages::arithmetic(board);
  stages::motion(board);
  stages::distances(board);
  for_each_scene(board, [&](const Scene& scene) {
    stages::scene_bytes(board, scene);
    stages::decomposition(board, scene);
    stages::searches(board, scene);
    stages::departures(board, scene);
    stages::improvements(board, scene);
  });
  return kDone;
}

}  // namespace krait::firmware
