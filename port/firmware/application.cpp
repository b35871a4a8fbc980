// SPDX-License-Identifier: Apache-2.0
#include "firmware/application.hpp"

#include <cstddef>
#include <cstring>

namespace krait::firmware {

Failure open_scene(const Board& board, Scene& scene) {
  std::uint32_t size = 0;  // a scene is aligned to 4 bytes only, its header's type to 8
  if (board.scene_room >= sizeof(format::Header)) {
    std::memcpy(&size, static_cast<const std::byte*>(board.scene) + offsetof(format::Header, total_bytes), sizeof size);
  }
  return Scene::open(board.scene, size > board.scene_room ? board.scene_room : size, scene);
}

std::uint64_t block_bytes(const Board& board, const Request& request) {
  constexpr std::uint64_t kKilobyte = 1024;
  constexpr int kShortRobot = 5;  // trailers
  if (request.memory > 0) return request.memory;
  const std::uint64_t wanted = (request.trailers <= kShortRobot ? 128 : 256) * kKilobyte;
  return wanted < board.arena_room ? wanted : board.arena_room;
}

int run(const Board& board, int count, const char* const* words) {
  Request request;
  const char* const complaint = parse(count, words, kModel, kHasTrailers, request);
  if (complaint != nullptr) return refuse(board, complaint);
  Report report;
  plan(board, request, report);
  return write(board, request, report);
}

}  // namespace krait::firmware
