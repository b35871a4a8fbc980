# SPDX-License-Identifier: Apache-2.0
# cmake -DOUTPUT=shipped_files.cpp -DDIRECTORY=robots -DNAMES=a,b -P embed.cmake
# Writes the shipped robots' files as a table of names and texts.
set(text "// Made by embed.cmake.\n#include \"host/robot_file/shipped.hpp\"\n\nnamespace krait::host {\n\n")
string(APPEND text "const std::vector<ShippedRobot>& shipped_robots() {\n  static const std::vector<ShippedRobot> all = {\n")
string(REPLACE "," ";" names "${NAMES}")
foreach(name ${names})
  file(READ ${DIRECTORY}/${name}.json content)
  string(APPEND text "      {\"${name}\", R\"krait(${content})krait\"},\n")
endforeach()
string(APPEND text "  };\n  return all;\n}\n\n}  // namespace krait::host\n")
file(WRITE ${OUTPUT} "${text}")
