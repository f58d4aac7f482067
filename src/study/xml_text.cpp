// SPDX-License-Identifier: Apache-2.0
#include "study/xml_text.h"

#include "text/utf8.h"

namespace pyrasim {
namespace {

/// The characters of XML 1.0 (fifth edition, 2.2); of the control characters, none that a label could show.
bool is_allowed(char32_t code_point) { return !is_control(code_point) && code_point != 0xFFFE && code_point != 0xFFFF; }

}  // namespace

std::string xml_text(std::string_view text) {
  std::string result;
  for (std::size_t position = 0; position < text.size();) {
    const std::size_t begin = position;
    const std::optional<char32_t> code_point = next_code_point(text, position);
    if (!code_point || !is_allowed(*code_point)) {
      result += replacement_character;
    } else if (*code_point == '&') {
      result += "&amp;";
    } else if (*code_point == '<') {
      result += "&lt;";
    } else if (*code_point == '>') {
      result += "&gt;";
    } else if (*code_point == '"') {
      result += "&quot;";
    } else {
      result += text.substr(begin, position - begin);
    }
  }
  return result;
}

}  // namespace pyrasim
