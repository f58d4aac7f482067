// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace pyrasim {

/// A file that appears under its name only when it is complete.
///
/// What is written goes to a nameless or temporary file in the same folder; commit() gives it its name, replacing what
/// stood there. Without commit() nothing changes. A symbolic link stays, and its target is written, also one that does
/// not exist yet. A device or a pipe (`/dev/null`) is written to directly, and so is what an open descriptor leads to
/// (`/dev/stdout`, `/dev/fd/3`): behind what it has written, as its opener wants. A file whose
/// parts are each complete gets its name with the first of them: publish().
class OutputFile {
 public:
  /// Opens the output, so that one that cannot be written is known before the work begins.
  /// Throws RunError "PATH: cannot write: reason".
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// A nameless file in the system's folder for temporary files, for copy_to() alone: there is nothing to commit.
  struct Scratch {};
  explicit OutputFile(Scratch scratch);

  /// Appends `bytes`. Throws RunError, as the constructor does.
  void write(std::string_view bytes);

  /// Bytes written so far.
  std::uint64_t size() const { return written_ + buffer_.size(); }
  /// Whether overwrite() is possible: not where the bytes go to a device, a pipe or a descriptor directly.
  bool revisable() const { return !direct_; }
  /// Puts `bytes` in the place of as many that were written from `position` on. Throws RunError, as the constructor
  /// does.
  void overwrite(std::uint64_t position, std::string_view bytes);
  /// Appends all that has been written so far, which has to be revisable, to `take` in pieces. Throws RunError, as the
  /// constructor does.
  void copy_to(const std::function<void(std::string_view)>& take);

  /// Gives the file its name with all that has been written so far, which is complete in itself; more may follow, and
  /// appears with the next call. Where that fails the file ends with what was published before. Throws RunError, as the
  /// constructor does.
  void publish();

  /// Completes the file; nothing may be written afterwards. Throws RunError, as the constructor does.
  void commit();

  /// The name as given to the constructor.
  const std::filesystem::path& path() const { return path_; }

 private:
  void open_descriptor(int descriptor);
  void open_direct();
  void open_temporary();
  void flush();
  void close();
  [[noreturn]] void fail(int error_number) const;

  std::filesystem::path path_;
  std::filesystem::path target_;     // path_ with symbolic links followed
  std::filesystem::path temporary_;  // empty where the file has no name yet, or is written to directly
  std::string buffer_;
  int descriptor_ = -1;
  bool direct_ = false;
  bool named_ = false;         // published
  std::uint64_t written_ = 0;  // bytes that have left the buffer
};

}  // namespace pyrasim
