// SPDX-License-Identifier: Apache-2.0
// What comments say of defaults and ranges is what the code has: those of krait.h, which cannot name the constants of
// the C++ headers, and the ranges in parameters.hpp.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "krait/krait.h"
#include "krait/krait.hpp"
#include "krait/robots/all.hpp"
#include "paths.hpp"

namespace krait::test::header_comments_test {
namespace {

using Numbers = std::map<std::string, double>;

std::string header(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(source_path("include/krait/" + name)).rdbuf();
  return text.str();
}

std::string in_one_line(const std::string& text) { return std::regex_replace(text, std::regex("\\s+"), " "); }

// A number of a struct of krait.h.
struct Field {
  std::string type;
  std::string name;
  std::string comment;
  std::size_t offset;
};

std::size_t bytes_of(const std::string& type) {
  static const std::map<std::string, std::size_t> bytes = {
      {"bool", sizeof(bool)}, {"uint8_t", 1}, {"uint32_t", 4}, {"uint64_t", 8}, {"int", sizeof(int)}, {"float", 4}};
  return bytes.at(type);
}

// In their order, each where C puts it, with the type of the one before where it has none of its own.
std::vector<Field> fields_of(const std::string& structure) {
  static const std::string text = header("krait.h");
  const std::string begin = "typedef struct " + structure + " {";
  const std::size_t from = text.find(begin) + begin.size();
  const std::string body = text.substr(from, text.find("} " + structure + ";", from) - from);
  const std::regex pattern("(?:(\\w+) )?(\\w+)[,;]\\s*/\\*\\*<([^*]*)\\*/");
  std::vector<Field> fields;
  std::string type;
  std::size_t end = 0;
  for (std::sregex_iterator at(body.begin(), body.end(), pattern); at != std::sregex_iterator(); ++at) {
    if ((*at)[1].matched) type = (*at)[1];
    if (type.starts_with("krait_")) continue;
    const std::size_t size = bytes_of(type);
    const std::size_t offset = (end + size - 1) / size * size;
    fields.push_back({type, (*at)[2], in_one_line((*at)[3]), offset});
    end = offset + size;
  }
  return fields;
}

// Calls use(number) with a number of the field's type.
template <class Use>
void by_type(const Field& field, const Use& use) {
  if (field.type == "float") return use(0.0F);
  if (field.type == "int") return use(0);
  if (field.type == "uint32_t") return use(std::uint32_t{});
  if (field.type == "uint64_t") return use(std::uint64_t{});
  use(std::uint8_t{});  // bool, too
}

// All: a struct of C++ that has the same fields in the same places, as c_interface_test says.
template <class All>
double value_in(const All& all, const Field& field) {
  double value = 0;
  by_type(field, [&](auto number) {
    ASSERT_LE(field.offset + sizeof number, sizeof all);
    std::memcpy(&number, reinterpret_cast<const char*>(&all) + field.offset, sizeof number);
    value = static_cast<double>(number);
  });
  return value;
}
template <class All>
All with(All all, const Field& field, double value) {
  by_type(field, [&](auto number) {
    number = static_cast<decltype(number)>(value);
    std::memcpy(reinterpret_cast<char*>(&all) + field.offset, &number, sizeof number);
  });
  return all;
}

// None where the word is no number. `others`: what names stand for beside these.
std::optional<double> number_of(std::string word, const Numbers& others) {
  constexpr double kPi = 3.14159265358979323846;
  static const Numbers named = {{"pi", kPi},  {"pi/2", kPi / 2},      {"true", 1},
                                {"false", 0}, {"INFINITY", HUGE_VAL}, {"KRAIT_MAX_TRAILERS", KRAIT_MAX_TRAILERS}};
  for (const Numbers* names : {&named, &others}) {
    if (const auto found = names->find(word); found != names->end()) return found->second;
  }
  std::erase(word, ',');
  char* end = nullptr;
  const double number = std::strtod(word.c_str(), &end);
  return end == word.c_str() || *end != '\0' ? std::nullopt : std::optional(number);
}

std::optional<double> number_after(const std::string& comment, const std::string& words, const Numbers& others = {}) {
  std::smatch match;
  const std::regex pattern("(?:^|[ (])" + words + " ([-+.,/\\w]*\\w)");
  return std::regex_search(comment, match, pattern) ? number_of(match[1], others) : std::nullopt;
}

struct End {
  double at;
  bool included;
};
struct Range {
  std::optional<End> least;
  std::optional<End> most;
};

// That of "A to B", "A … B", "> A", "above A, up to B" and the like.
Range range_in(const std::string& words, const Numbers& others = {}) {
  Range range;
  for (const auto& [sign, included] : {std::pair(">", false), {"[Aa]bove", false}, {">=", true}, {"at least", true}}) {
    if (const auto at = number_after(words, sign, others)) range.least = End{*at, included};
  }
  for (const auto& [sign, included] : {std::pair("<=", true), {"up to", true}, {"at most", true}, {"below", false}}) {
    if (const auto at = number_after(words, sign, others)) range.most = End{*at, included};
  }
  std::smatch both;
  if (std::regex_search(words, both, std::regex("(-?[0-9.]+) (?:to|…) ([.,\\w]*\\w)"))) {
    range.least = End{number_of(both[1], others).value(), true};
    range.most = End{number_of(both[2], others).value(), true};
  }
  return range;
}

// What stands before the text that says what the number is for.
std::string head_of(const std::string& comment) { return comment.substr(0, comment.find_first_of(":;")); }

double beside(double number, bool whole, double toward) {
  if (whole) return number + (toward > number ? 1 : -1);
  return static_cast<double>(std::nextafter(static_cast<float>(number), static_cast<float>(toward)));
}

// accepts(number): whether the code does.
template <class Accepts>
void expect_end(const End& end, bool whole, double outward, const Accepts& accepts) {
  EXPECT_EQ(accepts(end.at), end.included) << end.at;
  if (std::isinf(end.at)) return;
  EXPECT_FALSE(accepts(beside(end.at, whole, outward))) << "beyond " << end.at;
  const bool within = accepts(beside(end.at, whole, -outward));
  EXPECT_TRUE(end.included || within) << "within " << end.at;
}
template <class Accepts>
void expect_range(const Range& range, bool whole, const Accepts& accepts) {
  if (range.least) expect_end(*range.least, whole, -HUGE_VAL, accepts);
  if (range.most) expect_end(*range.most, whole, HUGE_VAL, accepts);
}

// As good as the decimals of a comment.
void expect_default(const Field& field, std::optional<double> said, double value) {
  ASSERT_TRUE(said) << field.name << " has no default";
  EXPECT_NEAR(*said, value, 1e-7 * std::abs(value)) << field.name;
}

// Returns how many ranges the comments have.
template <class All, class Accepts>
int expect_fields(const std::string& structure, const All& defaults, const Accepts& accepts) {
  int with_range = 0;
  for (const Field& field : fields_of(structure)) {
    SCOPED_TRACE(field.name);
    expect_default(field, number_after(field.comment, "default"), value_in(defaults, field));
    const Range range = range_in(head_of(field.comment));
    expect_range(range, field.type != "float", [&](double number) {
      return (field.type == "float" || number >= 0) && accepts(with(defaults, field, number));
    });
    with_range += range.least && range.most ? 1 : 0;
  }
  return with_range;
}

std::vector<Argument> arguments_with_range() {
  std::vector<Argument> all;
  for (int i = 0; i <= static_cast<int>(Argument::robot_sizes); ++i) {
    const ParameterRange range = Parameters::range(static_cast<Argument>(i));
    if (range.least != range.most) all.push_back(static_cast<Argument>(i));
  }
  return all;
}

TEST(HeaderComments, ParametersInCAreTheCpps) {
  const auto accepts = [](const Parameters& p) { return p.first_bad() == Argument::none; };
  const auto accepts_tuning = [&](const SearchTuning& tuning) {
    Parameters parameters;
    parameters.tuning = tuning;
    return accepts(parameters);
  };
  const int with_range = expect_fields("krait_parameters", Parameters(), accepts) +
                         expect_fields("krait_search_tuning", SearchTuning(), accepts_tuning);
  EXPECT_EQ(with_range, static_cast<int>(arguments_with_range().size()));
}

TEST(HeaderComments, LimitsInCAreTheCpps) {
  std::size_t with_range = 0;
  for (const Field& field : fields_of("krait_limits")) {
    SCOPED_TRACE(field.name);
    const Range range = range_in(field.comment);
    if (range.least) ++with_range;
    // 0 stands for no room
    expect_range(range, true, [&](double number) {
      return number != 0 && with(Limits(), field, number).first_bad() == Argument::none;
    });
  }
  EXPECT_EQ(with_range, 4U);
}

// The struct of krait.h that has the parameters of a model, by what the union says of its members.
std::string structure_of(const std::string& model) {
  const std::string text = in_one_line(header("krait.h"));
  std::smatch match;
  const std::regex pattern("(krait_\\w+_parameters) \\w+; /\\*\\*< of (?:[^*]* )?krait_" + model + "[ ,]");
  return std::regex_search(text, match, pattern) ? match[1].str() : "";
}

template <class R>
void expect_robot(const std::string& model) {
  SCOPED_TRACE(model);
  constexpr bool kIsCar = std::is_same_v<R, Car>;  // has defaults in brackets, and ignores what its class sets
  const typename R::Parameters defaults = defaults_of<R>();
  const std::vector<Field> fields = fields_of(structure_of(model));
  Numbers values;
  for (const Field& field : fields) values[field.name] = value_in(defaults, field);
  for (const Field& field : fields) {
    SCOPED_TRACE(field.name);
    if (field.name != "trailers") {
      std::smatch brackets;
      std::regex_search(field.comment, brackets, std::regex("default \\S+ \\(([0-9.]+)\\)"));
      const bool bracketed = kIsCar && !brackets.empty();
      expect_default(field, bracketed ? number_of(brackets[1], {}) : number_after(field.comment, "default"),
                     values[field.name]);
    }
    if (kIsCar && field.comment.find("a car") != std::string::npos) continue;
    expect_range(range_in(head_of(field.comment), values), field.type != "float",
                 [&](double number) { return R(with(defaults, field, number)).sound(); });
  }
  std::size_t described = 0;
  R::Parameters::describe([&](const auto& field) {
    ASSERT_LT(described, fields.size());
    EXPECT_EQ(fields[described++].name, field.name);
  });
  EXPECT_EQ(described, fields.size());
}

TEST(HeaderComments, RobotsInCAreTheCpps) {
#define KRAIT_EXPECT(name, Class, file, trailers) expect_robot<Class>(#name);
  KRAIT_MODELS(KRAIT_EXPECT)
#undef KRAIT_EXPECT
}

// The comment on the member of that name: behind it, or the lines above.
std::string comment_on(const std::string& text, const std::string& member) {
  std::istringstream lines(text);
  std::string above;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t behind = line.find("///< ");
    const std::size_t begin = line.find_first_not_of(' ');
    if (line.find(" " + member + " = ") < line.size()) return behind < line.size() ? line.substr(behind + 5) : above;
    above = begin < line.size() && line.compare(begin, 4, "/// ") == 0 ? above + line.substr(begin + 4) + " " : "";
  }
  return "";
}

TEST(HeaderComments, RangesOfParametersAreThoseThatTheLibraryHas) {
  const std::string text = header("parameters.hpp");
  for (const Argument argument : arguments_with_range()) {
    const ParameterRange has = Parameters::range(argument);
    SCOPED_TRACE(to_string(argument));
    const Range said = range_in(head_of(comment_on(text, to_string(argument))), {{"infinity", HUGE_VAL}});
    ASSERT_TRUE(said.least && said.most);
    expect_range(said, false, [&](double number) {
      const auto close = static_cast<float>(number);
      return close >= has.least && close <= has.most;
    });
  }
}

}  // namespace
}  // namespace krait::test::header_comments_test
