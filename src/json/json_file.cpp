// SPDX-License-Identifier: Apache-2.0
#include "json/json_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "error.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

using nlohmann::json;

constexpr std::size_t largest_text = std::size_t{1} << 31U;  ///< of a file, bytes: some have no end
constexpr int overflow_id = 406;                             ///< nlohmann's number for "number overflow"

/// "FILE:LINE:COLUMN", both counted from 1, the column in characters, of the byte at `offset`.
std::string place(std::string_view text, const std::string& file, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::string_view in_line = before.substr(before.rfind('\n') + 1);  // npos + 1 is 0
  const auto column = 1 + std::count_if(in_line.begin(), in_line.end(), [](char c) {
                        return (static_cast<unsigned char>(c) & 0xc0U) != 0x80;  // a character's first byte
                      });
  return fmt::format("{}:{}:{}", file, line, column);
}

/// Fails where `text` holds what the parser would take for its end, or what is no text.
void check_characters(std::string_view text, const std::string& file) {
  if (const std::size_t null = text.find('\0'); null != std::string_view::npos) {
    throw InputError(place(text, file, null) + ": a null character; a JSON file has none");
  }
  if (const std::size_t wrong = first_not_utf8(text); wrong < text.size()) {
    throw InputError(fmt::format("{}: the byte 0x{:02x} is not UTF-8; a JSON file is UTF-8 throughout",
                                 place(text, file, wrong), static_cast<unsigned char>(text[wrong])));
  }
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// The NaN or Infinity literal, sign included, that the byte at `offset` is part of; empty when it is part of neither.
std::string_view non_finite_literal(std::string_view text, std::size_t offset) {
  std::size_t begin = offset;
  while (begin > 0 && is_letter(text[begin - 1])) --begin;
  std::size_t end = begin;
  while (end < text.size() && is_letter(text[end])) ++end;
  std::string word(text.substr(begin, end - begin));
  std::transform(word.begin(), word.end(), word.begin(), [](char c) { return c >= 'a' ? c : char(c - 'A' + 'a'); });
  if (word != "nan" && word != "inf" && word != "infinity") return {};
  if (begin > 0 && (text[begin - 1] == '-' || text[begin - 1] == '+')) --begin;
  return text.substr(begin, end - begin);
}

constexpr std::size_t longest_reason = 160;  ///< characters: what nlohmann says, and the beginning of a long token

/// What nlohmann says of a syntax error, without its prefix of numbers and positions.
std::string reason_of(const json::exception& error) {
  const std::string_view what = error.what();
  const std::size_t begin = what.find("syntax error");
  const std::size_t bracket = what.find("] ");
  if (begin != std::string_view::npos) return excerpt(what.substr(begin), longest_reason);
  return excerpt(bracket == std::string_view::npos ? what : what.substr(bracket + 2), longest_reason);
}

/// Builds the document from the parser's events and keeps the path to the value that is being read.
class DocumentBuilder final : public nlohmann::json_sax<json> {
 public:
  DocumentBuilder(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  json take_document() { return std::move(document_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t& /*text*/) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t& /*value*/) override { return false; }  // JSON text has none
  bool start_object(std::size_t /*size*/) override { return open(json::object()); }
  bool start_array(std::size_t /*size*/) override { return open(json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    Level& level = levels_.back();
    const auto [member, fresh] = level.container->emplace(name, nullptr);
    level.key = std::move(name);
    level.member = &*member;
    if (!fresh) {
      throw InputError(json_message(file_, pointer(), "the key appears twice", "a key is allowed once in its object"));
    }
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const json::exception& error) override {
    if (error.id == overflow_id) {
      throw InputError(json_message(file_, pointer(), fmt::format("the number {} is too large", excerpt(token)),
                                    "a magnitude of at most 1.797e308 is allowed"));
    }
    const std::size_t offset = std::min(position > 0 ? position - 1 : 0, text_.size());
    const std::string_view literal = non_finite_literal(text_, offset);
    if (!literal.empty()) {
      throw InputError(fmt::format("{}: {} is not a JSON number; a finite number is allowed",
                                   place(text_, file_, static_cast<std::size_t>(literal.data() - text_.data())),
                                   literal));
    }
    throw InputError(fmt::format("{}: {}", place(text_, file_, offset), reason_of(error)));
  }

 private:
  struct Level {
    json* container;
    std::string key{};       ///< of the member that is being read, in an object
    json* member = nullptr;  ///< likewise
  };

  /// The JSON pointer of the value that comes next.
  std::string pointer() const {
    std::string result;
    for (const Level& level : levels_) {
      // The open levels above the innermost are already elements of their arrays.
      const std::size_t count = level.container->size() - (&level == &levels_.back() ? 0 : 1);
      result = json_pointer_child(result, level.container->is_array() ? std::to_string(count) : level.key);
    }
    return result;
  }

  json* store(json value) {
    if (levels_.empty()) return &(document_ = std::move(value));
    json& container = *levels_.back().container;
    if (container.is_array()) {
      container.push_back(std::move(value));
      return &container.back();
    }
    return &(*levels_.back().member = std::move(value));
  }

  bool add(json value) {
    store(std::move(value));
    return true;
  }

  bool open(json container) {
    if (levels_.size() >= static_cast<std::size_t>(max_json_depth)) {
      throw InputError(json_message(file_, "", "arrays and objects are nested too deeply",
                                    fmt::format("at most {} levels are allowed", max_json_depth)));
    }
    levels_.push_back({.container = store(std::move(container))});
    return true;
  }

  bool close() {
    json& container = *levels_.back().container;
    if (container.is_array()) container.get_ref<json::array_t&>().shrink_to_fit();  // there may be millions
    levels_.pop_back();
    return true;
  }

  std::string_view text_;
  const std::string& file_;
  json document_;
  std::vector<Level> levels_;
};

}  // namespace

nlohmann::json parse_json(std::string_view text, const std::string& file) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.substr(0, byte_order_mark.size()) == byte_order_mark) text.remove_prefix(byte_order_mark.size());
  check_characters(text, file);
  DocumentBuilder builder(text, file);
  constexpr bool strict = true;
  constexpr bool ignore_comments = true;
  json::sax_parse(text.begin(), text.end(), &builder, json::input_format_t::json, strict, ignore_comments);
  return builder.take_document();
}

nlohmann::json read_json_file(const std::filesystem::path& file) {
  std::string text;
  try {
    text = read_text(file);
  } catch (const std::runtime_error& error) {
    throw InputError(
        fmt::format("{}: cannot be read: {}; a readable JSON file is allowed", file.string(), error.what()));
  }
  return parse_json(text, file.string());
}

std::string read_text(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw std::runtime_error("it is a folder");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(std::strerror(errno));
  std::string text;
  std::array<char, 65536> block;
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > largest_text) throw std::runtime_error("it is larger than 2 GiB");
  }
  if (stream.bad()) throw std::runtime_error(std::strerror(errno));
  return text;
}

std::string json_pointer_child(std::string_view pointer, std::string_view key) {
  std::string result(pointer);
  result += '/';
  for (const char c : key) {
    if (c == '~') {
      result += "~0";
    } else if (c == '/') {
      result += "~1";
    } else {
      result += c;
    }
  }
  return result;
}

std::string json_message(std::string_view file, std::string_view pointer, std::string_view wrong,
                         std::string_view allowed) {
  std::string shown = pointer.empty() ? "(root)" : "";
  while (!pointer.empty()) {
    const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
    shown += '/' + excerpt(pointer.substr(1, end - 1));
    pointer.remove_prefix(end);
  }
  return fmt::format("{}: {}: {}; {}", file, shown, wrong, allowed);
}

}  // namespace pyrasim
