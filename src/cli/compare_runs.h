// SPDX-License-Identifier: Apache-2.0
// What differs between two runs, by the documents that --stats wrote of them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <unordered_map>
#include <vector>

namespace pyrasim::cli {

/// A run's statistics as read from a file.
class RunFile {
 public:
  /// Throws InputError where the file is none of them.
  explicit RunFile(const std::string& name);
  RunFile(const RunFile&) = delete;
  RunFile& operator=(const RunFile&) = delete;

  const std::string& file() const { return file_; }
  /// Paths of all values, as in Difference, in the document's order.
  const std::vector<std::string>& paths() const { return paths_; }
  /// The value at a path; null where there is none.
  const nlohmann::json* at(const std::string& path) const;

 private:
  void collect(const nlohmann::json& value, const std::string& path);

  std::string file_;
  nlohmann::json document_;
  std::vector<std::string> paths_;
  std::unordered_map<std::string, const nlohmann::json*> values_;
};

/// A value that the two runs do not share. Null where a run has no such value.
struct Difference {
  std::string path;  ///< "machine.cycles", "units.pixel_scan.busy", "rays.by_level.2"
  const nlohmann::json* first;
  const nlohmann::json* second;
};

/// Whether such a path is one of what the run was asked for.
bool is_setting(const std::string& path);

/// All of them but the command lines and the program's versions: settings, then what the runs took and gave. The values
/// are the documents' own; a list whose elements have neither name nor level, a histogram for one, is a value as a
/// whole.
std::vector<Difference> differences(const RunFile& first, const RunFile& second);

/// The differences as text for people: values, then a line for each unit and FIFO that differs.
std::string comparison_table(const RunFile& first, const RunFile& second);

/// The same as JSON, every difference with both values.
nlohmann::ordered_json comparison_document(const RunFile& first, const RunFile& second);

}  // namespace pyrasim::cli
