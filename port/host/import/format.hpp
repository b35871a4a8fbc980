// SPDX-License-Identifier: Apache-2.0
// One file format of maps: how to recognise it and how to read it.
#pragma once

#include <string>
#include <string_view>

#include "host/import/import.hpp"

namespace krait::host {

struct Source {
  std::string path;
  std::string content;
};

// The place of a content's first character behind white space and a byte order mark; npos where there is none.
inline std::size_t text_begin(std::string_view content) { return content.find_first_not_of(" \t\r\n\xEF\xBB\xBF"); }

// The import options that a format has a use for.
struct Uses {
  bool unknown = false;
  bool unit = false;
  bool datum = false;
};

struct Format {
  const char* name;
  const char* extension;                    // a name ends with it: who else has no content to go by is of this format
  bool (*recognise)(const Source& source);  // by content; cheap, true for broken files of the format too
  Workspace (*read)(const Source& source, const ImportOptions& options);  // throws InputError
  Uses uses = {};
};

// Whether a format recognises the source, a compiled scene's among them.
bool is_map(const Source& source);

// By the format that recognises the source. Throws InputError, also where none does.
Workspace read_workspace(const Source& source, const ImportOptions& options);

extern const Format kSceneFile;
extern const Format kNative;
extern const Format kMapServer;
extern const Format kMovingAi;
extern const Format kDynobench;
extern const Format kTpcap;
extern const Format kGeoJson;
extern const Format kSvg;

}  // namespace krait::host
