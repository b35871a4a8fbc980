// SPDX-License-Identifier: Apache-2.0
// krait export: what it writes compiles to the same bytes, and what it refuses.
#include <gmock/gmock.h>

#include "../scratch.hpp"
#include "host/input/file.hpp"
#include "program.hpp"

namespace krait::host {
namespace {

using testing::HasSubstr;

class CliExport : public ScratchTest {
 protected:
  Outcome krait(const std::vector<std::string>& arguments) const {
    return run_program(KRAIT_BIN_DIR "/krait", arguments, directory());
  }
  std::string compiled(const std::string& map) const {
    EXPECT_EQ(krait({"compile", map, "-o", "out.krait"}).code, 0) << map;
    return read_file(path("out.krait"), 1U << 24);
  }
};

TEST_F(CliExport, WhatItWritesCompilesToTheSameScene) {
  ASSERT_EQ(krait({"scene", "rooms", "-o", "rooms.json"}).code, 0);
  const Outcome outcome =
      krait({"export", "rooms.json", "--json", "a.json", "--geojson", "a.geojson", "--svg", "a.svg"});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(read_file(path("a.json"), 1U << 24), read_file(path("rooms.json"), 1U << 24));
  const std::string scene = compiled("rooms.json");
  for (const char* copy : {"a.json", "a.geojson", "a.svg"}) EXPECT_EQ(compiled(copy), scene) << copy;
}

TEST_F(CliExport, WithoutAnOutputThereIsNothingToDo) {
  const Outcome outcome = krait({"export", "rooms.json"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.errors, "krait: export: nothing to write: give --geojson, --svg or --json with a file\n");
}

TEST_F(CliExport, AnInputIsNotOverwritten) {
  write("m.json", R"({"bounds": {"min": [0, 0], "max": [9, 9]}})");
  const Outcome outcome = krait({"export", "m.json", "--json", "./m.json"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("--json ./m.json: would overwrite the input m.json"));
}

}  // namespace
}  // namespace krait::host
