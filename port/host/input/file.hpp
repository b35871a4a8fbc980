// Reads and writes whole files.
#pragma once

#include <cstdint>
#include <string>

namespace krait::host {

// The bytes of a regular file of 1 to `most` bytes. Throws InputError naming the path: missing, a directory, a
// device, empty, too large, unreadable.
std::string read_file(const std::string& path, std::uint64_t most);

// Throws InputError where write_file(path, …) is bound to fail: a folder, no such folder, no permission. Writes
// nothing.
void check_writable(const std::string& path);

// Writes a file whole or not at all: to a temporary beside it, then by rename; a symbolic link is followed, and a
// device (/dev/stdout) is written to directly. Throws InputError.
void write_file(const std::string& path, const std::string& content);

}  // namespace krait::host
