// SPDX-License-Identifier: Apache-2.0
// The commands of the program `krait`. Each adds itself to the app; its callback returns by throwing nothing, or
// throws Exit with the program's exit code, or InputError for bad input (exit 2).
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

namespace krait::host {

inline constexpr int kDone = 0;
inline constexpr int kHonestNo = 1;
inline constexpr int kBadInput = 2;
inline constexpr int kOwnBug = 3;

struct Exit {
  int code;
};

// On stderr; nothing where the text is empty.
inline void warn(const std::string& text) {
  if (!text.empty()) std::fprintf(stderr, "krait: warning: %s\n", text.c_str());
}

// `program` is the path of the running executable: krait-compile lies beside it.
void add_compile(CLI::App& app, const char* program);
void add_info(CLI::App& app);
void add_plan(CLI::App& app, const char* program);
void add_verify(CLI::App& app);
void add_scene(CLI::App& app);
void add_export(CLI::App& app);
void add_robot(CLI::App& app);  // robot and robots

}  // namespace krait::host
