// SPDX-License-Identifier: Apache-2.0
// Every file of scene_evils.hpp, with the right check sum: the answer names the section and the element.
#include <gtest/gtest.h>

#include "scene_evils.hpp"

namespace krait::test::scene_evil_test {
namespace {

using evil::Evil;
using format::Header;

class SceneEvil : public ::testing::TestWithParam<Evil> {};

TEST_P(SceneEvil, IsRejectedWithSectionAndElement) {
  SceneBytes bytes = evil::sound().bytes();
  Scene scene;
  ASSERT_TRUE(Scene::open(bytes.data(), bytes.size(), scene).ok());
  GetParam().spoil(bytes);
  bytes.repair_crc();
  const Failure failure = Scene::open(bytes.data(), bytes.size(), scene);
  EXPECT_EQ(failure.status, Status::bad_scene);
  EXPECT_EQ(int{failure.section}, int{GetParam().section});
  EXPECT_EQ(failure.element, GetParam().element);
}

INSTANTIATE_TEST_SUITE_P(Files, SceneEvil, ::testing::ValuesIn(evil::all_evils()),
                         [](const auto& evil) { return evil.param.name; });

TEST(SceneEvilSum, WrongSumIsNamed) {
  SceneBytes bytes = evil::sound().bytes();
  bytes.put(offsetof(Header, crc32), bytes.get<std::uint32_t>(offsetof(Header, crc32)) ^ 1U);
  Scene scene;
  const Failure failure = Scene::open(bytes.data(), bytes.size(), scene);
  EXPECT_EQ(failure.element, offsetof(Header, crc32));
}

// As many slivers as a byte of the file allows.
TEST(SceneEvilSlivers, AFewOnEachOtherAreTaken) {
  const SceneBytes bytes = evil::slivers(10).bytes();
  Scene scene;
  EXPECT_TRUE(Scene::open(bytes.data(), bytes.size(), scene).ok());
}

// 16-bit indices cannot name what 65,535 elements and more hold.
TEST(SceneEvilCounts, ManyWithNarrowIndicesAreRejected) {
  SceneBytes bytes = evil::sound().bytes();
  bytes.put(offsetof(Header, vertices), std::uint32_t{65535});
  bytes.repair_crc();
  Scene scene;
  const Failure failure = Scene::open(bytes.data(), bytes.size(), scene);
  EXPECT_EQ(failure.status, Status::bad_scene);
  EXPECT_EQ(failure.element, offsetof(Header, vertices));
}

}  // namespace
}  // namespace krait::test::scene_evil_test
