// SPDX-License-Identifier: Apache-2.0
#include "host/input/file.hpp"

#include <fcntl.h>
#include <linux/magic.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "host/input/interrupt.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {
namespace {

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

[[noreturn]] void fail(const std::string& path, const char* action, int error) {
  throw InputError((path.empty() ? "\"\"" : path) + ": cannot be " + action + ": " + std::strerror(error));
}

void write_all(int descriptor, const std::string& path, const std::string& content) {
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t count = ::write(descriptor, content.data() + done, content.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path, "written", errno);
    done += static_cast<std::size_t>(count);
  }
}

const char* kind_of(mode_t mode) {
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return S_ISBLK(mode) ? "a block device" : "a character device";
}

// A pipe without a name, which the shell has opened: /dev/stdout before a |, or >(…).
bool is_pipe_of_the_shell(const std::string& path) {
  struct statfs system = {};
  return ::statfs(path.c_str(), &system) == 0 && system.f_type == PIPEFS_MAGIC;
}

// A named pipe without a reader would never be opened, and a block device holds something else than files.
void require_writable_kind(const std::string& path, mode_t mode) {
  if (S_ISREG(mode) || S_ISCHR(mode) || (S_ISFIFO(mode) && is_pipe_of_the_shell(path))) return;
  const std::string kind = S_ISFIFO(mode) ? "a named pipe" : kind_of(mode);
  throw InputError(path + ": cannot be written: is " + kind + ", not a regular file");
}

// Removes the temporary unless it became the file.
struct Temporary {
  std::string path;
  bool renamed = false;
  ~Temporary() {
    if (!renamed) ::unlink(path.c_str());
  }
};

// While it lives, Ctrl-C and its like wait: no temporary is left behind.
class Undisturbed {
 public:
  Undisturbed() {
    sigset_t ending;
    ::sigemptyset(&ending);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaddset(&ending, signal);
    ::pthread_sigmask(SIG_BLOCK, &ending, &before_);
  }
  Undisturbed(const Undisturbed&) = delete;
  Undisturbed& operator=(const Undisturbed&) = delete;
  ~Undisturbed() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

// O_NONBLOCK: opening a terminal does not wait for its other end.
void write_device(const std::string& path, const std::string& content) {
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (file.number() < 0 || ::fcntl(file.number(), F_SETFL, 0) != 0) fail(path, "written", errno);
  write_all(file.number(), path, content);
}

// `replaced` is what there is at `target`; null: nothing.
void replace_file(const std::string& path, const std::string& target, const struct stat* replaced,
                  const std::string& content) {
  static unsigned serial = 0;
  const Undisturbed undisturbed;
  const std::string name = target + ".part" + std::to_string(::getpid()) + "-" + std::to_string(serial++);
  Descriptor file(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (file.number() < 0) fail(path, "written", errno);
  Temporary temporary{name};
  if (replaced != nullptr && ::fchmod(file.number(), replaced->st_mode & 0777U) != 0) fail(path, "written", errno);
  write_all(file.number(), path, content);
  if (::fsync(file.number()) != 0) fail(path, "written", errno);
  if (::close(file.release()) != 0) fail(path, "written", errno);
  if (std::rename(name.c_str(), target.c_str()) != 0) fail(path, "written", errno);
  temporary.renamed = true;
}

}  // namespace

std::string read_file(const std::string& path, std::uint64_t most) {
  // O_NONBLOCK: opening a FIFO without a writer returns at once and is then refused as no regular file.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (file.number() < 0) fail(path, "read", errno);
  struct stat status = {};
  if (::fstat(file.number(), &status) != 0) fail(path, "read", errno);
  if (S_ISDIR(status.st_mode)) throw InputError(path + ": is a directory, not a file");
  if (!S_ISREG(status.st_mode)) {
    throw InputError(path + ": is not a regular file but " + kind_of(status.st_mode) +
                     ": save its content to a file first");
  }
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size == 0) throw InputError(path + ": is empty");
  if (size > most) {
    throw InputError(path + ": has " + std::to_string(size) + " bytes; at most " + std::to_string(most) + " are read");
  }
  std::string content(size, '\0');
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t count = ::read(file.number(), content.data() + done, content.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path, "read", errno);
    if (count == 0) throw InputError(path + ": became shorter while it was read");
    done += static_cast<std::size_t>(count);
  }
  return content;
}

std::string led_to(const std::string& path) {
  constexpr int kMostLinks = 40;  // of a system that follows them
  std::filesystem::path target = path;
  std::error_code none;
  for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(target, none); ++i) {
    target = target.parent_path() / std::filesystem::read_symlink(target, none);
  }
  return target.string();
}

void check_writable(const std::string& path) {
  struct stat status = {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (!exists && errno == ELOOP) fail(path, "written", ELOOP);
  if (exists && S_ISDIR(status.st_mode)) throw InputError(path + ": cannot be written: is a directory");
  if (exists) require_writable_kind(path, status.st_mode);
  std::error_code nowhere;  // then the folder is "", which cannot be written to
  const std::string folder = std::filesystem::absolute(led_to(path), nowhere).parent_path().string();
  const std::string& written = exists && !S_ISREG(status.st_mode) ? path : folder;
  if (::access(written.c_str(), W_OK) != 0) fail(path, "written", errno);
}

void write_file(const std::string& path, const std::string& content) {
  check_writable(path);
  struct stat status = {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode)) return write_device(path, content);
  replace_file(path, led_to(path), exists ? &status : nullptr, content);
}

void write_files(const std::vector<FileText>& files) {
  const Interrupt too_late;
  for (const FileText& file : files) write_file(file.path, file.text);
}

}  // namespace krait::host
