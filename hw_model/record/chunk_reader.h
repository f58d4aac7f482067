// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "hw_model/record/chunk_writer.h"

namespace pyrasim::hw {

struct Chunk {
  ChunkType type;
  std::string content;  ///< as it was given to ChunkWriter
};

/// Throws InputError for a chunk of `file` that is not as it was written.
[[noreturn]] void fail_damaged(const std::string& file);

/// Reads what ChunkWriter writes, up to the last whole chunk of a file that was broken off.
class ChunkReader {
 public:
  /// Throws InputError where `file` cannot be read, or is no such file.
  explicit ChunkReader(const std::filesystem::path& file);

  /// The next chunk; none where no whole one is left. Throws InputError for one that is damaged.
  std::optional<Chunk> next();
  /// Whether nothing is left, not even a piece of a chunk.
  bool at_end() const { return rest_.empty(); }

 private:
  std::string name_;
  std::string bytes_;
  std::string_view rest_;
};

}  // namespace pyrasim::hw
