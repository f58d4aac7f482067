// SPDX-License-Identifier: Apache-2.0
#include "json/json_override.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <string>

#include "error.h"
#include "json/json_file.h"
#include "text/counted.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

using nlohmann::json;

/// As it stands on the command line, in messages.
struct Assignment {
  std::string_view option;
  std::string_view text;
};

[[noreturn]] void fail(const Assignment& assignment, std::string_view wrong, std::string_view allowed) {
  throw UsageError(fmt::format("{} {}: {}; {}", assignment.option, excerpt(assignment.text), wrong, allowed));
}

json parse_value(const Assignment& assignment, std::string_view value) {
  constexpr std::string_view json_begins = "-0123456789[{\" \t";
  const bool literal = value == "true" || value == "false" || value == "null";
  if (value.empty()) fail(assignment, "the value is missing", "PATH=VALUE is allowed, and \"\" for an empty text");
  if (!literal && json_begins.find(value.front()) == std::string_view::npos) return std::string(value);
  try {
    return parse_json(value, "value");
  } catch (const InputError& error) {
    fail(assignment, error.what(), "a JSON value is allowed; a text that begins like one needs double quotes");
  }
}

/// What `key` selects inside `node`; a missing member is made, as null.
json& step(json& node, std::string_view key, const Assignment& assignment) {
  if (key.empty()) fail(assignment, "a key is empty", "PATH is keys separated by dots");
  if (node.is_null()) node = json::object();
  if (node.is_object()) return node[std::string(key)];
  if (!node.is_array()) {
    fail(assignment, fmt::format("there is nothing inside to select by \"{}\"", excerpt(key)),
         "only objects and arrays hold other settings");
  }
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), index);
  if (error != std::errc() || end != key.data() + key.size() || index >= node.size()) {
    fail(assignment, fmt::format("\"{}\" selects no element", excerpt(key)),
         fmt::format("the array has {}, counted from 0", counted(node.size(), "element")));
  }
  return node[index];
}

/// How deeply arrays and objects are nested in `value`, which keeps within max_json_depth.
int depth_of(const json& value) {
  if (!value.is_structured()) return 0;
  int deepest = 0;
  for (const json& inside : value) deepest = std::max(deepest, depth_of(inside));
  return deepest + 1;
}

/// Fails where the document would be nested too deeply for those who read it.
void check_depth(std::string_view path, const json& value, const Assignment& assignment) {
  const auto levels = std::count(path.begin(), path.end(), '.') + 1 + depth_of(value);
  if (levels > max_json_depth) {
    fail(assignment, fmt::format("it is nested {} levels deep", levels),
         fmt::format("at most {} levels are allowed", max_json_depth));
  }
}

}  // namespace

void apply_override(nlohmann::json& document, std::string_view text, std::string_view option) {
  const Assignment assignment{option, text};
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) fail(assignment, "there is no \"=\"", "PATH=VALUE is allowed");
  json value = parse_value(assignment, text.substr(equals + 1));
  std::string_view path = text.substr(0, equals);
  check_depth(path, value, assignment);
  json changed = document;  // a refused assignment leaves the document as it was
  json* node = &changed;
  while (true) {
    const std::size_t dot = path.find('.');
    node = &step(*node, path.substr(0, dot), assignment);
    if (dot == std::string_view::npos) break;
    path.remove_prefix(dot + 1);
  }
  *node = std::move(value);
  document = std::move(changed);
}

}  // namespace pyrasim
