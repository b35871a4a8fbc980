// krait compile: runs krait-compile, a program of its own (GPL), with the same arguments.
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "host/cli/commands.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {
namespace {

std::string compiler_path(const char* program) {
  std::error_code error;
  std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) self = program;
  return self.parent_path() / "krait-compile";
}

[[noreturn]] void become_compiler(const std::string& compiler, std::vector<std::string> arguments) {
  std::vector<char*> argv;
  std::string name = "krait compile";
  argv.push_back(name.data());
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  execv(compiler.c_str(), argv.data());
  throw InputError("cannot run " + compiler + ": it must lie beside krait (build the target krait-compile)");
}

}  // namespace

void add_compile(CLI::App& app, const char* program) {
  CLI::App* command = app.add_subcommand("compile", "compile a map or drawing into a scene file");
  command->prefix_command();
  command->set_help_flag();
  command->callback([command, path = compiler_path(program)] { become_compiler(path, command->remaining()); });
}

}  // namespace krait::host
