// SPDX-License-Identifier: Apache-2.0
// Comma-separated values, RFC 4180.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pyrasim::cli {

/// A field as it stands in a row: in quotes where it holds a comma, a quote or a line end.
std::string csv_field(std::string_view text);

/// A row's line, with its end.
std::string csv_row(const std::vector<std::string>& fields);

/// The fields of a line without its end.
std::vector<std::string> csv_fields(std::string_view line);

}  // namespace pyrasim::cli
