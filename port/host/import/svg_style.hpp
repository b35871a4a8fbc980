// SPDX-License-Identifier: Apache-2.0
// What of an SVG element's looks matters to a map: its place, whether it is filled and seen, and its role.
#pragma once

#include <pugixml.hpp>
#include <string>

#include "host/import/affine.hpp"
#include "host/import/drawing.hpp"
#include "host/import/fill.hpp"
#include "host/import/svg_scanner.hpp"

namespace krait::host {

// Throws InputError "FILE: line N: <name id="…">: ATTRIBUTE: …".
class SvgPlaces {
 public:
  SvgPlaces(const std::string& file, const std::string& content) : file_(file), content_(content) {}

  [[noreturn]] void fail(const pugi::xml_node& element, const std::string& what) const;
  SvgScanner scan(const pugi::xml_node& element, const char* attribute) const;

  // A length in user units, 96 an inch; `usual` where the attribute is missing.
  double length(const pugi::xml_node& element, const char* attribute, double usual = 0) const;

 private:
  const std::string& file_;
  const std::string& content_;
};

// User units, 96 an inch, in a unit's name; 0 where it is not an absolute one.
double svg_unit(std::string_view name);

// What elements inherit.
struct SvgStyle {
  Affine place;           // of the element's coordinates, in metres
  bool is_filled = true;  // also where nothing says so
  FillRule rule = FillRule::nonzero;
  bool is_shown = true;    // nothing in what is not shown is seen
  bool is_visible = true;  // what is in it may be, where it says so
  Role role = Role::obstacle;

  SvgStyle of(const pugi::xml_node& element, const SvgPlaces& places) const;
};

// Refuses what CSS says of a shape's or a group's place and size, and what moves its transform elsewhere.
void check_placing(const pugi::xml_node& element, const SvgPlaces& places);

// The element's <title>, else its id, else nothing; safe to print.
std::string svg_name(const pugi::xml_node& element);

}  // namespace krait::host
