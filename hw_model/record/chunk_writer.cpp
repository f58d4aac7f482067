// SPDX-License-Identifier: Apache-2.0
#include "hw_model/record/chunk_writer.h"

#include <string>

#include "hw_model/record/compressed.h"
#include "hw_model/record/varint.h"

namespace pyrasim::hw {
namespace {

constexpr int compression = 4;  ///< higher levels save little, and take long

}  // namespace

ChunkWriter::ChunkWriter(OutputFile& output) : output_(output) { output_.write(ptrace_magic); }

void ChunkWriter::write(ChunkType type, std::string_view content) {
  const std::string payload = is_compressed(type) ? compressed(content, compression) : std::string(content);
  std::string chunk(1, static_cast<char>(type));
  append_varint(chunk, payload.size());
  output_.write(chunk + payload);
}

}  // namespace pyrasim::hw
