// SPDX-License-Identifier: Apache-2.0
#include "base/arena.hpp"

namespace krait::detail {
namespace {
constexpr const char* kPoolNames[kPoolCount] = {"regions",    "portals", "groups",      "vertices", "states",
                                                "expansions", "members", "improvement", "work"};
}

const char* to_string(Pool pool) { return kPoolNames[static_cast<std::size_t>(pool)]; }

void* Arena::allocate_rows(Pool pool, std::uint32_t count, std::size_t bytes) {
  const std::uint64_t padded = (std::uint64_t{count} * bytes + kAlignment - 1) / kAlignment * kAlignment;
  const std::uint64_t offset = needed_;
  needed_ += padded;
  by_pool_[static_cast<std::size_t>(pool)] += padded;
  return block_ != nullptr && needed_ <= bytes_ ? block_ + offset : nullptr;
}

}  // namespace krait::detail
