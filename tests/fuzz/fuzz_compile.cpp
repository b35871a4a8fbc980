// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing of up to a dozen obstacles made of the bytes, compiled: one line, or a scene that the core opens (compile
// itself checks that and throws std::logic_error, a finding).
#include <cstring>
#include <vector>

#include "harness.hpp"
#include "host/compiler/compiler.hpp"

namespace {

using namespace krait::host;

krait::fuzz::Outcomes drawings("a drawing");

// Numbers from bytes: coordinates near a coarse grid, so that they meet, or anywhere.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool done() const { return at_ >= size_; }
  unsigned byte() { return done() ? 0 : data_[at_++]; }
  double coordinate() {
    const unsigned kind = byte();
    if (kind < 160) return 0.5 * (kind % 32) - 2;
    if (kind < 250) return 16.0 * (256 * byte() + byte()) / 65536 - 2;
    return kind == 250 ? 5e9 : 1e-5 * byte();
  }
  Point point() {
    const double x = coordinate();
    return {x, coordinate()};
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

Ring ring(Bytes& bytes) {
  Ring ring;
  for (unsigned corners = 3 + bytes.byte() % 6; corners > 0; --corners) ring.push_back(bytes.point());
  return ring;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  Workspace w;
  w.max = {12, 12};
  CompileOptions options;
  options.tolerance = bytes.byte() % 4 * 0.1;
  while (!bytes.done() && w.obstacles.size() < 12) {
    Obstacle obstacle{"o", ring(bytes), {}};
    if (bytes.byte() % 4 == 0) obstacle.holes.push_back(ring(bytes));
    w.obstacles.push_back(obstacle);
  }
  w.goals.push_back({"goal", {{9, 9}, {11, 9}, {11, 11}, {9, 11}}});
  try {
    krait::fuzz::require(!compile(w, options).bytes.empty(), "a scene without bytes");
    drawings.accepted.reach();
  } catch (const InputError&) {
    drawings.refused.reach();
  }
  return 0;
}
