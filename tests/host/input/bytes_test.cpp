// SPDX-License-Identifier: Apache-2.0
#include "host/input/bytes.hpp"

#include <gmock/gmock.h>

#include "../scratch.hpp"

namespace krait::host {
namespace {

TEST(Bytes, HaveUnitsOfPowersOfTwo) {
  EXPECT_EQ(parse_bytes("--memory", "0"), 0U);
  EXPECT_EQ(parse_bytes("--memory", "131072"), 131072U);
  EXPECT_EQ(parse_bytes("--memory", "128K"), 131072U);
  EXPECT_EQ(parse_bytes("--memory", "3M"), 3U << 20U);
  EXPECT_EQ(parse_bytes("--memory", "64G"), std::uint64_t{64} << 30U);
}

// 2^34 G, 2^44 M and 2^54 K are 2^64 bytes: none, where they wrap around.
TEST(Bytes, ThatAreTooManyOrNoneAreRefused) {
  for (const char* text : {"", "K", "-1", "1.5M", "1k", "1KB", "128 K", "68719476737", "65G", "67108865K",
                           "17179869184G", "17592186044416M", "18014398509481984K", "99999999999999999999"}) {
    EXPECT_THAT(error_of([&] { parse_bytes("--memory", text); }),
                testing::HasSubstr(std::string("--memory ") + text + ": give bytes"));
  }
}

}  // namespace
}  // namespace krait::host
