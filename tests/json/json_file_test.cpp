// SPDX-License-Identifier: Apache-2.0
#include "json/json_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "../error_of.h"
#include "error.h"

namespace pyrasim {
namespace {

std::string parse_error(const std::string& text) {
  return error_of<InputError>([&] { parse_json(text, "f.json"); });
}

TEST(JsonFile, BuildsTheSameDocumentAsThePlainParser) {
  const std::string text =
      R"({"a": [1, -2, 2.5e3, [], {}, [[3], {"b": null}]], "c": {"d": true, "e": "x\n\u00e9"}, "": 0})";
  EXPECT_EQ(parse_json(text, "f.json"), nlohmann::json::parse(text));
  EXPECT_EQ(parse_json(" 7 ", "f.json"), nlohmann::json(7));
}

TEST(JsonFile, AllowsComments) {
  EXPECT_EQ(parse_json("// head\n{\"a\": /* one */ 1} // tail", "f.json"), nlohmann::json({{"a", 1}}));
}

TEST(JsonFile, RefusesDuplicateKeysAndPointsAtThem) {
  EXPECT_EQ(parse_error(R"({"a": 1, "b": 2, "a": 1})"),
            "f.json: /a: the key appears twice; a key is allowed once in its object");
  EXPECT_EQ(parse_error(R"({"o": [0, {"x": [], "y": [7, 8]}, {"k~/": 1, "k~/": [2]}]})"),
            "f.json: /o/2/k~0~1: the key appears twice; a key is allowed once in its object");
  EXPECT_EQ(parse_error(R"([[{"a": {"b": 1, "b": {}}}]])"),
            "f.json: /0/0/a/b: the key appears twice; a key is allowed once in its object");
  EXPECT_EQ(parse_error(R"({"a\n": 1, "a\n": 2})"),
            "f.json: /a\\u000a: the key appears twice; a key is allowed once in its object");
}

TEST(JsonFile, AllowsTheSameKeyInDifferentObjects) {
  EXPECT_NO_THROW(parse_json(R"({"a": {"a": 1}, "b": [{"a": 1}, {"a": 2}]})", "f.json"));
}

TEST(JsonFile, SyntaxErrorsSayLineAndColumn) {
  EXPECT_EQ(parse_error("{\n  \"a\": 1\n  \"b\": 2\n}").find("f.json:3:5: syntax error"), 0U)
      << parse_error("{\n  \"a\": 1\n  \"b\": 2\n}");
  EXPECT_EQ(parse_error("{\"a\": ?}").find("f.json:1:7: syntax error"), 0U) << parse_error("{\"a\": ?}");
  EXPECT_EQ(parse_error("").find("f.json:1:1: syntax error"), 0U) << parse_error("");
  EXPECT_EQ(parse_error("{} x").find("f.json:1:4: syntax error"), 0U) << parse_error("{} x");
  EXPECT_EQ(parse_error("\"a\nb\"").find('\n'), std::string::npos);
}

TEST(JsonFile, ColumnsAreCountedInCharacters) {
  EXPECT_EQ(parse_error("{\n\"\u00e9\u4e2d\": ?}").find("f.json:2:7: syntax error"), 0U)
      << parse_error("{\n\"\u00e9\u4e2d\": ?}");
}

TEST(JsonFile, RefusesNullCharactersWhereverTheyAre) {
  const std::string null(1, '\0');
  EXPECT_EQ(parse_error("{} " + null + " } garbage"), "f.json:1:4: a null character; a JSON file has none");
  EXPECT_EQ(parse_error("{}\n" + null), "f.json:2:1: a null character; a JSON file has none");
  EXPECT_EQ(parse_error("{\"a" + null + "\": 1}"), "f.json:1:4: a null character; a JSON file has none");
  EXPECT_EQ(parse_error("// comment" + null + "\n{}"), "f.json:1:11: a null character; a JSON file has none");
  EXPECT_EQ(parse_error(null), "f.json:1:1: a null character; a JSON file has none");
}

TEST(JsonFile, RefusesWhatIsNotUtf8WhereverItIs) {
  EXPECT_EQ(parse_error("{\n\"sph\xe8re\": 1}"),
            "f.json:2:5: the byte 0xe8 is not UTF-8; a JSON file is UTF-8 throughout");
  EXPECT_EQ(parse_error("{} // sph\xe8re"), "f.json:1:10: the byte 0xe8 is not UTF-8; a JSON file is UTF-8 throughout");
  EXPECT_EQ(parse_error("\xff\xfe{"), "f.json:1:1: the byte 0xff is not UTF-8; a JSON file is UTF-8 throughout");
}

TEST(JsonFile, PassesOverAByteOrderMark) {
  EXPECT_EQ(parse_json("\xef\xbb\xbf{\"a\": 1}", "f.json"), nlohmann::json({{"a", 1}}));
  EXPECT_EQ(parse_error("\xef\xbb\xbf{?").find("f.json:1:2: syntax error"), 0U) << parse_error("\xef\xbb\xbf{?");
  EXPECT_NE(parse_error("{}\xef\xbb\xbf"), "(no error)");
}

TEST(JsonFile, MessagesRepeatLittleOfLongTexts) {
  const std::string much(3'000'000, 'w');
  const std::string some = std::string(60, 'w') + "\u2026";
  EXPECT_EQ(parse_error("{\"a\": {\"" + much + "\": 1, \"" + much + "\": 2}}"),
            "f.json: /a/" + some + ": the key appears twice; a key is allowed once in its object");
  EXPECT_EQ(parse_error("1" + std::string(3'000'000, '0')),
            "f.json: (root): the number 1" + std::string(59, '0') +
                "\u2026 is too large; a magnitude of at most 1.797e308 is allowed");
  EXPECT_LT(parse_error("{\"" + much).size(), 250U);
  EXPECT_LT(parse_error("{} \"" + much + "\"").size(), 250U);
}

TEST(JsonFile, RefusesNumbersBeyondDouble) {
  EXPECT_EQ(parse_error(R"({"a": [1, -1e999]})"),
            "f.json: /a/1: the number -1e999 is too large; a magnitude of at most 1.797e308 is allowed");
}

TEST(JsonFile, RefusesNanAndInfinity) {
  EXPECT_EQ(parse_error("{\"a\":\n NaN}"), "f.json:2:2: NaN is not a JSON number; a finite number is allowed");
  EXPECT_EQ(parse_error("[nan]"), "f.json:1:2: nan is not a JSON number; a finite number is allowed");
  EXPECT_EQ(parse_error("[0, -Infinity]"), "f.json:1:5: -Infinity is not a JSON number; a finite number is allowed");
  EXPECT_EQ(parse_error("inf"), "f.json:1:1: inf is not a JSON number; a finite number is allowed");
}

TEST(JsonFile, RefusesDeepNesting) {
  EXPECT_NO_THROW(parse_json(std::string(64, '[') + std::string(64, ']'), "f.json"));
  EXPECT_EQ(parse_error(std::string(100000, '[')),
            "f.json: (root): arrays and objects are nested too deeply; at most 64 levels are allowed");
}

TEST(JsonFile, SaysWhyAFileCannotBeRead) {
  const auto missing = std::filesystem::path(testing::TempDir()) / "no_such_folder" / "f.json";
  EXPECT_EQ(error_of<InputError>([&] { read_json_file(missing); }),
            missing.string() + ": cannot be read: No such file or directory; a readable JSON file is allowed");
  EXPECT_EQ(error_of<InputError>([&] { read_json_file(testing::TempDir()); }),
            testing::TempDir() + ": cannot be read: it is a folder; a readable JSON file is allowed");
}

TEST(JsonFile, ReadsAFileAndNamesItInErrors) {
  const auto file = std::filesystem::path(testing::TempDir()) / "pyrasim_json_file_test.json";
  std::ofstream(file) << "{\"a\": 1}";
  EXPECT_EQ(read_json_file(file), nlohmann::json({{"a", 1}}));
  std::ofstream(file) << "{\"a\": 1, \"a\": 2}";
  EXPECT_EQ(error_of<InputError>([&] { read_json_file(file); }).find(file.string() + ": /a: the key"), 0U);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace pyrasim
