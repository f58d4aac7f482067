// SPDX-License-Identifier: Apache-2.0
#include "json/json_reader.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "../error_of.h"
#include "error.h"
#include "json/json_file.h"

namespace pyrasim {
namespace {

using nlohmann::json;

/// The message that `read(root cursor)` throws for the document `text`.
template <class Read>
std::string reader_error(const std::string& text, Read read) {
  const json document = parse_json(text, "m.json");
  const JsonReader root("m.json", document);
  return error_of<InputError>([&] { read(root); });
}

TEST(JsonReader, ReadsTypedMembers) {
  const json document = parse_json(
      R"({"n": 2.5, "i": 4, "e": 4e0, "s": "x", "b": true, "v": [1, -2.5, 3], "a": [7, 8], "o": {"k": 1}})", "m.json");
  const JsonReader root("m.json", document);
  EXPECT_EQ(root.member("n").number({0, 3}), 2.5);
  EXPECT_EQ(root.member("i").integer({1, 4}), 4);
  EXPECT_EQ(root.member("e").integer(), 4);
  EXPECT_EQ(root.member("s").string(), "x");
  EXPECT_TRUE(root.member("b").boolean());
  EXPECT_EQ(root.member("v").vec3(), glm::dvec3(1, -2.5, 3));
  ASSERT_EQ(root.member("a").elements(1, 2).size(), 2U);
  EXPECT_EQ(root.member("a").elements()[1].integer(), 8);
  EXPECT_EQ(root.member("a").elements()[1].pointer(), "/a/1");
  ASSERT_EQ(root.member("o").members().size(), 1U);
  EXPECT_EQ(root.member("o").members()[0].first, "k");
  EXPECT_EQ(root.member("o").members()[0].second.pointer(), "/o/k");
}

TEST(JsonReader, OptionalMembersMayBeAbsent) {
  const json document = parse_json(R"({"n": 1, "s": "y"})", "m.json");
  const JsonReader root("m.json", document);
  EXPECT_EQ(root.optional_number("n"), 1.0);
  EXPECT_EQ(root.optional_number("absent"), std::nullopt);
  EXPECT_EQ(root.optional_integer("absent"), std::nullopt);
  EXPECT_EQ(root.optional_string("s"), "y");
  EXPECT_EQ(root.optional_string("absent"), std::nullopt);
  EXPECT_EQ(root.optional_boolean("absent"), std::nullopt);
  EXPECT_EQ(root.optional_vec3("absent"), std::nullopt);
  EXPECT_EQ(root.optional_choice<int>("s", {{"x", 1}, {"y", 2}}), 2);
  EXPECT_EQ(root.optional_choice<int>("absent", {{"x", 1}}), std::nullopt);
  EXPECT_TRUE(root.has("n"));
  EXPECT_FALSE(root.find("absent"));
}

TEST(JsonReader, OptionalMembersAreStillChecked) {
  EXPECT_EQ(reader_error(R"({"u": 65})",
                         [](const JsonReader& r) {
                           r.optional_integer("u", {1, 64});
                         }),
            "m.json: /u: 65 is out of range; an integer from 1 to 64 is allowed");
  EXPECT_EQ(reader_error(R"({"u": null})", [](const JsonReader& r) { r.optional_number("u"); }),
            "m.json: /u: it is null; a number is allowed");
}

TEST(JsonReader, RefusesUnknownAndMissingKeys) {
  EXPECT_EQ(reader_error(R"({"a": {"x/~": 1}})",
                         [](const JsonReader& r) {
                           r.member("a").allow_keys({"p", "q"});
                         }),
            "m.json: /a/x~1~0: unknown key; allowed keys: p, q");
  EXPECT_EQ(reader_error(R"({"a": {}})", [](const JsonReader& r) { r.member("a").member("p"); }),
            "m.json: /a: the key \"p\" is missing; it must be given");
  EXPECT_EQ(reader_error("[]", [](const JsonReader& r) { r.allow_keys({}); }),
            "m.json: (root): it is an array; an object is allowed");
}

TEST(JsonReader, RefusesWrongKinds) {
  const auto number = [](const JsonReader& r) { r.member("a").number({0, 1}); };
  EXPECT_EQ(reader_error(R"({"a": "1"})", number),
            "m.json: /a: it is the string \"1\"; a number from 0 to 1 is allowed");
  EXPECT_EQ(reader_error(R"({"a": true})", number), "m.json: /a: it is true; a number from 0 to 1 is allowed");
  EXPECT_EQ(reader_error(R"({"a": {}})", [](const JsonReader& r) { r.member("a").string(); }),
            "m.json: /a: it is an object; a string is allowed");
  EXPECT_EQ(reader_error(R"({"a": 0})", [](const JsonReader& r) { r.member("a").boolean(); }),
            "m.json: /a: it is the number 0; true or false is allowed");
  EXPECT_EQ(reader_error(R"({"a": 1.5})", [](const JsonReader& r) { r.member("a").integer({.min = 1}); }),
            "m.json: /a: it is the number 1.5; an integer of at least 1 is allowed");
  EXPECT_EQ(reader_error(R"({"a": 1})", [](const JsonReader& r) { r.member("a").elements(1); }),
            "m.json: /a: it is the number 1; an array of at least 1 element is allowed");
  EXPECT_EQ(reader_error(R"({"a": [1, 2]})", [](const JsonReader& r) { r.member("a").vec3(); }),
            "m.json: /a: it has 2 elements; an array of 3 numbers is allowed");
  EXPECT_EQ(reader_error(R"({"a": [1, 2, "3"]})", [](const JsonReader& r) { r.member("a").vec3(); }),
            "m.json: /a/2: it is the string \"3\"; a number is allowed");
}

TEST(JsonReader, RefusesNumbersOutOfRange) {
  const auto exclusive = [](const JsonReader& r) { r.member("a").number({0, 180, true}); };
  EXPECT_EQ(reader_error(R"({"a": 180})", exclusive),
            "m.json: /a: 180 is out of range; a number between 0 and 180, neither included, is allowed");
  EXPECT_EQ(reader_error(R"({"a": 0})", [](const JsonReader& r) { r.member("a").number({.min = 0.5}); }),
            "m.json: /a: 0 is out of range; a number of at least 0.5 is allowed");
  EXPECT_EQ(reader_error(R"({"a": 1})", [](const JsonReader& r) { r.member("a").number({.max = 0.5}); }),
            "m.json: /a: 1 is out of range; a number of at most 0.5 is allowed");
  EXPECT_EQ(reader_error(R"({"a": [0, 2, 0]})",
                         [](const JsonReader& r) {
                           r.member("a").vec3({0, 1});
                         }),
            "m.json: /a/1: 2 is out of range; a number from 0 to 1 is allowed");
  EXPECT_EQ(reader_error(R"({"a": 18446744073709551615})", [](const JsonReader& r) { r.member("a").integer(); }),
            "m.json: /a: 18446744073709551615 is out of range; an integer is allowed");
  EXPECT_EQ(reader_error(R"({"a": 1e300})", [](const JsonReader& r) { r.member("a").integer({.max = 9}); }),
            "m.json: /a: 1e+300 is out of range; an integer of at most 9 is allowed");
  EXPECT_EQ(reader_error(R"({"a": [1, 2, 3]})", [](const JsonReader& r) { r.member("a").elements(1, 2); }),
            "m.json: /a: it has 3 elements; an array of 1 to 2 elements is allowed");
}

TEST(JsonReader, RefusesUnknownChoices) {
  const auto order = [](const JsonReader& r) { r.member("a").choice<int>({{"depth", 1}, {"breadth", 2}}); };
  EXPECT_EQ(reader_error(R"({"a": "wide"})", order),
            "m.json: /a: \"wide\" is unknown; one of \"depth\", \"breadth\" is allowed");
  EXPECT_EQ(reader_error(R"({"a": 1})", order),
            "m.json: /a: it is the number 1; one of \"depth\", \"breadth\" is allowed");
}

TEST(JsonReader, CutsLongTextsAndKeepsMessagesOnOneLine) {
  const auto order = [](const JsonReader& r) { r.choice<int>({{"x", 1}}); };
  const std::string message = reader_error("\"\\n" + std::string(1000, 'w') + "\"", order);
  EXPECT_EQ(message,
            "m.json: (root): \"\\u000a" + std::string(54, 'w') + "\u2026\" is unknown; one of \"x\" is allowed");
  EXPECT_EQ(
      reader_error("{\"" + std::string(3'000'000, 'w') + "\": 1}", [](const JsonReader& r) { r.allow_keys({"a"}); }),
      "m.json: /" + std::string(60, 'w') + "\u2026: unknown key; allowed keys: a");
  std::string accents;
  for (int k = 0; k < 1000; ++k) accents += "\u00e9";
  EXPECT_EQ(reader_error("\"a" + accents + "\"", order),
            "m.json: (root): \"a" + accents.substr(0, 118) + "\u2026\" is unknown; one of \"x\" is allowed");
  EXPECT_EQ(reader_error(R"("\u009b2J\u202e")", order),
            R"(m.json: (root): "\u009b2J\u202e" is unknown; one of "x" is allowed)");
}

}  // namespace
}  // namespace pyrasim
