// SPDX-License-Identifier: Apache-2.0
// Texts of unknown origin (file names, keys, names, words of a file) as a terminal may show them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pyrasim {

/// How much of a user's text a message repeats, characters.
inline constexpr std::size_t longest_excerpt = 60;

/// `text` in one line that steers no terminal: control characters (C0, delete, C1), line separators and the marks that
/// turn the direction of writing (Unicode's bidirectional formatting) become \uXXXX, bytes that are no UTF-8 \xXX.
/// A text that is printable already stays as it is.
std::string one_line(std::string_view text);

/// one_line() of the beginning of `text`, at most `longest` characters, and an ellipsis where something is left out.
std::string excerpt(std::string_view text, std::size_t longest = longest_excerpt);

/// A value of the command line as a message shows it: excerpt(), or "(empty)".
std::string value_excerpt(std::string_view text);

/// one_line() of a whole message, whose middle is left out where it is longer than any message has to be.
std::string message_line(std::string_view text);

/// The offset of the first byte that is not part of well-formed UTF-8 (RFC 3629); the text's size where all are.
std::size_t first_not_utf8(std::string_view text);

}  // namespace pyrasim
