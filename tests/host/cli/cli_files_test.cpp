// SPDX-License-Identifier: Apache-2.0
// Files are written whole or not at all: programs killed at random moments, and disks that are full.
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <random>
#include <thread>

#include "host/cli/program.hpp"
#include "paths.hpp"

namespace krait::host {
namespace {

using testing::HasSubstr;
using Arguments = std::vector<std::string>;

class CliFiles : public CliTest {
 protected:
  // Starts krait and kills it after `delay`, if it still runs.
  void run_killed(const Arguments& arguments, std::chrono::microseconds delay) const {
    const pid_t child = ::fork();
    if (child == 0) {
      const std::string krait = test::program_path("krait");
      std::vector<char*> argv = {const_cast<char*>(krait.c_str())};
      for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
      argv.push_back(nullptr);
      const int null = ::open("/dev/null", O_WRONLY);
      ::dup2(null, STDOUT_FILENO);
      ::dup2(null, STDERR_FILENO);
      if (::chdir(directory().c_str()) == 0) ::execv(argv[0], argv.data());
      ::_exit(127);
    }
    std::this_thread::sleep_for(delay);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }

  // Runs it `times`, killed somewhere in the time that it takes: `file` is what stood there or what it would write.
  template <class Whole>
  void expect_whole(const Arguments& arguments, const std::string& file, int times, Whole whole) const {
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_EQ(krait(arguments).code, 0);
    const auto takes = std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begin);
    ASSERT_TRUE(whole(read_text(path(file))));
    std::mt19937 random(7);
    int old = 0;
    for (int i = 0; i < times; ++i) {
      write(file, "old");
      run_killed(arguments, std::chrono::microseconds(random() % static_cast<unsigned>(takes.count() + 1)));
      const std::string content = read_text(path(file));
      old += content == "old" ? 1 : 0;
      ASSERT_TRUE(content == "old" || whole(content)) << file << ", " << content.size() << " bytes";
    }
    EXPECT_GT(old, 0) << "none was killed before it wrote";
  }

  // krait where no file may grow over a kilobyte, as on a disk that is full.
  Outcome krait_on_full_disk(const Arguments& arguments) const {
    std::string line = "trap '' XFSZ; ulimit -f 1; exec " + test::program_path("krait");
    for (const std::string& argument : arguments) line += " " + argument;
    return run_program("/bin/bash", {"-c", line}, directory());
  }

  void expect_full_disk_said(const Arguments& arguments, const std::string& file) const {
    SCOPED_TRACE(file);
    write(file, "old");
    const auto before = files();
    const Outcome outcome = krait_on_full_disk(arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr(file + ": cannot be written: File too large"));
    EXPECT_EQ(read_text(path(file)), "old");
    EXPECT_EQ(files(), before);
  }
};

TEST_F(CliFiles, ASceneIsWholeWhenItsCompilerIsKilled) {
  const std::string reference = read_text(path("room.krait"));
  expect_whole({"compile", "room.json", "-o", "out.krait"}, "out.krait", 40,
               [&](const std::string& content) { return content == reference; });
}

TEST_F(CliFiles, APlanIsWholeWhenItsPlannerIsKilled) {
  expect_whole({"plan", "room.krait", "--robot", "car", "-o", "plan.json"}, "plan.json", 40,
               [](const std::string& content) {
                 const auto plan = nlohmann::ordered_json::parse(content, nullptr, false);
                 return plan.is_object() && plan.value("status", "") == "solved" && content.back() == '\n';
               });
}

TEST_F(CliFiles, APageIsWholeWhenItsPlannerIsKilled) {
  expect_whole({"plan", "room.krait", "--robot", "car", "--html", "plan.html"}, "plan.html", 20,
               [](const std::string& content) { return content.find("</html>") != std::string::npos; });
}

TEST_F(CliFiles, AFullDiskIsSaidAndTheOldFileStays) {
  expect_full_disk_said({"compile", "room.json", "-o", "out.krait"}, "out.krait");
  expect_full_disk_said({"scene", "gates", "-o", "out.json"}, "out.json");
  for (const auto& [option, file] :
       std::initializer_list<std::pair<const char*, const char*>>{{"-o", "plan.json"},
                                                                  {"--csv", "plan.csv"},
                                                                  {"--svg", "plan.svg"},
                                                                  {"--png", "plan.png"},
                                                                  {"--html", "plan.html"}}) {
    expect_full_disk_said({"plan", "room.krait", "--robot", "car", option, file}, file);
  }
}

}  // namespace
}  // namespace krait::host
