// SPDX-License-Identifier: Apache-2.0
#include "scene/nff_words.h"

#include <fmt/format.h>

#include <utility>

#include "error.h"
#include "text/parse_number.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

std::string in_quotes(std::string_view word) { return '"' + excerpt(word) + '"'; }

bool contains(const NumberRange& range, double value) { return range.contains(value); }
bool contains(const IntegerRange& range, std::int64_t value) { return value >= range.min && value <= range.max; }

}  // namespace

NffWords::NffWords(std::string_view text, std::string file) : file_(std::move(file)), lines_(text) {}

bool NffWords::next_command() {
  if (const std::string_view more = next_word(rest_); !more.empty()) {
    fail(fmt::format("{} follows all that {} takes", in_quotes(more), in_quotes(command_)),
         "a command has to begin a line");
  }
  while (lines_.next()) {
    rest_ = lines_.line();
    command_ = next_word(rest_);
    if (!command_.empty()) return true;
  }
  return false;
}

bool NffWords::line_goes_on() const {
  std::string_view rest = rest_;
  return !next_word(rest).empty();
}

std::string_view NffWords::word(std::string_view what) {
  std::string_view found = next_word(rest_);
  while (found.empty()) {
    if (!lines_.next())
      fail(fmt::format("the file ends within {}", in_quotes(command_)), fmt::format("its {} is needed", what));
    rest_ = lines_.line();
    found = next_word(rest_);
  }
  return found;
}

void NffWords::expect(std::string_view name, std::string_view allowed) {
  const std::string_view found = word(in_quotes(name));
  if (found != name) fail(fmt::format("{} stands where {} has to", in_quotes(found), in_quotes(name)), allowed);
}

template <class Value, class Range>
Value NffWords::value(std::string_view what, const Range& range) {
  const std::string_view found = word(what);
  Value value{};
  if (!parse_whole(found, value) || !contains(range, value)) {
    fail(fmt::format("{} is no {}", in_quotes(found), what), range.text() + " is allowed");
  }
  return value;
}

double NffWords::number(std::string_view what, const NumberRange& range) { return value<double>(what, range); }

std::int64_t NffWords::integer(std::string_view what, const IntegerRange& range) {
  return value<std::int64_t>(what, range);
}

glm::dvec3 NffWords::vec3(std::string_view what, const NumberRange& range) {
  glm::dvec3 result;
  for (int k = 0; k < 3; ++k) result[k] = number(what, range);
  return result;
}

void NffWords::fail(std::string_view wrong, std::string_view allowed) const {
  throw InputError(fmt::format("{}:{}: {}; {}", file_, line(), wrong, allowed));
}

}  // namespace pyrasim
