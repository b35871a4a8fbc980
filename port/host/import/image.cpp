// SPDX-License-Identifier: Apache-2.0
#include "host/import/image.hpp"

#include "host/input/file.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {
namespace {

constexpr std::uint64_t kMaxFileBytes = 8 * kMaxCells;  // 16-bit RGBA without compression

}  // namespace

void require_cells(std::uint64_t columns, std::uint64_t rows, const std::string& file) {
  if (columns >= 1 && rows >= 1 && columns <= kMaxCells && rows <= kMaxCells && columns * rows <= kMaxCells) return;
  throw InputError(file + ": " + std::to_string(columns) + " x " + std::to_string(rows) +
                   " cells: a map must have from 1 to " + std::to_string(kMaxCells));
}

bool is_image(const std::string& content) {
  return is_pgm(content) || is_png(content) || is_bmp(content) || is_jpeg(content);
}

Image decode_image(const std::string& content, const std::string& file) {
  if (is_pgm(content)) return decode_pgm(content, file);
  if (is_png(content)) return decode_png(content, file);
  if (is_bmp(content)) return decode_bmp(content, file);
  if (is_jpeg(content)) return decode_jpeg(content, file);
  throw InputError(file + ": is no PGM (P2 or P5), PNG, BMP or JPEG image; convert it to one");
}

Image read_image(const std::string& path) { return decode_image(read_file(path, kMaxFileBytes), path); }

}  // namespace krait::host
