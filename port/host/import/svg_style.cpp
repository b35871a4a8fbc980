// SPDX-License-Identifier: Apache-2.0
#include "host/import/svg_style.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "host/input/json.hpp"

namespace krait::host {
namespace {

constexpr std::string_view kSpace = " \t\r\n\f";

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
  return text.substr(0, text.find_last_not_of(kSpace) + 1);
}

// A property of the style attribute; empty where it says nothing of it.
std::string_view declared(const pugi::xml_node& element, std::string_view name) {
  std::string_view style = element.attribute("style").value();
  std::string_view found;
  while (!style.empty()) {
    const std::size_t end = std::min(style.find(';'), style.size());
    const std::string_view declaration = style.substr(0, end);
    const std::size_t colon = declaration.find(':');
    if (colon != std::string_view::npos && trimmed(declaration.substr(0, colon)) == name) {
      found = trimmed(declaration.substr(colon + 1));
    }
    style.remove_prefix(std::min(end + 1, style.size()));
  }
  return found;
}

// A property, of which the style attribute goes before the attribute of that name.
std::string_view property(const pugi::xml_node& element, const char* name) {
  const std::string_view found = declared(element, name);
  return found.empty() ? trimmed(element.attribute(name).value()) : found;
}

// What CSS may say of where and how large a shape is, which this reader knows from attributes alone.
constexpr std::string_view kPlacing[] = {"transform", "translate", "rotate", "scale", "offset-path", "x",  "y", "width",
                                         "height",    "cx",        "cy",     "r",     "rx",          "ry", "d"};

Affine rotation(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const double c = std::cos(angle), s = std::sin(angle);
  return {c, s, -s, c, 0, 0};
}

Affine shift(double x, double y) { return {1, 0, 0, 1, x, y}; }

double tangent(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

struct Call {
  std::string name;
  std::vector<double> values;
};

Call read_call(SvgScanner& text) {
  Call call{std::string(text.word()), {}};
  text.expect('(');
  while (text.at_number() && call.values.size() < 7) call.values.push_back(text.number());
  text.expect(')');
  return call;
}

Affine map_of(const Call& call, const SvgScanner& text) {
  const std::vector<double>& v = call.values;
  const std::size_t n = v.size();
  if (call.name == "matrix" && n == 6) return {v[0], v[1], v[2], v[3], v[4], v[5]};
  if (call.name == "translate" && (n == 1 || n == 2)) return shift(v[0], n == 2 ? v[1] : 0);
  if (call.name == "scale" && (n == 1 || n == 2)) return {v[0], 0, 0, v[n - 1], 0, 0};
  if (call.name == "rotate" && n == 1) return rotation(v[0]);
  if (call.name == "rotate" && n == 3) return shift(v[1], v[2]).after(rotation(v[0])).after(shift(-v[1], -v[2]));
  if (call.name == "skewX" && n == 1) return {1, 0, tangent(v[0]), 1, 0, 0};
  if (call.name == "skewY" && n == 1) return {1, tangent(v[0]), 0, 1, 0, 0};
  text.fail("\"" + cleaned_name(call.name) + "\" with " + std::to_string(n) +
            " numbers is unknown; known are matrix, translate, scale, rotate, skewX and skewY");
}

Affine read_transform(SvgScanner text) {
  Affine map;
  while (!text.done()) map = map.after(map_of(read_call(text), text));
  return map;
}

// "goal", "goals", "goal2" and "goal-dock" are goals, "goalkeeper" is none.
std::optional<Role> role_of_name(std::string_view name) {
  const std::size_t letters = std::min(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz"), name.size());
  if (letters < name.size() && name[letters] >= 'A' && name[letters] <= 'Z') return std::nullopt;
  const std::string_view word = name.substr(0, letters);
  const auto role = role_of(word);
  return role || !word.ends_with('s') ? role : role_of(word.substr(0, word.size() - 1));
}

// By its classes, else by its id, else by Inkscape's label.
std::optional<Role> role_of_element(const pugi::xml_node& element) {
  std::string_view classes = element.attribute("class").value();
  while (!classes.empty()) {
    const std::size_t end = std::min(classes.find_first_of(kSpace), classes.size());
    if (const auto role = role_of_name(classes.substr(0, end))) return role;
    classes.remove_prefix(std::min(end + 1, classes.size()));
  }
  if (const auto role = role_of_name(element.attribute("id").value())) return role;
  return role_of_name(element.attribute("inkscape:label").value());
}

}  // namespace

double svg_unit(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, double>, 8> kUnits = {{{"", 1},
                                                                          {"px", 1},
                                                                          {"mm", 96 / 25.4},
                                                                          {"cm", 96 / 2.54},
                                                                          {"in", 96},
                                                                          {"pt", 96.0 / 72},
                                                                          {"pc", 16},
                                                                          {"Q", 96 / 101.6}}};
  for (const auto& [unit, size] : kUnits) {
    if (unit == name) return size;
  }
  return 0;
}

void SvgPlaces::fail(const pugi::xml_node& element, const std::string& what) const {
  const auto begin = content_.begin();
  const auto offset = std::clamp<std::ptrdiff_t>(element.offset_debug(), 0, std::ssize(content_));
  const std::string id = element.attribute("id").value();
  throw InputError(file_ + ": line " + std::to_string(1 + std::count(begin, begin + offset, '\n')) + ": <" +
                   cleaned_name(element.name()) + (id.empty() ? "" : " id=\"" + cleaned_name(id) + "\"") +
                   ">: " + what);
}

SvgScanner SvgPlaces::scan(const pugi::xml_node& element, const char* attribute) const {
  return {element.attribute(attribute).value(),
          [this, element, attribute](const std::string& what) { fail(element, std::string(attribute) + ": " + what); }};
}

double SvgPlaces::length(const pugi::xml_node& element, const char* attribute, double usual) const {
  if (!element.attribute(attribute)) return usual;
  SvgScanner text = scan(element, attribute);
  const double number = text.number();
  const std::string unit(text.unit());
  if (svg_unit(unit) == 0 || !text.done()) {
    text.fail("must be a number with one of the units px, mm, cm, in, pt, pc, Q or none");
  }
  return number * svg_unit(unit);
}

SvgStyle SvgStyle::of(const pugi::xml_node& element, const SvgPlaces& places) const {
  SvgStyle style = *this;
  if (element.attribute("transform")) style.place = place.after(read_transform(places.scan(element, "transform")));
  const std::string_view fill = property(element, "fill");
  if (!fill.empty() && fill != "inherit") style.is_filled = fill != "none" && fill != "transparent";
  const std::string_view own_rule = property(element, "fill-rule");
  if (!own_rule.empty() && own_rule != "inherit")
    style.rule = own_rule == "evenodd" ? FillRule::even_odd : FillRule::nonzero;
  if (property(element, "display") == "none") style.is_shown = false;
  const std::string_view visibility = property(element, "visibility");
  if (!visibility.empty() && visibility != "inherit") style.is_visible = visibility == "visible";
  if (const auto own = role_of_element(element)) style.role = *own;
  return style;
}

void check_placing(const pugi::xml_node& element, const SvgPlaces& places) {
  for (const std::string_view name : kPlacing) {
    const std::string_view value = declared(element, name);
    if (value.empty() || value == "none" || value == "auto") continue;
    places.fail(element, "style: " + std::string(name) + " is not read there: give it as an attribute of its own");
  }
  if (!element.attribute("transform")) return;
  for (const char* name : {"transform-origin", "transform-box"}) {
    if (property(element, name).empty()) continue;
    places.fail(element, std::string(name) + " is not read: put it into the transform, or ungroup the element");
  }
}

std::string svg_name(const pugi::xml_node& element) {
  const std::string title = element.child_value("title");
  return cleaned_name(title.empty() ? element.attribute("id").value() : title);
}

}  // namespace krait::host
