// SPDX-License-Identifier: Apache-2.0
// Files that are no map at all, and maps made to hurt.
#include <gmock/gmock.h>

#include <random>

#include "../scratch.hpp"
#include "host/import/import.hpp"

namespace krait::host::import_bad_input_test {
namespace {

using testing::HasSubstr;

class BadInputTest : public ScratchTest {
 protected:
  std::string error(const std::string& name, const std::string& content) const {
    return error_of([&] { import_workspace(write(name, content), {}); });
  }
};

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

TEST_F(BadInputTest, FilesThatAreNoMapAreRefused) {
  EXPECT_THAT(error_of([&] { import_workspace(path("none.yaml"), {}); }), HasSubstr("none.yaml: cannot be read"));
  EXPECT_THAT(error_of([&] { import_workspace(directory().string(), {}); }), HasSubstr("is a directory"));
  EXPECT_THAT(error("empty.json", ""), HasSubstr("is empty"));
  EXPECT_THAT(error("a.krait", "KRSC1234"), HasSubstr("is shorter than a scene's header"));
  EXPECT_THAT(error("a.pgm", "P5 1 1 255\nx"), HasSubstr("is an image alone"));
  EXPECT_THAT(error("a.txt", "hello"), HasSubstr("is in no known format; known are"));
}

TEST_F(BadInputTest, DeepNestingEndsInALine) {
  for (const int depth : {100, 1000, 100000}) {
    EXPECT_THAT(error("a.json", R"({"bounds": )" + repeated("[", depth)), HasSubstr("nested deeper than 64"));
    EXPECT_THAT(error("a.json", repeated("{\"a\":", depth)), HasSubstr("nested deeper than 64"));
    EXPECT_THAT(error("a.yaml", "environment: " + repeated("[", depth)), HasSubstr("nested deeper than 64"));
    EXPECT_THAT(error("a.yaml", "environment: " + repeated("{a: ", depth)), HasSubstr("nested deeper than 64"));
  }
  EXPECT_THAT(error("a.yaml", "environment:\n" + repeated("- ", 100000)), HasSubstr("nested deeper than 64"));
  EXPECT_THAT(error("a.yaml", "environment:\n" + repeated("? ", 100000)), HasSubstr("nested deeper than 64"));
  EXPECT_THAT(error("a.yaml", "environment:\n  " + repeated(": ", 100000)), HasSubstr("nested deeper than 64"));
  std::string steps = "environment:\n";
  for (int i = 1; i < 1000; ++i) steps += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  EXPECT_THAT(error("a.yaml", steps), HasSubstr("nested deeper than 64"));
  EXPECT_NE(error("a.yaml", "environment: " + repeated("!a ", 100000)), "");
  EXPECT_NE(error("a.yaml", "environment: " + repeated("&a ", 100000)), "");
}

TEST_F(BadInputTest, ManyKeysEndInALine) {
  std::string keys;
  for (int i = 0; i < 1001; ++i) keys += "  k" + std::to_string(i) + ": 0\n";
  EXPECT_THAT(error("a.yaml", "environment:\n" + keys), HasSubstr("a.yaml: an object has more than 1000 keys"));
}

TEST_F(BadInputTest, AliasesThatMultiplyEndInALine) {
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 20; ++i) {
    const std::string before = std::to_string(i - 1);
    const std::string self = std::to_string(i);
    bomb.append("a").append(self).append(": &a").append(self).append(" [*a").append(before);
    for (int k = 0; k < 9; ++k) bomb.append(", *a").append(before);
    bomb.append("]\n");
  }
  EXPECT_THAT(error("a.yaml", bomb + "environment: *a19\n"), HasSubstr("its aliases make it larger"));
  EXPECT_NE(error("a.yaml", "environment: &a [*a]\n"), "");
}

TEST_F(BadInputTest, OfMoreThanOneYamlDocumentNoneIsRead) {
  const std::string more = "is more than one YAML document; do all its lines begin in the same column?";
  EXPECT_THAT(error("a.yaml", "environment:\n  a: 1\n---\nb: 2\n"), HasSubstr(more));
  EXPECT_THAT(error("a.yaml", " image: a.pgm\nresolution: 1\n"), HasSubstr(more));
  EXPECT_THAT(error("a.yaml", "---\nresolution: 1\n...\n"),
              HasSubstr("a.yaml: image, origin, occupied_thresh, free_thresh: are missing"));
}

TEST_F(BadInputTest, BrokenYamlEndsInALine) {
  for (const char* text : {"environment: [", "environment: \"", "environment: *none", "image: {a", "image: m\n\tb: 1",
                           "environment: 1\n---\n}", "environment:\n- a\nb: c", "image: !!", "image: @x"}) {
    EXPECT_NE(error("a.yaml", text), "") << text;
  }
  EXPECT_THAT(error("a.yaml", std::string("image: a\0b", 10)), HasSubstr("zero bytes"));
  const std::string room = R"({"bounds": {"min": [0, 0], "max": [20, 10]}})";
  EXPECT_EQ(error("a.json", room), "");
  EXPECT_THAT(error("a.json", room + std::string("\0, {", 4)), HasSubstr("a.json: is not JSON: it has zero bytes"));
}

TEST_F(BadInputTest, AByteOrderMarkIsPassedOver) {
  const std::string mark = "\xEF\xBB\xBF";
  for (const auto& [name, content] :
       std::vector<std::pair<std::string, std::string>>{{"a.map", "type octile\nheight 1\nwidth 2\nmap\n..\n"},
                                                        {"a.csv", "1,2,0,4,2,0,0"},
                                                        {"a.json", R"({"bounds": {"min": [0, 0], "max": [20, 10]}})"},
                                                        {"a.yaml", "environment:\n  min: [0, 0]\n  max: [1, 1]\n"},
                                                        {"a.svg", "<svg width=\"9m\"/>"}}) {
    EXPECT_EQ(error(name, mark + content), error(name, content)) << name;
  }
  EXPECT_EQ(error("a.map", mark + "type octile\nheight 1\nwidth 2\nmap\n..\n"), "");
}

TEST_F(BadInputTest, JunkOfAnyKindEndsInALine) {
  std::mt19937 random(7);
  const std::vector<std::string> starts = {
      "", "{", "type octile\n", "image: ", "environment:\n", "P5 ", "\x89PNG\r\n\x1a\n"};
  for (int i = 0; i < 600; ++i) {
    std::string junk = starts[random() % starts.size()];
    const std::size_t size = 1 + random() % 200;
    while (junk.size() < size) {
      junk += i % 2 == 0 ? static_cast<char>(random()) : "[]{}:-,?&*!|>'\"#%@ \n\tab01."[random() % 27];
    }
    EXPECT_NE(error(i % 3 == 0 ? "a.yaml" : "a.bin", junk), "");
  }
}

}  // namespace
}  // namespace krait::host::import_bad_input_test
