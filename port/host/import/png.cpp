// SPDX-License-Identifier: Apache-2.0
#include <png.h>

#include <bit>
#include <cstdio>
#include <cstring>

#include "host/import/image.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {
namespace {

constexpr std::size_t kSignatureBytes = 8;

// What libpng's callbacks see.
struct Input {
  const std::string& content;
  std::size_t offset = 0;
  char message[128] = {};
};

void on_error(png_structp png, png_const_charp message) {
  auto* input = static_cast<Input*>(png_get_error_ptr(png));
  std::snprintf(input->message, sizeof input->message, "%s", message);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_read(png_structp png, png_bytep target, std::size_t count) {
  auto* input = static_cast<Input*>(png_get_io_ptr(png));
  if (count > input->content.size() - input->offset) png_error(png, "ends early");
  std::memcpy(target, input->content.data() + input->offset, count);
  input->offset += count;
}

struct Reader {
  explicit Reader(Input& input)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &input, on_error, on_warning)),
        info(png == nullptr ? nullptr : png_create_info_struct(png)) {
    if (info != nullptr) png_set_read_fn(png, &input, on_read);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }

  png_structp png;
  png_infop info;
};

// libpng leaves the two functions below by longjmp: nothing in them has a destructor.
bool read_header(png_structp png, png_infop info) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_read_info(png, info);
  return true;
}

// Every kind of pixel becomes four 16-bit channels in the machine's byte order.
bool read_pixels(png_structp png, png_infop info, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_expand(png);
  png_set_expand_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xFFFF, PNG_FILLER_AFTER);
  if (std::endian::native == std::endian::little) png_set_swap(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  return true;
}

// Deflate packs at most 1032 bytes into one: a header that promises more lies.
void require_plausible(const Reader& reader, const std::string& content, const std::string& file) {
  const std::uint64_t rows = png_get_image_height(reader.png, reader.info);
  require_cells(png_get_image_width(reader.png, reader.info), rows, file);
  if (rows * png_get_rowbytes(reader.png, reader.info) > 1032 * std::uint64_t{content.size()}) {
    throw InputError(file + ": is not a sound PNG: too short for the size that its header says");
  }
}

}  // namespace

bool is_png(const std::string& content) {
  return content.size() >= kSignatureBytes &&
         png_sig_cmp(reinterpret_cast<png_const_bytep>(content.data()), 0, kSignatureBytes) == 0;
}

Image decode_png(const std::string& content, const std::string& file) {
  Input input{content};
  const Reader reader(input);
  if (reader.info == nullptr) throw std::bad_alloc();
  const auto fail = [&] { throw InputError(file + ": is not a sound PNG: " + input.message); };
  if (!read_header(reader.png, reader.info)) fail();
  require_plausible(reader, content, file);

  Image image;
  image.columns = static_cast<int>(png_get_image_width(reader.png, reader.info));
  image.rows = static_cast<int>(png_get_image_height(reader.png, reader.info));
  image.has_alpha = (png_get_color_type(reader.png, reader.info) & PNG_COLOR_MASK_ALPHA) != 0 ||
                    png_get_valid(reader.png, reader.info, PNG_INFO_tRNS) != 0;
  const auto columns = static_cast<std::size_t>(image.columns);
  image.pixels.resize(columns * static_cast<std::size_t>(image.rows));
  std::vector<png_bytep> rows(static_cast<std::size_t>(image.rows));
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = reinterpret_cast<png_bytep>(&image.pixels[i * columns]);
  if (!read_pixels(reader.png, reader.info, rows.data())) fail();
  return image;
}

}  // namespace krait::host
