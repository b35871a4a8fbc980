// SPDX-License-Identifier: Apache-2.0
// How long Scene::open takes for each file, and per byte: linear in the size.
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "host/run/run.hpp"

namespace {

using Clock = std::chrono::steady_clock;

// The least of several runs, seconds.
double time_of_open(const krait::host::SceneBytes& bytes) {
  double least = 1e9;
  for (int i = 0; i < 9; ++i) {
    krait::Scene scene;
    const Clock::time_point begin = Clock::now();
    if (!krait::Scene::open(bytes.data(), bytes.size(), scene).ok()) return 0;
    least = std::min(least, std::chrono::duration<double>(Clock::now() - begin).count());
  }
  return least;
}

}  // namespace

int main(int argc, char** argv) {
  std::printf("| scene | bytes | open, ms | ns a byte |\n|---|---|---|---|\n");
  for (int i = 1; i < argc; ++i) {
    const auto bytes = krait::host::SceneBytes::read(argv[i]);
    const double seconds = time_of_open(bytes);
    const auto size = static_cast<double>(bytes.size());
    std::printf("| %s | %zu | %.3f | %.1f |\n", argv[i], bytes.size(), 1e3 * seconds, 1e9 * seconds / size);
  }
  return 0;
}
