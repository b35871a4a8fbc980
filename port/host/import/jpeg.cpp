// SPDX-License-Identifier: Apache-2.0
// JPEG by TurboJPEG, whose functions return codes. Damaged and truncated data is refused, not guessed at.
#include <turbojpeg.h>

#include <memory>

#include "host/import/image.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {
namespace {

struct Close {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using Handle = std::unique_ptr<void, Close>;

[[noreturn]] void fail(const Handle& handle, const std::string& file) {
  throw InputError(file + ": is not a sound JPEG: " + tjGetErrorStr2(handle.get()));
}

// A block of 64 pixels has at least one bit: a header that promises more than twice as many pixels lies.
void require_plausible(std::uint64_t columns, std::uint64_t rows, std::size_t bytes, const std::string& file) {
  require_cells(columns, rows, file);
  if (columns * rows <= 1024 * std::uint64_t{bytes}) return;
  throw InputError(file + ": is not a sound JPEG: too short for the size that its header says");
}

}  // namespace

bool is_jpeg(const std::string& content) { return content.starts_with("\xFF\xD8\xFF"); }

Image decode_jpeg(const std::string& content, const std::string& file) {
  const Handle handle(tjInitDecompress());
  if (!handle) throw std::bad_alloc();
  const auto* bytes = reinterpret_cast<const unsigned char*>(content.data());
  int columns = 0;
  int rows = 0;
  int subsampling = 0;
  int colors = 0;
  if (tjDecompressHeader3(handle.get(), bytes, content.size(), &columns, &rows, &subsampling, &colors) != 0) {
    fail(handle, file);
  }
  const bool inked = colors == TJCS_CMYK || colors == TJCS_YCCK;
  if (inked) throw InputError(file + ": is a JPEG in CMYK: save it in grey or RGB");
  if (columns < 1 || rows < 1) throw InputError(file + ": is not a sound JPEG: it ends before its picture begins");
  require_plausible(static_cast<std::uint64_t>(columns), static_cast<std::uint64_t>(rows), content.size(), file);
  const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  std::vector<unsigned char> channels(3 * count);
  constexpr int kFlags = TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS;
  if (tjDecompress2(handle.get(), bytes, content.size(), channels.data(), columns, 0, rows, TJPF_RGB, kFlags) != 0) {
    fail(handle, file);
  }
  Image image{columns, rows, false, std::vector<Pixel>(count), true};
  for (std::size_t i = 0; i < count; ++i) {
    const auto channel = [&](std::size_t k) { return static_cast<std::uint16_t>(257 * channels[3 * i + k]); };
    image.pixels[i] = {channel(0), channel(1), channel(2), 65535};
  }
  return image;
}

}  // namespace krait::host
