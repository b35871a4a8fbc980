// SPDX-License-Identifier: Apache-2.0
#include "host/cli/program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <regex>
#include <sstream>
#include <thread>

#include "paths.hpp"

namespace krait::host {
namespace {

constexpr const char* kRoom = R"({"name": "room", "bounds": {"min": [-12, 0], "max": [20, 10]},
  "obstacles": [{"box": {"center": [10, 2], "size": [1, 4], "angle": 0}},
                {"box": {"center": [10, 8], "size": [1, 4], "angle": 0}}],
  "goals": [{"name": "east", "box": {"center": [17, 5], "size": [2, 2], "angle": 0}},
            {"name": "south", "box": {"center": [17, 2], "size": [2, 2], "angle": 0}}],
  "starts": [{"name": "west", "position": [3, 5], "heading": 0},
             {"name": "north", "position": [3, 8], "heading": -0.5, "angles": [-0.4, -0.2]}]})";

// Logs lie beside the folder, so that the folder shows only what the program left.
std::string log_path(const std::filesystem::path& directory, const char* stream) { return directory.string() + stream; }

void redirect(const std::string& path, int descriptor) {
  ::dup2(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), descriptor);
}

[[noreturn]] void become(const std::string& program, std::vector<std::string> arguments,
                         const std::filesystem::path& directory, const std::string& errors = {}) {
  std::vector<char*> argv = {const_cast<char*>(program.c_str())};
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  redirect(log_path(directory, ".out"), STDOUT_FILENO);
  redirect(errors.empty() ? log_path(directory, ".err") : errors, STDERR_FILENO);
  if (::chdir(directory.c_str()) == 0) ::execv(program.c_str(), argv.data());
  ::_exit(127);
}

std::string take_log(const std::filesystem::path& directory, const char* stream) {
  const std::string path = log_path(directory, stream);
  const std::string text = read_text(path);
  std::filesystem::remove(path);
  return text;
}

// Waits for the end: its exit code, or minus the number of the signal.
int code_of(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

std::string joined(const std::vector<std::string>& arguments) {
  std::string text;
  for (const std::string& argument : arguments) text += argument + " ";
  return text;
}

}  // namespace

std::string read_text(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                    const std::filesystem::path& directory) {
  const pid_t child = ::fork();
  if (child == 0) become(program, arguments, directory);
  const int code = code_of(child);
  return {code, take_log(directory, ".out"), take_log(directory, ".err")};
}

Outcome run_and_interrupt(const std::string& program, const std::vector<std::string>& arguments,
                          const std::filesystem::path& directory, std::chrono::milliseconds after) {
  const pid_t child = ::fork();
  if (child == 0) become(program, arguments, directory);
  std::this_thread::sleep_for(after);
  ::kill(child, SIGINT);
  const int code = code_of(child);
  return {code, take_log(directory, ".out"), take_log(directory, ".err")};
}

Outcome run_on_terminal(const std::string& program, const std::vector<std::string>& arguments,
                        const std::filesystem::path& directory) {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  EXPECT_TRUE(terminal >= 0 && ::grantpt(terminal) == 0 && ::unlockpt(terminal) == 0);
  const std::string other_end = ::ptsname(terminal);
  const pid_t child = ::fork();
  if (child == 0) become(program, arguments, directory, other_end);
  std::string shown;
  std::array<char, 4096> block{};
  const int keeps_open = ::open(other_end.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  std::atomic<bool> ended = false;
  std::thread reader([&] {
    while (!ended) {
      pollfd waiting{terminal, POLLIN, 0};
      if (::poll(&waiting, 1, 20) <= 0) continue;
      const ssize_t count = ::read(terminal, block.data(), block.size());
      if (count > 0) shown.append(block.data(), static_cast<std::size_t>(count));
    }
  });
  const int code = code_of(child);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  ended = true;
  reader.join();
  ::close(keeps_open);
  ::close(terminal);
  return {code, take_log(directory, ".out"), shown};
}

CliTest::CliTest() {
  write("room.json", kRoom);
  expect_done({"compile", "room.json", "-o", "room.krait"});
}

Outcome CliTest::krait(const std::vector<std::string>& arguments) const {
  return run_program(test::program_path("krait"), arguments, directory());
}

void CliTest::expect_refused(const std::vector<std::string>& arguments, const std::string& mention) const {
  SCOPED_TRACE(joined(arguments));
  const auto before = files();
  const Outcome outcome = krait(arguments);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.output, "");
  EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
  EXPECT_THAT(outcome.errors, testing::StartsWith("krait"));
  EXPECT_THAT(outcome.errors, testing::HasSubstr(mention));
  EXPECT_EQ(files(), before);
}

void CliTest::expect_done(const std::vector<std::string>& arguments) const {
  SCOPED_TRACE(joined(arguments));
  const Outcome outcome = krait(arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  const std::regex progress("krait(-compile)?: [^\n]* lasts[^\n]*\n");  // of a step of five seconds, on a slow machine
  EXPECT_EQ(std::regex_replace(outcome.errors, progress, ""), "");
}

nlohmann::ordered_json CliTest::json(const std::string& name) const {
  return nlohmann::ordered_json::parse(read_text(path(name)));
}

std::set<std::string> CliTest::files() const {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory())) {
    names.insert(entry.path().string());
  }
  return names;
}

}  // namespace krait::host
