// SPDX-License-Identifier: Apache-2.0
#include "host/input/json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

// The parser's own text without its "[json.exception…]" mark, on one line.
std::string reason(const Json::exception& error) {
  std::string text = error.what();
  const std::size_t mark = text.find("] ");
  if (mark != std::string::npos) text.erase(0, mark + 2);
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

double number_or_nan(const Json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

constexpr const char* kMissing = "is missing";

// That it is missing, and what may have been meant for it.
std::string missing(const std::string& key, const Json& object) {
  for (const auto& item : object.items()) {
    if (key.size() > 2 && is_misspelt(key, item.key()))
      return std::string(kMissing) + "; is \"" + cleaned_name(item.key()) + "\" it, misspelt?";
  }
  return kMissing;
}

// Refuses deep nesting, large objects and repeated keys while the text is parsed.
class Guard {
 public:
  explicit Guard(const std::string& file) : file_(file) {}

  bool operator()(int depth, Json::parse_event_t event, const Json& value) {
    if (depth > kMaxDepth) {
      throw InputError(file_ + ": lists and objects are nested deeper than " + std::to_string(kMaxDepth));
    }
    if (event == Json::parse_event_t::object_start) {
      keys_.emplace_back();
    } else if (event == Json::parse_event_t::object_end) {
      keys_.pop_back();
    } else if (event == Json::parse_event_t::key) {
      const std::string& key = value.get_ref<const std::string&>();
      if (keys_.back().size() == kMaxKeys) fail_keys(file_);
      if (!keys_.back().insert(key).second)
        throw InputError(file_ + ": key \"" + cleaned_name(key) + "\" is given twice");
    }
    return true;
  }

 private:
  const std::string& file_;
  std::vector<std::set<std::string>> keys_;
};

}  // namespace

bool is_misspelt(const std::string& a, const std::string& b) {
  const auto [from_a, from_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  const std::string rest_a(from_a, a.end()), rest_b(from_b, b.end());
  if (rest_a.empty() || rest_b.empty()) return rest_a.size() + rest_b.size() == 1;
  if (rest_a.substr(1) == rest_b.substr(1) || rest_a.substr(1) == rest_b || rest_a == rest_b.substr(1)) return true;
  return rest_a.size() > 1 && rest_b.size() > 1 && rest_a[0] == rest_b[1] && rest_a[1] == rest_b[0] &&
         rest_a.substr(2) == rest_b.substr(2);
}

void fail_keys(const std::string& file) {
  throw InputError(file + ": an object has more than " + std::to_string(kMaxKeys) + " keys");
}

std::string shown(double number) { return printed("%.8g", number); }

void require_no_zero_bytes(const std::string& text, const std::string& language, const std::string& file) {
  if (text.find('\0') != std::string::npos) throw InputError(file + ": is not " + language + ": it has zero bytes");
}

Json parse_json(const std::string& text, const std::string& file) {
  require_no_zero_bytes(text, "JSON", file);
  try {
    Guard guard(file);
    return Json::parse(
        text, [&guard](int depth, Json::parse_event_t event, Json& value) { return guard(depth, event, value); });
  } catch (const Json::exception& error) {
    throw InputError(file + ": is not valid JSON: " + reason(error));
  }
}

Json to_json(const Ring& ring) {
  Json list = Json::array();
  for (const Point& point : ring) list.push_back({point.x, point.y});
  return list;
}

std::string cleaned_name(const std::string& text) {
  std::string name = safe_to_print(text);
  if (name.size() <= kMaxNameBytes) return name;
  std::size_t end = kMaxNameBytes;
  while ((static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80) end -= 1;  // to where a character begins
  name.resize(end);
  return name;
}

Field::Field(const Json& document, const std::string& file)
    : Field(document, std::make_shared<const std::string>(file), {}) {}

Field::Field(const Json& value, std::shared_ptr<const std::string> file, std::string place)
    : value_(&value), file_(std::move(file)), place_(std::move(place)) {}

void Field::fail(const std::string& what) const {
  throw InputError(*file_ + ": " + (place_.empty() ? "" : place_ + ": ") + what);
}

std::string Field::shown_value() const {
  constexpr std::size_t kMostShown = 40;
  if (value_->is_structured())
    return (value_->is_array() ? "a list of " : "an object of ") + std::to_string(value_->size());
  if (value_->is_number_float() && !std::isfinite(value_->get<double>())) return shown(value_->get<double>());
  std::string text = value_->dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() > kMostShown) text.replace(kMostShown, std::string::npos, "...");
  return text;
}

void Field::fail_expecting(const std::string& expected) const { fail("must be " + expected + ", is " + shown_value()); }

bool Field::has(const char* key) const { return value_->is_object() && value_->contains(key); }

void Field::keys(std::initializer_list<const char*> known) const {
  if (!value_->is_object()) fail_expecting("an object");
  for (const auto& item : value_->items()) {
    if (std::find(known.begin(), known.end(), item.key()) != known.end()) continue;
    std::string names;
    for (const char* name : known) names += (names.empty() ? "" : ", ") + std::string(name);
    fail("unknown key \"" + cleaned_name(item.key()) + "\"; known here: " + names);
  }
}

void Field::require(std::initializer_list<const char*> keys) const {
  if (!value_->is_object()) fail_expecting("an object");
  std::string absent;
  for (const char* key : keys) {
    if (has(key)) continue;
    if (missing(key, *value_) != kMissing) (void)at(key);  // which asks about it
    absent += (absent.empty() ? "" : ", ") + std::string(key);
  }
  if (absent.empty()) return;
  fail(absent + (absent.find(',') == std::string::npos ? ": is missing" : ": are missing"));
}

Field Field::at(const char* key) const {
  if (!value_->is_object()) fail_expecting("an object");
  const auto found = value_->find(key);
  const std::string place = place_.empty() ? key : place_ + "." + key;
  if (found == value_->end()) throw InputError(*file_ + ": " + place + ": " + missing(key, *value_));
  return Field(*found, file_, place);
}

std::size_t Field::size(std::size_t least, std::size_t most) const {
  if (!value_->is_array()) fail_expecting("a list");
  if (value_->size() < least) fail_expecting("a list of at least " + std::to_string(least));
  if (value_->size() > most) fail_expecting("a list of at most " + std::to_string(most));
  return value_->size();
}

Field Field::item(std::size_t index) const {
  return Field((*value_)[index], file_, place_ + "[" + std::to_string(index) + "]");
}

double Field::number(double least, double most, const std::string& unit) const {
  const double number = number_or_nan(*value_);
  if (!(number >= least && number <= most))
    fail_expecting("a number from " + shown(least) + " to " + shown(most) + (unit.empty() ? "" : " ") + unit);
  return number;
}

long long Field::integer(long long least, long long most, const std::string& of) const {
  const double value = number_or_nan(*value_);
  if (!(value >= static_cast<double>(least) && value <= static_cast<double>(most)) || value != std::floor(value)) {
    fail_expecting("a whole number " + (of.empty() ? "" : "of " + of + " ") + "from " + std::to_string(least) + " to " +
                   std::to_string(most));
  }
  return static_cast<long long>(value);
}

bool Field::boolean() const {
  if (!value_->is_boolean()) fail_expecting("true or false");
  return value_->get<bool>();
}

std::string Field::text() const {
  if (!value_->is_string()) fail_expecting("a text");
  return value_->get<std::string>();
}

std::string Field::printed() const {
  std::string printed = text();
  if (!is_safe_to_print(printed)) fail_expecting("a text without control characters");
  return printed;
}

std::string Field::name() const {
  std::string name = text();
  if (name.empty() || name.size() > kMaxNameBytes || !is_safe_to_print(name)) {
    fail_expecting("a name of 1 to " + std::to_string(kMaxNameBytes) + " bytes without control characters");
  }
  return name;
}

Point Field::point(double most) const {
  if (size() != 2) fail_expecting("[x, y]");
  return {item(0).number(-most, most, "metres"), item(1).number(-most, most, "metres")};
}

Ring Field::ring(std::size_t most, double most_coordinate) const {
  Ring ring(size(3, most));
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = item(i).point(most_coordinate);
  return ring;
}

}  // namespace krait::host
