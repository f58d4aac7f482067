// SPDX-License-Identifier: Apache-2.0
// Where a file's name leads, so that two names of one file are known for what they are.
#pragma once

#include <filesystem>

namespace pyrasim {

struct FilePlace {
  std::filesystem::path file;  ///< symbolic links followed, the last one also where nothing stands there yet
  int descriptor = -1;         ///< of this process, where the name stands for one: /dev/stdout, /dev/fd/3; else -1
};

FilePlace place_of(const std::filesystem::path& name);

/// The folder that an entry of that name is in.
std::filesystem::path folder_of(const std::filesystem::path& file);

/// Whether it is there and is a file with content of its own, no folder, device or pipe.
bool is_regular_file(const FilePlace& place);

/// Whether what is written to one arrives at the other: one descriptor, one file (by whatever links), one pipe, or one
/// name of a file to come. A character device, a terminal or /dev/null, takes whatever it is sent.
bool same_place(const FilePlace& a, const FilePlace& b);

}  // namespace pyrasim
