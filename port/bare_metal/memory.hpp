// SPDX-License-Identifier: Apache-2.0
// The memory of a bare-metal program, as the linker script lays it out.
#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware/board.hpp"

extern "C" {
// Addresses, defined in linker.ld.in; they have no contents of these types.
extern std::uint32_t krait_stack_limit[], krait_stack_top[];
extern std::byte krait_flash_start[], krait_flash_end[];
extern std::byte krait_scene_start[], krait_scene_end[];
extern std::byte krait_bss_end[];
extern std::byte krait_arena_start[], krait_arena_end[];
// A number: its address is the value.
extern std::byte krait_tick_q16[];
}

namespace krait::bare_metal {

// Makes memory what the language promises: .data copied from flash, .bss zero, static constructors run.
// To be called first, with the stack in place.
void prepare_memory();

// Fills the stack that is not in use with a pattern.
void paint_stack();

// The most bytes of stack in use since paint_stack.
std::size_t stack_bytes();

// The duration of `ticks` of the board's counter, nanoseconds; exact to 2^-16 ns a tick, without overflow for 80 years.
std::uint64_t nanoseconds(std::uint64_t ticks);

// Fills in everything but name and callbacks.
void describe_memory(firmware::Board& board);

}  // namespace krait::bare_metal
