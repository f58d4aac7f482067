// SPDX-License-Identifier: Apache-2.0
#include "cli/row_output.h"

#include <fmt/format.h>

#include <iostream>

#include "cli/command.h"
#include "error.h"
#include "files/output_file.h"
#include "run/interrupt.h"
#include "text/counted.h"

namespace pyrasim::cli {
namespace {

void print(std::ostream& stream, const std::string& text) {
  stream << text << std::flush;
  if (!stream) throw RunError("stdout: cannot write");
}

}  // namespace

struct RowOutput::File {
  explicit File(const std::string& name) : output(name) {}
  OutputFile output;
};

RowOutput::RowOutput(const std::string& csv_file, std::ostream& table)
    : csv_on_stdout_(csv_file == "-"), table_(table) {
  if (!csv_file.empty() && !csv_on_stdout_) file_ = std::make_unique<File>(csv_file);
}
RowOutput::~RowOutput() = default;

void RowOutput::header(const std::string& csv, const std::string& table) {
  csv_header_ = csv;
  print(table_, table);
}

void RowOutput::row(const std::string& csv, const std::string& table) {
  if (csv_on_stdout_) print(std::cout, csv_header_ + csv);
  if (file_) {
    file_->output.write(csv_header_ + csv);
    file_->output.publish();
  }
  csv_header_.clear();
  print(table_, table);
}

void RowOutput::finish(const std::string& text) {
  if (file_) file_->output.commit();
  print(table_, text);
}

void make_rows(const std::vector<std::string>& names, int at_once,
               const std::function<std::optional<Task>(std::size_t)>& prepare,
               const std::function<void(std::size_t, const std::optional<Outcome>&)>& take) {
  std::size_t done = 0;
  TaskList list{.size = names.size(), .what = "its simulation", .prepare = prepare};
  list.take = [&](std::size_t k, const std::optional<Outcome>& outcome) {
    take(k, outcome);
    ++done;
  };
  list.progress = [&](std::size_t k) { return progress_bar(fmt::format("simulating {} of {}", k + 1, names.size())); };
  const auto how_far = [&] {
    return fmt::format("with {} of {} done{}", done, counted(names.size(), "row"),
                       done < names.size() ? ", in " + names[done] : "");
  };
  try {
    run_interruptibly([&] { execute(list, at_once); }, how_far);
  } catch (const Interrupted&) {
    throw;
  } catch (const Error& error) {
    throw_error(error.exit_code(),
                fmt::format("{} ({} of {} done): {}", names[done], done, counted(names.size(), "row"), error.what()));
  } catch (const std::bad_alloc&) {
    throw RunError(fmt::format("{} ({} of {} done): out of memory", names[done], done, counted(names.size(), "row")));
  }
}

void JobOption::add(const Command& command) {
  command
      .add_integer("--jobs", jobs, 0, 1024,
                   "rows to make at the same time, each in a process of its own; 0: one for each core; results do not "
                   "depend on it")
      .show_default();
}

}  // namespace pyrasim::cli
