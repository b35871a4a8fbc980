// SPDX-License-Identifier: Apache-2.0
#include "bare_metal/memory.hpp"

extern "C" {
extern std::uint32_t krait_data_image[], krait_data_start[], krait_data_end[];
extern std::uint32_t krait_bss_start[];
using Constructor = void (*)();
extern const Constructor krait_init_array_start[], krait_init_array_end[];
}

namespace krait::bare_metal {
namespace {

constexpr std::uint32_t kPaint = 0xC0DEC0DE;
constexpr std::size_t kOwnFrame = 64;  // bytes below a frame's address that the painter itself may use

std::size_t distance(const void* from, const void* to) {
  return reinterpret_cast<std::uintptr_t>(to) - reinterpret_cast<std::uintptr_t>(from);
}

}  // namespace

void prepare_memory() {
  const std::uint32_t* image = krait_data_image;
  for (std::uint32_t* word = krait_data_start; word != krait_data_end; ++word) *word = *image++;
  auto* const bss_end = reinterpret_cast<std::uint32_t*>(krait_bss_end);
  for (std::uint32_t* word = krait_bss_start; word != bss_end; ++word) *word = 0;
  for (const Constructor* each = krait_init_array_start; each != krait_init_array_end; ++each) (*each)();
}

void paint_stack() {
  const auto frame = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0)) - kOwnFrame;
  auto* const end = reinterpret_cast<std::uint32_t*>(frame);
  for (volatile std::uint32_t* word = krait_stack_limit; word < end; ++word) *word = kPaint;
}

std::size_t stack_bytes() {
  const volatile std::uint32_t* word = krait_stack_limit;
  while (word != krait_stack_top && *word == kPaint) ++word;
  return distance(const_cast<const std::uint32_t*>(word), krait_stack_top);
}

std::uint64_t nanoseconds(std::uint64_t ticks) {
  const std::uint64_t tick = reinterpret_cast<std::uintptr_t>(krait_tick_q16);
  return (ticks >> 16U) * tick + (((ticks & 0xFFFFU) * tick) >> 16U);
}

void describe_memory(firmware::Board& board) {
  board.scene = krait_scene_start;
  board.scene_room = distance(krait_scene_start, krait_scene_end);
  board.arena = krait_arena_start;
  board.arena_room = distance(krait_arena_start, krait_arena_end);
  board.flash_bytes = distance(krait_flash_start, krait_flash_end);
  board.ram_bytes = distance(krait_stack_limit, krait_arena_start);
  board.stack_bytes = stack_bytes;
}

}  // namespace krait::bare_metal
