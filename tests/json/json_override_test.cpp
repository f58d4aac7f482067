// SPDX-License-Identifier: Apache-2.0
#include "json/json_override.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "../error_of.h"
#include "error.h"

namespace pyrasim {
namespace {

using nlohmann::json;

std::string after(const char* text, const char* assignment) {
  json document = json::parse(text);
  apply_override(document, assignment);
  return document.dump();
}

std::string override_error(const char* text, const char* assignment) {
  json document = json::parse(text);
  const std::string message = error_of<UsageError>([&] { apply_override(document, assignment); });
  EXPECT_EQ(document, json::parse(text)) << "a refused assignment changed the document";
  return message;
}

TEST(JsonOverride, ReplacesAndMakesMembers) {
  EXPECT_EQ(after(R"({"intersection":{"latency":8,"units":1}})", "intersection.units=4"),
            R"({"intersection":{"latency":8,"units":4}})");
  EXPECT_EQ(after("{}", "a.b.c=0.5"), R"({"a":{"b":{"c":0.5}}})");
  EXPECT_EQ(after(R"({"a":[1,{"b":2}]})", "a.1.b=3"), R"({"a":[1,{"b":3}]})");
}

TEST(JsonOverride, ReadsValuesAsJsonOrElseAsText) {
  EXPECT_EQ(after("{}", "a=true"), R"({"a":true})");
  EXPECT_EQ(after("{}", "a=[1, 2]"), R"({"a":[1,2]})");
  EXPECT_EQ(after("{}", "a=depth=first"), R"({"a":"depth=first"})");
  EXPECT_EQ(after("{}", "a=\"4\""), R"({"a":"4"})");
}

TEST(JsonOverride, KeepsWithinTheDepthOfADocument) {
  const auto path = [](int keys) {
    std::string text = "a";
    for (int k = 1; k < keys; ++k) text += ".a";
    return text;
  };
  EXPECT_NE(after("{}", (path(64) + "=1").c_str()), "");
  EXPECT_NE(after("{}", (path(62) + "=[[1], 2]").c_str()), "");
  EXPECT_EQ(override_error("{}", (path(65) + "=1").c_str()),
            "--set " + path(30) + ".\u2026: it is nested 65 levels deep; at most 64 levels are allowed");
  EXPECT_EQ(override_error("{}", (path(63) + "=[[1], 2]").c_str()),
            "--set " + path(30) + ".\u2026: it is nested 65 levels deep; at most 64 levels are allowed");
  EXPECT_EQ(override_error("{}", (path(1'000'000) + "=1").c_str()),
            "--set " + path(30) + ".\u2026: it is nested 1000000 levels deep; at most 64 levels are allowed");
}

TEST(JsonOverride, MessagesRepeatLittleOfLongTexts) {
  const std::string much(3'000'000, 'w');
  const std::string some = std::string(60, 'w') + "\u2026";
  EXPECT_EQ(override_error("{}", much.c_str()), "--set " + some + ": there is no \"=\"; PATH=VALUE is allowed");
  EXPECT_EQ(override_error("[1]", (much + "=1").c_str()),
            "--set " + some + ": \"" + some + "\" selects no element; the array has 1 element, counted from 0");
  EXPECT_LT(override_error("{}", ("a=\"" + much).c_str()).size(), 350U);
}

TEST(JsonOverride, RefusesAssignmentsWithoutSense) {
  EXPECT_EQ(override_error("{}", "a"), "--set a: there is no \"=\"; PATH=VALUE is allowed");
  EXPECT_EQ(override_error("{}", "=1"), "--set =1: a key is empty; PATH is keys separated by dots");
  EXPECT_EQ(override_error("{}", "a..b=1"), "--set a..b=1: a key is empty; PATH is keys separated by dots");
  EXPECT_EQ(override_error("{}", "a="),
            "--set a=: the value is missing; PATH=VALUE is allowed, and \"\" for an empty text");
  EXPECT_EQ(override_error(R"({"a":1})", "a.b=1"),
            "--set a.b=1: there is nothing inside to select by \"b\"; only objects and arrays hold other settings");
  EXPECT_EQ(override_error(R"({"a":[1]})", "a.1=1"),
            "--set a.1=1: \"1\" selects no element; the array has 1 element, counted from 0");
  EXPECT_EQ(override_error(R"({"a":[1]})", "a.x=1"),
            "--set a.x=1: \"x\" selects no element; the array has 1 element, counted from 0");
  EXPECT_EQ(override_error("{}", "a=4x").find("--set a=4x: value:1:2: syntax error"), 0U);
}

}  // namespace
}  // namespace pyrasim
