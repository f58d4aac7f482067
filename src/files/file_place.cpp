// SPDX-License-Identifier: Apache-2.0
#include "files/file_place.h"

#include <sys/stat.h>

#include <charconv>
#include <optional>
#include <string>

namespace pyrasim {
namespace {

constexpr int most_links = 40;  // as Linux follows

std::filesystem::path canonical_or_empty(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::canonical(path, error);
}

/// The descriptor that an entry of this process's own folder of descriptors stands for, by whatever name; else -1.
int own_descriptor(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  int descriptor = -1;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), descriptor);
  if (error != std::errc() || end != name.data() + name.size() || descriptor < 0) return -1;
  const std::filesystem::path folder = canonical_or_empty(folder_of(file));
  if (folder.empty()) return -1;
  const bool own =
      folder == canonical_or_empty("/proc/self/fd") || folder == canonical_or_empty("/proc/thread-self/fd");
  return own ? descriptor : -1;
}

std::optional<struct stat> status_of(const FilePlace& place) {
  struct stat status {};
  const int failed = place.descriptor >= 0 ? fstat(place.descriptor, &status) : stat(place.file.c_str(), &status);
  return failed == 0 ? std::optional(status) : std::nullopt;
}

bool is_there(const std::filesystem::path& file) {
  struct stat status {};
  return stat(file.c_str(), &status) == 0;
}

}  // namespace

FilePlace place_of(const std::filesystem::path& name) {
  std::filesystem::path file = name;
  for (int links = 0; links < most_links; ++links) {
    const int descriptor = own_descriptor(file);
    if (descriptor >= 0) return {file, descriptor};
    std::error_code no_link;
    const std::filesystem::path target = std::filesystem::read_symlink(file, no_link);
    if (no_link) break;
    const std::filesystem::path next = folder_of(file) / target;
    if (is_there(file) && !is_there(next)) break;  // its text is no path: another process's "pipe:[123]"
    file = next;
  }
  return {file, -1};
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

bool is_regular_file(const FilePlace& place) {
  const auto status = status_of(place);
  return status && S_ISREG(status->st_mode);
}

bool same_place(const FilePlace& a, const FilePlace& b) {
  if (a.descriptor >= 0 && a.descriptor == b.descriptor) return true;
  const auto of_a = status_of(a);
  const auto of_b = status_of(b);
  if (of_a && of_b) {
    return of_a->st_dev == of_b->st_dev && of_a->st_ino == of_b->st_ino && !S_ISCHR(of_a->st_mode);
  }
  std::error_code no_folder;
  return !of_a && !of_b && a.file.filename() == b.file.filename() &&
         std::filesystem::equivalent(folder_of(a.file), folder_of(b.file), no_folder);
}

}  // namespace pyrasim
