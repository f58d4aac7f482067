// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

#include "json/json_reader.h"
#include "text/text_lines.h"

namespace pyrasim {

/// The words of an NFF text, command by command: each begins a line, and what it takes may go on in the lines below.
/// All functions throw InputError "FILE:LINE: what is wrong; what is allowed".
class NffWords {
 public:
  /// `text` must outlive it; `file` is the name that messages give it.
  NffWords(std::string_view text, std::string file);

  /// Goes to the next command; false behind the last one. Fails where the line of the one before has more words.
  bool next_command();
  /// The one that is being read.
  std::string_view command() const { return command_; }
  /// The number, from 1, of the line that was read last.
  std::size_t line() const { return lines_.number(); }

  /// Whether the line has more words.
  bool line_goes_on() const;
  /// The next word, which has to be `name`; `allowed` says what else to know of it.
  void expect(std::string_view name, std::string_view allowed);
  /// A number that is a `what`, "radius" for instance.
  double number(std::string_view what, const NumberRange& range);
  std::int64_t integer(std::string_view what, const IntegerRange& range);
  /// Three numbers.
  glm::dvec3 vec3(std::string_view what, const NumberRange& range);

  /// At the line that was read last.
  [[noreturn]] void fail(std::string_view wrong, std::string_view allowed) const;

 private:
  /// `what` is for the message where the text ends.
  std::string_view word(std::string_view what);
  template <class Value, class Range>
  Value value(std::string_view what, const Range& range);

  std::string file_;
  TextLines lines_;
  std::string_view rest_;  ///< of the line
  std::string command_;
};

}  // namespace pyrasim
