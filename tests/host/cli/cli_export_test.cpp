// SPDX-License-Identifier: Apache-2.0
// krait export: what it writes compiles to the same bytes, and what it refuses.
#include <gmock/gmock.h>

#include "../scratch.hpp"
#include "host/input/file.hpp"
#include "host/workspace/printed.hpp"
#include "paths.hpp"
#include "program.hpp"

namespace krait::host {
namespace {

using testing::HasSubstr;

class CliExport : public ScratchTest {
 protected:
  Outcome krait(const std::vector<std::string>& arguments) const {
    return run_program(test::program_path("krait"), arguments, directory());
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

TEST_F(CliExport, WhatIsDoubtfulInAMapIsSaid) {
  write("map.pgm", "P2 2 1 255\n205 255\n");
  write("map.yaml",
        "image: map.pgm\nresolution: 5\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const Outcome outcome = krait({"export", "map.yaml", "--json", "map.json"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.errors, testing::StartsWith("krait: warning: map.yaml: 50 % of the cells are unknown"));
}

// A drawing has a line for a goal, whatever its radius and tolerances; the other formats have all of them.
TEST_F(CliExport, GoalsThatADrawingHasNoPlaceForAreNamed) {
  const char* goals[] = {R"("radius": 0.1)", R"("radius": 0.2)", R"("radius": 0.1, "heading_tolerance": 0.3)",
                         R"("radius": 0.1, "either_way": true)", R"("radius": 0.1, "hitch_tolerance": 0.2)"};
  std::string list;
  int number = 0;
  for (const char* goal : goals) {
    list += printed(R"(%s{"name": "g%d", "position": [%d, 5], "heading": 1, %s})", number > 0 ? ", " : "", number,
                    3 + 3 * number, goal);
    ++number;
  }
  write("m.json", R"({"bounds": {"min": [0, 0], "max": [20, 10]}, "goals": [)" + list + "]}");
  std::string expected;
  for (int i = 1; i < number; ++i) {
    expected += printed(
        "krait: warning: goal 'g%d' becomes a line of the drawing, which is read as 0.1 m and 0.1 rad "
        "around it, not as the map has it\n",
        i);
  }
  EXPECT_EQ(krait({"export", "m.json", "--svg", "m.svg"}).errors, expected);
  EXPECT_EQ(krait({"export", "m.json", "--json", "n.json", "--geojson", "m.geojson"}).errors, "");
}

TEST_F(CliExport, AnInputIsNotOverwritten) {
  write("m.json", R"({"bounds": {"min": [0, 0], "max": [9, 9]}})");
  const Outcome outcome = krait({"export", "m.json", "--json", "./m.json"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("--json ./m.json: would overwrite the input m.json"));
}

}  // namespace
}  // namespace krait::host
