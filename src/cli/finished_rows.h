// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <vector>

namespace pyrasim::cli {

/// The rows of a CSV file that an earlier sweep wrote. A row is known by its first fields, which say what was run.
class FinishedRows {
 public:
  FinishedRows() = default;
  /// None where there is no such file. Throws InputError for one that is not such a table: `header` is its first line.
  /// A last line without an end was not finished, and is left out.
  FinishedRows(const std::string& file, const std::string& header, std::size_t key_fields);

  bool holds(const std::vector<std::string>& key) const { return keys_.contains(key); }
  std::size_t count() const { return keys_.size(); }
  /// All rows, whole lines.
  const std::string& text() const { return text_; }

 private:
  std::set<std::vector<std::string>> keys_;
  std::string text_;
};

}  // namespace pyrasim::cli
