// SPDX-License-Identifier: Apache-2.0
// krait compile: runs krait-compile, a program of its own (GPL), with the same arguments.
#include "host/cli/commands.hpp"
#include "host/cli/compiler_process.hpp"

namespace krait::host {

void add_compile(CLI::App& app, const char* program) {
  CLI::App* command = app.add_subcommand("compile", "compile a map or drawing into a scene file");
  command->prefix_command();
  command->set_help_flag();
  command->callback([command, path = compiler_path(program)] { become_compiler(path, command->remaining()); });
}

}  // namespace krait::host
