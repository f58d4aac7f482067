// SPDX-License-Identifier: Apache-2.0
// JSON text into a document, strictly: what most readers pass over in silence is an error here.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace pyrasim {

/// The deepest nesting of arrays and objects that a document may have.
inline constexpr int max_json_depth = 64;

/// Parses `text`, which is UTF-8; comments (`//` and `/* */`) and a byte-order mark in front are allowed. `file` is the
/// name that error messages give the text. Throws InputError: "FILE:LINE:COLUMN: ..." for text that is no JSON, NaN,
/// Infinity and null characters included, and "FILE: /json/pointer: ..." for a key that appears twice in its object and
/// for a number beyond the range of double.
nlohmann::json parse_json(std::string_view text, const std::string& file);

/// The same for a file. Throws InputError also when it cannot be read.
nlohmann::json read_json_file(const std::filesystem::path& file);

/// The whole content of a file. Throws std::runtime_error with the reason alone ("No such file or directory").
std::string read_text(const std::filesystem::path& file);

/// `pointer` with one more token, escaped as RFC 6901 says ("~" as "~0", "/" as "~1").
std::string json_pointer_child(std::string_view pointer, std::string_view key);

/// "FILE: /json/pointer: WRONG; ALLOWED". The document's root, an empty pointer, reads "(root)"; of a pointer's longest
/// tokens an excerpt is shown.
std::string json_message(std::string_view file, std::string_view pointer, std::string_view wrong,
                         std::string_view allowed);

}  // namespace pyrasim
