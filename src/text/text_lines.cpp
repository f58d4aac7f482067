// SPDX-License-Identifier: Apache-2.0
#include "text/text_lines.h"

#include <algorithm>

namespace pyrasim {
namespace {

constexpr std::string_view blanks = " \t\v\f";

}  // namespace

TextLines::TextLines(std::string_view text) : rest_(text) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
}

bool TextLines::next() {
  if (rest_.empty()) return false;
  number_ += pieces_;
  pieces_ = 1;
  Piece piece = next_piece();
  line_ = piece.text;
  if (!piece.continued) return true;
  joined_ = piece.text;
  while (piece.continued && !rest_.empty()) {
    piece = next_piece();
    joined_.append(" ").append(piece.text);
    ++pieces_;
  }
  line_ = joined_;
  return true;
}

TextLines::Piece TextLines::next_piece() {
  const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + (rest_.substr(end, 2) == "\r\n" ? 2 : 1), rest_.size()));
  const std::size_t comment = line.find('#');
  if (comment != std::string_view::npos) return {line.substr(0, comment), false};
  const std::size_t last = line.find_last_not_of(blanks);
  if (last == std::string_view::npos || line[last] != '\\') return {line, false};
  return {line.substr(0, last), true};
}

std::string_view next_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  line.remove_prefix(word.size());
  return word;
}

std::string_view trimmed(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  return line.substr(0, line.find_last_not_of(blanks) + 1);
}

}  // namespace pyrasim
