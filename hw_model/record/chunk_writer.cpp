// SPDX-License-Identifier: Apache-2.0
#include "hw_model/record/chunk_writer.h"

#include <zlib.h>

#include <new>
#include <string>

#include "hw_model/record/varint.h"

namespace pyrasim::hw {
namespace {

constexpr int compression = 4;  ///< higher levels save little, and take long

std::string compressed(std::string_view content) {
  uLongf size = compressBound(content.size());
  std::string bytes(size, '\0');
  const int result = compress2(reinterpret_cast<Bytef*>(bytes.data()), &size,
                               reinterpret_cast<const Bytef*>(content.data()), content.size(), compression);
  if (result != Z_OK) throw std::bad_alloc();  // there is no other cause
  bytes.resize(size);
  return bytes;
}

}  // namespace

ChunkWriter::ChunkWriter(OutputFile& output) : output_(output) { output_.write(ptrace_magic); }

void ChunkWriter::write(ChunkType type, std::string_view content) {
  const std::string payload = is_compressed(type) ? compressed(content) : std::string(content);
  std::string chunk(1, static_cast<char>(type));
  append_varint(chunk, payload.size());
  output_.write(chunk + payload);
}

}  // namespace pyrasim::hw
