// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pyrasim {

/// The lines of a text of words, as of an OBJ, MTL or NFF file: ended by LF, CR or both, without comments (from `#`
/// on), and joined to the next one where a backslash is the last character but blanks. A byte-order mark in front is
/// passed over.
class TextLines {
 public:
  explicit TextLines(std::string_view text);

  /// Goes to the next line; false behind the last one.
  bool next();

  /// The line, until next() is called.
  std::string_view line() const { return line_; }
  /// The number, from 1, of the line in the text; of lines that were joined, the first one's.
  std::size_t number() const { return number_; }

 private:
  struct Piece {
    std::string_view text;
    bool continued;  ///< by the line below
  };
  Piece next_piece();

  std::string_view rest_;
  std::string_view line_;
  std::string joined_;  ///< what line_ refers to, where it is of several lines
  std::size_t number_ = 0;
  std::size_t pieces_ = 1;  ///< lines of the text that line_ consists of
};

/// Cuts the first word off `line`; empty at the line's end.
std::string_view next_word(std::string_view& line);

/// `line` without the blanks around it.
std::string_view trimmed(std::string_view line);

}  // namespace pyrasim
