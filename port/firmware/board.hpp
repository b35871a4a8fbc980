// SPDX-License-Identifier: Apache-2.0
// What a port hands to the firmware application besides its callbacks.
#pragma once

#include <cstddef>
#include <cstdint>

#include "port.hpp"

namespace krait::firmware {

struct Board {
  const char* name;
  Port port;

  // Where the scene lies, aligned to 4 bytes, and how many bytes there may hold it. Read only.
  const void* scene;
  std::size_t scene_room;

  // Memory for the planner's block, aligned to Setup::kAlignment.
  void* arena;
  std::size_t arena_room;

  // Bytes of the program in flash, and of RAM outside the arena with the whole stack in it; 0 where the machine has
  // no such number.
  std::size_t flash_bytes;
  std::size_t ram_bytes;

  // The most bytes of stack in use since the start; null where the machine cannot tell.
  std::size_t (*stack_bytes)();
};

}  // namespace krait::firmware
