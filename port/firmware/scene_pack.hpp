// SPDX-License-Identifier: Apache-2.0
// Several scenes, one right behind the other where a board has its scene: how tests and benches load all that they
// need in one run.
#pragma once

#include <cstddef>
#include <cstring>

#include "firmware/board.hpp"
#include "krait/scene.hpp"

namespace krait::firmware {

// Calls visit(scene) for every scene, up to the first bytes that are none.
template <class Visit>
void for_each_scene(const Board& board, Visit visit) {
  const auto* bytes = static_cast<const std::byte*>(board.scene);
  std::size_t room = board.scene_room;
  static Scene scene;  // large for a small stack
  while (room >= sizeof(format::Header)) {
    std::uint32_t size = 0;  // a scene is aligned to 4 bytes only, its header's type to 8
    std::memcpy(&size, bytes + offsetof(format::Header, total_bytes), sizeof size);
    if (size > room || !Scene::open(bytes, size, scene).ok()) return;
    visit(scene);
    bytes += size;
    room -= size;
  }
}

}  // namespace krait::firmware
