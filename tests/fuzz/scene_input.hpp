// SPDX-License-Identifier: Apache-2.0
// A scene as a fuzzer hands it over, made whole: aligned, its length and check sum right; and how it is changed.
#pragma once

#include <vector>

#include "harness.hpp"
#include "scene_mutator.hpp"

extern "C" {
// libFuzzer's own mutation, where it is linked.
__attribute__((weak)) std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
}

namespace krait::fuzz {

// What a harness's LLVMFuzzerCustomMutator does with a scene.
inline std::size_t change_scene(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  if (seed % 4 == 0 && LLVMFuzzerMutate != nullptr) {
    size = LLVMFuzzerMutate(data, size, most);
    repair(data, size);
    return size;
  }
  SceneMutator(data, size, seed).run();
  return size;
}

class SceneInput {
 public:
  SceneInput(const std::uint8_t* bytes, std::size_t size) : words_((size + 7) / 8), size_(size) {
    if (size == 0) return;
    std::memcpy(words_.data(), bytes, size);
    repair(data(), size);
  }

  std::uint8_t* data() { return reinterpret_cast<std::uint8_t*>(words_.data()); }
  std::size_t size() const { return size_; }

 private:
  std::vector<std::uint64_t> words_;
  std::size_t size_;
};

}  // namespace krait::fuzz
