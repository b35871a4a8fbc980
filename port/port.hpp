// SPDX-License-Identifier: Apache-2.0
// The contract between a program that plans and the machine it runs on. The core never calls a port: the program hands
// the core numbers (a seed, a budget) and asks the port for the rest.
#pragma once

#include <cstdint>

namespace krait {

// Callbacks of a port; each is given `context`. None may be null.
struct Port {
  void* context;

  // Nanoseconds since some moment; never goes back. Called from where `advance` is called, never by an interrupt.
  std::uint64_t (*clock)(void* context);

  // Writes text, as it is, to whoever listens. May block.
  void (*log)(void* context, const char* text);

  // Ends the program for a reason that is its own bug. Does not return.
  void (*fault)(void* context, const char* what);
};

}  // namespace krait
