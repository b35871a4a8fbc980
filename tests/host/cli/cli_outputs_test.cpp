// SPDX-License-Identifier: Apache-2.0
// Outputs that would destroy an input or one another, or on which krait would wait for ever.
#include <sys/stat.h>

#include "host/cli/program.hpp"
#include "paths.hpp"

namespace krait::host {
namespace {

using testing::HasSubstr;

class CliOutputs : public CliTest {
 protected:
  // Refused with this line, and the file's content stays.
  void expect_kept(const std::string& file, const std::vector<std::string>& arguments, const std::string& line) const {
    const std::string before = read_text(path(file));
    expect_refused(arguments, line);
    EXPECT_EQ(read_text(path(file)), before);
  }
};

TEST_F(CliOutputs, AnInputIsNotOverwritten) {
  std::filesystem::create_hard_link(path("room.json"), path("hard.json"));
  std::filesystem::create_symlink("room.json", path("soft.json"));
  std::filesystem::create_directory_symlink(".", path("here"));
  for (const char* option : {"-o", "--csv", "--svg", "--png", "--html"}) {
    const auto refused = [&](const std::string& input, const std::string& output) {
      expect_kept(input, {"plan", input, "--robot", "car", option, output},
                  "krait: " + std::string(option) + " " + output + ": would overwrite the input " + input +
                      ": choose another file\n");
    };
    refused("room.krait", "room.krait");
    refused("room.krait", "here/room.krait");
    for (const char* output : {"room.json", "./room.json", "hard.json", "soft.json", "here/soft.json"}) {
      refused("room.json", output);
    }
  }
  for (const char* output : {"room.json", "hard.json", "soft.json", "here/room.json"}) {
    expect_kept(
        "room.json", {"compile", "room.json", "-o", output},
        "krait-compile: -o " + std::string(output) + ": would overwrite the input room.json: choose another file\n");
  }
}

TEST_F(CliOutputs, ARobotIsNotOverwritten) {
  write("robot.json", R"({"model": "car"})");
  write("car", "a file that has the name of a model");
  expect_kept("robot.json", {"plan", "room.krait", "--robot", "robot.json", "-o", "robot.json"},
              "krait: -o robot.json: would overwrite the input robot.json: choose another file\n");
  expect_done({"plan", "room.krait", "--robot", "car", "-o", "car"});
}

TEST_F(CliOutputs, TheImageOfAMapIsNotOverwritten) {
  write("map.pgm", "P2 2 2 255\n255 255 255 255\n");
  write("map.yaml",
        "image: map.pgm\nresolution: 5\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const std::string line = ": would overwrite the input map.pgm: choose another file\n";
  expect_kept("map.pgm", {"compile", "map.yaml", "-o", "map.pgm"}, "krait-compile: -o map.pgm" + line);
  expect_kept("map.pgm",
              {"plan", "map.yaml", "--robot", "car", "--start", "3,3,0", "--goal", "7,7,1", "--png", "map.pgm"},
              "krait: --png map.pgm" + line);
  expect_kept("map.pgm", {"export", "map.yaml", "--json", "map.pgm"}, "krait: --json map.pgm" + line);
}

TEST_F(CliOutputs, TwoOutputsAreNotOneFile) {
  write("old", "old");
  std::filesystem::create_symlink("old", path("link"));
  std::filesystem::create_directory_symlink(".", path("here"));
  for (const auto& [one, other] :
       {std::pair{"new", "new"}, {"new", "./new"}, {"new", "here/new"}, {"old", "link"}, {"old", "here/old"}}) {
    expect_kept(
        "old", {"plan", "room.krait", "--robot", "car", "-o", one, "--html", other},
        "krait: --html " + std::string(other) + ": would overwrite the output -o " + one + ": choose another file\n");
  }
  expect_done({"plan", "room.krait", "--robot", "car", "-o", "/dev/null", "--csv", "/dev/null"});
}

TEST_F(CliOutputs, ANamedPipeIsRefusedWhetherOrNotItHasAReader) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const std::string written = "pipe: cannot be written: is a named pipe, not a regular file\n";
  for (const char* option : {"-o", "--csv", "--svg", "--png", "--html"}) {
    expect_refused({"plan", "room.krait", "--robot", "car", option, "pipe"}, "krait: " + written);
  }
  expect_refused({"compile", "room.json", "-o", "pipe"}, "krait-compile: " + written);
  expect_refused({"scene", "gates", "-o", "pipe"}, "krait: " + written);
  const std::string read = "pipe: is not a regular file but a pipe: save its content to a file first\n";
  expect_refused({"plan", "pipe"}, "krait: " + read);
  expect_refused({"plan", "room.krait", "--robot", "./pipe"}, "krait: ./" + read);
  expect_refused({"info", "pipe"}, "krait: " + read);
  expect_refused({"verify", "pipe", "pipe"}, "krait: " + read);
  expect_refused({"verify", "room.json", "pipe"}, "krait: " + read);
  expect_refused({"compile", "pipe", "-o", "x.krait"}, "krait-compile: " + read);
}

// What the shell has opened is written to, and is not read from.
TEST_F(CliOutputs, PipesOfTheShell) {
  const auto in_shell = [&](const std::string& command) {
    return run_program("/bin/bash", {"-c", "PATH=" + test::program_path("") + ":$PATH; " + command}, directory());
  };
  EXPECT_THAT(in_shell("krait compile room.json -o /dev/stdout | cmp - room.krait && echo same").output, "same\n");
  EXPECT_THAT(in_shell("krait plan room.json --robot car -o /dev/stdout | head -c 23").output,
              "{\"format\":\"krait-plan\",");
  EXPECT_THAT(in_shell("krait scene gates -o >(cat >gates.json); wait $!; sleep 0.1; grep -c bounds gates.json").output,
              "1\n");
  EXPECT_THAT(in_shell("krait plan <(cat room.json)").errors,
              HasSubstr(": is not a regular file but a pipe: save its content to a file first\n"));
  EXPECT_THAT(in_shell("krait plan /dev/stdin --robot car <room.json").output, HasSubstr("verified"));
}

}  // namespace
}  // namespace krait::host
