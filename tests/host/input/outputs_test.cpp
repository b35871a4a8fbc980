// SPDX-License-Identifier: Apache-2.0
// Outputs that would overwrite an input or one another are found before any is written, whatever their paths look like.
#include "host/input/outputs.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "../scratch.hpp"

namespace krait::host {
namespace {

class OutputsTest : public ScratchTest {
 protected:
  OutputsTest() {
    write("map", "content");
    std::filesystem::create_hard_link(path("map"), path("hard"));
    std::filesystem::create_symlink("map", path("soft"));
    std::filesystem::create_directory_symlink(".", path("here"));
  }

  std::string error(const std::vector<std::string>& outputs) const {
    std::vector<Output> all;
    for (const std::string& output : outputs) all.push_back({"--" + std::to_string(all.size()), output});
    return error_of([&] { check_outputs(all, {path("map")}); });
  }
};

TEST_F(OutputsTest, FilesOfTheirOwnAreTaken) {
  write("old", "content");
  EXPECT_EQ(error({path("new"), path("old"), path("newer"), ""}), "");
  EXPECT_EQ(error({"", ""}), "");
  EXPECT_EQ(error({"/dev/null", "/dev/null"}), "");
  std::filesystem::create_directory(path("folder"));
  EXPECT_EQ(error({path("new"), path("folder/new")}), "");
  EXPECT_FALSE(std::filesystem::exists(path("new")));
}

TEST_F(OutputsTest, AnInputIsNotOverwrittenByAnyOfItsNames) {
  for (const char* name : {"map", "hard", "soft", "here/map", "here/soft", "here/./here/hard"}) {
    EXPECT_EQ(error({path("new"), path(name)}),
              "--1 " + path(name) + ": would overwrite the input " + path("map") + ": choose another file");
  }
}

TEST_F(OutputsTest, TwoOutputsAreNotOneFile) {
  write("old", "content");
  std::filesystem::create_symlink("old", path("to_old"));
  std::filesystem::create_symlink("new", path("to_new"));
  for (const auto& [one, other] : {std::pair{"new", "new"},
                                   {"new", "here/new"},
                                   {"new", "here/here/./new"},
                                   {"old", "old"},
                                   {"old", "to_old"},
                                   {"new", "to_new"},
                                   {"here/old", "to_old"}}) {
    EXPECT_EQ(error({path(one), "", path(other)}),
              "--2 " + path(other) + ": would overwrite the output --0 " + path(one) + ": choose another file");
  }
  EXPECT_NE(error({"/dev/zero", "/dev/zero"}), "");
}

TEST_F(OutputsTest, WhatCannotBeWrittenIsSaidFirst) {
  EXPECT_EQ(error({path("no/such"), path("no/such")}),
            path("no/such") + ": cannot be written: No such file or directory");
}

}  // namespace
}  // namespace krait::host
