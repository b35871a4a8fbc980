// What the library's archive asks of the linker: nothing of the heap, of exceptions, of run-time types or of libm.
#include <gtest/gtest.h>

#include <cstdio>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace krait {
namespace {

struct Symbol {
  char kind;
  std::string name;
};

std::vector<std::string> lines_of(const std::string& command) {
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  char buffer[4096];
  while (const std::size_t got = fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, got);
  pclose(pipe);
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

// By nm, demangled: "address kind name", the address blank where the symbol is undefined.
std::vector<Symbol> symbols() {
  std::vector<Symbol> result;
  for (const std::string& line : lines_of("nm --demangle \"" KRAIT_ARCHIVE "\" 2>/dev/null")) {
    if (line.size() < 20 || line[16] != ' ' || line[18] != ' ') continue;
    result.push_back({line[17], line.substr(19)});
  }
  return result;
}

TEST(Symbols, ArchiveIsRead) {
  std::set<std::string> defined;
  for (const Symbol& s : symbols()) {
    if (s.kind == 'T') defined.insert(s.name);
  }
  EXPECT_EQ(defined.count("krait::atan2(float, float)"), 1U);
  EXPECT_EQ(defined.count("krait::Scene::open(void const*, unsigned long, krait::Scene&)"), 1U);
  EXPECT_GT(defined.size(), 40U);
}

TEST(Symbols, NothingForbiddenIsDefinedOrAskedFor) {
  const std::set<std::string> forbidden = {"malloc",
                                           "calloc",
                                           "realloc",
                                           "free",
                                           "aligned_alloc",
                                           "posix_memalign",
                                           "abort",
                                           "exit",
                                           "__cxa_throw",
                                           "__cxa_allocate_exception",
                                           "__cxa_begin_catch",
                                           "__cxa_rethrow",
                                           "__gxx_personality_v0",
                                           "__cxa_pure_virtual",
                                           "__dynamic_cast",
                                           "__cxa_guard_acquire",
                                           "__cxa_atexit",
                                           "printf",
                                           "fprintf",
                                           "snprintf",
                                           "vsnprintf",
                                           "puts",
                                           "fopen",
                                           "fwrite",
                                           "time",
                                           "clock",
                                           "rand",
                                           "qsort",
                                           "sin",
                                           "cos",
                                           "tan",
                                           "sincos",
                                           "atan",
                                           "atan2",
                                           "log",
                                           "exp",
                                           "pow",
                                           "hypot",
                                           "fmod",
                                           "sinf",
                                           "cosf",
                                           "tanf",
                                           "sincosf",
                                           "atanf",
                                           "atan2f",
                                           "logf",
                                           "expf",
                                           "powf",
                                           "hypotf",
                                           "fmodf",
                                           "fmaf",
                                           "fma",
                                           "b2Alloc",
                                           "b2Free",
                                           "b2Log"};
  const std::vector<std::string> prefixes = {"operator new", "operator delete", "_Unwind",
                                             "typeinfo",     "vtable",          "std::"};
  for (const Symbol& s : symbols()) {
    const std::string plain = s.name.substr(0, s.name.find('@'));
    EXPECT_EQ(forbidden.count(plain), 0U) << s.kind << " " << s.name;
    for (const std::string& prefix : prefixes) EXPECT_NE(s.name.rfind(prefix, 0), 0U) << s.kind << " " << s.name;
  }
}

// But for a constant of Box2D's that only its type keeps out of read-only memory.
TEST(Symbols, NoWritableGlobals) {
  int objects = 0;
  for (const std::string& line : lines_of("objdump --syms --demangle \"" KRAIT_ARCHIVE "\"")) {
    if (line.find(" O ") == std::string::npos) continue;
    ++objects;
    if (line.find("b2Vec2_zero") != std::string::npos) continue;
    EXPECT_EQ(line.find(" .bss"), std::string::npos) << line;
    const std::size_t data = line.find(" .data");
    EXPECT_TRUE(data == std::string::npos || line.compare(data, 13, " .data.rel.ro") == 0) << line;
  }
  EXPECT_GT(objects, 3);
}

TEST(Symbols, EverythingDefinedIsInOurNamespace) {
  for (const Symbol& s : symbols()) {
    if (std::string("TWV").find(s.kind) == std::string::npos) continue;
    EXPECT_NE(s.name.find("krait::"), std::string::npos) << s.name;
  }
}

TEST(Symbols, UndefinedAreOursOrOfAShortList) {
  const std::set<std::string> allowed = {"memcpy", "memset", "memmove",       "memcmp",
                                         "strcmp", "sqrtf",  "__popcountdi2", "_GLOBAL_OFFSET_TABLE_"};
  for (const Symbol& s : symbols()) {
    if (s.kind != 'U') continue;
    EXPECT_TRUE(s.name.rfind("krait::", 0) == 0 || allowed.count(s.name) == 1) << s.name;
  }
}

}  // namespace
}  // namespace krait
