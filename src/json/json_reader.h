// SPDX-License-Identifier: Apache-2.0
// Typed reading of a JSON document, where every mistake is one line that says where it is and what is allowed.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <limits>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pyrasim {

/// The numbers that a setting may have: from `min` to `max`, without these two when `exclusive`.
struct NumberRange {
  double min = std::numeric_limits<double>::lowest();
  double max = std::numeric_limits<double>::max();
  bool exclusive = false;

  bool contains(double value) const;
  /// "a number from 0 to 1", "a number between 0 and 180, neither included", "a number of at most 5" ...
  std::string text() const;
};

/// The integers from `min` to `max`.
struct IntegerRange {
  std::int64_t min = std::numeric_limits<std::int64_t>::min();
  std::int64_t max = std::numeric_limits<std::int64_t>::max();

  /// "an integer from 1 to 64" ...
  std::string text() const;
};

/// A name that a string may have, and what it stands for.
template <class T>
struct JsonChoice {
  std::string_view name;
  T value;
};

class JsonElements;

/// A cursor: a node of a document, with its file and its JSON pointer. Cheap to copy. All reading functions throw
/// InputError "FILE: /json/pointer: what is wrong; what is allowed".
///
///     const json document = read_json_file(file);
///     const JsonReader root(file.string(), document);
///     root.allow_keys({"clock_mhz", "intersection"});
///     const double clock = root.member("clock_mhz").number({1, 10000});
///     if (const auto intersection = root.find("intersection")) {
///       intersection->allow_keys({"units", "order"});
///       settings.units = intersection->optional_integer("units", {1, 64});  // std::optional<std::int64_t>
///       ...
class JsonReader {
 public:
  /// A cursor at the root of `document`, which must outlive all cursors that come from it.
  JsonReader(std::string file, const nlohmann::json& document);
  JsonReader(std::string file, nlohmann::json&& document) = delete;

  const std::string& file() const { return *file_; }
  const std::string& pointer() const { return pointer_; }

  /// Throws the InputError of this node, for checks that this class does not know.
  [[noreturn]] void fail(std::string_view wrong, std::string_view allowed) const;

  // Objects. Each of these fails when the node is no object.
  /// Fails at the first key that is none of `allowed`, and lists them.
  void allow_keys(const std::vector<std::string_view>& allowed) const;
  bool has(std::string_view key) const;
  /// A member that must be there.
  JsonReader member(std::string_view key) const;
  /// A member that may be absent.
  std::optional<JsonReader> find(std::string_view key) const;
  /// All members with their keys, sorted by key: for tables whose keys are names.
  std::vector<std::pair<std::string, JsonReader>> members() const;

  /// The elements of an array, whose number must be from `min` to `max`.
  JsonElements elements(std::size_t min = 0, std::size_t max = std::numeric_limits<std::size_t>::max()) const;

  bool is_array() const;

  double number(const NumberRange& range = {}) const;
  /// An integer; as in JSON Schema, 4.0 and 4e0 are the integer 4.
  std::int64_t integer(const IntegerRange& range = {}) const;
  std::string string() const;
  bool boolean() const;
  /// An array of three numbers, each within `range`.
  glm::dvec3 vec3(const NumberRange& range = {}) const;
  /// What the string stands for: `reader.choice<Order>({{"depth_first", Order::depth}, {"breadth_first", ...}})`.
  template <class T>
  T choice(std::initializer_list<JsonChoice<T>> choices) const {
    std::vector<std::string_view> names;
    for (const JsonChoice<T>& choice : choices) names.push_back(choice.name);
    return (choices.begin() + choice_index(names))->value;
  }

  // Members that may be absent.
  std::optional<double> optional_number(std::string_view key, const NumberRange& range = {}) const;
  std::optional<std::int64_t> optional_integer(std::string_view key, const IntegerRange& range = {}) const;
  std::optional<std::string> optional_string(std::string_view key) const;
  std::optional<bool> optional_boolean(std::string_view key) const;
  std::optional<glm::dvec3> optional_vec3(std::string_view key, const NumberRange& range = {}) const;
  template <class T>
  std::optional<T> optional_choice(std::string_view key, std::initializer_list<JsonChoice<T>> choices) const {
    const auto reader = find(key);
    return reader ? std::optional<T>(reader->choice(choices)) : std::nullopt;
  }

 private:
  friend class JsonElements;

  JsonReader child(std::string_view key, const nlohmann::json& node) const;
  /// Of an array.
  JsonReader element(std::size_t index) const;
  void require_object() const;
  std::ptrdiff_t choice_index(const std::vector<std::string_view>& names) const;
  /// Fails because the node is of another kind: "it is a string; a number from 0 to 1 is allowed".
  [[noreturn]] void fail_kind(std::string_view allowed) const;

  std::shared_ptr<const std::string> file_;
  std::string pointer_;
  const nlohmann::json* node_;
};

/// The elements of an array; each is read when it is asked for.
class JsonElements {
 public:
  class Iterator {
   public:
    Iterator(const JsonReader& array, std::size_t index) : array_(&array), index_(index) {}
    JsonReader operator*() const { return array_->element(index_); }
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    const JsonReader* array_;
    std::size_t index_;
  };

  explicit JsonElements(JsonReader array) : array_(std::move(array)) {}

  std::size_t size() const;
  JsonReader operator[](std::size_t index) const { return array_.element(index); }
  Iterator begin() const { return {array_, 0}; }
  Iterator end() const { return {array_, size()}; }

 private:
  JsonReader array_;
};

}  // namespace pyrasim
