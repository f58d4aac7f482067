// SPDX-License-Identifier: Apache-2.0
#include "cli/finished_rows.h"

#include <fmt/format.h>

#include <filesystem>

#include "cli/csv.h"
#include "error.h"
#include "json/json_file.h"

namespace pyrasim::cli {

FinishedRows::FinishedRows(const std::string& file, const std::string& header, std::size_t key_fields) {
  if (!std::filesystem::exists(file)) return;
  std::string content;
  try {
    content = read_text(file);
  } catch (const std::runtime_error& error) {
    throw InputError(fmt::format("{}: cannot read: {}", file, error.what()));
  }
  content.erase(content.rfind('\n') + 1);
  if (content.empty()) return;
  if (!content.starts_with(header)) {
    throw InputError(fmt::format("{}:1: it is not a table of this version's sweep; the first line has to be {}", file,
                                 header.substr(0, header.size() - 1)));
  }
  text_ = content.substr(header.size());
  for (std::size_t begin = 0; begin < text_.size();) {
    const std::size_t end = text_.find('\n', begin);
    std::vector<std::string> fields = csv_fields(std::string_view(text_).substr(begin, end - begin));
    fields.resize(key_fields);
    keys_.insert(std::move(fields));
    begin = end + 1;
  }
}

}  // namespace pyrasim::cli
