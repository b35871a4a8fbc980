// SPDX-License-Identifier: Apache-2.0
// Writes small JPEGs.
#pragma once

#include <turbojpeg.h>

#include <string>

namespace krait::host {

// Of red, green, blue in bytes, or of what `format` says, the top row first.
inline std::string jpeg(int columns, int rows, int subsampling, int quality, const std::string& pixels, int flags = 0,
                        int format = TJPF_RGB) {
  void* handle = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  tjCompress2(handle, reinterpret_cast<const unsigned char*>(pixels.data()), columns, 0, rows, format, &bytes, &size,
              subsampling, quality, flags);
  std::string content(reinterpret_cast<char*>(bytes), size);
  tjFree(bytes);
  tjDestroy(handle);
  return content;
}

}  // namespace krait::host
