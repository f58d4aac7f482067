// SPDX-License-Identifier: Apache-2.0
#include "hw_model/record/chunk_reader.h"

#include <fmt/format.h>
#include <zlib.h>

#include <array>
#include <stdexcept>

#include "error.h"
#include "hw_model/record/varint.h"
#include "json/json_file.h"

namespace pyrasim::hw {
namespace {

/// None where `bytes` are not a whole stream of zlib, or one of more than most_content_bytes.
std::optional<std::string> decompressed(std::string_view bytes) {
  if (bytes.size() > most_content_bytes) return std::nullopt;
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) throw std::bad_alloc();
  stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string content;
  std::array<char, 65536> piece{};
  int result = Z_OK;
  while (result == Z_OK && content.size() <= most_content_bytes) {
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = piece.size();
    result = inflate(&stream, Z_NO_FLUSH);
    content.append(piece.data(), piece.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (result == Z_MEM_ERROR) throw std::bad_alloc();
  const bool whole = result == Z_STREAM_END && stream.avail_in == 0 && content.size() <= most_content_bytes;
  return whole ? std::optional(std::move(content)) : std::nullopt;
}

}  // namespace

ChunkReader::ChunkReader(const std::filesystem::path& file) : name_(file.string()) {
  try {
    bytes_ = read_text(file);
  } catch (const std::runtime_error& error) {
    throw InputError(fmt::format("{}: cannot read: {}", name_, error.what()));
  }
  if (!bytes_.starts_with(ptrace_magic)) {
    throw InputError(
        fmt::format("{}: it is no trace of this program; a file of simulate --trace FILE.ptrace is allowed", name_));
  }
  rest_ = std::string_view(bytes_).substr(ptrace_magic.size());
}

std::optional<Chunk> ChunkReader::next() {
  if (rest_.empty()) return std::nullopt;
  std::string_view ahead = rest_.substr(1);
  const auto length = take_varint(ahead);
  if (!length) {
    if (rest_.size() > 10) fail_damaged(name_);
    return std::nullopt;
  }
  if (*length > ahead.size()) return std::nullopt;
  const auto type = static_cast<ChunkType>(rest_.front());
  const std::string_view payload = ahead.substr(0, *length);
  rest_ = ahead.substr(*length);
  if (!is_compressed(type)) return Chunk{type, std::string(payload)};
  auto content = decompressed(payload);
  if (!content) fail_damaged(name_);
  return Chunk{type, std::move(*content)};
}

void fail_damaged(const std::string& file) {
  throw InputError(fmt::format("{}: a chunk of it is damaged; it has to be as simulate wrote it", file));
}

}  // namespace pyrasim::hw
