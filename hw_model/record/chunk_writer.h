// SPDX-License-Identifier: Apache-2.0
// The container of .ptrace files: docs/ptrace.md.
#pragma once

#include <cstddef>
#include <string_view>

#include "files/output_file.h"

namespace pyrasim::hw {

/// The first line of the file.
inline constexpr std::string_view ptrace_magic = "pyrasim trace 1\n";

/// What a compressed content has at the most: more than a table of any machine and scene needs.
inline constexpr std::size_t most_content_bytes = std::size_t{32} << 20U;

/// What a chunk holds. Readers pass over those that they do not know.
enum class ChunkType : char {
  header = 'H',  ///< JSON: what was run; the first
  rays = 'R',    ///< rows of RayColumns
  nodes = 'N',   ///< rows of NodeColumns
  events = 'E',  ///< reserved
  image = 'I',   ///< the picture as PNG
  end = 'Z',     ///< JSON: what came of it; the last
};

/// Of types that are not known the content is taken as it is.
inline bool is_compressed(ChunkType type) {
  return type == ChunkType::rays || type == ChunkType::nodes || type == ChunkType::events || type == ChunkType::end;
}

/// Writes such a file, chunk by chunk: type, length as a varint, content. All but header and picture are
/// compressed (zlib, RFC 1950). What is in the file at any time can be read up to the last whole chunk.
class ChunkWriter {
 public:
  /// `output` outlives it.
  explicit ChunkWriter(OutputFile& output);
  void write(ChunkType type, std::string_view content);

 private:
  OutputFile& output_;
};

}  // namespace pyrasim::hw
