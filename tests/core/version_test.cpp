// SPDX-License-Identifier: Apache-2.0
// The versions that version.h states are those of the pages.
#include "krait/version.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "krait/format.hpp"
#include "paths.hpp"

namespace krait::test::version_test {
namespace {

std::string page(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(source_path(name)).rdbuf();
  return text.str();
}

TEST(Version, OfTheSceneFormatIsItsPages) {
  const std::string title = "# The bytes of a scene file, version " + std::to_string(format::kVersion) + "\n";
  EXPECT_EQ(page("include/krait/FORMAT.md").substr(0, title.size()), title);
}

TEST(Version, HasAnEntryInTheChanges) {
  const std::string version = std::to_string(KRAIT_VERSION_MAJOR) + "." + std::to_string(KRAIT_VERSION_MINOR) + "." +
                              std::to_string(KRAIT_VERSION_PATCH);
  EXPECT_NE(page("CHANGELOG.md").find("\n## " + version), std::string::npos) << version;
  EXPECT_EQ(KRAIT_VERSION_NUMBER, (KRAIT_VERSION_MAJOR * 100 + KRAIT_VERSION_MINOR) * 100 + KRAIT_VERSION_PATCH);
}

}  // namespace
}  // namespace krait::test::version_test
