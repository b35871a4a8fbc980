#include "firmware/application.hpp"

namespace krait::firmware {

Failure open_scene(const Board& board, Scene& scene) {
  std::size_t size = 0;
  if (board.scene_room >= sizeof(format::Header)) size = static_cast<const format::Header*>(board.scene)->total_bytes;
  if (size > board.scene_room) size = board.scene_room;
  return Scene::open(board.scene, size, scene);
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
