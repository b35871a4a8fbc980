// SPDX-License-Identifier: Apache-2.0
// Scene::open in a page that cannot be written, with a page behind it that cannot be read: like flash.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>

#include "decomposition/locate.hpp"
#include "scene_builder.hpp"

namespace krait::test::scene_memory_test {
namespace {

// A copy of the bytes that ends where an unreadable page begins, read-only itself.
class Flash {
 public:
  explicit Flash(const SceneBytes& bytes) : size_(bytes.size()) {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    pages_ = (size_ + page - 1) / page * page;
    map_ = static_cast<std::uint8_t*>(
        mmap(nullptr, pages_ + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    whole_ = pages_ + page;
    std::copy_n(bytes.data(), size_, data_at(0));
    mprotect(map_, pages_, PROT_READ);
    mprotect(map_ + pages_, page, PROT_NONE);
  }
  ~Flash() { munmap(map_, whole_); }
  Flash(const Flash&) = delete;
  Flash& operator=(const Flash&) = delete;

  // The last `size() - offset` bytes.
  std::uint8_t* data_at(std::size_t offset) const { return map_ + pages_ - size_ + offset; }
  std::size_t size() const { return size_; }

 private:
  std::uint8_t* map_;
  std::size_t size_, pages_, whole_;
};

Room room() {
  Room result = random_room(11);
  result.starts = {{1.0F, 1.0F, 0.0F, 0, 0}};
  return result;
}

TEST(SceneMemory, OpensAndIsUsedInReadOnlyMemoryBeforeAGuardPage) {
  const Flash flash(data_of(room()).bytes());
  Scene scene;
  ASSERT_TRUE(Scene::open(flash.data_at(0), flash.size(), scene).ok());
  std::mt19937 random(1);
  int found = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Vec2 p{uniform_float(random, -1, 13), uniform_float(random, -1, 13)};
    found += detail::locate(scene, p) != kNone ? 1 : 0;
    EXPECT_GE(scene.clearance().at(p), 0.0F);
  }
  EXPECT_GT(found, 1000);
  EXPECT_STREQ(scene.start_name(0), "start0");
}

TEST(SceneMemory, EveryTruncationReadsNothingBehindItsBytes) {
  const SceneBytes whole = data_of(room()).bytes();
  // Cut to `size` and moved to the end of the page: whatever is read behind the cut faults.
  for (std::size_t size = 0; size < whole.size(); size += size < 600 ? 4 : 212) {
    SceneBytes cut(size);
    std::copy_n(whole.data(), size, cut.data());
    const Flash flash(cut);
    Scene scene;
    ASSERT_EQ(Scene::open(flash.data_at(0), size, scene).status, Status::bad_scene) << size;
  }
}

// The length and the sum say that the file is whole: only the counts betray that it is not.
TEST(SceneMemory, TruncationWithRightLengthAndSumReadsNothingBehindItsBytes) {
  const SceneBytes whole = data_of(room()).bytes();
  for (std::size_t size = sizeof(format::Header); size < whole.size(); size += 52) {
    SceneBytes cut(size);
    std::copy_n(whole.data(), size, cut.data());
    cut.put(offsetof(format::Header, total_bytes), static_cast<std::uint32_t>(size));
    cut.repair_crc();
    const Flash flash(cut);
    Scene scene;
    ASSERT_EQ(Scene::open(flash.data_at(0), size, scene).status, Status::bad_scene) << size;
  }
}

}  // namespace
}  // namespace krait::test::scene_memory_test
