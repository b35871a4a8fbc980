// SPDX-License-Identifier: Apache-2.0
// Reads and writes whole files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace krait::host {

// The bytes of a regular file of 1 to `most` bytes. Throws InputError naming the path: missing, a directory, a
// device, a pipe (also the shell's <(…)), empty, too large, unreadable. Never waits.
std::string read_file(const std::string& path, std::uint64_t most);

// The file that a path leads to by symbolic links, whether or not there is one; where they go round, one of them.
std::string led_to(const std::string& path);

// Throws InputError where write_file(path, …) is bound to fail: a folder, no such folder, no permission, a named pipe,
// a socket, a block device. Writes and opens nothing.
void check_writable(const std::string& path);

// Writes a file whole or not at all: to a temporary beside it, then by rename, while SIGINT, SIGTERM and SIGHUP wait. A
// file that is replaced keeps its permissions, and symbolic links are followed. A character device (/dev/null, a
// terminal) and a pipe that the shell has opened (/dev/stdout before a |, >(…)) are written to directly. Opening never
// waits. Throws InputError.
void write_file(const std::string& path, const std::string& content);

struct FileText {
  std::string path;
  std::string text;
};

// Writes the files; Ctrl-C comes too late for all of them. Throws as write_file.
void write_files(const std::vector<FileText>& files);

}  // namespace krait::host
