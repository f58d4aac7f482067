// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/command_parser.h"
#include "run/executor.h"

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

/// Makes the rows `names`, `at_once` at the same time: `prepare` and `take` as in TaskList. An Error is thrown on with
/// the row's name and how many rows are done; so is an interrupt.
void make_rows(const std::vector<std::string>& names, int at_once,
               const std::function<std::optional<Task>(std::size_t)>& prepare,
               const std::function<void(std::size_t, const std::optional<Outcome>&)>& take);

/// --jobs: how many rows are made at the same time, each in a process of its own.
struct JobOption {
  int jobs = 1;  ///< 0: one for each core

  void add(const Command& command);
  int at_once() const { return thread_count(jobs); }
};

}  // namespace pyrasim::cli
