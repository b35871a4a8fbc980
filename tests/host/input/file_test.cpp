// SPDX-License-Identifier: Apache-2.0
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
  EXPECT_EQ(read_error("fifo"), path("fifo") + ": is not a regular file but a pipe: save its content to a file first");
  EXPECT_EQ(error_of([] { read_file("/dev/zero", 100); }),
            "/dev/zero: is not a regular file but a character device: save its content to a file first");
  EXPECT_EQ(error_of([] { read_file("", 100); }), "\"\": cannot be read: No such file or directory");
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

TEST_F(FileTest, ALinkToAFileThatThereIsNotYetIsFollowed) {
  std::filesystem::create_directory(path("folder"));
  std::filesystem::create_symlink("folder/next", path("link"));
  std::filesystem::create_symlink("target", path("folder/next"));
  write_file(path("link"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  EXPECT_EQ(content_of(path("folder/target")), "new");

  std::filesystem::create_symlink("gone/target", path("lost"));
  std::filesystem::create_symlink("loop", path("loop"));
  for (const char* name : {"lost", "loop"}) {
    EXPECT_THAT(error_of([&] { check_writable(path(name)); }), HasSubstr(": cannot be written: "));
    EXPECT_THAT(error_of([&] { write_file(path(name), "x"); }), HasSubstr(": cannot be written: "));
    EXPECT_TRUE(std::filesystem::is_symlink(path(name)));
  }
}

TEST_F(FileTest, AFileThatIsReplacedKeepsItsPermissions) {
  for (const mode_t mode : {0600U, 0664U, 0400U}) {
    ASSERT_EQ(::chmod(write("f", "old").c_str(), mode), 0);
    write_file(path("f"), "new");
    struct stat status = {};
    ASSERT_EQ(::stat(path("f").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777U, mode);
    std::filesystem::remove(path("f"));
  }
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

// Neither is opened: without a reader, opening would never end.
TEST_F(FileTest, DoesNotWriteToNamedPipesAndSockets) {
  ASSERT_EQ(::mkfifo(path("fifo").c_str(), 0600), 0);
  ASSERT_EQ(::mknod(path("socket").c_str(), S_IFSOCK | 0600, 0), 0);
  const auto expect_refused = [](const std::string& file, const std::string& kind) {
    const std::string expected = file + ": cannot be written: is " + kind + ", not a regular file";
    EXPECT_EQ(error_of([&] { check_writable(file); }), expected);
    EXPECT_EQ(error_of([&] { write_file(file, "x"); }), expected);
  };
  expect_refused(path("fifo"), "a named pipe");
  expect_refused(path("socket"), "a socket");
}

TEST_F(FileTest, WritesToAPipeThatIsOpenAlready) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const std::string name = "/dev/fd/" + std::to_string(ends[1]);
  EXPECT_EQ(error_of([&] { check_writable(name); }), "");
  write_file(name, "content");
  char text[16];
  EXPECT_EQ(::read(ends[0], text, sizeof text), 7);
  EXPECT_EQ(std::string(text, 7), "content");
  ::close(ends[0]);
  std::signal(SIGPIPE, SIG_IGN);
  EXPECT_EQ(error_of([&] { write_file(name, "content"); }), name + ": cannot be written: Broken pipe");
  ::close(ends[1]);
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
