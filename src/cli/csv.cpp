// SPDX-License-Identifier: Apache-2.0
#include "cli/csv.h"

namespace pyrasim::cli {

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

std::string csv_row(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) line += (line.empty() ? "" : ",") + csv_field(field);
  return line + '\n';
}

std::vector<std::string> csv_fields(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const bool doubled = quoted && line.substr(k, 2) == "\"\"";
    if (line[k] == ',' && !quoted) {
      fields.emplace_back();
    } else if (line[k] != '"' || doubled) {
      fields.back() += line[k];
      if (doubled) ++k;
    } else {
      quoted = !quoted;
    }
  }
  return fields;
}

}  // namespace pyrasim::cli
