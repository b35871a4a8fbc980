// SPDX-License-Identifier: Apache-2.0
// A scene file that is cut short or damaged is refused, at every length and every byte.
#include "host/cli/program.hpp"
#include "krait/scene.hpp"

namespace krait::host {
namespace {

class CliSceneFile : public CliTest {
 protected:
  CliSceneFile() : bytes_(read_text(path("room.krait"))) {}

  // Opens from memory of exactly that size, so that a sanitizer sees any byte read beyond it.
  static Status open(const std::string& bytes) {
    std::vector<std::uint32_t> words((bytes.size() + 3) / 4);
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(words.data()));
    krait::Scene scene;
    return krait::Scene::open(words.data(), bytes.size(), scene).status;
  }

  std::string bytes_;
};

TEST_F(CliSceneFile, Opens) { EXPECT_EQ(open(bytes_), Status::ok); }

TEST_F(CliSceneFile, IsRefusedAtEveryShorterLength) {
  for (std::size_t length = 0; length < bytes_.size(); ++length) {
    ASSERT_EQ(open(bytes_.substr(0, length)), Status::bad_scene) << length << " bytes";
  }
}

TEST_F(CliSceneFile, IsRefusedWithAnyByteChanged) {
  for (std::size_t i = 0; i < bytes_.size(); ++i) {
    std::string changed = bytes_;
    changed[i] = static_cast<char>(changed[i] ^ 0x10);
    ASSERT_EQ(open(changed), Status::bad_scene) << "byte " << i;
  }
}

TEST_F(CliSceneFile, IsRefusedWithBytesAfterItsEnd) { EXPECT_EQ(open(bytes_ + "more"), Status::bad_scene); }

TEST_F(CliSceneFile, EveryCommandRefusesItInOneLine) {
  const std::size_t size = bytes_.size();
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{1}, std::size_t{4}, std::size_t{100}, std::size_t{216}, size / 2, size - 1}) {
    write("cut.krait", bytes_.substr(0, length));
    expect_refused({"info", "cut.krait"}, "cut.krait");
    expect_refused({"plan", "cut.krait", "-o", "plan.json"}, "cut.krait");
    expect_refused({"verify", "cut.krait", "room.json"}, "cut.krait");
    expect_refused({"compile", "cut.krait", "-o", "x.krait"}, "cut.krait");
  }
  std::string changed = bytes_;
  changed[size / 2] = static_cast<char>(changed[size / 2] ^ 1);
  write("changed.krait", changed);
  expect_refused({"info", "changed.krait"}, "bad_scene");
  expect_refused({"plan", "changed.krait", "-o", "plan.json"}, "bad_scene");
}

}  // namespace
}  // namespace krait::host
