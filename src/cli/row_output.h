// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace pyrasim::cli {

/// A table whose rows are finished work, each written as soon as it is done: for people, and as CSV where asked for. A
/// CSV file gets its name with its first row, and then grows by whole rows; what stood there stays until then.
class RowOutput {
 public:
  /// `csv_file`: "-" for stdout, empty for no CSV. `table`: where the table for people goes, as OutputPlan says. Throws
  /// RunError where the file cannot be written.
  RowOutput(const std::string& csv_file, std::ostream& table);
  ~RowOutput();
  RowOutput(const RowOutput&) = delete;
  RowOutput& operator=(const RowOutput&) = delete;

  /// The first line of each; that of the CSV is written with its first row.
  void header(const std::string& csv, const std::string& table);
  /// Whole lines. Throws RunError where they cannot be written.
  void row(const std::string& csv, const std::string& table);
  /// The end of both: after lines for people alone. Throws RunError likewise.
  void finish(const std::string& text);

 private:
  struct File;
  bool csv_on_stdout_;
  std::ostream& table_;
  std::unique_ptr<File> file_;  ///< none: no CSV, or on stdout
  std::string csv_header_;      ///< as long as it is not written
};

/// Makes the rows `names`, one after the other, by `make_row`. An Error is thrown on with the row's name and how many
/// rows are done; so is an interrupt.
void make_rows(const std::vector<std::string>& names, const std::function<void(std::size_t)>& make_row);

}  // namespace pyrasim::cli
