// SPDX-License-Identifier: Apache-2.0
// Writes small JPEGs.
#pragma once

#include <turbojpeg.h>

#include <string>

namespace krait::host {

// Of red, green, blue in bytes, the top row first.
inline std::string jpeg(int columns, int rows, int subsampling, int quality, const std::string& rgb, int flags = 0) {
  void* handle = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  tjCompress2(handle, reinterpret_cast<const unsigned char*>(rgb.data()), columns, 0, rows, TJPF_RGB, &bytes, &size,
              subsampling, quality, flags);
  std::string content(reinterpret_cast<char*>(bytes), size);
  tjFree(bytes);
  tjDestroy(handle);
  return content;
}

}  // namespace krait::host
