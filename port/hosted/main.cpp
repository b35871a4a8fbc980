// SPDX-License-Identifier: Apache-2.0
// The application where there are files: main --scene FILE.krait [options of the application].
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "firmware/application.hpp"

namespace {

using krait::firmware::Board;
using krait::firmware::kBadInput;
using krait::firmware::kOwnBug;

constexpr std::size_t kSceneRoom = std::size_t{16} << 20U;
constexpr std::size_t kArenaRoom = std::size_t{64} << 20U;

alignas(8) std::byte scene_memory[kSceneRoom];
alignas(krait::Setup::kAlignment) std::byte arena_memory[kArenaRoom];

std::uint64_t clock_nanoseconds(void*) {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(now).count());
}

void log_text(void*, const char* text) { std::fputs(text, stdout); }

void fault(void*, const char* what) {
  std::fprintf(stderr, "krait: fault: %s\n", what);
  std::exit(kOwnBug);
}

// Returns the number of bytes; 0 when the file cannot be read.
std::size_t read_scene(const char* path) {
  std::FILE* file = std::fopen(path, "rb");
  if (file == nullptr) return 0;
  const std::size_t bytes = std::fread(scene_memory, 1, kSceneRoom, file);
  std::fclose(file);
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3 || std::strcmp(argv[1], "--scene") != 0) {
    std::fprintf(stderr, "krait: give --scene FILE.krait first\n");
    return kBadInput;
  }
  const std::size_t bytes = read_scene(argv[2]);
  if (bytes == 0) {
    std::fprintf(stderr, "krait: %s: cannot be read\n", argv[2]);
    return kBadInput;
  }
  Board board{};
  board.name = KRAIT_BOARD;
  board.port = {nullptr, clock_nanoseconds, log_text, fault};
  board.scene = scene_memory;
  board.scene_room = bytes;
  board.arena = arena_memory;
  board.arena_room = kArenaRoom;
  return krait::firmware::run(board, argc - 3, argv + 3);
}
