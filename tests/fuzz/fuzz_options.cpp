// SPDX-License-Identifier: Apache-2.0
// The texts of the command line's options: the first byte chooses which.
#include <cmath>
#include <string>

#include "harness.hpp"
#include "host/cli/options.hpp"
#include "host/import/import.hpp"

namespace {

using krait::fuzz::Outcomes;

Outcomes kinds[] = {Outcomes("a memory"), Outcomes("a start"),        Outcomes("a goal"),
                    Outcomes("a robot"),  Outcomes("a whole number"), Outcomes("a datum")};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace krait::host;
  using krait::fuzz::require;
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  SearchRequest request;
  Outcomes& kind = kinds[data[0] % 6];
  try {
    switch (data[0] % 6) {
      case 0:
        require(parse_memory(text) <= std::uint64_t{64} << 30U, "more memory than can be asked for");
        break;
      case 1:
        parse_start(text, request);
        require(!request.start || std::abs(request.start->position.x) <= 1e7, "a start out of all bounds");
        break;
      case 2:
        parse_goal(text, request);
        require(!request.goal || request.goal->radius > 0, "a goal without a radius");
        break;
      case 3:
        require(parse_robot(text).bodies.size() >= 1, "a robot without a body");
        break;
      case 5:
        require(std::abs(parse_datum(text).latitude) <= 90, "a datum off the earth");
        break;
      default:
        if (!whole_number(data[0])(const_cast<std::string&>(text)).empty()) throw InputError("no whole number");
    }
    kind.accepted.reach();
  } catch (const InputError&) {
    kind.refused.reach();
  }
  return 0;
}
