// SPDX-License-Identifier: Apache-2.0
#include "host/cli/compiler_process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "host/cli/commands.hpp"
#include "host/input/interrupt.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {
namespace {

constexpr const char* kStopped = "krait: stopped by you while the map was compiled: nothing is written\n";
constexpr int kNotRun = 127;  // the exit code of a child that did not become krait-compile

[[noreturn]] void refuse_to_run(const std::string& compiler) {
  throw InputError("cannot run " + compiler + ": it must lie beside krait (build the target krait-compile)");
}

// Returns only where the program cannot be run.
void execute(const std::string& compiler, std::vector<std::string>& arguments) {
  std::vector<char*> argv;
  std::string name = "krait compile";
  argv.push_back(name.data());
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  ::execv(compiler.c_str(), argv.data());
}

// In the child: its standard output is the pipe, and it ends when its parent does, which has the word on Ctrl-C.
[[noreturn]] void become_child(pid_t parent, int pipe_end, const std::string& compiler,
                               std::vector<std::string>& arguments) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  std::signal(SIGINT, SIG_IGN);
  const bool connected = ::dup2(pipe_end, STDOUT_FILENO) >= 0 && ::fcntl(STDOUT_FILENO, F_SETFD, 0) == 0;
  if (connected && ::getppid() == parent) execute(compiler, arguments);
  ::_exit(kNotRun);
}

std::string read_to_end(int descriptor) {
  std::string all;
  std::array<char, 65536> block{};
  for (;;) {
    const ssize_t count = ::read(descriptor, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return all;
    all.append(block.data(), static_cast<std::size_t>(count));
  }
}

int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return status;
}

void require_success(int status, const std::string& compiler, const std::string& map) {
  if (WIFSIGNALED(status)) {
    throw InputError(map + ": krait-compile was ended by signal " + std::to_string(WTERMSIG(status)) + " (" +
                     ::strsignal(WTERMSIG(status)) + "); has this machine enough memory for the map?");
  }
  const int code = WEXITSTATUS(status);
  if (code == kNotRun) refuse_to_run(compiler);
  if (code != kDone) throw Exit{code};
}

}  // namespace

std::string compiler_path(const std::string& program) {
  std::error_code error;
  std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) self = program;
  return self.parent_path() / "krait-compile";
}

void become_compiler(const std::string& compiler, std::vector<std::string> arguments) {
  execute(compiler, arguments);
  refuse_to_run(compiler);
}

std::string run_compiler(const std::string& compiler, const std::string& map, std::vector<std::string> options) {
  std::vector<std::string> arguments = {"-o", "/dev/stdout"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  arguments.insert(arguments.end(), {"--", map});
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) refuse_to_run(compiler);
  std::signal(SIGCHLD, SIG_DFL);  // whoever started this program may have had it ignored
  const LastWord word(kStopped);  // a terminal sends Ctrl-C to both programs
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) become_child(parent, ends[1], compiler, arguments);
  ::close(ends[1]);
  std::string scene = read_to_end(ends[0]);
  ::close(ends[0]);
  if (child < 0) refuse_to_run(compiler);
  require_success(wait_for(child), compiler, map);
  return scene;
}

}  // namespace krait::host
