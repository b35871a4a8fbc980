// SPDX-License-Identifier: Apache-2.0
// Looks at all files that a command is going to write before it does any work.
#pragma once

#include <string>
#include <vector>

namespace krait::host {

struct Output {
  std::string option;  // that names it, "--csv"
  std::string path;    // empty: not asked for
};

// Throws InputError, naming the option, where an output cannot be written (check_writable), is one of the files that
// are read, or is another output too: whether two paths lead to one file is a question of device and inode, so that
// other spellings and links count. Any number of outputs may go to /dev/null. Writes and opens nothing.
void check_outputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs);

}  // namespace krait::host
