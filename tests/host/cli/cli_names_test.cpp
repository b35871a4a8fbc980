// SPDX-License-Identifier: Apache-2.0
// No name, file name or argument commands the terminal or turns the direction of a line, on any way to the user.
#include "host/cli/program.hpp"
#include "paths.hpp"

namespace krait::host {
namespace {

using testing::HasSubstr;

constexpr const char* kOverride = "\xE2\x80\xAE";  // U+202E, right-to-left override
constexpr const char* kEscape = "\x1B[31m";
constexpr const char* kC1 = "\xC2\x9B";  // U+009B, the C1 form of ESC [

// Bytes that a terminal could take for more than text.
bool is_harmless(const std::string& text) {
  for (const char* bad : {kOverride, kC1, "\x1B", "\x07", "\x7F", "\r"}) {
    if (text.find(bad) != std::string::npos) return false;
  }
  return true;
}

class CliNames : public CliTest {
 protected:
  void expect_harmless(const std::vector<std::string>& arguments, int code, const std::string& mention) const {
    const Outcome outcome = krait(arguments);
    EXPECT_EQ(outcome.code, code) << mention;
    EXPECT_TRUE(is_harmless(outcome.output)) << outcome.output;
    EXPECT_TRUE(is_harmless(outcome.errors)) << outcome.errors;
    EXPECT_THAT(outcome.output + outcome.errors, HasSubstr(mention));
  }
};

TEST_F(CliNames, InMapsAreRefused) {
  std::string map = read_text(path("room.json"));
  map.replace(map.find("east"), 4, std::string("ea") + kOverride);
  write("bad.json", map);
  const std::string why =
      "bad.json: goals[0].name: must be a name of 1 to 200 bytes without control characters, is \"ea\\u202e\"\n";
  expect_refused({"compile", "bad.json", "-o", "bad.krait"}, "krait-compile: " + why);
  expect_refused({"plan", "bad.json"}, "krait: " + why);
  expect_refused({"verify", "bad.json", "plan.json"}, "krait: " + why);
}

// Also where its check sum is right: what reads it without the core looks for itself.
TEST_F(CliNames, InCompiledScenesAreRefused) {
  std::string scene = read_text(path("room.krait"));
  scene.replace(scene.rfind("room"), 4, std::string("a") + kC1 + "b");
  write("bad.krait", scene);
  expect_refused({"compile", "bad.krait", "-o", "x.krait"},
                 "krait-compile: bad.krait: has a name with control characters\n");
  expect_refused({"verify", "bad.krait", "plan.json"}, "krait: bad.krait: has a name with control characters\n");
  expect_refused({"plan", "bad.krait"}, "krait: bad.krait: bad_scene: ");
  expect_refused({"info", "bad.krait"}, "krait: bad.krait: bad_scene: ");
}

TEST_F(CliNames, InPlansAreRefused) {
  expect_done({"plan", "room.krait", "--robot", "car", "-o", "plan.json"});
  nlohmann::ordered_json plan = json("plan.json");
  plan["status"] = std::string("solved") + kEscape;
  write("plan.json", plan.dump());
  expect_refused({"verify", "room.json", "plan.json", "--robot", "car"},
                 "krait: plan.json: status: must be a text without control characters, is \"solved\\u001b[31m\"\n");
}

TEST_F(CliNames, InRobotsAreRefused) {
  write("robot.json", R"({"model": "car\u009b"})");
  expect_refused({"plan", "room.krait", "--robot", "robot.json"}, "unknown model \"car\\u009B\"");
  write("robot.json", R"({"model": "car", "parameters": {"\u202e": 1}})");
  expect_refused({"plan", "room.krait", "--robot", "robot.json"}, "unknown parameter \"\\u202E\"");
}

TEST_F(CliNames, OfFilesAreEscapedInMessages) {
  for (const auto& [bad, escaped] :
       {std::pair{kOverride, "\\u202E"}, {kEscape, "\\u001B[31m"}, {kC1, "\\u009B"}, {"\xFF", "\\xFF"}}) {
    const std::string file = std::string("a") + bad;
    const std::string shown = std::string("a") + escaped;
    expect_refused({"compile", file, "-o", "x.krait"}, "krait-compile: " + shown + ": cannot be read: ");
    expect_refused({"compile", "room.json", "-o", "no/" + file},
                   "krait-compile: no/" + shown + ": cannot be written: ");
    expect_refused({"compile", "room.json", "-o", "x.krait", "--" + file}, shown);
    expect_refused({"plan", file}, "krait: " + shown + ": cannot be read: ");
    expect_refused({"plan", "room.krait", "--html", "no/" + file}, "krait: no/" + shown + ": cannot be written: ");
    expect_refused({"plan", "room.krait", "--csv", file, "--svg", file},
                   "krait: --svg " + shown + ": would overwrite the output --csv " + shown + ": choose another file\n");
    expect_refused({"info", file}, "krait: " + shown + ": cannot be read: ");
    expect_refused({"verify", file, file}, "krait: " + shown + ": cannot be read: ");
    expect_refused({"scene", file, "-o", "x.json"}, shown);
  }
}

TEST_F(CliNames, OfFilesAreEscapedWhereAllIsWell) {
  const std::string bad = std::string("a") + kEscape + kOverride;
  const std::string shown = "a\\u001B[31m\\u202E";
  write(bad + ".json", R"({"bounds": {"min": [0, 0], "max": [20, 10]},
      "goals": [{"name": "goal", "box": {"center": [17, 5], "size": [2, 2]}}],
      "starts": [{"name": "start", "position": [3, 5], "heading": 0}]})");
  expect_harmless({"plan", bad + ".json", "--robot", "car", "-o", "plan.json", "--svg", "plan.svg"}, 0,
                  "solved: car (1 body) in " + shown + ", seed 1");
  EXPECT_EQ(json("plan.json").at("scene"), shown);
  EXPECT_TRUE(is_harmless(read_text(path("plan.svg"))));
  expect_harmless({"compile", bad + ".json", "-o", "x.krait"}, 0, "");
  write(bad, R"({"model": "car"})");
  expect_harmless({"info", "x.krait", "--robot", bad}, 0, "advance(1) of " + shown + ": at most");
  expect_harmless({"info", "x.krait"}, 0, "scene     " + shown);
}

TEST_F(CliNames, InArgumentsAreEscaped) {
  const std::string bad = std::string("x") + kEscape + kC1 + kOverride + "\n";
  const std::string shown = "x\\u001B[31m\\u009B\\u202E\\u000A";
  expect_refused({bad}, "krait: no such command: " + shown + " (see krait --help)\n");
  expect_refused({"plan", "room.krait", bad}, "krait: not expected here: " + shown + " (see krait plan --help)\n");
  for (const char* option :
       {"--start", "--goal", "--robot", "--planner", "--seed", "--memory", "--alpha", "--unknown"}) {
    expect_refused({"plan", "room.krait", option, bad}, shown);
  }
  expect_refused({"compile", "room.json", "-o", "x.krait", "--start", bad}, shown);
  expect_refused({"compile", "room.json", "-o", "x.krait", "--unknown", bad}, shown);
}

TEST_F(CliNames, InArgumentsOfTheDemoAreEscaped) {
  const std::string bad = std::string("x") + kEscape + kC1 + kOverride;
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{bad},
                                                    {"room.json", "--" + bad},
                                                    {"room.json", "--" + bad + "=1"},
                                                    {"room.json", bad}}) {
    std::vector<std::string> whole = {test::source_path("port/host/demo")};
    whole.insert(whole.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run_program("/bin/bash", whole, directory());
    EXPECT_EQ(outcome.code, 2);
    EXPECT_TRUE(is_harmless(outcome.errors)) << outcome.errors;
    EXPECT_THAT(outcome.errors, testing::AnyOf(HasSubstr("x\\E[31m\\302\\233\\342\\200\\256"),
                                               HasSubstr("x\\u001B[31m\\u009B\\u202E")));
  }
}

}  // namespace
}  // namespace krait::host
