// SPDX-License-Identifier: Apache-2.0
// The main function of a program of tests. A program may hold the tests of a whole folder; with --file=NAME_test.cpp it
// runs those of one source. Exit code: 0 all passed, 1 one failed, 2 no source has that name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

namespace {

// Whether all tests of a suite stand in the source, or none. A suite in two sources would be run twice.
bool stands_in(const testing::TestSuite& suite, std::string_view source) {
  int here = 0;
  for (int i = 0; i < suite.total_test_count(); ++i)
    here += std::string_view(suite.GetTestInfo(i)->file()).ends_with(source);
  if (here == 0 || here == suite.total_test_count()) return here > 0;
  std::cerr << "tests: the suite " << suite.name() << " stands in " << source << " and in another source\n";
  std::exit(2);
}

// A filter of GoogleTest for the suites of one source; empty where it has none.
std::string suites_of(std::string_view source) {
  std::string end("/");
  end += source;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  std::string filter;
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    if (stands_in(suite, end)) filter += suite.name() + std::string(".*:");
  }
  return filter;
}

// A filter may be set besides, as by GTEST_FILTER, that excludes tests. One that chooses tests would choose others'.
bool choose_source(std::string_view source) {
  const std::string suites = suites_of(source);
  const std::string asked = GTEST_FLAG_GET(filter);
  const std::size_t excluded = std::min(asked.find('-'), asked.size());
  const std::string chosen = asked.substr(0, excluded);
  if (suites.empty() || !(chosen.empty() || chosen == "*")) return false;
  GTEST_FLAG_SET(filter, suites + asked.substr(excluded));
  return true;
}

}  // namespace

int main(int count, char** arguments) {
  constexpr std::string_view kFile = "--file=";
  testing::InitGoogleMock(&count, arguments);
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = arguments[i];
    if (argument.starts_with(kFile) && choose_source(argument.substr(kFile.size()))) continue;
    std::cerr << "tests: '" << argument << "' is no option, names no source of tests here, or stands beside a filter "
              << "that does not only exclude (-PATTERN)\n";
    return 2;
  }
  return RUN_ALL_TESTS();
}
