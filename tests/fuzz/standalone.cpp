// SPDX-License-Identifier: Apache-2.0
// A harness without a fuzzer: runs it on files and folders, and on changes of them.
//   fuzz_NAME [--rounds N] [--seed S] [--landmarks] FILE|FOLDER…
// --rounds: N changed copies, drawn from all files, the same for the same S. --landmarks: prints how often the files
// reach each of the harness's landmarks; exit code 1 where they never reach one.
// Exit code 2: a file that cannot be read, or another wrong argument.
// Before each input it is written to crash-NAME in the working folder, and removed after: what is left made it fail.
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "../whole_number.hpp"
#include "harness.hpp"

extern "C" __attribute__((weak)) std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                                                     std::size_t most, unsigned seed);

namespace {

using Bytes = std::vector<std::uint8_t>;

[[noreturn]] void refuse(const std::string& why) {
  std::fprintf(stderr, "fuzz: %s (usage: fuzz_NAME [--rounds N] [--seed S] [--landmarks] FILE|FOLDER...)\n",
               why.c_str());
  std::exit(2);
}

Bytes read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse("cannot read '" + path.string() + "'");
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return {path};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// Tokens that formats of text hang on, and numbers at the edges.
const char* const kWords[] = {"0",    "-1", "1e999", "1e-999", "NaN",  "5e9", "4294967296", "100000",  "null", "true",
                              "[",    "]",  "{",     "}",      "\"",   ":",   ",",          "\n",      "- ",   "&a ",
                              "*a",   "? ", "P5",    "P2",     "map",  "#",   "1000000000", "0.5",     "[]",   "{}",
                              "\\u0", "!!", ".inf",  "---\n",  "\xFF", "'",   "width 9",    "height 9"};

void change_bytes(Bytes& bytes, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return random() % n; };
  const auto at = [&] { return static_cast<std::ptrdiff_t>(below(bytes.size() + 1)); };
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
    const std::string word = kWords[below(std::size(kWords))];
    switch (below(5)) {
      case 0:
        if (!bytes.empty()) bytes[below(bytes.size())] = static_cast<std::uint8_t>(random());
        break;
      case 1:
        bytes.insert(bytes.begin() + at(), word.begin(), word.end());
        break;
      case 2: {  // in place of as many bytes
        const std::ptrdiff_t first = at();
        const auto last = std::min(first + static_cast<std::ptrdiff_t>(below(12)), std::ssize(bytes));
        bytes.erase(bytes.begin() + first, bytes.begin() + last);
        bytes.insert(bytes.begin() + first, word.begin(), word.end());
        break;
      }
      case 3: {  // a stretch again
        const std::ptrdiff_t first = at();
        const auto last = std::min(first + static_cast<std::ptrdiff_t>(below(40)), std::ssize(bytes));
        const Bytes stretch(bytes.begin() + first, bytes.begin() + last);
        bytes.insert(bytes.begin() + at(), stretch.begin(), stretch.end());
        break;
      }
      default:
        bytes.resize(below(bytes.size() + 1));
    }
  }
}

Bytes changed(Bytes bytes, std::mt19937& random) {
  if (LLVMFuzzerCustomMutator == nullptr || random() % 8 == 0) {
    change_bytes(bytes, random);
  } else {
    bytes.resize(LLVMFuzzerCustomMutator(bytes.data(), bytes.size(), bytes.size(), static_cast<unsigned>(random())));
  }
  return bytes;
}

void run(const Bytes& bytes) {
  const std::string crash = std::string("crash-") + program_invocation_short_name;
  std::ofstream(crash, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  ::unlink(crash.c_str());
}

// Whether the inputs so far have reached every landmark.
bool print_landmarks() {
  bool all = true;
  for (const auto* landmark = krait::fuzz::Landmark::first(); landmark != nullptr; landmark = landmark->next()) {
    std::printf("%6lu  %s\n", landmark->times(), landmark->name().c_str());
    all = all && landmark->times() > 0;
  }
  if (!all) std::fprintf(stderr, "fuzz: no file reaches the landmarks that are counted 0\n");
  return all;
}

struct Options {
  std::uint64_t rounds = 0;
  std::uint64_t seed = 1;
  bool landmarks = false;
  std::vector<Bytes> inputs;
};

std::uint64_t number(const std::string& option, const std::string& text) {
  const std::optional<std::uint64_t> value = krait::test::whole_number(text);
  if (!value) refuse(option + ": '" + text + "' is no whole number");
  return *value;
}

Options read_options(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if ((argument == "--rounds" || argument == "--seed") && i + 1 < argc) {
      (argument == "--rounds" ? options.rounds : options.seed) = number(argument, argv[++i]);
    } else if (argument == "--landmarks") {
      options.landmarks = true;
    } else {
      for (const auto& file : files_in(argument)) options.inputs.push_back(read(file));
    }
  }
  if (options.inputs.empty()) refuse("no file to run");
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  for (const Bytes& bytes : options.inputs) run(bytes);
  if (options.landmarks && !print_landmarks()) return 1;
  std::mt19937 random(static_cast<unsigned>(options.seed));
  for (std::uint64_t i = 0; i < options.rounds; ++i) {
    run(changed(options.inputs[random() % options.inputs.size()], random));
  }
  std::printf("%zu files, %llu changed ones: nothing found\n", options.inputs.size(),
              static_cast<unsigned long long>(options.rounds));
  return 0;
}
