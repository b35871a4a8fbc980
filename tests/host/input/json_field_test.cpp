// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "../scratch.hpp"
#include "host/input/json.hpp"

namespace krait::host {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string parse_error(const std::string& text) {
  return error_of([&] { parse_json(text, "f.json"); });
}

template <class Read>
std::string field_error(const std::string& text, Read read) {
  const Json document = parse_json(text, "f.json");
  return error_of([&] { read(Field(document, "f.json")); });
}

TEST(Json, RefusesWhatIsNotJson) {
  for (const char* text :
       {"{", "[1,]", "[NaN]", "[1e999]", "{\"a\": Infinity}", "\x89PNG\r\n", "{} {}", "[\"\xFF\"]"}) {
    EXPECT_THAT(parse_error(text), StartsWith("f.json: is not valid JSON: ")) << text;
  }
}

TEST(Json, RefusesDeepNestingOfAnyLength) {
  EXPECT_EQ(parse_error(std::string(60, '[') + std::string(60, ']')), "");
  EXPECT_THAT(parse_error(std::string(100, '[') + std::string(100, ']')), HasSubstr("nested deeper than 64"));
  EXPECT_THAT(parse_error(std::string(10'000'000, '[')), HasSubstr("nested deeper than 64"));
}

TEST(Json, RefusesAKeyGivenTwice) {
  EXPECT_THAT(parse_error(R"({"a": {"b": 1}, "c": {"b": 1, "b": 2}})"), HasSubstr("key \"b\" is given twice"));
}

TEST(Json, RefusesAnObjectOfMoreKeysThanAMapHas) {
  const auto object = [](int keys) {
    std::string text = "{\"k\": 0";
    for (int i = 1; i < keys; ++i) text += ", \"" + std::to_string(i) + "\": 0";
    return text + "}";
  };
  EXPECT_EQ(parse_error(object(1000)), "");
  EXPECT_EQ(parse_error("[" + object(1000) + ", " + object(1000) + "]"), "");
  EXPECT_EQ(parse_error(object(1001)), "f.json: an object has more than 1000 keys");
}

TEST(Field, NamesThePlaceOfAWrongNumber) {
  const auto read = [](const Field& f) { f.at("a").item(1).at("b").number(0, 10); };
  EXPECT_EQ(field_error(R"({"a": [0, {"b": 11}]})", read), "f.json: a[1].b: must be a number from 0 to 10, is 11");
  EXPECT_EQ(field_error(R"({"a": [0, {"b": "x"}]})", read), "f.json: a[1].b: must be a number from 0 to 10, is \"x\"");
  EXPECT_EQ(field_error(R"({"a": [0, {"c": 1}]})", read), "f.json: a[1].b: is missing");
}

TEST(Field, NamesTheKeyThatMayBeTheMissingOneMisspelt) {
  const auto read = [](const Field& f) { f.at("radius").number(0, 10); };
  for (const char* key : {"radus", "radiuss", "radios", "raidus", "adius", "radiu", "Radius", "aradius", "rdaius"}) {
    EXPECT_EQ(field_error(R"({"name": 1, ")" + std::string(key) + R"(": 2})", read),
              "f.json: radius: is missing; is \"" + std::string(key) + "\" it, misspelt?");
  }
  for (const char* key : {"raddiuss", "diameter", "r", "", "radiusab", "rad", "suidar"}) {
    EXPECT_EQ(field_error(R"({")" + std::string(key) + R"(": 2})", read), "f.json: radius: is missing") << key;
  }
}

TEST(Field, NamesTheUnitOfAWrongNumber) {
  EXPECT_EQ(field_error(R"({"dt": 11})", [](const Field& f) { f.at("dt").number(0, 10, "seconds"); }),
            "f.json: dt: must be a number from 0 to 10 seconds, is 11");
  EXPECT_EQ(field_error(R"({"at": [1, 11]})", [](const Field& f) { f.at("at").point(10); }),
            "f.json: at[1]: must be a number from -10 to 10 metres, is 11");
}

TEST(Field, RefusesUnknownKeysByName) {
  EXPECT_EQ(field_error(R"({"a": 1, "boxx": 2})",
                        [](const Field& f) {
                          f.keys({"a", "box"});
                        }),
            "f.json: unknown key \"boxx\"; known here: a, box");
}

TEST(Field, WholeNumbersAreWhole) {
  const auto read = [](const Field& f) { f.integer(0, 25); };
  EXPECT_EQ(field_error("25", read), "");
  EXPECT_NE(field_error("2.5", read), "");
  EXPECT_NE(field_error("26", read), "");
  EXPECT_NE(field_error("-1", read), "");
  EXPECT_NE(field_error("1e300", read), "");
}

TEST(Field, NamesHaveNoControlCharacters) {
  const auto read = [](const Field& f) { f.name(); };
  EXPECT_EQ(field_error("\"Tür 1\"", read), "");
  EXPECT_NE(field_error(R"("")", read), "");
  EXPECT_NE(field_error(R"("a\nb")", read), "");
  EXPECT_NE(field_error(R"("a\u0000b")", read), "");
  EXPECT_NE(field_error("\"" + std::string(201, 'n') + "\"", read), "");
  EXPECT_EQ(field_error(R"("a\u009bb")", read),
            "f.json: must be a name of 1 to 200 bytes without control characters, is \"a\\u009bb\"");
  for (const char* mark : {"\\u007f", "\\u0080", "\\u061c", "\\u200e", "\\u200f", "\\u2028", "\\u202e", "\\u2069"}) {
    EXPECT_THAT(field_error("\"a" + std::string(mark) + "b\"", read), HasSubstr("without control characters")) << mark;
  }
}

TEST(Field, PrintedTextsMayBeEmptyOrLong) {
  const auto read = [](const Field& f) { f.printed(); };
  EXPECT_EQ(field_error(R"("")", read), "");
  EXPECT_EQ(field_error("\"" + std::string(1000, 'n') + "\"", read), "");
  EXPECT_EQ(field_error(R"("a\u202eb")", read), "f.json: must be a text without control characters, is \"a\\u202eb\"");
}

TEST(Field, MessagesQuoteKeysEscaped) {
  EXPECT_EQ(field_error("{\"a\xC2\x9B\": 1}", [](const Field& f) { f.keys({"box"}); }),
            "f.json: unknown key \"a\\u009B\"; known here: box");
}

TEST(CleanedName, IsAlwaysValid) {
  for (const std::string& text : {std::string("a\xFF\n"), std::string(500, '\xC3'), std::string("\xE2\x82")}) {
    EXPECT_NO_THROW(Json(cleaned_name(text)).dump()) << text;
    EXPECT_TRUE(is_safe_to_print(cleaned_name(text))) << text;
    EXPECT_LE(cleaned_name(text).size(), kMaxNameBytes);
  }
  EXPECT_EQ(cleaned_name("a\n\xE2\x80\xAE"), "a\\u000A\\u202E");
  EXPECT_EQ(cleaned_name("a" + std::string(100, '\n')).size(), kMaxNameBytes);
  std::string umlauts = "a";
  for (int i = 0; i < 150; ++i) umlauts += "\xC3\xA4";
  EXPECT_EQ(cleaned_name(umlauts), umlauts.substr(0, 199));
}

}  // namespace
}  // namespace krait::host
