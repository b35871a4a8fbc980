# SPDX-License-Identifier: Apache-2.0
# cmake -DOUTPUT=page_files.cpp -DDIRECTORY=page -P embed.cmake
# Writes the files of the replay page as string literals.
set(text "// Made by embed.cmake.\n#include \"host/picture/page_files.hpp\"\n\nnamespace krait::host::page {\n")
foreach(file index.html style.css replay.js)
  string(REPLACE "." "_" name ${file})
  file(READ ${DIRECTORY}/${file} content)
  string(APPEND text "\nconst std::string_view ${name} = R\"krait(${content})krait\";\n")
endforeach()
string(APPEND text "\n}  // namespace krait::host::page\n")
file(WRITE ${OUTPUT} "${text}")
