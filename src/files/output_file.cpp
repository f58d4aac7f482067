// SPDX-License-Identifier: Apache-2.0
#include "files/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "error.h"
#include "files/file_place.h"

namespace pyrasim {
namespace {

constexpr std::size_t buffer_bytes = 65536;
constexpr mode_t new_file_mode = 0666;  // less the user's umask

/// The name that the kernel keeps for an open file, by which a nameless one can be given a name.
std::string descriptor_name(int descriptor) { return fmt::format("/proc/self/fd/{}", descriptor); }

/// Calls `create` with names in `folder` until one is not taken; it returns a negative number and sets errno on
/// failure. Returns the name; empty, with errno set, where it failed for another reason.
template <typename Create>
std::filesystem::path with_temporary_name(const std::filesystem::path& folder, Create create) {
  for (unsigned attempt = 0;; ++attempt) {
    std::filesystem::path name = folder / fmt::format(".pyrasim-{}-{}.tmp", getpid(), attempt);
    if (create(name.c_str()) >= 0) return name;
    if (errno != EEXIST) return {};
  }
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)) {
  FilePlace place = place_of(path_);
  target_ = std::move(place.file);
  if (place.descriptor >= 0) {
    open_descriptor(place.descriptor);
    return;
  }
  struct stat status {};
  if (stat(target_.c_str(), &status) != 0) {
    if (errno != ENOENT) fail(errno);
    if (!target_.has_filename()) fail(target_.empty() ? ENOENT : EISDIR);
    open_temporary();
    return;
  }
  if (S_ISDIR(status.st_mode)) fail(EISDIR);
  if (!S_ISREG(status.st_mode)) {
    open_direct();
    return;
  }
  if (access(target_.c_str(), W_OK) != 0) fail(errno);
  open_temporary();
  // A file that is replaced keeps its permissions where the system lets it.
  [[maybe_unused]] const int ignored = fchmod(descriptor_, status.st_mode & 07777U);
}

OutputFile::OutputFile(Scratch /*scratch*/) {
  const char* const folder = std::getenv("TMPDIR");
  path_ = folder != nullptr && *folder != '\0' ? folder : "/tmp";
  target_ = path_ / "scratch";
  open_temporary();
}

OutputFile::~OutputFile() { close(); }

void OutputFile::write(std::string_view bytes) {
  assert(descriptor_ >= 0 && "written after commit");
  buffer_.append(bytes);
  if (buffer_.size() >= buffer_bytes) flush();
}

void OutputFile::overwrite(std::uint64_t position, std::string_view bytes) {
  assert(revisable() && position + bytes.size() <= size());
  while (!bytes.empty() && position < written_) {
    const ssize_t written = pwrite(descriptor_, bytes.data(), std::min<std::size_t>(bytes.size(), written_ - position),
                                   static_cast<off_t>(position));
    if (written < 0 && errno != EINTR) fail(errno);
    if (written <= 0) continue;
    bytes.remove_prefix(static_cast<std::size_t>(written));
    position += static_cast<std::uint64_t>(written);
  }
  std::copy(bytes.begin(), bytes.end(), buffer_.begin() + static_cast<std::ptrdiff_t>(position - written_));
}

void OutputFile::copy_to(const std::function<void(std::string_view)>& take) {
  assert(revisable());
  flush();
  std::string piece(buffer_bytes, '\0');
  for (std::uint64_t position = 0; position < written_;) {
    const ssize_t count = pread(descriptor_, piece.data(), piece.size(), static_cast<off_t>(position));
    if (count < 0 && errno != EINTR) fail(errno);
    if (count == 0) fail(EIO);  // somebody has cut it
    if (count < 0) continue;
    take(std::string_view(piece).substr(0, static_cast<std::size_t>(count)));
    position += static_cast<std::uint64_t>(count);
  }
}

void OutputFile::publish() {
  assert(descriptor_ >= 0 && "published after commit");
  flush();
  if (!direct_ && !named_) {
    if (temporary_.empty()) {
      temporary_ = with_temporary_name(folder_of(target_), [this](const char* name) {
        return linkat(AT_FDCWD, descriptor_name(descriptor_).c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW);
      });
      if (temporary_.empty()) fail(errno);
    }
    if (rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
    temporary_.clear();
  }
  named_ = true;
}

void OutputFile::commit() {
  publish();
  const int descriptor = std::exchange(descriptor_, -1);
  if (::close(descriptor) != 0) fail(errno);
}

/// A copy shares the place in the file with the original, and that it appends. What was handed to the program does not
/// close on exec, or it would not be here; what does is a file of its own, which nobody can mean.
void OutputFile::open_descriptor(int descriptor) {
  direct_ = true;
  const int flags = fcntl(descriptor, F_GETFL);
  const int descriptor_flags = fcntl(descriptor, F_GETFD);
  if (flags >= 0 && (static_cast<unsigned>(flags) & O_ACCMODE) == O_RDONLY) fail(EBADF);
  if (descriptor_flags >= 0 && (static_cast<unsigned>(descriptor_flags) & FD_CLOEXEC) != 0) fail(EBADF);
  descriptor_ = fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  if (descriptor_ < 0) fail(errno);
}

void OutputFile::open_direct() {
  direct_ = true;
  descriptor_ = open(target_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  if (descriptor_ < 0) fail(errno);
}

/// A nameless file is preferred: it leaves nothing behind however the program ends.
void OutputFile::open_temporary() {
  const std::filesystem::path folder = folder_of(target_);
  descriptor_ = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, new_file_mode);
  if (descriptor_ >= 0 && access(descriptor_name(descriptor_).c_str(), F_OK) == 0) return;
  close();
  temporary_ = with_temporary_name(folder, [this](const char* name) {
    return descriptor_ = open(name, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, new_file_mode);
  });
  if (descriptor_ < 0) fail(errno);
}

/// Where it fails, a file that has its name ends with what was whole before.
void OutputFile::flush() {
  const std::uint64_t whole = written_;
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno != EINTR) {
      const int error = errno;
      if (named_ && !direct_) [[maybe_unused]]
        const int ignored = ftruncate(descriptor_, static_cast<off_t>(whole));
      fail(error);
    }
    if (written <= 0) continue;
    rest.remove_prefix(static_cast<std::size_t>(written));
    written_ += static_cast<std::uint64_t>(written);
  }
  buffer_.clear();
}

void OutputFile::close() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
  descriptor_ = -1;
  temporary_.clear();
}

void OutputFile::fail(int error_number) const {
  throw RunError(fmt::format("{}: cannot write: {}", path_.string(), std::generic_category().message(error_number)));
}

}  // namespace pyrasim
