// SPDX-License-Identifier: Apache-2.0
// The picture of a map, PGM, PNG, BMP or JPEG by its content: one line or a picture of the size that it says.
#include <string>

#include "harness.hpp"
#include "host/import/image.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::fuzz {
namespace {

struct Kind {
  bool (*is)(const std::string& content);
  Outcomes outcomes;
};
Kind kinds[] = {{host::is_pgm, Outcomes("PGM")},
                {host::is_png, Outcomes("PNG")},
                {host::is_bmp, Outcomes("BMP")},
                {host::is_jpeg, Outcomes("JPEG")}};

void look_at(const std::string& content, Landmark Outcomes::*outcome) {
  for (Kind& kind : kinds) {
    if (kind.is(content)) (kind.outcomes.*outcome).reach();
  }
}

}  // namespace
}  // namespace krait::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace krait::fuzz;
  const std::string content(reinterpret_cast<const char*>(data), size);
  try {
    const krait::host::Image image = krait::host::decode_image(content, "image");
    const auto pixels = static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows);
    require(pixels > 0 && image.pixels.size() == pixels, "a picture whose size lies");
    look_at(content, &Outcomes::accepted);
  } catch (const krait::host::InputError& error) {
    look_at(content, &Outcomes::refused);
    require(std::string(error.what()).find('\n') == std::string::npos, "an error of more than one line");
  }
  return 0;
}
