// SPDX-License-Identifier: Apache-2.0
#include "json/json_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "error.h"
#include "json/json_file.h"
#include "text/counted.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

using nlohmann::json;

/// A string as a message shows it.
std::string in_quotes(std::string_view text) { return '"' + excerpt(text) + '"'; }

/// "an object", "the string \"x\"", "the number 4" ...
std::string kind_of(const json& node) {
  if (node.is_object()) return "an object";
  if (node.is_array()) return "an array";
  if (node.is_string()) return "the string " + in_quotes(node.get_ref<const std::string&>());
  if (node.is_number()) return "the number " + node.dump();
  return node.dump();  // true, false, null
}

bool is_integral(double value) { return std::isfinite(value) && std::trunc(value) == value; }

/// The integer that a number stands for, where it stands for one that std::int64_t can hold.
std::optional<std::int64_t> integer_of(const json& node) {
  constexpr double beyond = 9223372036854775808.0;  // 2^63
  if (node.is_number_unsigned()) {
    const auto value = node.get<std::uint64_t>();
    if (value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) return std::nullopt;
    return static_cast<std::int64_t>(value);
  }
  if (node.is_number_integer()) return node.get<std::int64_t>();
  const auto value = node.get<double>();
  if (!is_integral(value) || value < -beyond || value >= beyond) return std::nullopt;
  return static_cast<std::int64_t>(value);
}

}  // namespace

bool NumberRange::contains(double value) const {
  return exclusive ? value > min && value < max : value >= min && value <= max;
}

std::string NumberRange::text() const {
  const bool from = min > std::numeric_limits<double>::lowest();
  const bool to = max < std::numeric_limits<double>::max();
  if (from && to && exclusive) return fmt::format("a number between {} and {}, neither included,", min, max);
  if (from && to) return fmt::format("a number from {} to {}", min, max);
  if (from) return fmt::format("a number {} {}", exclusive ? "greater than" : "of at least", min);
  if (to) return fmt::format("a number {} {}", exclusive ? "less than" : "of at most", max);
  return "a number";
}

std::string IntegerRange::text() const {
  const bool from = min > std::numeric_limits<std::int64_t>::min();
  const bool to = max < std::numeric_limits<std::int64_t>::max();
  if (from && to) return fmt::format("an integer from {} to {}", min, max);
  if (from) return fmt::format("an integer of at least {}", min);
  if (to) return fmt::format("an integer of at most {}", max);
  return "an integer";
}

JsonReader::JsonReader(std::string file, const nlohmann::json& document)
    : file_(std::make_shared<const std::string>(std::move(file))), node_(&document) {}

JsonReader JsonReader::child(std::string_view key, const nlohmann::json& node) const {
  JsonReader result = *this;
  result.pointer_ = json_pointer_child(pointer_, key);
  result.node_ = &node;
  return result;
}

JsonReader JsonReader::element(std::size_t index) const { return child(std::to_string(index), (*node_)[index]); }

std::size_t JsonElements::size() const { return array_.node_->size(); }

void JsonReader::fail(std::string_view wrong, std::string_view allowed) const {
  throw InputError(json_message(*file_, pointer_, wrong, allowed));
}

void JsonReader::fail_kind(std::string_view allowed) const {
  fail("it is " + kind_of(*node_), fmt::format("{} is allowed", allowed));
}

void JsonReader::require_object() const {
  if (!node_->is_object()) fail_kind("an object");
}

void JsonReader::allow_keys(const std::vector<std::string_view>& allowed) const {
  require_object();
  for (const auto& item : node_->items()) {
    if (std::find(allowed.begin(), allowed.end(), item.key()) != allowed.end()) continue;
    child(item.key(), item.value()).fail("unknown key", fmt::format("allowed keys: {}", fmt::join(allowed, ", ")));
  }
}

bool JsonReader::has(std::string_view key) const {
  require_object();
  return node_->contains(key);
}

JsonReader JsonReader::member(std::string_view key) const {
  auto reader = find(key);
  if (!reader) fail(fmt::format("the key \"{}\" is missing", key), "it must be given");
  return *std::move(reader);
}

std::optional<JsonReader> JsonReader::find(std::string_view key) const {
  require_object();
  const auto found = node_->find(key);
  if (found == node_->end()) return std::nullopt;
  return child(key, *found);
}

std::vector<std::pair<std::string, JsonReader>> JsonReader::members() const {
  require_object();
  std::vector<std::pair<std::string, JsonReader>> result;
  for (const auto& item : node_->items()) result.emplace_back(item.key(), child(item.key(), item.value()));
  return result;
}

JsonElements JsonReader::elements(std::size_t min, std::size_t max) const {
  const bool bounded = max < std::numeric_limits<std::size_t>::max();
  std::string allowed = "an array";
  if (min == max) {
    allowed = fmt::format("an array of {}", counted(min, "element"));
  } else if (bounded) {
    allowed = fmt::format("an array of {} to {} elements", min, max);
  } else if (min > 0) {
    allowed = fmt::format("an array of at least {}", counted(min, "element"));
  }
  if (!node_->is_array()) fail_kind(allowed);
  if (node_->size() < min || node_->size() > max) {
    fail("it has " + counted(node_->size(), "element"), allowed + " is allowed");
  }
  return JsonElements(*this);
}

bool JsonReader::is_array() const { return node_->is_array(); }

double JsonReader::number(const NumberRange& range) const {
  if (!node_->is_number()) fail_kind(range.text());
  const auto value = node_->get<double>();
  if (!range.contains(value)) fail(node_->dump() + " is out of range", range.text() + " is allowed");
  return value;
}

std::int64_t JsonReader::integer(const IntegerRange& range) const {
  if (!node_->is_number()) fail_kind(range.text());
  const std::optional<std::int64_t> value = integer_of(*node_);
  if (!value && !is_integral(node_->get<double>())) fail_kind(range.text());
  if (!value || *value < range.min || *value > range.max) {
    fail(node_->dump() + " is out of range", range.text() + " is allowed");
  }
  return *value;
}

std::string JsonReader::string() const {
  if (!node_->is_string()) fail_kind("a string");
  return node_->get<std::string>();
}

bool JsonReader::boolean() const {
  if (!node_->is_boolean()) fail_kind("true or false");
  return node_->get<bool>();
}

glm::dvec3 JsonReader::vec3(const NumberRange& range) const {
  if (!node_->is_array()) fail_kind("an array of 3 numbers");
  if (node_->size() != 3) fail("it has " + counted(node_->size(), "element"), "an array of 3 numbers is allowed");
  glm::dvec3 result;
  for (int i = 0; i < 3; ++i) {
    const json& component = (*node_)[static_cast<std::size_t>(i)];
    const bool good = component.is_number() && range.contains(component.get<double>());
    result[i] = good ? component.get<double>() : element(static_cast<std::size_t>(i)).number(range);  // or says why not
  }
  return result;
}

std::ptrdiff_t JsonReader::choice_index(const std::vector<std::string_view>& names) const {
  const auto allowed = [&] {
    std::vector<std::string> shown;
    shown.reserve(names.size());
    for (const std::string_view name : names) shown.push_back(in_quotes(name));
    return fmt::format("one of {}", fmt::join(shown, ", "));
  };
  if (!node_->is_string()) fail_kind(allowed());
  const auto& value = node_->get_ref<const std::string&>();
  const auto found = std::find(names.begin(), names.end(), value);
  if (found == names.end()) fail(in_quotes(value) + " is unknown", allowed() + " is allowed");
  return found - names.begin();
}

std::optional<double> JsonReader::optional_number(std::string_view key, const NumberRange& range) const {
  const auto reader = find(key);
  return reader ? std::optional(reader->number(range)) : std::nullopt;
}

std::optional<std::int64_t> JsonReader::optional_integer(std::string_view key, const IntegerRange& range) const {
  const auto reader = find(key);
  return reader ? std::optional(reader->integer(range)) : std::nullopt;
}

std::optional<std::string> JsonReader::optional_string(std::string_view key) const {
  const auto reader = find(key);
  return reader ? std::optional(reader->string()) : std::nullopt;
}

std::optional<bool> JsonReader::optional_boolean(std::string_view key) const {
  const auto reader = find(key);
  return reader ? std::optional(reader->boolean()) : std::nullopt;
}

std::optional<glm::dvec3> JsonReader::optional_vec3(std::string_view key, const NumberRange& range) const {
  const auto reader = find(key);
  return reader ? std::optional(reader->vec3(range)) : std::nullopt;
}

}  // namespace pyrasim
