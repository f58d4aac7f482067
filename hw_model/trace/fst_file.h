// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "files/output_file.h"

namespace pyrasim::hw {

/// A fast signal trace (FST), made by GTKWave's own writer in nameless files, in bounded memory.
class FstFile {
 public:
  /// `time_unit`: "1 ns". The files are made in `folder`. Throws RunError.
  FstFile(const std::filesystem::path& folder, const std::string& time_unit, const std::string& comment);
  ~FstFile();
  FstFile(const FstFile&) = delete;
  FstFile& operator=(const FstFile&) = delete;

  void begin_scope(const std::string& name);
  void end_scope();
  /// Returns the number by which change() knows the signal. `states`: its values are those of StageState, with names.
  std::size_t add_signal(const std::string& name, std::size_t bits, bool states);

  /// The time of what follows; ascending.
  void set_time(std::uint64_t time);
  /// `bits`: of 0 and 1, without zeros in front if need be, or x.
  void change(std::size_t signal, std::string_view bits);

  /// Completes the trace and appends it to `output`. Throws RunError.
  void write_to(OutputFile& output);

 private:
  struct Signal {
    std::uint32_t handle;
    std::string value;  ///< as wide as the signal is
  };

  void complete();
  /// Whether the completed trace holds all changes.
  bool is_whole() const;
  [[noreturn]] void fail(const std::string& why) const;

  std::filesystem::path folder_;
  void* writer_ = nullptr;  ///< none: complete
  int descriptor_ = -1;     ///< of the file that the writer fills
  std::uint32_t state_names_ = 0;
  std::vector<Signal> signals_;
  std::uint64_t changes_ = 0;
};

}  // namespace pyrasim::hw
