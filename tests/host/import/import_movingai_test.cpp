// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "../scratch.hpp"
#include "host/import/import.hpp"

namespace krait::host::import_movingai_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class MovingAiTest : public ScratchTest {
 protected:
  Workspace read(const std::string& text) const { return import_workspace(write("a.map", text), {}); }
  std::string error(const std::string& text) const {
    return error_of([&] { read(text); });
  }
};

TEST_F(MovingAiTest, TheFirstRowIsTheTop) {
  const Workspace w = read("type octile\nheight 2\nwidth 3\nmap\n@..\n...\n");
  EXPECT_EQ(w.cells->resolution, 1);
  EXPECT_TRUE(w.cells->at(0, 1));
  EXPECT_FALSE(w.cells->at(0, 0));
  EXPECT_EQ(w.max.x, 3);
  EXPECT_EQ(w.max.y, 2);
}

TEST_F(MovingAiTest, GroundAndSwampArePassableNothingElse) {
  EXPECT_THAT(read("type octile\nheight 1\nwidth 7\nmap\n.GS@OTW\n").cells->occupied, ElementsAre(0, 0, 0, 1, 1, 1, 1));
}

TEST_F(MovingAiTest, TakesLinesOfWindowsAndNoLastNewline) {
  EXPECT_THAT(read("type octile\r\nheight 1\r\nwidth 2\r\nmap\r\n.@").cells->occupied, ElementsAre(0, 1));
}

TEST_F(MovingAiTest, IsRecognisedByContentToo) {
  EXPECT_EQ(import_workspace(write("a.txt", "type octile\nheight 1\nwidth 1\nmap\n."), {}).cells->rows, 1);
}

TEST_F(MovingAiTest, UnsoundFilesAreRefusedByLine) {
  EXPECT_THAT(error("type tile\n"), HasSubstr("line 1: must be \"type octile\""));
  EXPECT_THAT(error("type octile\nheight x\n"), HasSubstr("line 2: must be \"height N\""));
  EXPECT_THAT(error("type octile\nheight 1\nwidth 0\n"), HasSubstr("line 3: must be \"width N\""));
  EXPECT_THAT(error("type octile\nheight 1\nwidth 1\n.\n"), HasSubstr("line 4: must be \"map\""));
  EXPECT_THAT(error("type octile\nheight 2\nwidth 2\nmap\n..\n.\n"),
              HasSubstr("line 6: has 1 cells, the header says 2"));
  EXPECT_THAT(error("type octile\nheight 2\nwidth 2\nmap\n....\n"), HasSubstr("line 5: has 4 cells"));
  EXPECT_THAT(error("type octile\nheight 3\nwidth 2\nmap\n..\n..\n"), HasSubstr("ends early"));
  EXPECT_THAT(error("type octile\nheight 1\nwidth 2\nmap\n..\n..\n"), HasSubstr("line 6: is one row more"));
  EXPECT_THAT(error("type octile\nheight 1\nwidth 2\nmap\n.x\n"), HasSubstr("line 5: column 2: unknown terrain 'x'"));
  EXPECT_THAT(error("type octile\nheight 1\nwidth 2\nmap\n.\xFF\n"), HasSubstr("unknown terrain byte 255"));
  EXPECT_THAT(error("type octile\nheight 100000\nwidth 100000\nmap\n"), HasSubstr("100000 x 100000 cells"));
  EXPECT_THAT(error("type octile\nheight 8000\nwidth 8000\nmap\n"), HasSubstr("too short for the 8000 x 8000 cells"));
  EXPECT_THAT(error("type octile\nheight 99999999999\nwidth 1\nmap\n"), HasSubstr("line 2"));
}

}  // namespace
}  // namespace krait::host::import_movingai_test
