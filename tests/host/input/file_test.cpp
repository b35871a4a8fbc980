#include "host/input/file.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "../scratch.hpp"

namespace krait::host {
namespace {

using testing::HasSubstr;

class FileTest : public ScratchTest {
 protected:
  std::string read_error(const std::string& name, std::uint64_t most = 100) const {
    return error_of([&] { read_file(path(name), most); });
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(directory()), {}));
  }
};

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST_F(FileTest, ReadsEveryByte) {
  const std::string bytes("a\0\r\nb\xFF", 6);
  EXPECT_EQ(read_file(write("f", bytes), 6), bytes);
}

TEST_F(FileTest, RefusesWhatIsNoReadableFile) {
  write("empty", "");
  write("large", std::string(101, 'x'));
  std::filesystem::create_directory(path("folder"));
  std::filesystem::create_symlink("loop", path("loop"));
  ASSERT_EQ(::mkfifo(path("fifo").c_str(), 0600), 0);
  EXPECT_THAT(read_error("none"), HasSubstr("none: cannot be read: No such file"));
  EXPECT_THAT(read_error("empty"), HasSubstr("is empty"));
  EXPECT_THAT(read_error("large"), HasSubstr("has 101 bytes; at most 100"));
  EXPECT_THAT(read_error("folder"), HasSubstr("is a directory"));
  EXPECT_THAT(read_error("loop"), HasSubstr("symbolic links"));
  EXPECT_THAT(read_error("fifo"), HasSubstr("is not a regular file"));
}

TEST_F(FileTest, ReplacesAFileAndLeavesNoTemporary) {
  write("f", "old");
  write_file(path("f"), "new");
  EXPECT_EQ(content_of(path("f")), "new");
  EXPECT_EQ(files(), 1U);
}

TEST_F(FileTest, WritesThroughASymbolicLink) {
  write("target", "old");
  std::filesystem::create_symlink("target", path("link"));
  write_file(path("link"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  EXPECT_EQ(content_of(path("target")), "new");
}

TEST_F(FileTest, WritesToADeviceWithoutReplacingIt) {
  write_file("/dev/null", "gone");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(FileTest, SaysWhereItCannotWrite) {
  EXPECT_THAT(error_of([&] { write_file(path("no/such"), "x"); }), HasSubstr("no/such: cannot be written: No such"));
  EXPECT_THAT(error_of([&] { write_file(directory().string(), "x"); }), HasSubstr("is a directory"));
  EXPECT_THAT(error_of([&] { write_file("/dev/full", "x"); }), HasSubstr("No space left"));
}

TEST_F(FileTest, KeepsTheOldFileWhenTheNewOneDoesNotFit) {
  write("f", "old");
  const rlimit small = {100, RLIM_INFINITY};
  rlimit before = {};
  ::getrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_IGN);
  ::setrlimit(RLIMIT_FSIZE, &small);
  const std::string error = error_of([&] { write_file(path("f"), std::string(1000, 'x')); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_THAT(error, HasSubstr("cannot be written: File too large"));
  EXPECT_EQ(content_of(path("f")), "old");
  EXPECT_EQ(files(), 1U);
}

}  // namespace
}  // namespace krait::host
